// The project's own files: what lies in its folder but was not built there.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace tread {

struct SourceFile {
    std::filesystem::path name;  // relative to the root of the project
    std::string text;
};

// Folders of the root that hold no files of the project (see .gitignore).
inline bool isForeignFolder(const std::string& name) {
    return name == ".git" || name == ".cache" || name == "out" || name == "build" || name.starts_with("build-");
}

// All files below the folders of the root for which `wanted(name)` holds; sorted.
template <class Wanted>
std::vector<SourceFile> sourceFiles(const std::filesystem::path& root, Wanted&& wanted) {
    namespace fs = std::filesystem;
    std::vector<SourceFile> files;
    for (auto entry = fs::recursive_directory_iterator(root); entry != fs::recursive_directory_iterator(); ++entry) {
        if (entry.depth() == 0 && isForeignFolder(entry->path().filename().string())) entry.disable_recursion_pending();
        const fs::path name = fs::relative(entry->path(), root);
        if (!entry->is_regular_file() || !wanted(name)) continue;
        std::ostringstream text;
        text << std::ifstream(entry->path(), std::ios::binary).rdbuf();
        files.push_back({name, std::move(text).str()});
    }
    std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    return files;
}

}  // namespace tread
