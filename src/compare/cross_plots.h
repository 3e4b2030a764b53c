// A simulation judged against measurements with the tolerance envelopes of ISO 19364: on each cross-plot the measured
// points must lie within boundaries around the simulated curve.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "compare/envelope.h"
#include "compare/score.h"

namespace tread {

struct CrossPlot {
    std::string channel;
    std::string against = "chassis.ay";
    EnvelopeTolerance tolerance;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(channel), About{"", "channel that is judged: the y axis"});
        field(TREAD_FIELD(against), About{"", "channel of the x axis"});
        field(TREAD_FIELD(tolerance), About{"", "half axes of the ellipse that is swept along the simulated curve"});
    }
};
static_assert(describesEveryMember<CrossPlot>());

// Steering wheel and lateral acceleration: the defaults of TU Munich's VVUQ framework for ISO 19364 (5 deg and 3 %, 0.1
// m/s2 and 6 %). For sideslip and roll the standard's numbers were not at hand: 0.3 deg and 0.2 deg with 6 % are
// tread's choice.
inline std::vector<CrossPlot> iso19364CrossPlots() {
    constexpr double kDegree = 0.017453292519943295;  // rad
    return {{"driver.steering_wheel_angle", "chassis.ay", {0.1, 0.06, 5 * kDegree, 0.03}},
            {"chassis.sideslip", "chassis.ay", {0.1, 0.06, 0.3 * kDegree, 0.06}},
            {"chassis.roll", "chassis.ay", {0.1, 0.06, 0.2 * kDegree, 0.06}}};
}

struct CrossPlots {
    std::vector<CrossPlot> plots = iso19364CrossPlots();

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(plots), About{"", "cross-plots and their tolerances"});
    }
};
static_assert(describesEveryMember<CrossPlots>());

struct CrossPlotJudgement {
    CrossPlot plot;
    std::string measurement;
    EnvelopeJudgement envelope;
};

struct CrossPlotResult {
    bool inside = false;  // every measured point of every plot, and there was one of each
    std::vector<CrossPlotJudgement> plots;
    std::vector<std::string> notes;  // what was not judged and why, one sentence each
};

CrossPlotResult judgeCrossPlots(const Log& simulated, const std::vector<NamedLog>& measured, const CrossPlots& plots);

// First line: the answer in words.
std::string text(const CrossPlotResult& result);
nlohmann::json json(const CrossPlotResult& result);

}  // namespace tread
