#include "stages.h"

#include <array>
#include <filesystem>

#include "diagnose/answer/diagnosis.h"
#include "log/csv.h"
#include "store/result_folder.h"

namespace tread::program {

using diagnose::answer::Overlay;

namespace {

struct Stage {
    const char* file;
    Log Overlay::*log;
};
constexpr std::array<Stage, 4> kStages{{{"measured.csv", &Overlay::measured},
                                        {"nominal.csv", &Overlay::nominal},
                                        {"calibrated.csv", &Overlay::calibrated},
                                        {"extended.csv", &Overlay::extended}}};

// Of recordings that an earlier call had and this one has not; other files in these folders stay.
void removeEarlierStages(const std::vector<Overlay>& overlays, const Path& folder) {
    std::error_code error;
    std::vector<Path> earlier;
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (entry->is_directory(error)) earlier.push_back(entry->path());
    for (const Overlay& overlay : overlays) std::erase(earlier, folder / overlay.recording);
    for (const Path& recording : earlier) {
        for (const Stage& stage : kStages) removeResult(recording / stage.file);
        if (std::filesystem::is_empty(recording, error)) removeResult(recording);
    }
}

}  // namespace

void writeStages(const std::vector<Overlay>& overlays, const Path& folder) {
    removeEarlierStages(overlays, folder);
    for (const Overlay& overlay : overlays) {
        makeFolder(folder / overlay.recording);
        for (const auto& [file, log] : kStages) writeLog(folder / overlay.recording / file, overlay.*log);
    }
}

}  // namespace tread::program
