// A foreign log and a mapping become a tread log; what was changed is said in words and counted.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "import/formats/foreign_table.h"
#include "import/import_map.h"
#include "log/log.h"

namespace tread {

struct Change {
    std::string kind;       // "unit", "sign", "duplicates", "jump", "gaps", "spikes", "rate", ...
    std::string channel;    // empty: the whole log
    std::size_t count = 0;  // samples, pieces or columns that it concerns
    std::string text;       // one clause
};

struct Imported {
    std::vector<Log> logs;  // one, or one for each recording when jumps split the file
    std::vector<Change> changes;
    std::vector<std::string> not_taken;  // foreign columns that no channel uses
    std::size_t rows = 0;                // of the file
};

// Throws LoadError with every fault; those of the mapping have no file and the path in the mapping: "map.3.from".
Imported importLog(const ForeignTable& table, const ImportMap& map);

// "3 duplicate time stamps dropped", one line for each change.
std::string text(const std::vector<Change>& changes);
nlohmann::json json(const std::vector<Change>& changes);

// A mapping as YAML, without the fields that have their defaults.
std::string mappingText(const ImportMap& map);

// What of a guessed mapping a person has to confirm.
struct Guess {
    std::string channel;  // "time" for the time base; empty: a column that was left out
    std::string field;    // of the channel: "from", "unit", "sign"; empty: none
    std::string text;     // one clause, that names the column
    std::string comment;  // the same behind the field
};

struct GuessedMap {
    ImportMap map;
    std::vector<Guess> guesses;
    bool by_names = true;  // false: the file itself says which channels it has
};

// The mapping that names, units and values of a file suggest: units that make the values those of a road vehicle, signs
// by the majority of what the channels of a rigid body say of one another.
GuessedMap guessMap(const ForeignTable& table);
ImportMap guessMap(const ForeignTable& table, std::vector<std::string>& guesses);

// The mapping with every guess in a comment.
std::string mappingText(const GuessedMap& guessed);

}  // namespace tread
