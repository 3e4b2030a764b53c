#include "stages.h"

#include "diagnose/answer/diagnosis.h"
#include "log/csv.h"
#include "store/result_folder.h"

namespace tread::program {

using diagnose::answer::Overlay;

using tread::diagnose::answer::Overlay;

void writeStages(const std::vector<Overlay>& overlays, const Path& folder) {
    for (const Overlay& overlay : overlays) {
        const Path here = folder / overlay.recording;
        makeFolder(here);
        writeLog(here / "measured.csv", overlay.measured);
        writeLog(here / "nominal.csv", overlay.nominal);
        writeLog(here / "calibrated.csv", overlay.calibrated);
        writeLog(here / "extended.csv", overlay.extended);
    }
}

}  // namespace tread::program
