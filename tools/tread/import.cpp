#include "import/import.h"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/yaml/position.h"
#include "base/yaml/read.h"
#include "base/yaml/write.h"
#include "commands.h"
#include "import/essentials.h"
#include "kind_of_file.h"
#include "log/csv.h"
#include "output.h"
#include "tread/load.h"

namespace tread::program {
namespace {

// Whether both names stand for one file.
bool same(const Path& a, const Path& b) {
    std::error_code none;
    return std::filesystem::equivalent(a, b, none) || a.lexically_normal() == b.lexically_normal();
}

void refuseToOverwrite(const std::string& output, const std::string& input, std::string_view option) {
    if (input.empty() || !same(output, input)) return;
    throw LoadError({{"", 0, 0, "",
                      fmt::format("tread import: {} names '{}', which is read; it would be overwritten: name another "
                                  "file",
                                  option, output)}});
}

// The file to write: the named one, else one beside the source: drive.csv becomes drive.tread.csv.
std::string outputOf(const ImportOptions& options, const char* extension) {
    if (!options.output.empty()) {
        refuseToOverwrite(options.output, options.file, "-o");
        refuseToOverwrite(options.output, options.map, "-o");
        return options.output;
    }
    const Path beside = Path(options.file).replace_extension(extension);
    if (!std::filesystem::exists(beside)) return beside.string();
    throw LoadError({{"", 0, 0, "",
                      fmt::format("tread import: '{}' is there already; name the file to write with -o, or remove it",
                                  beside.string())}});
}

int importTyre(const ImportOptions& options) {
    if (!options.map.empty() || !options.init.empty()) {
        throw LoadError({{options.file, 0, 0, "", "is a tyre property file, which needs no mapping; leave out --map"}});
    }
    const std::string output = outputOf(options, ".tread.yaml");
    const TyreParams tyre = loadTyre(options.file);
    writeFile(output, writeYaml(tyre));
    const std::string answer =
        fmt::format("Imported the tyre {} into {}", Path(options.file).filename().string(), output);
    if (options.json) {
        printJson({{"answer", answer}, {"file", options.file}, {"output", {output}}, {"notes", tyre.notes}});
    } else {
        for (const std::string& remark : tyre.notes) note(remark);
        say(answer + "\n");
    }
    return kYes;
}

// A fault of the mapping, with its position in the mapping file.
Problem placed(Problem problem, const ImportOptions& options) {
    if (!problem.file.empty()) return problem;
    if (options.map.empty()) {
        problem.file = options.file;
        problem.text += "; `tread import --init map.yaml` writes the guessed mapping for you to correct";
        return problem;
    }
    const TextPosition position = positionOfValue(options.map, problem.path);
    problem.file = options.map;
    problem.line = position.line;
    problem.column = position.column;
    return problem;
}

Imported imported(const ForeignTable& table, const ImportMap& map, const ImportOptions& options) {
    try {
        return importLog(table, map);
    } catch (const LoadError& error) {
        std::vector<Problem> problems;
        for (const Problem& problem : error.problems()) problems.push_back(placed(problem, options));
        throwIfAny(std::move(problems));
        throw;
    }
}

// log.csv, or log_1.csv, log_2.csv and so on for several logs.
std::vector<std::string> writeLogs(const std::vector<Log>& logs, const std::string& output) {
    std::vector<std::string> files;
    for (std::size_t i = 0; i < logs.size(); ++i) {
        Path file = output;
        if (logs.size() > 1) {
            file.replace_filename(fmt::format("{}_{}{}", file.stem().string(), i + 1, file.extension().string()));
        }
        writeLog(file, logs[i]);
        files.push_back(file.string());
    }
    return files;
}

std::string answerOf(const Imported& result, const std::string& file, const std::vector<std::string>& output) {
    const Log& log = result.logs.front();
    const std::vector<double>& time = log.channels.front().values;
    const std::string into =
        output.size() == 1 ? output.front() : fmt::format("{} files from {}", output.size(), output.front());
    return fmt::format("Imported {}: {} channels, {} samples, {:.4g} s{}, into {}", Path(file).filename().string(),
                       log.channels.size() - 1, time.size(), time.back(),
                       output.size() > 1 ? " in the first recording" : "", into);
}

std::string listedNames(const std::vector<std::string>& names) {
    std::string out;
    for (const std::string& name : names) out += (out.empty() ? "" : ", ") + name;
    return out;
}

std::vector<std::string> textsOf(const std::vector<Guess>& guesses) {
    std::vector<std::string> texts;
    for (const Guess& guess : guesses) texts.push_back(guess.text);
    return texts;
}

std::vector<std::string> channelsOf(const ImportMap& map) {
    std::vector<std::string> channels;
    if (!map.time.from.empty()) channels.emplace_back("time");
    for (const ImportChannel& channel : map.map) channels.push_back(channel.channel);
    for (const ImportConstant& constant : map.constants) channels.push_back(constant.channel);
    return channels;
}

// Lines for the error stream, each with what it is in front.
std::string lines(std::string_view what, const std::vector<std::string>& texts) {
    std::string out;
    for (const std::string& text : texts) out += fmt::format("{}: {}\n", what, text);
    return out;
}

void noteLines(std::string text) {
    if (text.empty()) return;
    text.pop_back();  // the end of the last line
    note(text);
}

int writeGuess(const ImportOptions& options, const GuessedMap& guessed) {
    refuseToOverwrite(options.init, options.file, "--init");
    writeFile(options.init, mappingText(guessed));
    const std::vector<std::string> guesses = textsOf(guessed.guesses);
    const std::vector<std::string> lacking = lackingEssentials(channelsOf(guessed.map));
    const std::string answer =
        fmt::format("Guessed {} channels of {}; correct {} and import with --map {}", guessed.map.map.size(),
                    Path(options.file).filename().string(), options.init, options.init);
    if (options.json) {
        printJson({{"answer", answer},
                   {"file", options.file},
                   {"output", {options.init}},
                   {"guesses", guesses},
                   {"lacking", lacking}});
    } else {
        noteLines(lines("guess", guesses) + lines("lacking", lacking));
        say(answer + "\n");
    }
    return kYes;
}

}  // namespace

int import(const ImportOptions& options) {
    expectKind(options.file, {"table", "log", "vbo", "mat", "mcap", "tir"});
    expectKind(options.map, {"import"});
    const std::string extension = Path(options.file).extension().string();
    if (extension == ".tir" || extension == ".TIR") return importTyre(options);

    const ForeignTable table = readForeignTable(options.file);
    const bool guessed = options.map.empty();
    const GuessedMap mapping = guessed ? guessMap(table) : GuessedMap{readYaml<ImportMap>(options.map), {}};
    const ImportMap& map = mapping.map;
    if (!options.init.empty()) return writeGuess(options, mapping);

    const std::string output = outputOf(options, ".tread.csv");
    const Imported result = imported(table, map, options);
    const std::vector<std::string> files = writeLogs(result.logs, output);
    const std::string answer = answerOf(result, options.file, files);
    const std::vector<std::string> guesses = textsOf(mapping.guesses), lacking = lackingEssentials(channelsOf(map));
    if (options.json) {
        printJson({{"answer", answer},
                   {"file", options.file},
                   {"kind", table.kind},
                   {"output", files},
                   {"rows", result.rows},
                   {"samples", result.logs.front().samples()},
                   {"changes", tread::json(result.changes)},
                   {"not_taken", result.not_taken},
                   {"guesses", guesses},
                   {"lacking", lacking},
                   {"guessed_mapping", guessed ? nlohmann::json(mappingText(mapping)) : nlohmann::json(nullptr)}});
        return kYes;
    }
    std::string words = text(result.changes);
    if (!result.not_taken.empty()) words += "not taken: " + listedNames(result.not_taken) + "\n";
    words += lines("guess", guesses) + lines("lacking", lacking);
    if (guessed) words += "guessed mapping (--init FILE writes it):\n" + mappingText(mapping);
    noteLines(words);
    say(answer + "\n");
    return kYes;
}

}  // namespace tread::program
