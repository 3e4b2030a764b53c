#include "run_all.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "accepting.h"
#include "answer.h"
#include "base/text/number_text.h"
#include "drive.h"
#include "kind_of_file.h"
#include "log/csv.h"
#include "output.h"
#include "plausibility.h"
#include "report/series_report.h"
#include "run/simulate.h"
#include "run_inputs.h"
#include "run_scenario.h"
#include "terminal.h"
#include "tread/problem.h"

namespace tread::program {
namespace {

std::vector<Path> scenariosIn(const Path& folder) {
    std::vector<Path> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        if (entry.path().extension() == ".yaml") files.push_back(entry.path());
    }
    if (error) throw FileError(fmt::format("cannot read the folder {}: {}", folder.string(), error.message()));
    if (files.empty()) {
        throw FileError(
            fmt::format("found no scenario (*.yaml) in the folder {}; name another with --all", folder.string()));
    }
    std::sort(files.begin(), files.end());
    return files;
}

// One scenario of the folder: its run, or the fault of its file.
struct Planned {
    std::string name;
    RunRecord record;
    std::string fault;                 // empty: none
    std::vector<Problem> implausible;  // numbers of car and scenario
};

// All faults of a file in one sentence: the first one, and the number of the others.
std::string sentenceOf(const LoadError& error) {
    const std::size_t more = error.problems().size() - 1;
    const std::string first = toText(error.problems().front());
    if (more == 0) return first;
    return fmt::format("{} (and {} more {}; `tread check` lists all)", first, more, more == 1 ? "fault" : "faults");
}

// All inputs are read before anything is driven. A faulty scenario does not stop the others. If none can be driven, the
// fault is probably in the car or in a setting, so the error of the first scenario is thrown.
std::vector<Planned> planned(const RunOptions& options) {
    std::vector<Planned> all;
    std::optional<LoadError> first;
    for (const Path& file : scenariosIn(options.all)) {
        RunOptions one = options;
        one.scenario = file.string();
        Planned plan{file.stem().string(), {}, "", {}};
        try {
            RunInputs inputs = readRunInputs(one);
            plan.record = std::move(inputs.record);
            plan.implausible = std::move(inputs.implausible);
        } catch (const LoadError& error) {
            plan.fault = sentenceOf(error);
            if (!first) first = error;
        }
        all.push_back(std::move(plan));
    }
    const auto faulty = [](const Planned& plan) { return !plan.fault.empty(); };
    if (std::all_of(all.begin(), all.end(), faulty)) throw LoadError(*first);
    std::vector<NamedScenario> named;
    for (const Planned& plan : all) named.push_back({plan.name, faulty(plan) ? nullptr : &plan.record.scenario});
    expectAllUsed(options.accept, named);
    return all;
}

// Row of one scenario on the overview page, and its part of the command's answer.
struct Outcome {
    Overview::Entry entry;
    nlohmann::json json;
};

Outcome failed(const std::string& name, const std::string& title, const std::string& why) {
    return {{name, title, fmt::format("failed: {}", why), {}, {}, "", false}, {{"scenario", name}, {"failure", why}}};
}

// Throws Interrupted.
Outcome drive(const Planned& plan, const Path& out, const TellShare& tell) {
    const std::string& name = plan.name;
    if (!plan.fault.empty()) return failed(name, name, plan.fault);
    const std::string& title = plan.record.scenario.title;
    try {
        Driven driven = driveScenario(plan.record, out / name, plan.implausible, tell);
        for (const Problem& warning : plan.implausible) driven.json["warnings"].push_back(toText(warning));
        return {{name, title, driven.answer, std::move(driven.metrics), driven.warnings, name + "/report.html", true,
                 driven.verdicts},
                {{"scenario", name}, {"result", std::move(driven.json)}}};
    } catch (const Interrupted&) {
        throw;
    } catch (const SimulationError& error) {
        return failed(name, title, withSuspects(error, plan.implausible));
    } catch (const std::runtime_error& error) {
        return failed(name, title, error.what());
    }
}

}  // namespace

int runAll(const RunOptions& options) {
    expectKind(options.all, {"folder"});
    const std::vector<Planned> plans = planned(options);
    const Path out = options.output.empty() ? Path("out") : Path(options.output);
    const OutputFolder output(out);
    listenToSignals();

    Overview overview;
    nlohmann::json list = nlohmann::json::array();
    std::string lines;
    std::vector<Verdict> verdicts;
    std::vector<JUnitCase> cases;
    {
        Progress progress(static_cast<double>(plans.size()), "scenarios");
        for (std::size_t i = 0; i < plans.size(); ++i) {
            try {
                Outcome outcome =
                    drive(plans[i], out, [&](double share) { progress.at(static_cast<double>(i) + share); });
                lines += fmt::format("  {:<28} {}\n", plans[i].name, outcome.entry.answer);
                const std::vector<Verdict>& own = outcome.entry.verdicts;
                for (const Verdict& verdict : own) lines += fmt::format("  {:<28} {}\n", "", text(verdict));
                verdicts.insert(verdicts.end(), own.begin(), own.end());
                const auto of_run = outcome.entry.driven
                                        ? junitCases(plans[i].name, own)
                                        : std::vector<JUnitCase>{{plans[i].name, "run", "", outcome.entry.answer}};
                cases.insert(cases.end(), of_run.begin(), of_run.end());
                list.push_back(std::move(outcome.json));
                overview.entries.push_back(std::move(outcome.entry));
            } catch (const Interrupted& error) {
                fmt::print(stderr, "tread run: {}: {}\n", plans[i].name, error.what());
                return stoppedStatus();
            }
        }
    }
    const auto readable = std::find_if(plans.begin(), plans.end(), [](const Planned& p) { return p.fault.empty(); });
    const auto driven = std::count_if(overview.entries.begin(), overview.entries.end(),
                                      [](const Overview::Entry& entry) { return entry.driven; });
    const std::string vehicle = readable->record.vehicle.name;
    overview.title = fmt::format("All manoeuvres of {}", vehicle);
    overview.answer =
        withVerdict(fmt::format("{} of {} scenarios driven with the {}", driven, plans.size(), vehicle), verdicts);
    overview.vehicle = vehicle;
    overview.version = readable->record.tread_version;
    writeFile(out / "index.html", overviewReport(overview));
    output.complete();
    if (!options.junit.empty()) writeFile(options.junit, junit("tread run", cases));
    if (options.json) {
        printJson({{"answer", overview.answer}, {"verdicts", tread::json(verdicts)}, {"scenarios", list}});
    } else {
        const bool all = driven == std::ssize(plans) && allMet(verdicts);
        say(fmt::format("{}\n{}Overview: {}\n", overview.answer, lines,
                        std::filesystem::absolute(out / "index.html").lexically_normal().string()),
            all ? Tone::good : Tone::bad);
    }
    if (std::any_of(plans.begin(), plans.end(), [](const Planned& p) { return !p.fault.empty(); })) return kBadInput;
    if (driven != std::ssize(plans)) return kRunFailed;
    return allMet(verdicts) ? kYes : kNo;
}

}  // namespace tread::program
