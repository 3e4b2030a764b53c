// Does a measurement lie within the boundaries around a simulation on a cross-plot, after ISO 19364?
//
// The standard defines boundaries around the simulated curve by an offset and a gain for both axes; measured points
// must lie between them. An ellipse with the half axes x_offset + x_gain |x| and y_offset + y_gain |y| is swept along
// the curve; the boundaries are its envelope. With time as x channel it is a tolerance for small shifts in time and
// level.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "log/log.h"
#include "tread/describe.h"

namespace tread {

struct EnvelopeTolerance {
    double x_offset = kRequired;
    double x_gain = 0;
    double y_offset = kRequired;
    double y_gain = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(x_offset), About{"unit of the x channel", "tolerance of x at x = 0", kPositive});
        field(TREAD_FIELD(x_gain), About{"-", "additional tolerance of x per magnitude of x", kNonNegative});
        field(TREAD_FIELD(y_offset), About{"unit of the y channel", "tolerance of y at y = 0", kPositive});
        field(TREAD_FIELD(y_gain), About{"-", "additional tolerance of y per magnitude of y", kNonNegative});
    }
};
static_assert(describesEveryMember<EnvelopeTolerance>());

struct EnvelopePoint {
    double x;
    double y;
};

struct EnvelopeJudgement {
    bool inside = false;          // every judged point lies within; false when there was none to judge
    std::size_t judged = 0;       // measured points beside the simulated curve
    std::size_t outside = 0;      // of these
    std::size_t not_covered = 0;  // measured points beyond the x range of the simulated curve, or not finite
    double worst = 0;             // distance from the curve over the tolerance, largest; 1 is on the boundary
    std::optional<double> first_outside_time;  // s, on the clock of the measurement
    std::vector<EnvelopePoint> top, bottom;    // the boundaries, for plots
};

// Channels are cross-plotted by name in both logs; throws std::invalid_argument when one is missing or the simulated
// curve is a single point.
EnvelopeJudgement judgeEnvelope(const Log& simulated, const Log& measured, std::string_view x_channel,
                                std::string_view y_channel, const EnvelopeTolerance& tolerance);

}  // namespace tread
