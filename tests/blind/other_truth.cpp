#include "blind/other_truth.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/numbers.h"
#include "diagnose/catalogue/effect.h"
#include "diagnose/model/parameter.h"
#include "recording/subject.h"

namespace other_car {
namespace {

using tread::diagnose::catalogue::Effect;
using tread::diagnose::model::Parameter;
using tread::recording::Subject;

using tread::diagnose::catalogue::Effect;
using tread::diagnose::catalogue::Knob;
using tread::diagnose::model::Parameter;
using tread::recording::Subject;

constexpr double kSmallest = 0.6, kLargest = 1.6;  // of the typical size

void addAxle(std::vector<SharedNumber>& all, const std::string& axle, Axle& a) {
    const auto same = [&](const char* path, double& value) { all.push_back({axle + path, {&value}, false}); };
    const auto factor = [&](const char* path, double& value) { all.push_back({axle + path, {&value}, true}); };
    factor(".track", a.track);
    factor(".unsprung_mass", a.unsprung_mass);
    factor(".wheel_inertia", a.wheel_inertia);
    same(".suspension.spring", a.spring);
    same(".suspension.anti_roll_bar", a.anti_roll_bar);
    same(".suspension.side_view_slope_braking", a.brake_support);
    same(".suspension.roll_centre_height", a.roll_axis);
    same(".suspension.toe_by_travel", a.toe_by_travel);
    same(".suspension.camber_by_travel", a.camber_by_travel);
    same(".suspension.steer_by_lateral_force", a.compliance_steer);
    factor(".tyre.lambda.Ky", a.tyre.stiffness);
    factor(".tyre.lambda.Kx", a.tyre.slip_stiffness);
    factor(".tyre.lambda.Ey", a.tyre.curvature);
    factor(".tyre.lambda.t", a.tyre.trail);
    factor(".tyre.lambda.Cz", a.tyre.radial_stiffness);
    factor(".tyre.parameters.cFy", a.tyre.carcass);
    factor(".tyre.parameters.cFx", a.tyre.carcass_x);
    factor(".tyre.parameters.pKy2", a.tyre.stiffness_load);
    same(".tyre.parameters.pDy2", a.tyre.friction_by_load);
    factor(".tyre.parameters.qy1", a.tyre.rolling_resistance);
    factor(".tyre.parameters.Re", a.tyre.rolling_radius);
    factor(".tyre.parameters.Ro", a.tyre.loaded_radius);
}

const SharedNumber* find(const std::vector<SharedNumber>& all, const std::string& path) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const SharedNumber& one) { return one.path == path; });
    return found == all.end() ? nullptr : &*found;
}

void change(const std::vector<SharedNumber>& all, const Parameter& parameter, double units) {
    for (const Parameter::Move& move : parameter.moves) {
        const SharedNumber* shared = find(all, move.path);
        if (!shared) continue;
        for (double* value : shared->values) {
            if (shared->by_factor) *value *= 1 + units * move.by / move.nominal;
            else *value += units * move.by;
        }
    }
}

double between(tread::Random& random, double low, double high) {
    return low + (high - low) * random.uniform();
}

struct Change {
    Parameter parameter;
    double units;
};

// Errors of everything that is known to a tolerance only.
std::vector<Change> errors(const Subject& nominal, tread::Random& random) {
    const double most = std::sqrt(3.0);  // of the uniform distribution, in its standard deviations
    std::vector<Change> all;
    for (const Parameter& uncertain : tread::diagnose::model::nuisances(nominal, {}))
        all.push_back({uncertain, std::clamp(between(random, -most, most), uncertain.lowest, uncertain.highest)});
    return all;
}

std::vector<Change> changesOf(const Effect& effect, const Subject& nominal, tread::Random& random) {
    const double size = between(random, kSmallest, kLargest);
    std::vector<Change> all;
    for (const Parameter& knob : tread::diagnose::model::knobsOf(effect, nominal)) {
        const double sign = knob.lowest == 0 ? 1 : knob.highest == 0 ? -1 : random.uniform() < 0.5 ? -1 : 1;
        all.push_back({knob, std::clamp(sign * size, knob.lowest, knob.highest)});
    }
    return all;
}

}  // namespace

