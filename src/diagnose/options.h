// How a diagnosis is carried out. Apart from the manoeuvres to choose the next drive from, nothing here changes its
// answer.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "recording/replay.h"

namespace tread::diagnose {

// A manoeuvre that could be driven next, with the name under which the user knows it.
struct PossibleDrive {
    std::string name;
    Scenario scenario;
};

// Called with the share of the work that is done, from 0 to 1, and the name of the current step.
using Progress = std::function<void(double, const std::string&)>;

struct Options {
    recording::Simulate simulate = {};          // empty: that of src/run
    std::function<void()> before_each = [] {};  // called before each simulation; what it throws ends the diagnosis
    int threads = 0;                            // number of threads; 0: one per core
    std::filesystem::path cache{};  // folder in which the sensitivities of the nominal car are kept; empty: none
    std::vector<PossibleDrive> possible_next{};  // manoeuvres to choose from; empty: no next drive is proposed
    Progress progress = [](double, const std::string&) {};
};

// Progress of a part of the work that takes the whole from the share `from` to the share `to`.
inline Progress partOf(const Progress& whole, double from, double to) {
    return [=](double share, const std::string& what) { whole(from + (to - from) * share, what); };
}

}  // namespace tread::diagnose
