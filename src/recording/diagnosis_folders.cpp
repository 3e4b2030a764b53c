#include "recording/diagnosis_folders.h"

#include <algorithm>

namespace tread::recording {

std::vector<std::string> diagnosisFolders(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        if (std::filesystem::exists(entry.path() / "diagnosis.yaml")) names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace tread::recording
