// What the program can describe by name: the one place where the names that users type meet the described types.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/fields/reference_table.h"
#include "commands.h"
#include "tread/problem.h"

namespace tread::program {

// A field of the outermost struct: the first name of a path.
struct TopField {
    std::string name;
    std::string meaning;
};

// What the reader of a file should see.
struct FileReading {
    std::vector<std::string> notes = {};
    std::vector<Problem> warnings = {};  // implausible numbers
    std::vector<Problem> faults = {};
};

struct Describable {
    std::string_view name;     // as typed: "vehicle"
    std::string_view meaning;  // "a car"
    std::vector<TopField> (*top)();
    std::vector<ReferenceRow> (*rows)();
    // Of what is a YAML file; nullptr for anything else. Reading returns the faults, or throws LoadError with them.
    std::string (*schema)() = nullptr;
    FileReading (*read)(const Path& file) = nullptr;

    bool isFile() const { return read != nullptr; }
};

const std::vector<Describable>& describables();

// The names, of files only or of everything.
std::vector<std::string_view> describableNames(bool only_files);

// The one of that name; LoadError with a suggestion and the list when there is none.
const Describable& describable(std::string_view name, bool only_files);

// A tyre file, YAML or .tir.
FileReading readTyreFile(const Path& file);

// LoadError: there is no <what> "x", only y or z; did you mean "y"?
[[noreturn]] void rejectName(std::string_view what, std::string_view name, const std::vector<std::string_view>& known);

}  // namespace tread::program
