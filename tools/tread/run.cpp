#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "accepting.h"
#include "commands.h"
#include "output.h"
#include "plausibility.h"
#include "run/simulate.h"
#include "run_all.h"
#include "run_inputs.h"
#include "run_scenario.h"
#include "scenario/load.h"
#include "series/series.h"
#include "terminal.h"
#include "tread/problem.h"

namespace tread::program {
namespace {

void show(const Driven& driven, const RunOptions& options, const Path& folder) {
    for (const std::string& warning : driven.warnings) warn(warning);
    if (options.json) {
        printJson(driven.json);
        return;
    }
    std::string text = driven.answer + "\n";
    std::size_t width = 0;
    for (const Metric& m : driven.metrics) width = std::max(width, titleOf(m).size());
    for (const Metric& m : driven.metrics) {
        const std::string value = std::isnan(m.value) ? "undefined" : fmt::format("{:.5g}", m.value);
        text += fmt::format("  {:<{}} {:>12} {:<10} {}\n", titleOf(m), width, value, m.unit, m.name);
    }
    for (const Verdict& verdict : driven.verdicts) text += fmt::format("Verdict: {}\n", tread::text(verdict));
    text += fmt::format("Report: {}\n", std::filesystem::absolute(folder / "report.html").lexically_normal().string());
    say(text, toneOf(driven.verdicts));
}

void writeJUnit(const RunOptions& options, const std::vector<JUnitCase>& cases) {
    if (!options.junit.empty()) writeFile(options.junit, junit("tread run", cases));
}

int failed(const RunOptions& options, const std::string& name, const std::string& why) {
    fmt::print(stderr, "tread run: {}\n", why);
    writeJUnit(options, {{name, "run", "", why}});
    return kRunFailed;
}

}  // namespace

int run(const RunOptions& options) {
    if (!options.all.empty()) return runAll(options);
    if (options.scenario.empty()) {
        throw LoadError(
            {{"tread run", 0, 0, "", "found no scenario, expected a file or --all with a folder of scenarios"}});
    }
    const auto [record, implausible] = readRunInputs(options);
    const Path folder = options.output.empty() ? Path("out") / Path(options.scenario).stem() : Path(options.output);
    const std::string name = Path(options.scenario).stem().string();
    bool accepted = true;
    listenToSignals();
    try {
        const double longest = longestDuration(record.scenario);
        Progress progress(longest, "s");
        Driven driven = driveScenario(record, folder, implausible, [&](double share) { progress.at(share * longest); });
        for (const Problem& warning : implausible) driven.json["warnings"].push_back(toText(warning));
        show(driven, options, folder);
        writeJUnit(options, junitCases(name, driven.verdicts));
        accepted = allMet(driven.verdicts);
    } catch (const Interrupted& error) {
        fmt::print(stderr, "tread run: {}\n", error.what());
        return stoppedStatus();
    } catch (const SimulationError& error) {
        return failed(options, name, withSuspects(error, implausible));
    } catch (const SeriesError& error) {
        return failed(options, name, error.what());
    }
    return accepted ? kYes : kNo;
}

}  // namespace tread::program
