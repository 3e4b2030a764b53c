#include "run_all.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/number_text.h"
#include "drive.h"
#include "log/csv.h"
#include "output.h"
#include "progress.h"
#include "report/series_report.h"
#include "run/simulate.h"
#include "run_inputs.h"
#include "run_scenario.h"
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

}  // namespace

int runAll(const RunOptions& options) {
    // All inputs are read before anything is driven.
    std::vector<RunRecord> records;
    const std::vector<Path> files = scenariosIn(options.all);
    for (const Path& file : files) {
        RunOptions one = options;
        one.scenario = file.string();
        records.push_back(readRunInputs(one));
    }
    const Path out = options.output.empty() ? Path("out") : Path(options.output);
    listenToSignals();

    Overview overview;
    nlohmann::json list = nlohmann::json::array();
    std::string lines;
    std::size_t driven_count = 0;
    {
        Progress progress(static_cast<double>(files.size()), "scenarios");
        for (std::size_t i = 0; i < files.size(); ++i) {
            const std::string name = files[i].stem().string();
            Overview::Entry entry{name, records[i].scenario.title, "", {}, {}, name + "/report.html", true};
            nlohmann::json json{{"scenario", name}};
            try {
                const Driven driven = driveScenario(records[i], out / name,
                                                    [&](double share) { progress.at(static_cast<double>(i) + share); });
                entry.answer = driven.answer;
                entry.metrics = driven.metrics;
                entry.warnings = driven.warnings;
                json["result"] = driven.json;
                ++driven_count;
            } catch (const Interrupted& error) {
                fmt::print(stderr, "tread run: {}: {}\n", name, error.what());
                return stoppedStatus();
            } catch (const std::runtime_error& error) {
                entry = {name, entry.title, fmt::format("failed: {}", error.what()), {}, {}, "", false};
                json["failure"] = error.what();
            }
            lines += fmt::format("  {:<28} {}\n", name, entry.answer);
            list.push_back(std::move(json));
            overview.entries.push_back(std::move(entry));
        }
    }
    const std::string vehicle = records.front().vehicle.name;
    overview.title = fmt::format("All manoeuvres of {}", vehicle);
    overview.answer = fmt::format("{} of {} scenarios driven with the {}", driven_count, files.size(), vehicle);
    overview.vehicle = vehicle;
    overview.version = records.front().tread_version;
    writeFile(out / "index.html", overviewReport(overview));
    if (options.json) {
        printJson({{"answer", overview.answer}, {"scenarios", list}});
    } else {
        print(fmt::format("{}\n{}Overview: {}\n", overview.answer, lines,
                          std::filesystem::absolute(out / "index.html").lexically_normal().string()));
    }
    return driven_count == files.size() ? kYes : kRunFailed;
}

}  // namespace tread::program
