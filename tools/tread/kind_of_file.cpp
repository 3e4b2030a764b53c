#include "kind_of_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "base/text/text_file.h"

namespace tread::program {
namespace {

// Number of keys that the description has; a key that is only mistyped counts half.
std::size_t score(const Describable& kind, const std::vector<std::string>& keys) {
    const std::vector<TopField> top = kind.top();
    std::vector<std::string_view> names;
    for (const TopField& field : top) names.push_back(field.name);
    std::size_t points = 0;
    for (const std::string& key : keys) {
        const bool known = std::find(names.begin(), names.end(), key) != names.end();
        points += known ? 2 : closest(key, names) ? 1 : 0;
    }
    return points;
}

// A kind of file as messages name it, and what takes such a file.
struct Kind {
    std::string_view name;
    std::string_view words;
    std::string_view use;
};
constexpr Kind kKinds[] = {
    {"vehicle", "a vehicle file", "`tread run` takes it first, `tread describe` shows its data sheet"},
    {"tyre", "a tyre file", "`tread tyre` takes it, and a vehicle names it as the tyre of an axle"},
    {"tir", "a tyre property file", "`tread tyre` and `tread import` take it, and a vehicle names it as a tyre"},
    {"scenario", "a scenario file", "`tread run` takes it after the vehicle"},
    {"accept", "a file of conditions on metrics", "`tread run` and `tread metrics` take it after --accept"},
    {"import", "a mapping for foreign logs", "`tread import` takes it after --map"},
    {"tolerances", "a tolerances file", "`tread compare` takes it after --tolerances"},
    {"envelope", "an envelope file", "`tread compare` takes it after --envelope"},
    {"score", "a score file", "`tread compare` takes it after --score"},
    {"diagnosis", "a diagnosis file", "`tread diagnose` and `tread identify` take it"},
    {"own_effects", "a file of own effects", "a diagnosis file names it under own_effects"},
    {"run", "the record of a run", "it lists inputs, which `tread run` takes as a vehicle and a scenario"},
    {"results", "the results of a run", "`tread compare` takes the folder that contains it"},
    {"log", "a log", "`tread metrics`, `tread compare` and, after --log, `tread run` take it"},
    {"height field", "a height field", "a scenario names it under road.height_field"},
    {"table", "a table of values", "`tread import` makes a log of a foreign one"},
    {"vbo", "a VBOX log", "`tread import` makes a log of it"},
    {"mat", "a MATLAB file", "`tread import` makes a log of it"},
    {"mcap", "an MCAP recording", "`tread import` makes a log of it"},
    {"page", "a page (HTML)", "open it in a browser"},
    {"folder", "a folder",
     "`tread compare` takes folders of runs, `tread run --all` a folder of scenarios, `tread diagnose --init` a folder "
     "of logs"},
};

const Kind& kindNamed(std::string_view name) {
    return *std::find_if(std::begin(kKinds), std::end(kKinds) - 1, [&](const Kind& kind) { return kind.name == name; });
}

std::string lowerCase(std::string text) {
    for (char& c : text) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    return text;
}

bool isYamlName(std::string_view extension) {
    return extension == ".yaml" || extension == ".yml" || extension == ".json";
}

std::string_view kindOfCsv(std::string_view text) {
    if (looksLikeHeightField(text)) return "height field";
    return text.starts_with("time [") ? "log" : "table";
}

// Points of the best of the wanted kinds.
std::size_t scoreOf(std::initializer_list<std::string_view> wanted, const std::vector<std::string>& keys) {
    std::size_t best = 0;
    for (const Describable& kind : describables()) {
        if (kind.isFile() && std::find(wanted.begin(), wanted.end(), kind.name) != wanted.end())
            best = std::max(best, score(kind, keys));
    }
    return best;
}

[[noreturn]] void reject(const Path& file, const std::string& found, std::initializer_list<std::string_view> wanted,
                         std::string_view advice) {
    std::vector<std::string_view> words;
    for (const std::string_view name : wanted) words.push_back(kindNamed(name).words);
    throw LoadError(
        {{file.string(), 0, 0, "", fmt::format("found {}, expected {}; {}", found, listed(words), advice)}});
}

}  // namespace

std::vector<std::string> keysOf(const YamlDocument& document) {
    std::vector<std::string> keys;
    const std::vector<std::size_t>& children = document.root().children;
    if (document.root().kind != YamlNode::Kind::map) return keys;
    for (std::size_t i = 0; i < children.size(); i += 2) keys.push_back(document.nodes[children[i]].text);
    return keys;
}

const Describable* bestMatch(const std::vector<std::string>& keys) {
    const Describable* best = nullptr;
    std::size_t most = 0;
    // A scenario has conditions and metrics too, but never them alone.
    if (std::find(keys.begin(), keys.end(), "phases") == keys.end() &&
        std::find(keys.begin(), keys.end(), "title") == keys.end()) {
        const Describable& accept = describable("accept", true);
        if (!keys.empty() && score(accept, keys) == 2 * keys.size()) return &accept;
        const Describable& metrics = describable("own_metrics", true);
        if (!keys.empty() && score(metrics, keys) == 2 * keys.size()) return &metrics;
    }
    for (const Describable& kind : describables()) {
        if (!kind.isFile()) continue;
        const std::size_t points = score(kind, keys);
        if (points > most) {
            most = points;
            best = &kind;
        } else if (points == most) {
            best = nullptr;
        }
    }
    return best;
}

bool looksLikeHeightField(std::string_view text) {
    while (text.starts_with('#')) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    return text.substr(0, text.find_first_of(",\n")).find("x\\y") != std::string_view::npos;
}

std::string_view kindOfOutput(const std::vector<std::string>& keys) {
    const auto has = [&](std::string_view key) { return std::find(keys.begin(), keys.end(), key) != keys.end(); };
    if (!has("tread_version")) return {};
    return has("metrics") ? "results" : "run";
}

std::string outputFault(const std::vector<std::string>& keys) {
    const std::string_view name = kindOfOutput(keys);
    if (name.empty()) return {};
    const Kind& kind = kindNamed(name);
    return fmt::format("found {}, which `tread run` has written, expected a file that it reads; {}", kind.words,
                       kind.use);
}

std::string foundKeys(const std::vector<std::string>& keys) {
    std::string found = keys.empty() ? "no \"key: value\" lines" : "";
    for (std::size_t i = 0; i < std::min<std::size_t>(keys.size(), 3); ++i)
        found += (i > 0 ? ", " : "") + quote(keys[i]);
    if (keys.size() > 3) found += fmt::format(" and {} more", keys.size() - 3);
    return found;
}

void expectKind(const Path& file, std::initializer_list<std::string_view> wanted) {
    const auto isWanted = [&](std::string_view name) {
        return std::find(wanted.begin(), wanted.end(), name) != wanted.end();
    };
    const auto refuseUnlessWanted = [&](std::string_view name) {
        if (isWanted(name)) return;
        const Kind& kind = kindNamed(name);
        reject(file, std::string(kind.words), wanted, kind.use);
    };
    std::error_code none;
    if (file.empty() || !std::filesystem::exists(file, none)) return;
    if (std::filesystem::is_directory(file, none)) return refuseUnlessWanted("folder");
    if (!std::filesystem::is_regular_file(file, none)) return;  // a pipe can be read only once
    const bool only_folder = wanted.size() == 1 && *wanted.begin() == "folder";
    const std::string extension = lowerCase(file.extension().string());
    if (extension == ".tir") return refuseUnlessWanted("tir");
    if (extension == ".vbo") return refuseUnlessWanted("vbo");
    if (extension == ".mat") return refuseUnlessWanted("mat");
    if (extension == ".mcap") return refuseUnlessWanted("mcap");
    if (extension == ".html") return refuseUnlessWanted("page");
    std::string fault;
    const auto text = readTextFile(file, fault);  // only the beginning of a long log
    if (!text || text->empty()) return;
    if (extension == ".csv" || text->starts_with("time [")) {
        const std::string_view kind = kindOfCsv(*text);
        const bool any_table = kind != "height field" && (isWanted("log") || isWanted("table"));
        return any_table ? void() : refuseUnlessWanted(kind);  // a faulty log may look like a foreign table
    }
    // The text of a foreign log may happen to be YAML.
    const bool wants_yaml = std::any_of(describables().begin(), describables().end(),
                                        [&](const Describable& kind) { return kind.isFile() && isWanted(kind.name); });
    if (!wants_yaml && !only_folder && !isYamlName(extension)) return;
    std::vector<Problem> problems;
    const auto document = parseYaml(*text, file.string(), problems);
    if (!document) {
        if (only_folder) reject(file, "a file", wanted, kindNamed("folder").use);
        return;
    }
    const std::vector<std::string> keys = keysOf(*document);
    if (const std::string_view output = kindOfOutput(keys); !output.empty()) return refuseUnlessWanted(output);
    const Describable* const kind = bestMatch(keys);
    if (kind && isWanted(kind->name)) return;
    const std::size_t points = scoreOf(wanted, keys);
    if (kind && score(*kind, keys) > points) return refuseUnlessWanted(kind->name);
    if (only_folder) reject(file, "a file", wanted, kindNamed("folder").use);
    if (points == 0 && !keys.empty())
        reject(file, "a file with the keys " + foundKeys(keys), wanted, "`tread check` says what a file is");
}

}  // namespace tread::program
