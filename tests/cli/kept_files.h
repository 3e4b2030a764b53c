// A folder as it was: its files and their bytes.
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "shared/scratch.h"

namespace tread {

using Files = std::map<std::string, std::string>;  // content by name, relative to the folder

inline Files filesIn(const std::filesystem::path& folder) {
    Files found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            found[entry.path().lexically_relative(folder).generic_string()] = contentOf(entry.path());
    return found;
}

inline void putBack(const Files& files, const std::filesystem::path& folder) {
    std::filesystem::remove_all(folder);
    for (const auto& [name, content] : files) {
        std::filesystem::create_directories((folder / name).parent_path());
        std::ofstream(folder / name, std::ios::binary) << content;
    }
}

inline std::string namesOf(const Files& all) {
    std::string names;
    for (const auto& [name, content] : all) names += name + " (" + std::to_string(content.size()) + ") ";
    return names;
}

}  // namespace tread
