#include "stages.h"

#include "log/csv.h"

namespace tread::program {

void writeStages(const std::vector<Overlay>& overlays, const Path& folder) {
    for (const Overlay& overlay : overlays) {
        const Path here = folder / overlay.recording;
        std::filesystem::create_directories(here);
        writeLog(here / "measured.csv", overlay.measured);
        writeLog(here / "nominal.csv", overlay.nominal);
        writeLog(here / "calibrated.csv", overlay.calibrated);
        writeLog(here / "extended.csv", overlay.extended);
    }
}

}  // namespace tread::program
