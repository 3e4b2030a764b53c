#include "blind/shown.h"

#include "blind/gauges.h"
#include "blind/measure.h"
#include "diagnose/catalogue/effect.h"
#include "run/simulate.h"

namespace tread {
namespace {

using diagnose::catalogue::Direction;
using diagnose::catalogue::Effect;
using diagnose::catalogue::Knob;

// Sum of squares of what all readings change by, in units of their noise. An effect that shows with less vanishes in
// what is not known of the car.
constexpr double kShown = 200;

double change(const Log& a, const Log& b) {
    double sum = 0;
    for (const Gauge& gauge : gauges()) {
        const auto &x = a.find(gauge.channel)->values, &y = b.find(gauge.channel)->values;
        for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i)
            sum += (x[i] - y[i]) * (x[i] - y[i]) / (gauge.noise * gauge.noise);
    }
    return sum;
}

}  // namespace

std::vector<Effect> shownEffects(const VehicleParams& nominal, const std::vector<Effect>& effects,
                                 const std::vector<Drive>& drives) {
    Truth as_known;
    as_known.car.vehicle = nominal;
    std::vector<Log> known;
    for (const Drive& drive : drives) known.push_back(measure(as_known, drive, 1, kIdeal));

    std::vector<Effect> shown;
    for (const Effect& effect : effects) {
        Truth truth = as_known;
        for (const Knob& knob : effect.knobs)
            move(truth.car, knob, knob.direction == Direction::down ? -knob.typical : knob.typical);
        double sum = 0;
        for (std::size_t i = 0; i < drives.size() && sum < kShown; ++i) {
            if (!drives[i].hold_out) sum += change(measure(truth, drives[i], 1, kIdeal), known[i]);
        }
        if (sum >= kShown) shown.push_back(effect);
    }
    return shown;
}

}  // namespace tread
