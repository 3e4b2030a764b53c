// `tread run` in a folder of its own, with the compact car and a short scenario to start from.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/text/did_you_mean.h"
#include "cli/program.h"
#include "metrics/metrics.h"
#include "places/places.h"

namespace tread {

inline const std::string kSource = sourceFile();

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("the text has no " + from);
    return text.replace(at, from.size(), to);
}

// "line:column" of the first place where the words stand.
inline std::string placeOf(const std::string& text, const std::string& words) {
    const std::size_t at = text.find(words);
    if (at == std::string::npos) throw std::logic_error("the text has no " + words);
    const std::string before = text.substr(0, at);
    const std::size_t line_start = before.rfind('\n') == std::string::npos ? 0 : before.rfind('\n') + 1;
    return std::to_string(std::count(before.begin(), before.end(), '\n') + 1) + ":" +
           std::to_string(at - line_start + 1);
}

// Straight on for a moment: what the tests change.
inline const std::string kScenario = R"(title: A short way
start: {speed: 80 km/h}
phases:
  - name: straight
    until: {duration: 0.2 s}
)";

// A stop from low speed: a run of a few milliseconds that has metrics.
inline const std::string kShortStop = R"(title: A short stop
manoeuvre: straight_braking
start: {speed: 15 km/h}
phases:
  - {name: straight, until: {duration: 0.1 s}}
  - name: brake
    throttle: {constant: {value: 0}}
    clutch: {constant: {value: 1}}
    brake: {ramp: {to: 1, rate: 20}}
    until: {speed_below: 0.02, duration: 5 s}
)";

// How the car's text names its tyre.
inline const std::string kTyre = "tyre: " + kSource + "/vehicles/tyres/car_205_60R15.yaml";

// What stands in place of an unknown manoeuvre.
inline const std::string kManoeuvres = [] {
    std::vector<std::string_view> names;
    for (const Manoeuvre& known : manoeuvres()) names.push_back(known.name);
    return listed(names) + ", or no such line for a run without metrics";
}();

inline void expectStart(const std::string& text, const std::string& start) {
    EXPECT_EQ(text.substr(0, start.size()), start);
}

class TreadRun : public testing::Test {
protected:
    Scratch scratch;

    // The compact car, which finds its tyre from any folder, with a text replaced.
    static std::string carText(const std::string& from = "", const std::string& to = "") {
        std::string text = contentOf(kSource + "/vehicles/compact.yaml");
        for (int axle = 0; axle < 2; ++axle) {
            text = replaced(text, "tyre: tyres/", "tyre: " + kSource + "/vehicles/tyres/");
        }
        return replaced(text, from, to);
    }
    std::string car(const std::string& text = carText()) const { return scratch.file("car.yaml", text); }
    std::string scenario(const std::string& text = kScenario) const { return scratch.file("scenario.yaml", text); }
    std::string out(const std::string& name = "") const {
        return scratch.path("out") + (name.empty() ? "" : "/" + name);
    }

    std::vector<std::string> words(const std::vector<std::string>& options = {}) const {
        std::vector<std::string> all{"run", scratch.path("car.yaml"), scratch.path("scenario.yaml"), "-o", out()};
        all.insert(all.end(), options.begin(), options.end());
        return all;
    }
    Result run(const std::vector<std::string>& options = {}) const { return runProgram(words(options)); }

    std::vector<std::string> results() const {
        std::vector<std::string> names;
        if (!std::filesystem::exists(out())) return names;
        for (const auto& entry : std::filesystem::directory_iterator(out())) {
            names.push_back(entry.path().filename().string());
        }
        std::sort(names.begin(), names.end());
        return names;
    }

    // Bad input: one message, no answer, no folder.
    void expectRefused(const Result& result, const std::string& message) const {
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(result.err, message + "\n");
        EXPECT_FALSE(std::filesystem::exists(out()));
    }
    void expectCarRefused(const std::string& text, const std::string& at, const std::string& message) const {
        car(text);
        scenario();
        expectRefused(run(), scratch.path("car.yaml") + ":" + placeOf(text, at) + ": " + message);
    }
    void expectScenarioRefused(const std::string& text, const std::string& at, const std::string& message) const {
        car();
        scenario(text);
        expectRefused(run(), scratch.path("scenario.yaml") + ":" + placeOf(text, at) + ": " + message);
    }
};

using Names = std::vector<std::string>;
inline const Names kAllResults{"log.csv", "metrics.json", "report.html", "run.yaml"};
inline const Names kFailedResults{"log.incomplete.csv", "run.yaml"};

}  // namespace tread
