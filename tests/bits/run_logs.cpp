// Writes the logs of all shipped scenarios and cars, whose bytes are the same on every machine (see bits.cmake).
//   run_logs ROOT OUT whole    the whole runs, in a Bullet world
//   run_logs ROOT OUT begin    the first seconds, by itself or in lanes: for emulators, which are slow
#include <algorithm>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/yaml/setting.h"
#include "log/csv.h"
#include "run/simulate.h"
#include "run/together.h"
#include "scenario/load.h"
#include "tread/load.h"
#include "vehicle/fields.h"

namespace tread {
namespace {

namespace fs = std::filesystem;

constexpr double kBegin = 2;  // s

struct Run {
    std::string car;
    fs::path scenario;
};

std::vector<fs::path> yamlFilesIn(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".yaml") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

// Every scenario, and every car.
std::vector<Run> allRuns(const fs::path& root) {
    const std::string usual = "compact", model_car = "dart";
    std::vector<Run> runs;
    for (const fs::path& file : yamlFilesIn(root / "scenarios")) runs.push_back({usual, file});
    for (const fs::path& file : yamlFilesIn(root / "tests" / "bits" / "scenarios")) runs.push_back({usual, file});
    for (const fs::path& file : yamlFilesIn(root / "scenarios" / "model_car")) runs.push_back({model_car, file});
    for (const fs::path& car : yamlFilesIn(root / "vehicles")) {
        const std::string name = car.stem().string();
        if (name != usual && name != model_car) runs.push_back({name, root / "scenarios" / "double_lane_change.yaml"});
    }
    return runs;
}

Log logOf(const VehicleParams& car, const Scenario& scenario, bool whole) {
    Log log;
    Recorder recorder = recorderInto(log);
    if (!whole) recorder.stop = [](double time) { return time >= kBegin; };
    try {
        simulate(car, scenario, recorder, {}, whole ? MovedBy::bullet : MovedBy::itself);
    } catch (const Interrupted&) {
        // The beginning is all that was wanted.
    }
    return log;
}

void writeAll(const fs::path& root, const fs::path& out, bool whole) {
    const std::vector<Run> runs = allRuns(root);
    drivenTogether(runs.size(), 0, [&](std::size_t i) {
        const Run& run = runs[i];
        const std::string name = run.scenario.stem().string();
        try {
            VehicleParams car = loadVehicle(root / "vehicles" / (run.car + ".yaml"));
            const Scenario scenario = loadScenario(run.scenario);
            applySettings(car, scenario.car_settings, name, [](std::string_view) { return std::string(); });
            const Log log = logOf(car, scenario, whole);
            fs::create_directories(out / run.car);
            writeLog(out / run.car / (name + ".csv"), log);
        } catch (const std::exception& error) {
            throw std::runtime_error(name + ", " + run.car + ": " + error.what());
        }
    });
}

}  // namespace
}  // namespace tread

int main(int argc, char** argv) {
    if (argc != 4) return 2;
    try {
        tread::writeAll(argv[1], argv[2], std::strcmp(argv[3], "whole") == 0);
    } catch (const std::exception& error) {
        std::cerr << "run_logs: " << error.what() << '\n';
        return 1;
    }
}
