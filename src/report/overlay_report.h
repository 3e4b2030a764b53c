// The report of a comparison: reference and candidate laid over each other, worst channels first.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tread {

struct ChannelOverlay {
    std::string name;
    std::string unit;               // SI
    std::vector<double> time;       // s; the differences are taken at these moments
    std::vector<double> reference;  // one per moment
    std::vector<double> candidate;
    double tolerance = 0;  // largest allowed |candidate - reference|, in the unit
    double largest = 0;    // |candidate - reference|
    double rms = 0;
    std::optional<double> r_squared = {};       // share of the reference's variance that the candidate explains
    std::optional<double> first_time_out = {};  // s, when the tolerance is first exceeded
    bool ok = true;
};

struct OverlayReport {
    std::string title;
    std::string answer;  // the result in one sentence
    std::string reference_name;
    std::string candidate_name;
    std::string version;
    bool ok = true;  // the verdict over all channels
    std::vector<ChannelOverlay> channels;
    std::vector<std::string> warnings = {};  // channels that only one log has, and the like
};

std::string overlayReport(const OverlayReport& content);

}  // namespace tread
