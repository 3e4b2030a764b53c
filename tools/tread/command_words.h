// The command line's description as plain words: what CLI11 knows of each command and option.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace tread::program {

struct OptionWords {
    std::vector<std::string> names;  // "-o", "--output"; of an argument, what it is called
    std::string value;               // "FILE", "FOLDER", "TEXT"; empty: a flag
    std::vector<std::string> choices;
    std::string meaning;
    bool required = false;
    bool repeated = false;  // takes many values

    bool isFolder() const { return value == "FOLDER"; }
};

struct CommandWords {
    std::string name;  // "run", "blind make"
    std::string meaning;
    std::vector<OptionWords> arguments;  // without a name, in their order
    std::vector<OptionWords> options;
};

// All commands, those within commands behind theirs.
std::vector<CommandWords> commandWords(const CLI::App& app);

// Options of the program itself.
std::vector<OptionWords> ownOptions(const CLI::App& app);

}  // namespace tread::program
