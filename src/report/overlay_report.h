// The report of a comparison: reference and candidate laid over each other, worst channels first.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "report/replay.h"

namespace tread {

struct ChannelOverlay {
    std::string name;
    std::string unit;               // SI
    std::vector<double> time;       // s; the differences are taken at these moments
    std::vector<double> reference;  // one per moment
    std::vector<double> candidate;
    std::vector<std::vector<double>> others = {};  // of further runs, one each; empty where it has no such channel
    double tolerance = 0;                          // largest allowed |candidate - reference|, in the unit
    double largest = 0;                            // |candidate - reference|
    double rms = 0;
    std::optional<double> r_squared = {};  // as in compare/compare.h
    bool no_fit = false;
    std::optional<double> first_time_out = {};  // s, when the tolerance is first exceeded
    bool ok = true;
};

struct OverlayReport {
    std::string title;
    std::string answer;          // the result in one sentence
    std::string reference_name;  // in the legends
    std::string candidate_name;
    std::vector<std::string> other_names = {};  // of further runs, which are drawn but not judged
    std::string version;
    bool ok = true;  // the verdict over all channels
    std::vector<ChannelOverlay> channels;
    std::vector<std::string> warnings = {};  // channels that only one log has, and the like
    std::vector<ReplayCar> cars = {};        // reference, candidate and the others
    ReplayScene scene = {};                  // in which they drive
    std::string reference_file = {};         // where the name does not tell it
    std::string candidate_file = {};
};

// The colour of a run: reference, candidate, others.
constexpr Colour overlayColour(std::size_t run) {
    constexpr std::array kOthers{Colour::green, Colour::purple, Colour::amber, Colour::sky};
    return run == 0 ? Colour::grey : run == 1 ? Colour::blue : kOthers[(run - 2) % kOthers.size()];
}

std::string overlayReport(const OverlayReport& content);

}  // namespace tread
