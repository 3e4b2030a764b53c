// Dotted paths of fields: "front.damper.bump", "gears.0", "steering.ramp.to".
#pragma once

#include <string>
#include <string_view>

namespace tread {

inline std::string joinPath(std::string_view path, std::string_view name) {
    if (path.empty()) return std::string(name);
    return std::string(path) + "." + std::string(name);
}

// "bump" of "front.damper.bump".
inline std::string lastName(std::string_view path) {
    const std::size_t dot = path.rfind('.');
    return std::string(dot == std::string_view::npos ? path : path.substr(dot + 1));
}

// The first name of a path, which is then moved behind it.
inline std::string_view takeName(std::string_view& path) {
    const std::size_t dot = path.find('.');
    const std::string_view name = path.substr(0, dot);
    path.remove_prefix(dot == std::string_view::npos ? path.size() : dot + 1);
    return name;
}

}  // namespace tread
