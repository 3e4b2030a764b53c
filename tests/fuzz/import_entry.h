// What the fuzzers and the replay of their corpora do with the bytes of a foreign log: read it, guess a mapping, make a
// log. It must end in a log that keeps its promises, or in a fault that says something.
#pragma once

#include <cmath>
#include <filesystem>
#include <string>

#include "base/yaml/read.h"
#include "fuzz/demand.h"
#include "import/import.h"

namespace tread::fuzz {

// True when it became a log.
inline bool importHostile(auto&& read) {
    try {
        const ForeignTable table = read();
        std::vector<std::string> guesses;
        const ImportMap map = guessMap(table, guesses);
        demand(mappingText(readYamlText<ImportMap>(mappingText(map), "guess.yaml")) == mappingText(map));
        for (const Log& log : importLog(table, map).logs) {
            const std::vector<double>& time = log.channels.front().values;
            demand(time.size() >= 2 && time.front() == 0);
            for (const Channel& channel : log.channels) {
                demand(channel.values.size() == time.size() && !channel.name.empty() && !channel.unit.empty());
            }
            for (std::size_t i = 1; i < time.size(); ++i) demand(time[i] > time[i - 1]);
        }
        return true;
    } catch (const LoadError& error) {
        demand(!error.problems().empty());
        for (const Problem& problem : error.problems()) demand(!problem.text.empty());
        return false;
    }
}

inline bool importHostileVbo(const std::string& text) {
    return importHostile([&] { return parseVbo(text, "fuzz.vbo"); });
}

inline bool importHostileTable(const std::string& text) {
    return importHostile([&] { return parseForeignCsv(text, "fuzz.csv"); });
}

// Each text goes through both readers, whatever it looks like.
inline bool importHostileText(const std::string& text) {
    const bool vbo = importHostileVbo(text), table = importHostileTable(text);
    return vbo || table;
}

}  // namespace tread::fuzz
