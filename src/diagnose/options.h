// How a diagnosis is carried out: what does not change its answer, but for the manoeuvres among which to choose.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "recording/replay.h"

namespace tread::diagnose {

// A manoeuvre that could be driven next, under the name by which the user knows it.
struct PossibleDrive {
    std::string name;
    Scenario scenario;
};

// Told how much is done, from 0 to 1, and what is under way.
using Progress = std::function<void(double, const std::string&)>;

struct Options {
    recording::Simulate simulate = [](const VehicleParams& vehicle, const Scenario& scenario, const Recorder& recorder,
                                      const Pushing& pushing) {
        tread::simulate(vehicle, scenario, recorder, pushing);
    };
    int threads = 0;                             // 0: one per core
    std::filesystem::path cache{};               // folder of the sensitivities of the nominal car; empty: none
    std::vector<PossibleDrive> possible_next{};  // none: what to drive next is not asked
    Progress progress = [](double, const std::string&) {};
};

// A part of the work, from one share of the whole to another.
inline Progress partOf(const Progress& whole, double from, double to) {
    return [=](double share, const std::string& what) { whole(from + (to - from) * share, what); };
}

}  // namespace tread::diagnose
