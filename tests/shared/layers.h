// Which file may include which: the rules of the project's layers, checked on the #include lines of one file at a time.
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace tread::layers {

using Path = std::filesystem::path;

// A file may include from its own layer and from those to its left.
inline const std::vector<std::string> kOrder{"base",      "inference", "road",     "tyre",   "vehicle",   "host",
                                             "fmu",       "bullet",    "store",    "log",    "import",    "scenario",
                                             "run",       "compare",   "metrics",  "series", "recording", "diagnose",
                                             "calibrate", "blind",     "campaign", "sheet",  "report",    "tools"};

// Inside of a layer, a file may include from its own room and from those to its left. A room is a folder; "" is the
// layer's own, but for the files that kGroundFloor names.
inline const std::map<std::string, std::vector<std::string>> kRooms{
    {"base", {"", "math", "threads", "text", "units", "fields", "yaml"}},
    {"fmu", {"", "object", "package"}},
    {"bullet", {"", "ground", "drop_in"}},
    {"import", {"formats", ""}},
    {"recording", {"", "checks"}},
    {"diagnose", {"ground", "answer", "catalogue", "model", "select", "explain", ""}},
    {"blind", {"world", "drives", "key", "faults", "detectability", "make", "answers", "score"}},
};
inline const std::vector<Path> kGroundFloor{"diagnose/settings", "diagnose/options"};

// What computes an answer puts nothing into words: these rooms include none of the headers that print.
inline const std::vector<std::string> kWordless{"catalogue", "model", "select", "explain"};
inline bool isProse(const Path& name) {
    const std::string stem = name.stem().string();
    return name.parent_path() == "diagnose/answer" &&
           (stem == "words" || stem.ends_with("_text") || stem.ends_with("_json"));
}

// Public headers share one folder; each belongs to a layer.
inline const std::map<std::string, std::vector<std::string>> kPublicHeaders{
    {"base", {"api", "cpp20", "describe", "wheels", "curve", "problem", "state_parts", "vector", "vehicle_output"}},
    {"road", {"road", "height_field", "road_params", "road_surface"}},
    {"tyre", {"tyre"}},
    {"vehicle",
     {"suspension", "steering", "driveline", "engine", "gearbox", "differential", "brakes", "anti_lock",
      "stability_control", "aero", "tyre_surroundings", "vehicle", "equilibrium", "car_fleet", "load"}},
    {"host", {"c_api"}},
    {"bullet",
     {"bullet_precision", "bullet_road", "bullet_ground", "bullet_vehicle", "raycast_vehicle", "raycast_vehicle_file",
      "raycast_fleet"}},
};

// The sub-models of the car: they meet in vehicle.h and step.h only.
inline const std::vector<std::string> kSubModels{"suspension", "steering", "driveline", "brakes", "aero", "tyre"};

// Libraries that only some layers may include, by the beginnings of the included names.
struct Library {
    std::string name;
    std::vector<std::string> beginnings;
    std::vector<std::string> layers;
};
inline const std::vector<std::string> kLab(std::find(kOrder.begin(), kOrder.end(), "store"), kOrder.end());
inline const std::vector<Library> kLibraries{
    {"Bullet", {"bt", "Bullet", "LinearMath/"}, {"bullet", "run", "tools"}},
    {"yaml-cpp", {"yaml-cpp/"}, {"base"}},
    {"fmt", {"fmt/"}, kLab},
    {"nlohmann_json", {"nlohmann/"}, kLab},
    {"CLI11", {"CLI/"}, {"tools"}},
    {"pybind11", {"pybind11/"}, {"tools"}},
    {"OpenGL, GLFW and stb", {"epoxy/", "GLFW/", "stb/"}, {"tools"}},
    {"matio", {"matio.h"}, {"import"}},
    {"zlib", {"zlib.h"}, {"import"}},
    {"OpenSSL", {"openssl/"}, {"store"}},
    {"SQLite", {"sqlite3.h"}, {"campaign"}},
    {"Zstandard", {"zstd.h"}, {"log"}},
    {"libzip", {"zip.h"}, {"fmu"}},
    {"Boost.Context", {"boost/context/"}, {"run"}},
};

inline bool contains(const std::vector<std::string>& list, const std::string& value) {
    return std::find(list.begin(), list.end(), value) != list.end();
}

inline std::string layerOfPublicHeader(const Path& file) {
    for (const auto& [layer, headers] : kPublicHeaders) {
        if (contains(headers, file.stem().string())) return layer;
    }
    return {};
}

// Layer of a file, named relative to the root of the project: src/<layer>/..., include/tread/..., tools/...; or "".
inline std::string layerOfFile(const Path& file) {
    const std::string top = file.begin()->string();
    if (top == "tools") return top;
    if (top == "include") return layerOfPublicHeader(file);
    const std::string folder = std::next(file.begin())->string();
    return contains(kOrder, folder) ? folder : "";
}

// Layer of what an #include names: tread/..., <layer>/..., or a file beside the including one; or "".
inline std::string layerOfInclude(const Path& name, const std::string& including_layer) {
    if (!name.has_parent_path()) return including_layer;
    const std::string folder = name.begin()->string();
    if (folder == "tread") return layerOfPublicHeader(name);
    return contains(kOrder, folder) ? folder : "";
}

// Room of a file, named "<layer>/..." as an #include does; or "", also for layers that have none.
inline std::string roomOf(const Path& name) {
    Path bare = name;
    if (std::find(kGroundFloor.begin(), kGroundFloor.end(), bare.replace_extension()) != kGroundFloor.end())
        return "ground";
    const Path folder = name.parent_path();
    return folder.has_parent_path() ? std::next(folder.begin())->string() : "";
}

// src/<layer>/... -> <layer>/...
inline Path inSources(const Path& file) {
    return file.lexically_relative("src");
}

struct Include {
    int line;
    std::string name;
    bool quoted;
};

inline std::vector<Include> includesOf(const std::string& text) {
    std::vector<Include> found;
    std::istringstream lines(text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::erase_if(line, [](char c) { return c == ' ' || c == '\t'; });
        const std::string directive = "#include";
        if (!line.starts_with(directive) || line.size() < directive.size() + 2) continue;
        const char open = line[directive.size()];
        const std::size_t begin = directive.size() + 1, end = line.find(open == '<' ? '>' : '"', begin);
        if (end != std::string::npos) found.push_back({number, line.substr(begin, end - begin), open == '"'});
    }
    return found;
}

// What is wrong with an include between two files of one layer, both named "<layer>/...", or "".
inline std::string faultBetweenRooms(const Path& name, const Path& file, const std::string& layer) {
    const auto rooms = kRooms.find(layer);
    if (rooms == kRooms.end()) return {};
    const std::vector<std::string>& order = rooms->second;
    const auto placeOf = [&](const Path& of) { return std::find(order.begin(), order.end(), roomOf(of)); };
    if (placeOf(name) <= placeOf(file) && placeOf(name) != order.end()) return {};
    const auto inWords = [](const std::string& room) {
        return room.empty() ? "the layer's own files" : "room " + room;
    };
    return inWords(roomOf(file)) + " may not use " + inWords(roomOf(name)) + " of the same layer";
}

// What is wrong with one include of a file in a layer, or "".
inline std::string faultOf(const Include& include, const Path& file, const std::string& layer) {
    const Path name = include.name;
    for (const Library& library : kLibraries) {
        const bool belongs = std::any_of(library.beginnings.begin(), library.beginnings.end(),
                                         [&](const std::string& begin) { return include.name.starts_with(begin); });
        if (belongs && !contains(library.layers, layer)) return "layer " + layer + " does not use " + library.name;
    }
    if (!include.quoted && *name.begin() != "tread") return {};
    const std::string used = layerOfInclude(name, layer);
    if (used.empty()) return "it belongs to no layer (write \"tread/header.h\" or \"layer/file.h\")";
    if (std::find(kOrder.begin(), kOrder.end(), used) > std::find(kOrder.begin(), kOrder.end(), layer)) {
        return "layer " + layer + " may not use layer " + used + ", which lies above it";
    }
    if (isProse(name) && layer == "diagnose" && contains(kWordless, roomOf(inSources(file))))
        return "what computes an answer does not put it into words";
    if (used == layer && name.has_parent_path() && *file.begin() == "src") {
        if (const std::string fault = faultBetweenRooms(name, inSources(file), layer); !fault.empty()) return fault;
    }
    const bool is_public = *file.begin() == "include";
    if (is_public && *name.begin() != "tread")
        return "a public header includes public ones only: no other is installed";
    const bool between_sub_models = is_public && contains(kSubModels, file.stem()) && contains(kSubModels, name.stem());
    return between_sub_models ? "a sub-model's header includes no other's: they meet in vehicle.h" : "";
}

// What only code that computes with vectors has: games that include tread do not compile for its instruction sets.
inline std::string vectorCodeIn(const std::string& text) {
    for (const char* sign : {"vector_size", "intrin.h", "arm_neon.h", "<experimental/simd>", "Lanes", "alignas"}) {
        if (text.find(sign) != std::string::npos) return sign;
    }
    return {};
}

// Every fault of a file (named relative to the root of the project) as "file:line: what: why".
inline std::vector<std::string> faultsOf(const Path& file, const std::string& text) {
    std::vector<std::string> faults;
    const bool layered = *file.begin() != "tests";
    const std::string layer = layered ? layerOfFile(file) : "";
    if (layered && layer.empty())
        faults.push_back(file.string() + ":1: belongs to no layer: name it in tests/shared/layers.h");
    const std::string vector_code = *file.begin() == "include" ? vectorCodeIn(text) : "";
    if (!vector_code.empty())
        faults.push_back(file.string() + ":1: a public header has no vector code, but \"" + vector_code + "\"");
    if (const auto rooms = kRooms.find(layer);
        rooms != kRooms.end() && *file.begin() == "src" && !contains(rooms->second, roomOf(inSources(file))))
        faults.push_back(file.string() + ":1: belongs to no room of its layer: name it in tests/shared/layers.h");
    for (const Include& include : includesOf(text)) {
        std::string fault;
        if (Path(include.name).extension() == ".cpp") fault = "include headers, not sources";
        else if (!layer.empty()) fault = faultOf(include, file, layer);
        if (fault.empty()) continue;
        faults.push_back(file.string() + ":" + std::to_string(include.line) + ": includes " + include.name + ": " +
                         fault);
    }
    return faults;
}

}  // namespace tread::layers