std::vector<SharedNumber> sharedNumbers(Truth& truth) {
    std::vector<SharedNumber> all;
    Params& p = truth.car;
    const auto same = [&](const char* path, double& value) { all.push_back({path, {&value}, false}); };
    const auto factor = [&](const char* path, double& value) { all.push_back({path, {&value}, true}); };
    factor("mass", p.mass);
    factor("inertia.yaw", p.yaw_inertia);
    factor("inertia.roll", p.roll_inertia);
    factor("inertia.pitch", p.pitch_inertia);
    factor("wheelbase", p.wheelbase);
    same("front_axle_distance", p.front_distance);
    same("centre_of_gravity_height", p.height);
    addAxle(all, "front", p.front);
    addAxle(all, "rear", p.rear);
    factor("steering.ratio", p.steering_ratio);
    same("steering.delay", truth.steering_delay);
    same("steering.lag", p.steering_lag);
    factor("driveline.engine.torque_scale", p.drive_scale);
    factor("driveline.engine.drag_scale", p.drag_scale);
    factor("driveline.engine.inertia", p.engine_inertia);
    factor("brakes.full_pedal_torque", p.brake_torque);
    same("brakes.front_share", p.brake_front_share);
    same("brakes.delay", truth.brake_delay);
    same("brakes.lag", p.brake_lag);
    same("aero.drag_area", p.drag_area);
    same("aero.front_lift_area", p.front.lift_area);
    same("aero.rear_lift_area", p.rear.lift_area);
    same("wind.x", p.wind_x);
    same("wind.y", p.wind_y);
    same("road.grade", p.grade);
    same("road.bank", p.bank);
    factor("road.friction", p.road_friction);
    for (const tread::Number& number : tread::numbers(truth.instruments))
        all.push_back({"instruments." + number.path, {number.value}, false});
    return all;
}

std::vector<Effect> plantable(const std::vector<Effect>& effects, const tread::VehicleParams& nominal) {
    const Subject subject{.vehicle = nominal, .road = {}, .wind = {}, .instruments = {}};
    Truth any;
    const std::vector<SharedNumber> shared = sharedNumbers(any);
    std::vector<Effect> found;
    for (const Effect& effect : effects) {
        const std::vector<Parameter> knobs = tread::diagnose::model::knobsOf(effect, subject);
        const bool all = std::all_of(knobs.begin(), knobs.end(), [&](const Parameter& knob) {
            return std::all_of(knob.moves.begin(), knob.moves.end(),
                               [&](const Parameter::Move& move) { return find(shared, move.path) != nullptr; });
        });
        if (all && !knobs.empty()) found.push_back(effect);
    }
    return found;
}

Drawn draw(const Truth& known, const tread::VehicleParams& nominal, const std::vector<Effect>& effects,
           tread::CaseKind kind, tread::Random& random) {
    const Subject as_known{.vehicle = nominal, .road = {}, .wind = {}, .instruments = {}};
    const std::vector<Change> wrong = errors(as_known, random);
    std::vector<Change> planted;
    Drawn drawn{known, known, {}};
    drawn.key.kind = kind;
    if (kind != tread::CaseKind::none) {
        if (effects.empty()) throw std::invalid_argument("the other car can show none of these effects");
        const auto which = static_cast<std::size_t>(random.uniform() * static_cast<double>(effects.size()));
        drawn.key.effects = {effects[which].name};
        planted = changesOf(effects[which], as_known, random);
    }
    // The number at each path changes as the truth does.
    Subject as_drawn = as_known;
    const std::vector<SharedNumber> shared = sharedNumbers(drawn.truth);
    const auto make = [&](const std::vector<Change>& changes) {
        for (const auto& [parameter, units] : changes) {
            change(shared, parameter, units);
            move(as_drawn, parameter, units);
        }
    };
    make(wrong);
    drawn.before = drawn.truth;
    make(planted);
    for (const auto& [knob, units] : planted) {
        for (const Parameter::Move& move : knob.moves)
            drawn.key.numbers[move.path] = {move.nominal, *tread::recording::numberAt(as_drawn, move.path), units};
    }
    return drawn;
}

}  // namespace other_car
