#include "compare_folders.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/text/text_file.h"
#include "base/yaml/position.h"
#include "base/yaml/read.h"
#include "log/csv.h"
#include "output.h"
#include "output_folder.h"
#include "report/folders_report.h"
#include "report/junit.h"
#include "store/result_folder.h"

namespace tread::program {
namespace {

// What makes a folder a run, and what a baseline keeps of it: all but the page.
constexpr std::array kKept{"run.yaml", "log.csv", "metrics.json", "series.csv"};

bool isRun(const Path& folder) {
    return isIncomplete(folder) || std::any_of(kKept.begin(), kKept.end(), [&](const char* name) {
               return std::filesystem::exists(folder / name);
           });
}

// The runs in a folder and below it, by their names relative to it; the folder itself may be one.
std::map<std::string, Path> runsIn(const Path& root) {
    std::map<std::string, Path> runs;
    std::error_code error;
    if (isRun(root)) runs["."] = root;
    std::filesystem::recursive_directory_iterator walk(root, error);
    for (; !error && walk != std::filesystem::recursive_directory_iterator(); walk.increment(error)) {
        if (walk->is_directory() && isRun(walk->path()))
            runs[walk->path().lexically_relative(root).generic_string()] = walk->path();
    }
    if (error) throw FileError(fmt::format("cannot read the folder {}: {}", root.string(), error.message()));
    return runs;
}

// What becomes a baseline is whole. Throws LoadError.
void expectWholeRuns(const std::map<std::string, Path>& runs) {
    for (const auto& [name, folder] : runs) {
        if (!isIncomplete(folder)) continue;
        throw LoadError({{folder.string(), 0, 0, "",
                          "is incomplete, expected a whole run for the baseline: its run was killed or has not ended; "
                          "run it again"}});
    }
}

// Throws LoadError. None without the file.
std::vector<MetricValue> metricsIn(const Path& folder) {
    const Path file = folder / "metrics.json";
    if (!std::filesystem::exists(file)) return {};
    std::string fault;
    const auto text = readTextFile(file.string(), fault);
    if (!text) throw LoadError({{file.string(), 0, 0, "", fault}});
    const nlohmann::json content = nlohmann::json::parse(*text, nullptr, false);
    std::vector<MetricValue> found;
    try {
        for (const nlohmann::json& metric : content.at("metrics")) {
            const nlohmann::json& value = metric.at("value");
            found.push_back({metric.at("name").get<std::string>(),
                             value.is_null() ? std::nullopt : std::optional(value.get<double>()),
                             metric.at("unit").get<std::string>()});
        }
    } catch (const nlohmann::json::exception&) {
        throw LoadError({{file.string(), 0, 0, "",
                          "found no metrics as tread writes them, expected {\"metrics\": [{\"name\", \"value\", "
                          "\"unit\"}, ...]}; run the scenario again"}});
    }
    return found;
}

class FolderComparison {
public:
    explicit FolderComparison(const CompareOptions& options)
        : options_(options),
          tolerances_(options.tolerances.empty() ? Tolerances{} : readYaml<Tolerances>(options.tolerances)) {}

