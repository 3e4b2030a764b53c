#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "base/text/problem_texts.h"
#include "base/text/text_file.h"
#include "base/yaml/document.h"
#include "base/yaml/session.h"
#include "commands.h"
#include "describable.h"
#include "kind_of_file.h"
#include "log/csv.h"
#include "log/log_columns.h"
#include "output.h"
#include "road/height_field_file.h"

namespace tread::program {
namespace {

struct CheckedFile {
    std::string name;
    std::string kind;  // empty: not recognised
    std::vector<Problem> problems;
    std::vector<std::string> notes;
    std::vector<Problem> warnings;  // implausible numbers

    void take(FileReading reading) {
        notes = std::move(reading.notes);
        warnings = std::move(reading.warnings);
        try {
            throwIfAny(std::move(reading.faults));
        } catch (const LoadError& error) {
            problems = error.problems();
        }
    }
};

std::string unknownKindText(const std::vector<std::string>& keys) {
    return fmt::format("found {}, expected the keys of a {} file; `tread describe` with one of these words lists them",
                       foundKeys(keys), listed(describableNames(true)));
}

void checkYaml(CheckedFile& checked, std::string_view text) {
    const auto document = parseYaml(text, checked.name, checked.problems);
    if (!document) return;
    const std::vector<std::string> keys = keysOf(*document);
    if (const std::string fault = outputFault(keys); !fault.empty()) throw LoadError({{checked.name, 0, 0, "", fault}});
    const Describable* const kind = bestMatch(keys);
    if (!kind) throw LoadError({{checked.name, 0, 0, "", unknownKindText(keys)}});
    checked.kind = kind->name;
    checked.take(kind->read(checked.name));
}

void checkCsv(CheckedFile& checked, std::string_view text) {
    if (looksLikeHeightField(text)) {
        checked.kind = "height field";
        HeightField field;
        parseHeightField(field, text, checked.name, checked.problems);
    } else {
        checked.kind = "log";
        checked.problems = unitFaults(readLog(checked.name), checked.name);
    }
}

CheckedFile checkFile(const std::string& name) {
    CheckedFile checked{name, "", {}, {}, {}};
    const std::string extension = Path(name).extension().string();
    std::string fault;
    const auto text = readTextFile(name, fault);  // only the beginning of a long log
    if (!text) {
        checked.problems = {{name, 0, 0, "", fault}};
        return checked;
    }
    try {
        if (extension == ".tir" || extension == ".TIR") {
            checked.kind = "tyre";
            checked.take(readTyreFile(name));
        } else if (extension == ".csv" || extension == ".CSV") {
            checkCsv(checked, *text);
        } else {
            checkYaml(checked, *text);
        }
    } catch (const LoadError& error) {
        checked.problems = error.problems();
    } catch (const FileError& error) {
        checked.problems = {{name, 0, 0, "", error.what()}};
    }
    return checked;
}

// All faults, or all warnings; one of a file that several others include is listed once.
std::vector<Problem> allOf(const std::vector<CheckedFile>& files, std::vector<Problem> CheckedFile::*list) {
    std::vector<Problem> faults;
    std::set<std::tuple<std::string, int, int, std::string>> seen;
    for (const CheckedFile& file : files) {
        for (const Problem& problem : file.*list) {
            if (seen.emplace(problem.file, problem.line, problem.column, problem.text).second) {
                faults.push_back(problem);
            }
        }
    }
    return faults;
}

std::string answer(std::size_t faults, std::size_t warnings, std::size_t faulty, std::size_t files) {
    if (faults == 0) {
        const std::string words = fmt::format("{} {} fine", counted(files, "file"), files == 1 ? "is" : "are");
        return warnings == 0 ? words : fmt::format("{}, with {}", words, counted(warnings, "warning"));
    }
    if (files == 1) return fmt::format("{} in 1 file", counted(faults, "fault"));
    return fmt::format("{} in {} of {}", counted(faults, "fault"), faulty, counted(files, "file"));
}

std::string text(const std::vector<CheckedFile>& files, const std::vector<Problem>& faults,
                 const std::vector<Problem>& warnings) {
    std::string out = textOf(faults) + (faults.empty() ? "" : "\n");
    for (const Problem& warning : warnings) out += "warning: " + toText(warning) + "\n";
    for (const CheckedFile& file : files) {
        if (file.problems.empty()) out += fmt::format("{}: {}, fine\n", file.name, file.kind);
    }
    return out;
}

nlohmann::json json(const std::vector<Problem>& problems) {
    nlohmann::json list = nlohmann::json::array();
    for (const Problem& problem : problems) {
        list.push_back({{"file", problem.file},
                        {"line", problem.line > 0 ? nlohmann::json(problem.line) : nlohmann::json(nullptr)},
                        {"column", problem.line > 0 ? nlohmann::json(problem.column) : nlohmann::json(nullptr)},
                        {"path", problem.path},
                        {"text", problem.text}});
    }
    return list;
}

nlohmann::json json(const std::vector<CheckedFile>& files) {
    nlohmann::json list = nlohmann::json::array();
    for (const CheckedFile& file : files) {
        list.push_back({{"file", file.name},
                        {"kind", file.kind},
                        {"problems", json(file.problems)},
                        {"warnings", json(file.warnings)},
                        {"notes", file.notes}});
    }
    return list;
}

}  // namespace

int check(const CheckOptions& options) {
    std::vector<CheckedFile> files;
    for (const std::string& name : options.files) files.push_back(checkFile(name));
    if (options.strict) {
        for (CheckedFile& file : files)
            file.problems.insert(file.problems.end(), file.warnings.begin(), file.warnings.end());
        for (CheckedFile& file : files) file.warnings.clear();
    }
    for (const CheckedFile& file : files) {
        for (const std::string& note : file.notes) {
            // Notes on the file itself already start with its name.
            const bool named = note.starts_with(file.name + ": ");
            const std::size_t begin = named ? file.name.size() + 2 : 0;
            program::note(fmt::format("{}: note: {}", file.name, note.substr(begin)));
        }
    }
    const std::vector<Problem> faults = allOf(files, &CheckedFile::problems);
    const std::vector<Problem> warnings = allOf(files, &CheckedFile::warnings);
    const auto faulty = static_cast<std::size_t>(
        std::count_if(files.begin(), files.end(), [](const CheckedFile& file) { return !file.problems.empty(); }));
    const std::string words = answer(faults.size(), warnings.size(), faulty, files.size());
    if (options.json) {
        printJson(
            {{"answer", words}, {"faults", faults.size()}, {"warnings", warnings.size()}, {"files", json(files)}});
    } else {
        say(words + "\n" + text(files, faults, warnings), faults.empty() ? Tone::good : Tone::bad);
    }
    return faults.empty() ? kYes : kBadInput;
}

}  // namespace tread::program
