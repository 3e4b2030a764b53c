#include "compare/compare.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/yaml/read.h"
#include "commands.h"
#include "compare_folders.h"
#include "judge.h"
#include "kind_of_file.h"
#include "log/csv.h"
#include "output.h"
#include "overlay.h"
#include "run/run_record.h"

namespace tread::program {
namespace {

constexpr std::size_t kRows = 10;  // rows of the table, unless more channels differ

// File names without folders, unless two of them are equal.
std::vector<std::string> shortNames(const std::vector<std::string>& files) {
    std::vector<std::string> names;
    for (const std::string& file : files) {
        const std::string name = Path(file).filename();
        if (std::find(names.begin(), names.end(), name) != names.end()) return files;
        names.push_back(name);
    }
    return names;
}

// What runs are called on a page: by their cars where these differ, with their scenarios where only both do, else by
// their files. A log without a record is known by its file.
std::vector<std::string> namesOf(const std::vector<std::string>& files,
                                 const std::vector<std::optional<RunRecord>>& records) {
    const std::vector<std::string> short_names = shortNames(files);
    const auto named = [&](const auto& name) {
        std::vector<std::string> names;
        for (std::size_t i = 0; i < files.size(); ++i) names.push_back(records[i] ? name(*records[i]) : short_names[i]);
        return names;
    };
    const auto distinct = [](std::vector<std::string> names) {
        std::sort(names.begin(), names.end());
        const bool empty = std::any_of(names.begin(), names.end(), [](const auto& name) { return name.empty(); });
        return !empty && std::adjacent_find(names.begin(), names.end()) == names.end();
    };
    const auto cars = named([](const RunRecord& record) { return record.vehicle.name; });
    if (distinct(cars)) return cars;
    const auto runs = named([](const RunRecord& record) { return record.vehicle.name + ", " + record.scenario.title; });
    return distinct(runs) ? runs : short_names;
}

// The record that `tread run` saved beside its log; nothing beside a log of other origin.
std::optional<RunRecord> recordBeside(const std::string& log) {
    const Path file = Path(log).parent_path() / "run.yaml";
    if (Path(log).filename() != "log.csv" || !std::filesystem::exists(file)) return std::nullopt;
    try {
        return readYaml<RunRecord>(file);
    } catch (const LoadError&) {  // perhaps of another version: the replay shows a medium car on level ground
        return std::nullopt;
    }
}

void writeReport(const CompareOptions& options, const Log& reference, const Log& candidate,
                 const Comparison& comparison, const std::string& answer) {
    std::vector<std::string> files{options.reference, options.candidate};
    files.insert(files.end(), options.repeats.begin(), options.repeats.end());
    std::vector<std::optional<RunRecord>> records;
    for (const std::string& file : files) records.push_back(recordBeside(file));
    const std::vector<std::string> names = namesOf(files, records);
    std::vector<Log> others;
    for (const std::string& file : options.repeats) others.push_back(readLog(file));

    std::vector<ComparedLog> logs;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const Log& log = i == 0 ? reference : i == 1 ? candidate : others[i - 2];
        logs.push_back({names[i], files[i], log, records[i] ? &*records[i] : nullptr});
    }
    writeFile(options.report, comparisonReport(logs, comparison, answer));
    note("overlay report: " + options.report);
}

}  // namespace

int compare(const CompareOptions& options) {
    for (const std::string& log : options.repeats) expectKind(log, {"log"});
    expectKind(options.tolerances, {"tolerances"});
    expectKind(options.envelope, {"envelope"});
    expectKind(options.score, {"score"});
    if (std::filesystem::is_directory(options.reference) || std::filesystem::is_directory(options.candidate))
        return compareFolders(options);
    for (const std::string& log : {options.reference, options.candidate}) expectKind(log, {"log", "folder"});
    if (options.update || !options.junit.empty()) {
        throw LoadError(
            {{"tread compare", 0, 0, "",
              "found --update or --junit beside two logs, expected two folders of runs; name the folders"}});
    }
    if (!options.envelope.empty() || !options.score.empty()) return judge(options);
    if (!options.repeats.empty() && options.report.empty()) {
        throw LoadError(
            {{"", 0, 0, "",
              "tread compare: found --repeat alone, expected --report, --envelope or --score beside it: the "
              "plain comparison judges one log"}});
    }
    const Log reference = readLog(options.reference);
    const Log candidate = readLog(options.candidate);
    const Tolerances tolerances = readTolerances(options.tolerances, reference);
    const Comparison comparison = tread::compare(reference, candidate, tolerances);
    if (!comparison.nothing.empty()) {
        throw LoadError({{"tread compare", 0, 0, "", "nothing was compared: " + comparison.nothing}});
    }
    const std::string words = text(comparison, std::max(kRows, comparison.differing()));
    if (!options.report.empty()) {
        writeReport(options, reference, candidate, comparison, words.substr(0, words.find('\n')));
    }
    if (options.json) {
        printJson(tread::json(comparison));
    } else {
        say(words, comparison.same ? Tone::good : Tone::bad);
    }
    return comparison.same ? kYes : kNo;
}

}  // namespace tread::program