    std::vector<ComparedRun> compare(const std::map<std::string, Path>& reference,
                                     const std::map<std::string, Path>& candidate) {
        std::vector<ComparedRun> runs;
        for (const auto& [name, folder] : reference) {
            const auto there = candidate.find(name);
            runs.push_back(there == candidate.end() ? ComparedRun{name, "The run is only in the reference.", true}
                                                    : compareRun(name, folder, there->second));
        }
        for (const auto& [name, folder] : candidate) {
            if (!reference.contains(name)) runs.push_back({name, "The run is only in the new folder.", true});
        }
        throwIfAny(problems_);
        return runs;
    }

private:
    ComparedRun compareRun(const std::string& name, const Path& reference, const Path& candidate) {
        for (const Path& folder : {reference, candidate}) {
            if (!isIncomplete(folder)) continue;
            return {
                name,
                fmt::format("{} is incomplete: its run was killed or has not ended. Run it again.", folder.string()),
                true};
        }
        ComparedRun run{name, ""};
        std::string nothing = "it has no log and no metrics";
        const bool here = std::filesystem::exists(reference / "log.csv");
        const bool there = std::filesystem::exists(candidate / "log.csv");
        if (here && there) {
            const Log log = readLog((reference / "log.csv").string());
            for (const ToleranceFault& fault : unitFaults(tolerances_, log)) complain(fault);
            run.channels = tread::compare(log, readLog((candidate / "log.csv").string()), tolerances_);
            run.has_channels = run.channels.nothing.empty();
            if (!run.has_channels) nothing = run.channels.nothing;
        } else if (here != there) {
            return {name, fmt::format("The run has no log.csv in the {}.", here ? "new folder" : "reference"), true};
        }
        const std::vector<MetricValue> wanted = metricsIn(reference);
        for (const MetricValue& metric : wanted) {
            if (const auto fault = unitFault(tolerances_, metric.name, metric.unit)) complain(*fault);
        }
        run.metrics = compareMetrics(wanted, metricsIn(candidate), tolerances_);
        if (!run.has_channels && run.metrics.empty()) {
            run.problem = fmt::format("Nothing was compared: {}.", nothing);
            run.failed = true;
        }
        return run;
    }

    void complain(const ToleranceFault& fault) {
        const TextPosition at = positionOfValue(options_.tolerances, fault.path);
        const auto known = [&](const Problem& problem) { return problem.path == fault.path; };
        if (std::none_of(problems_.begin(), problems_.end(), known))
            problems_.push_back({options_.tolerances, at.line, at.column, fault.path, fault.text});
    }

