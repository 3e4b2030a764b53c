#include "blind/other_errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/fields/numbers.h"
#include "base/text/pattern.h"
#include "blind/world/draws.h"
#include "recording/instruments.h"
#include "recording/subject.h"

namespace other_car {
namespace {

using tread::Random;
using tread::blind::world::heavyTailed;
using tread::recording::Subject;

constexpr double kOpenLimit = 1e-3;  // of the nominal value, least distance from an open limit

constexpr std::array kSpreads{
    Spread{"mass", 0.006, 0, "load", "wheel scales, load guessed to 10 kg"},
    Spread{"front_axle_distance", 0, 0.008, "load", "wheel scales on a floor that is not level, load"},
    Spread{"centre_of_gravity_height", 0.03, 0, "load", "tilt tests; load"},
    Spread{"inertia.yaw", 0.03, 0, "load", "estimates from mass and wheelbase: 3 to 5 %"},
    Spread{"inertia.pitch", 0.04, 0, "load", "guess, as yaw"},
    Spread{"inertia.roll", 0.05, 0, "load", "guess: estimates by track are worse than by wheelbase"},
    Spread{"wheelbase", 0.0015, 0, "survey", "tape and plumb, 4 mm"},
    Spread{"*.track", 0.004, 0, "survey", "tape and plumb, 6 mm; suspension not settled"},
    Spread{"*.unsprung_mass", 0.06, 0, "", "guess: wheel weighed, links guessed"},
    Spread{"*.wheel_inertia", 0.06, 0, "wheels", "guess: by trifilar swing of another size"},
    Spread{"*.suspension.spring", 0.03, 0, "springs", "tolerance of makers, about 3 to 5 %"},
    Spread{"*.suspension.anti_roll_bar", 0.05, 0, "springs", "diameter to the fourth power, bushes"},
    Spread{"*.suspension.damper.*", 0.08, 0, "dampers", "tolerance of makers, about 10 %, and temperature"},
    Spread{"*.suspension.roll_centre_height", 0, 0.01, "", "guess: from hard points"},
    Spread{"*.suspension.side_view_slope_braking", 0, 0.02, "", "guess: from hard points"},
    Spread{"*.suspension.toe", 0, 0.0005, "", "alignment benches: 2 minutes of arc"},
    Spread{"*.suspension.camber", 0, 0.003, "", "alignment benches: 10 minutes of arc"},
    Spread{"*.suspension.toe_by_travel", 0, 0.007, "", "kinematics rigs: 0.4 deg/m"},
    Spread{"*.suspension.camber_by_travel", 0, 0.02, "", "kinematics rigs: 1 deg/m"},
    Spread{"*.suspension.steer_by_lateral_force", 0, 5e-7, "", "compliance rigs: 0.03 deg/kN"},
    Spread{"*.tyre.lambda.Ky", 0.035, 0, "stiffness", "tyre rigs against each other and the road: some percent"},
    Spread{"*.tyre.lambda.Kx", 0.06, 0, "stiffness", "as the cornering stiffness, harder to measure"},
    Spread{"*.tyre.parameters.cFy", 0.07, 0, "stiffness", "guess: from relaxation lengths"},
    Spread{"*.tyre.parameters.cFx", 0.08, 0, "stiffness", "guess"},
    Spread{"*.tyre.parameters.pKy2", 0.04, 0, "", "guess: from measurements at three loads"},
    Spread{"*.tyre.lambda.muy", 0.025, 0, "friction", "tyre rigs have another surface than the road"},
    Spread{"road.friction", 0.02, 0, "friction", "dry asphalt from place to place"},
    Spread{"*.tyre.parameters.pDy2", 0, 0.015, "friction", "guess"},
    Spread{"*.tyre.lambda.Ey", 0.12, 0, "", "guess: badly determined by measurements"},
    Spread{"*.tyre.lambda.t", 0.10, 0, "", "guess: aligning moments differ by that from rig to rig"},
    Spread{"*.tyre.parameters.qy1", 0.10, 0, "", "warm against cold"},
    Spread{"*.tyre.parameters.Re", 0.0015, 0, "radius", "wear of 0.5 mm"},
    Spread{"*.tyre.parameters.Ro", 0.0015, 0, "radius", "wear of 0.5 mm"},
    Spread{"steering.ratio", 0.01, 0, "", "turned lock to lock, play"},
    Spread{"steering.delay", 0, 0.002, "", "guess", true},
    Spread{"steering.lag", 0, 0.002, "", "guess", true},
    Spread{"driveline.engine.torque_scale", 0.03, 0, "engine", "tolerance of series, 5 %"},
    Spread{"driveline.engine.drag_scale", 0.08, 0, "engine", "oil"},
    Spread{"driveline.engine.inertia", 0.08, 0, "", "guess"},
    Spread{"driveline.gearbox.efficiency", 0.01, 0, "", "guess"},
    Spread{"brakes.full_pedal_torque", 0.05, 0, "", "friction of pads by batch"},
    Spread{"brakes.front_share", 0, 0.015, "", "pads by batch, front against rear"},
    Spread{"brakes.delay", 0, 0.004, "", "guess", true},
    Spread{"brakes.lag", 0, 0.004, "", "guess", true},
    Spread{"aero.drag_area", 0, 0.02, "", "coast down against wind tunnel, 3 %"},
    Spread{"aero.*_lift_area", 0, 0.02, "", "wind tunnel, ride height"},
    Spread{"road.grade", 0, 0.0005, "", "level of proving grounds"},
    Spread{"road.bank", 0, 0.0005, "", "level of proving grounds"},
    Spread{"instruments.*.gain", 0.002, 0, "", "data sheets of good instruments"},
    Spread{"instruments.*.delay", 0, 0.001, "", "filters set alike; drivers' inputs off the bus", true},
    Spread{"instruments.inertial_unit.roll", 0, 0.002, "", "spirit level"},
    Spread{"instruments.inertial_unit.pitch", 0, 0.002, "", "spirit level"},
    Spread{"instruments.inertial_unit.x", 0, 0.015, "survey", "tape"},
    Spread{"instruments.inertial_unit.y", 0, 0.015, "survey", "tape"},
    Spread{"instruments.inertial_unit.z", 0, 0.015, "survey", "tape"},
};

// Adds a mass `behind` the front axle and `above` the road (m).
void carry(Subject& car, double mass, double behind, double above) {
    tread::VehicleParams& v = car.vehicle;
    const double before = v.mass, along = behind - v.front_axle_distance, up = above - v.centre_of_gravity_height;
    const double reduced = before * mass / (before + mass);
    v.mass += mass;
    v.front_axle_distance += mass * along / v.mass;
    v.centre_of_gravity_height += mass * up / v.mass;
    v.inertia.yaw += reduced * along * along;
    v.inertia.pitch += reduced * (along * along + up * up);
    v.inertia.roll += reduced * up * up;
}

// `by`: K above the temperature of the file.
void warm(Subject& car, double by) {
    for (tread::AxleParams* axle : {&car.vehicle.front, &car.vehicle.rear}) {
        for (double* stiffness : {&axle->tyre.lambda.Kx, &axle->tyre.lambda.Ky}) *stiffness *= 1 - 0.003 * by;
        axle->tyre.lambda.muy *= 1 - 0.002 * by;
        axle->tyre.parameters.qy1 *= 1 - 0.007 * by;
        axle->suspension.damper.bump *= 1 - 0.003 * by;
        axle->suspension.damper.rebound *= 1 - 0.003 * by;
    }
    car.vehicle.aero.air_density *= 1 - by / 293;                // ideal gas
    car.vehicle.driveline.engine->torque_scale *= 1 - by / 586;  // square root of the density of air
}

void late(Subject& car, double by) {
    tread::recording::Instruments& i = car.instruments;
    for (tread::recording::Instrument* one :
         {&i.ax, &i.ay, &i.yaw_rate, &i.roll_rate, &i.roll, &i.speed, &i.wheel_speed})
        one->delay += by;
}

template <tread::recording::Instrument tread::recording::Instruments::*instrument>
void shift(Subject& car, double by) {
    (car.instruments.*instrument).bias += by;
}

using I = tread::recording::Instruments;
constexpr double kFree = tread::kInfinity;
constexpr std::array kCircumstances{
    Circumstance{"fuel", 0, 9, 0.3, -18, 18,
                 [](Subject& car, double kg) { carry(car, kg, car.vehicle.wheelbase - 0.35, 0.4); },
                 "kg; a tank of 50 l, filled up or not"},
    Circumstance{"persons", 0, 7, 0, -25, 25,
                 [](Subject& car, double kg) { carry(car, kg, 0.55 * car.vehicle.wheelbase, 0.65); },
                 "kg; another driver, another companion"},
    Circumstance{"temperature", 0, 5, 1.5, -15, 15, warm,
                 "K; weather of a week, tyres that warm up. Rubber: 0.2 to 0.5 % per K (guess)"},
    Circumstance{"wind along x", 0, 0.9, 0.6, -3, 3, [](Subject& car, double speed) { car.wind.x += speed; },
                 "m/s; with that along y up to 3 m/s from any direction on a calm day"},
    Circumstance{"wind along y", 0, 0.9, 0.6, -3, 3, [](Subject& car, double speed) { car.wind.y += speed; },
                 "m/s; as along x"},
    Circumstance{"grade", 0, 0, 0.0004, -kFree, kFree, [](Subject& car, double rise) { car.road.grade += rise; },
                 "-; another stretch or heading"},
    Circumstance{"bank", 0, 0, 0.0004, -kFree, kFree, [](Subject& car, double rise) { car.road.bank += rise; },
                 "-; another lane or heading"},
    Circumstance{"latency", 0.0025, 0, 0.0015, 0, 0.005, late, "s; one logger and its clock, common to all sensors"},
    Circumstance{"zero of ax", 0, 0.012, 0.004, -kFree, kFree, shift<&I::ax>, "m/s2; data sheets, warming up"},
    Circumstance{"zero of ay", 0, 0.012, 0.004, -kFree, kFree, shift<&I::ay>, "m/s2; as ax"},
    Circumstance{"zero of the yaw rate", 0, 4e-4, 2e-4, -kFree, kFree, shift<&I::yaw_rate>,
                 "rad/s; zeroed at standstill"},
    Circumstance{"zero of the roll rate", 0, 4e-4, 2e-4, -kFree, kFree, shift<&I::roll_rate>, "rad/s; as yaw rate"},
    Circumstance{"zero of the roll", 0, 8e-4, 3e-4, -kFree, kFree, shift<&I::roll>, "rad; load left or right, zeroed"},
    Circumstance{"zero of the steering", 0, 0.002, 0.0005, -kFree, kFree, shift<&I::steering_wheel_angle>,
                 "rad; the robot is mounted anew"},
};

double limited(const tread::Limits& limits, double wanted, double nominal) {
    const double margin = kOpenLimit * std::abs(nominal);
    return std::clamp(wanted, limits.lowest_open ? limits.lowest + margin : limits.lowest,
                      limits.highest_open ? limits.highest - margin : limits.highest);
}

const Spread* spreadAt(std::string_view path) {
    const auto found = std::find_if(kSpreads.begin(), kSpreads.end(),
                                    [&](const Spread& one) { return tread::matches(one.paths, path); });
    return found == kSpreads.end() ? nullptr : &*found;
}

}  // namespace

std::span<const Spread> spreads() {
    return kSpreads;
}

std::span<const Circumstance> circumstances() {
    return kCircumstances;
}

double spreadOf(std::string_view path, double value) {
    const Spread* spread = spreadAt(path);
    return spread ? spread->relative * std::abs(value) + spread->absolute : 0;
}

void drawErrors(Subject& car, Random& random) {
    std::map<std::string_view, double> common;
    for (const Spread& spread : kSpreads) {
        if (!spread.group.empty() && !common.contains(spread.group)) common[spread.group] = heavyTailed(random);
    }
    for (const tread::Number& number : tread::numbers(car)) {
        const Spread* spread = spreadAt(number.path);
        if (!spread) continue;
        const double own = heavyTailed(random);
        const double units = spread->group.empty() ? own : (common[spread->group] + own) / std::sqrt(2.0);
        const double sd = spreadOf(number.path, *number.value);
        *number.value = limited(number.about.limits, *number.value + sd * (spread->one_sided ? std::abs(units) : units),
                                *number.value);
    }
}

void meet(Subject& car, std::uint64_t day_seed, std::uint64_t drive_seed) {
    Random day(day_seed), drive(drive_seed);
    for (const Circumstance& one : kCircumstances) {
        const double amount = one.usual + one.each_day * day.normal() + one.each_drive * drive.normal();
        one.apply(car, std::clamp(amount, one.lowest, one.highest));
    }
}

}  // namespace other_car
