// Many diagnoses side by side: a folder of folders.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tread::recording {

// Names of the folders in this folder that hold a diagnosis.yaml, sorted; none when the folder cannot be read.
std::vector<std::string> diagnosisFolders(const std::filesystem::path& folder);

}  // namespace tread::recording