    const CompareOptions& options_;
    Tolerances tolerances_;
    std::vector<Problem> problems_;
};

std::string answerOf(const std::vector<ComparedRun>& runs) {
    const auto different = std::count_if(runs.begin(), runs.end(), [](const auto& run) { return !run.same(); });
    if (different > 0) return fmt::format("Different: {} of {} runs", different, runs.size());
    std::size_t channels = 0, metrics = 0;
    for (const ComparedRun& run : runs) {
        channels += run.channels.channels.size();
        metrics += run.metrics.size();
    }
    return fmt::format("Same within tolerance: {} run{}, {} channels, {} metrics", runs.size(),
                       runs.size() == 1 ? "" : "s", channels, metrics);
}

std::string textOf(const std::string& answer, const std::vector<ComparedRun>& runs) {
    std::string out = answer + "\n";
    for (const ComparedRun& run : runs) {
        out += fmt::format("  {:<28} {}\n", run.name, run.same() ? "same" : "different");
        for (const std::string& difference : differences(run)) out += fmt::format("    {}\n", difference);
    }
    return out;
}

nlohmann::json jsonOf(const std::string& answer, const std::vector<ComparedRun>& runs) {
    nlohmann::json list = nlohmann::json::array();
    bool same = true;
    for (const ComparedRun& run : runs) {
        same = same && run.same();
        list.push_back({{"run", run.name},
                        {"same", run.same()},
                        {"differences", differences(run)},
                        {"channels", run.has_channels ? tread::json(run.channels) : nlohmann::json(nullptr)},
                        {"metrics", tread::json(run.metrics)}});
    }
    return {{"answer", answer}, {"same", same}, {"runs", list}};
}

std::vector<JUnitCase> casesOf(const std::vector<ComparedRun>& runs) {
    std::vector<JUnitCase> cases;
    for (const ComparedRun& run : runs) {
        std::string words;
        for (const std::string& difference : differences(run)) words += (words.empty() ? "" : " ") + difference;
        cases.push_back({"compare", run.name, run.same() ? "" : words});
    }
    return cases;
}

void copyRun(const Path& from, const Path& to) {
    const OutputFolder output(to);
    for (const char* name : kKept) {
        if (std::filesystem::exists(from / name)) writeFile(to / name, readBytes(from / name));
        else output.remove(name);
    }
    output.complete();
}

// Of a run that is no more: its files, and its folder unless something else is in it.
void removeRun(const Path& folder) {
    std::error_code error;
    for (const char* name : kKept) std::filesystem::remove(folder / name, error);
    if (std::filesystem::is_empty(folder, error)) std::filesystem::remove(folder, error);
}

// Copies what differs, so that files of a baseline that is under version control change only where they must.
int update(const CompareOptions& options, const std::vector<ComparedRun>& runs,
           const std::map<std::string, Path>& reference, const std::map<std::string, Path>& candidate) {
    std::size_t changed = 0;
    for (const ComparedRun& run : runs) {
        if (run.same()) continue;
        const auto from = candidate.find(run.name);
        if (from == candidate.end()) {
            removeRun(reference.at(run.name));
        } else {
            copyRun(from->second, Path(options.reference) / run.name);
        }
        ++changed;
    }
    note(fmt::format("updated {}: {} of {} runs", options.reference, changed, runs.size()));
    return kYes;
}

void expectOptionsOfFolders(const CompareOptions& options) {
    const auto refuse = [](const std::string& text) { throw LoadError({{"tread compare", 0, 0, "", text}}); };
    if (!options.envelope.empty() || !options.score.empty() || !options.repeats.empty())
        refuse("found --envelope, --score or --repeat beside a folder, expected two logs; name the logs");
    const auto expectFolder = [&](const std::string& folder) {
        if (std::filesystem::is_directory(folder)) return;
        refuse("found " + folder + ", which is not a folder, expected two logs or two folders of runs");
    };
    expectFolder(options.candidate);
    const bool first_baseline = options.update && !std::filesystem::exists(options.reference);
    if (!first_baseline) expectFolder(options.reference);
}

}  // namespace

int compareFolders(const CompareOptions& options) {
    expectOptionsOfFolders(options);
    std::map<std::string, Path> reference;
    if (std::filesystem::exists(options.reference)) reference = runsIn(options.reference);
    const std::map<std::string, Path> candidate = runsIn(options.candidate);
    if (options.update) expectWholeRuns(candidate);
    const std::vector<ComparedRun> runs = FolderComparison(options).compare(reference, candidate);
    const auto compared = std::count_if(runs.begin(), runs.end(), [](const auto& run) { return run.compared(); });
    if (compared == 0 && !(options.update && !candidate.empty())) {
        throw LoadError(
            {{"tread compare", 0, 0, "",
              runs.empty() ? fmt::format("nothing was compared: found no run in {} and {}, expected folders "
                                         "that `tread run` has written",
                                         options.reference, options.candidate)
                           : fmt::format("nothing was compared: none of {} runs ({}, ...) could be compared. {}",
                                         runs.size(), runs.front().name, runs.front().problem)}});
    }
    const bool same = std::all_of(runs.begin(), runs.end(), [](const auto& run) { return run.same(); });
    const std::string answer = answerOf(runs);
    if (!options.report.empty()) {
        writeFile(options.report, foldersReport({.answer = answer,
                                                 .reference = options.reference,
                                                 .candidate = options.candidate,
                                                 .version = TREAD_VERSION,
                                                 .ok = same,
                                                 .runs = runs}));
    }
    if (!options.junit.empty()) writeFile(options.junit, junit("tread compare", casesOf(runs)));
    if (options.json) {
        printJson(jsonOf(answer, runs));
    } else {
        say(textOf(answer, runs), same ? Tone::good : Tone::bad);
    }
    if (options.update) return update(options, runs, reference, candidate);
    return same ? kYes : kNo;
}

}  // namespace tread::program
