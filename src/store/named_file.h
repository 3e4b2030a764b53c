// A file as another file names it.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace tread {

// The file that tread brings along under a name without folder and extension, in this folder of its own ("vehicles",
// "scenarios"); nothing: there is none.
using ShippedFiles =
    std::function<std::optional<std::filesystem::path>(const std::string& name, const std::string& folder)>;

// Relative to the folder of the file that names it. A plain name that is no file there is a shipped one, where there is
// one of that name. An empty name stays empty.
std::string namedFile(const std::filesystem::path& beside, const std::string& name, const ShippedFiles& shipped = {},
                      const std::string& folder = {});

}  // namespace tread
