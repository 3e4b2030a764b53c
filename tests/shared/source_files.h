// The project's own files: what lies in its folder but was not built there.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "shared/scratch.h"

namespace tread {

struct SourceFile {
    std::filesystem::path name;  // relative to the root of the project
    std::string text;
};

// Entries of the root that hold no files of the project (see .gitignore).
inline bool isForeign(const std::string& name) {
    return name == ".git" || name == ".cache" || name == "out" || name == "build" || name.starts_with("build-");
}

// All files below the folders of the root for which `wanted(name)` holds; sorted.
template <class Wanted>
std::vector<SourceFile> sourceFiles(const std::filesystem::path& root, Wanted&& wanted) {
    namespace fs = std::filesystem;
    std::vector<SourceFile> files;
    for (auto entry = fs::recursive_directory_iterator(root); entry != fs::recursive_directory_iterator(); ++entry) {
        const fs::path name = entry->path().lexically_relative(root);
        if (entry.depth() == 0 && isForeign(name.string())) {
            entry.disable_recursion_pending();
            continue;
        }
        if (!entry->is_regular_file() || !wanted(name)) continue;
        files.push_back({name, contentOf(entry->path())});
    }
    std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    return files;
}

}  // namespace tread
