#include <fmt/format.h>

#include <cmath>

#include "commands.h"
#include "output.h"
#include "progress.h"
#include "run/simulate.h"
#include "run_all.h"
#include "run_inputs.h"
#include "run_scenario.h"
#include "scenario/load.h"
#include "series/series.h"
#include "tread/problem.h"

namespace tread::program {
namespace {

void show(const Driven& driven, const RunOptions& options, const Path& folder) {
    for (const std::string& warning : driven.warnings) fmt::print(stderr, "warning: {}\n", warning);
    if (options.json) {
        printJson(driven.json);
        return;
    }
    std::string text = driven.answer + "\n";
    for (const Metric& m : driven.metrics) {
        const std::string value = std::isnan(m.value) ? "undefined" : fmt::format("{:.5g}", m.value);
        text += fmt::format("  {:<36} {:>12} {}\n", m.name, value, m.unit);
    }
    text += fmt::format("Report: {}\n", std::filesystem::absolute(folder / "report.html").lexically_normal().string());
    print(text);
}

}  // namespace

int run(const RunOptions& options) {
    if (!options.all.empty()) return runAll(options);
    if (options.scenario.empty()) {
        throw LoadError(
            {{"tread run", 0, 0, "", "found no scenario, expected a file or --all with a folder of scenarios"}});
    }
    const RunRecord record = readRunInputs(options);
    const Path folder = options.output.empty() ? Path("out") / Path(options.scenario).stem() : Path(options.output);
    listenToSignals();
    try {
        const double longest = longestDuration(record.scenario);
        Progress progress(longest, "s");
        const Driven driven = driveScenario(record, folder, [&](double share) { progress.at(share * longest); });
        show(driven, options, folder);
    } catch (const Interrupted& error) {
        fmt::print(stderr, "tread run: {}\n", error.what());
        return stoppedStatus();
    } catch (const SimulationError& error) {
        fmt::print(stderr, "tread run: {}\n", error.what());
        return kRunFailed;
    } catch (const SeriesError& error) {
        fmt::print(stderr, "tread run: {}\n", error.what());
        return kRunFailed;
    }
    return kYes;
}

}  // namespace tread::program
