#include "blind/detectability/detectable_effects.h"

#include "blind/drives/measure.h"
#include "blind/world/instruments.h"
#include "diagnose/catalogue/effect.h"
#include "run/simulate.h"

namespace tread::blind::detectability {
namespace {

using diagnose::catalogue::Direction;
using diagnose::catalogue::Effect;
using diagnose::catalogue::Knob;
using drives::Drive;
using drives::kIdeal;
using drives::measure;
using world::InstrumentSheet;
using world::instrumentSheets;
using world::Truth;

// Least sum of squared changes of all readings over their noise. The tolerances of the car hide anything smaller.
constexpr double kLeastChange = 200;

double change(const Log& a, const Log& b) {
    double sum = 0;
    for (const InstrumentSheet& sheet : instrumentSheets()) {
        const auto &x = a.find(sheet.channel)->values, &y = b.find(sheet.channel)->values;
        for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i)
            sum += (x[i] - y[i]) * (x[i] - y[i]) / (sheet.noise * sheet.noise);
    }
    return sum;
}

}  // namespace

std::vector<Effect> detectableEffects(const VehicleParams& nominal, const std::vector<Effect>& effects,
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
        for (std::size_t i = 0; i < drives.size() && sum < kLeastChange; ++i) {
            if (!drives[i].hold_out) sum += change(measure(truth, drives[i], 1, kIdeal), known[i]);
        }
        if (sum >= kLeastChange) shown.push_back(effect);
    }
    return shown;
}

}  // namespace tread::blind::detectability
