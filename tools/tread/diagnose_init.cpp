#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/text/number_text.h"
#include "diagnose_check.h"
#include "kind_of_file.h"
#include "output.h"
#include "recording/diagnosis_file.h"
#include "recording/driver_inputs.h"

namespace tread::program {
namespace {

using recording::DiagnosisFile;
using recording::readRecordings;

bool isLog(const Path& file) {
    const std::string extension = file.extension().string();
    return extension == ".csv" || extension == ".CSV" || extension == ".vbo" || extension == ".VBO" ||
           extension == ".mat" || extension == ".mcap";
}

std::vector<std::string> logsOf(const Path& folder) {
    if (!std::filesystem::is_directory(folder)) {
        throw LoadError({{folder.string(), 0, 0, "", "found no folder of this name, expected the folder of the logs"}});
    }
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.is_regular_file() && isLog(entry.path())) names.push_back(entry.path().filename().string());
    }
    if (names.empty()) {
        throw LoadError(
            {{folder.string(), 0, 0, "", "found no log in the folder, expected .csv, .vbo, .mat or .mcap files"}});
    }
    std::sort(names.begin(), names.end());
    return names;
}

// Contents of a log that decide how it can be replayed.
struct Recognised {
    std::vector<std::string> channels;
    std::string speed = "followed";
    std::string fault;  // reason why it cannot be read; empty if it can
};
Recognised recognise(const Path& folder, const std::string& name) {
    DiagnosisFile file;
    file.recordings = {{.log = (folder / name).string(), .name = name}};
    Recognised found;
    try {
        const Log log = readRecordings(file).logs.front();
        for (const Channel& channel : log.channels) found.channels.push_back(channel.name);
        if ((log.find("driver.throttle") || log.find("driver.brake")) && log.find("driveline.gear"))
            found.speed = "pedals";
        if (!recording::commandOf(log).empty()) found.speed = "command";
    } catch (const LoadError& error) {
        found.fault = error.problems().front().text;
    }
    return found;
}

std::string recordingText(const std::string& name, const Recognised& log, bool hold_out) {
    if (!log.fault.empty()) return fmt::format("  # {}: {}\n", name, log.fault);
    std::string text = fmt::format("  - log: {}\n    speed: {}\n", quote(name), log.speed);
    if (hold_out) text += "    hold_out: true  # used only to judge how far the gap shrinks\n";
    return text + fmt::format("    # channels: {}\n", fmt::join(log.channels, ", "));
}

}  // namespace

int initDiagnosis(const Path& folder, const std::string& vehicle) {
    expectKind(folder, {"folder"});
    expectKind(vehicle, {"vehicle"});
    const std::vector<std::string> names = logsOf(folder);
    const Path file = folder / "diagnosis.yaml";
    if (std::filesystem::exists(file))
        throw LoadError(
            {{file.string(), 0, 0, "", "exists already, expected no such file; move or delete it to start again"}});

    std::string recordings;
    std::size_t usable = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Recognised log = recognise(folder, names[i]);
        usable += log.fault.empty();
        recordings += recordingText(names[i], log, names.size() > 2 && i + 1 == names.size());
    }
    const std::string car = vehicle.empty() ? "vehicle.yaml  # replace by the file of the nominal car"
                                            : std::filesystem::absolute(vehicle).lexically_normal().string();
    writeFile(
        file.string(),
        fmt::format("# Diagnosis of the logs in this folder; `tread describe diagnosis` lists all settings.\n"
                    "vehicle: {}\n"
                    "recordings:\n{}"
                    "# tolerances:  # how accurately numbers of the car are known, where the defaults do not apply\n"
                    "#   - {{path: mass, relative: 0.01}}\n",
                    car, recordings));
    say(fmt::format("{} of {} logs can be read; wrote {}{}\n", usable, names.size(), file.string(),
                    vehicle.empty() ? "; enter the vehicle there" : ""));
    return usable > 0 ? kYes : kBadInput;
}

}  // namespace tread::program
