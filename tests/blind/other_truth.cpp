#include "blind/other_truth.h"

#include <algorithm>

#include "base/fields/numbers.h"
#include "diagnose/catalogue/effect.h"
#include "recording/subject.h"

namespace other_car {
namespace {

using tread::diagnose::catalogue::Effect;
using tread::diagnose::catalogue::Knob;
using tread::recording::Subject;

void addAxle(std::vector<SharedNumber>& all, const std::string& axle, Axle& a) {
    const auto same = [&](const char* path, double& value) { all.push_back({axle + path, &value, false}); };
    const auto factor = [&](const char* path, double& value) { all.push_back({axle + path, &value, true}); };
    factor(".track", a.track);
    factor(".unsprung_mass", a.unsprung_mass);
    factor(".wheel_inertia", a.wheel_inertia);
    same(".suspension.spring", a.spring);
    same(".suspension.anti_roll_bar", a.anti_roll_bar);
    for (const char* path : {".suspension.damper.bump", ".suspension.damper.rebound"})
        all.push_back({axle + path, &a.damping, false, 0.5});  // follows the mean of both
    same(".suspension.side_view_slope_braking", a.brake_support);
    same(".suspension.roll_centre_height", a.roll_axis);
    same(".suspension.toe", a.toe);
    same(".suspension.toe_by_travel", a.toe_by_travel);
    same(".suspension.camber", a.camber);
    same(".suspension.camber_by_travel", a.camber_by_travel);
    same(".suspension.steer_by_lateral_force", a.compliance_steer);
    factor(".tyre.lambda.Ky", a.tyre.stiffness);
    factor(".tyre.lambda.Kx", a.tyre.slip_stiffness);
    factor(".tyre.lambda.muy", a.tyre.friction);
    factor(".tyre.lambda.Ey", a.tyre.curvature);
    factor(".tyre.lambda.t", a.tyre.trail);
    factor(".tyre.parameters.cFy", a.tyre.carcass);
    factor(".tyre.parameters.cFx", a.tyre.carcass_x);
    factor(".tyre.parameters.pKy2", a.tyre.stiffness_load);
    same(".tyre.parameters.pDy2", a.tyre.friction_by_load);
    factor(".tyre.parameters.qy1", a.tyre.rolling_resistance);
    factor(".tyre.parameters.Re", a.tyre.rolling_radius);
    same(".tyre.parameters.pRe1", a.tyre.rolling_radius_by_load);
    factor(".tyre.parameters.Ro", a.tyre.loaded_radius);
}

void addWheel(std::vector<SharedNumber>& all, const std::string& wheel, WheelFault& fault) {
    all.push_back({wheel + ".cornering_stiffness", &fault.stiffness, true});
    all.push_back({wheel + ".slip_stiffness", &fault.slip_stiffness, true});
    all.push_back({wheel + ".grip", &fault.friction, true});
    all.push_back({wheel + ".brake_drag", &fault.drag_torque, false});
}

}  // namespace

std::vector<SharedNumber> sharedNumbers(Truth& truth) {
    std::vector<SharedNumber> all;
    Params& p = truth.car;
    const auto same = [&](const char* path, double& value) { all.push_back({path, &value, false}); };
    const auto factor = [&](const char* path, double& value) { all.push_back({path, &value, true}); };
    factor("mass", p.mass);
    factor("inertia.yaw", p.yaw_inertia);
    factor("inertia.roll", p.roll_inertia);
    factor("inertia.pitch", p.pitch_inertia);
    factor("wheelbase", p.wheelbase);
    same("front_axle_distance", p.front_distance);
    same("centre_of_gravity_height", p.height);
    addAxle(all, "front", p.front);
    addAxle(all, "rear", p.rear);
    addWheel(all, "front.left", p.wheels[0]);
    addWheel(all, "front.right", p.wheels[1]);
    addWheel(all, "rear.left", p.wheels[2]);
    addWheel(all, "rear.right", p.wheels[3]);
    factor("steering.ratio", p.steering_ratio);
    same("steering.delay", truth.steering_delay);
    same("steering.lag", p.steering_lag);
    factor("driveline.engine.torque_scale", p.drive_scale);
    factor("driveline.engine.drag_scale", p.drag_scale);
    factor("driveline.engine.inertia", p.engine_inertia);
    factor("driveline.gearbox.efficiency", p.drive_efficiency);
    factor("brakes.full_pedal_torque", p.brake_torque);
    same("brakes.front_share", p.brake_front_share);
    same("brakes.delay", truth.brake_delay);
    same("brakes.lag", p.brake_lag);
    same("aero.drag_area", p.drag_area);
    same("aero.front_lift_area", p.front.lift_area);
    same("aero.rear_lift_area", p.rear.lift_area);
    factor("aero.air_density", p.air_density);
    same("wind.x", p.wind_x);
    same("wind.y", p.wind_y);
    same("road.grade", p.grade);
    same("road.bank", p.bank);
    factor("road.friction", p.road_friction);
    for (const tread::Number& number : tread::numbers(truth.instruments))
        all.push_back({"instruments." + number.path, number.value, false});
    return all;
}

Subject asInFile(const tread::VehicleParams& vehicle) {
    return {.vehicle = vehicle, .road = {}, .wind = {}, .instruments = {}};
}

Truth withChanges(const Truth& known, const Subject& nominal, const Subject& changed) {
    Subject before = nominal, after = changed;
    const std::vector<tread::Number> from = tread::numbers(before), to = tread::numbers(after);
    Truth truth = known;
    for (const SharedNumber& shared : sharedNumbers(truth)) {
        const auto at =
            std::find_if(from.begin(), from.end(), [&](const auto& one) { return one.path == shared.path; });
        if (at == from.end()) continue;
        const double was = *at->value, is = *to[static_cast<std::size_t>(at - from.begin())].value;
        if (shared.by_factor) *shared.value *= is / was;
        else *shared.value += shared.share * (is - was);
    }
    return truth;
}

std::vector<Effect> plantable(const std::vector<Effect>& effects, const Subject& nominal) {
    Subject subject = nominal;
    Truth any;
    const std::vector<SharedNumber> shared = sharedNumbers(any);
    const auto isShared = [&](const std::string& path) {
        return std::any_of(shared.begin(), shared.end(), [&](const SharedNumber& one) { return one.path == path; });
    };
    std::vector<Effect> found;
    for (const Effect& effect : effects) {
        int moved = 0, missing = 0;
        for (const Knob& knob : effect.knobs) {
            for (const std::string& path : knob.paths) {
                const double* number = tread::recording::numberAt(subject, path);
                if (!number || (knob.relative && *number == 0)) continue;
                ++(isShared(path) ? moved : missing);
            }
        }
        if (moved > 0 && missing == 0) found.push_back(effect);
    }
    return found;
}

}  // namespace other_car
