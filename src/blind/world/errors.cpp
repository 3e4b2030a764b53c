#include "blind/world/errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "base/fields/numbers.h"
#include "base/text/pattern.h"
#include "blind/world/draws.h"
#include "blind/world/instruments.h"
#include "recording/instruments.h"
#include "recording/subject.h"

namespace tread::blind::world {
namespace {

using recording::Instrument;
using recording::Subject;

// Spreads are of the order of the tolerances in the description of a vehicle. A tolerance is the half-width of a
// uniform distribution: 5 % correspond to a spread of about 3 %.
constexpr std::string_view kGuess = "guess";
constexpr std::string_view kScales = "guess: weighed on four scales of 0.5 % each";
constexpr std::string_view kBatch = "guess: scatter of series parts, 5 to 10 %, alike within a batch";
constexpr std::string_view kPerson = "guess: measured by hand by one person with one tape or gauge";
constexpr std::string_view kSheet = "guess: data sheets of usual instruments of this class";
constexpr std::string_view kTyres = "guess: four tyres of one batch against the one that was measured, half worn";
constexpr std::string_view kWeather = "calculated: density and torque follow the absolute temperature";

constexpr std::array kErrors{
    // ---- Masses and centre of gravity, without the loads below
    NumberError{.pattern = "mass", .relative = 0.005, .source = kScales},
    NumberError{.pattern = "front_axle_distance", .relative = 0.006, .source = kScales},
    NumberError{.pattern = "lateral_offset", .absolute = 0.003, .source = kScales},
    NumberError{.pattern = "wheelbase", .relative = 0.002, .common = 0.5, .source = kPerson},
    NumberError{.pattern = "*.track", .relative = 0.004, .common = 0.5, .source = kPerson},
    NumberError{
        .pattern = "centre_of_gravity_height", .relative = 0.025, .source = "guess: tilting test, or an estimate"},
    NumberError{.pattern = "inertia.*", .relative = 0.03, .common = 0.6, .source = "guess: estimates err alike"},
    NumberError{.pattern = "inertia.roll_yaw", .absolute = 10, .source = kGuess},
    NumberError{.pattern = "*.unsprung_mass", .relative = 0.05, .common = 0.7, .source = kScales},
    NumberError{.pattern = "*.wheel_inertia", .relative = 0.05, .common = 0.8, .source = kGuess},

    // ---- Suspension
    NumberError{.pattern = "*.suspension.spring", .relative = 0.025, .common = 0.5, .source = kBatch},
    NumberError{.pattern = "*.suspension.damper.*",
                .relative = 0.06,
                .per_kelvin = -0.002,
                .common = 0.7,
                .by_axle = true,
                .source = kBatch},
    NumberError{.pattern = "*.suspension.anti_roll_bar", .relative = 0.05, .source = kBatch},
    NumberError{.pattern = "*_stop.stiffness", .relative = 0.15, .common = 0.7, .source = kBatch},
    NumberError{.pattern = "*_stop.progression", .relative = 0.15, .common = 0.7, .source = kBatch},
    NumberError{.pattern = "*_stop.clearance", .absolute = 0.003, .source = kPerson},
    NumberError{.pattern = "*.suspension.roll_centre_height", .absolute = 0.008, .common = 0.4, .source = kPerson},
    NumberError{.pattern = "*.suspension.side_view_slope_*", .absolute = 0.015, .common = 0.5, .source = kPerson},
    NumberError{.pattern = "*.suspension.toe", .absolute = 0.0005, .common = 0.4, .daily = 0.2, .source = kPerson},
    NumberError{.pattern = "*.suspension.camber", .absolute = 0.003, .common = 0.4, .daily = 0.2, .source = kPerson},
    NumberError{.pattern = "*.suspension.*_by_travel", .relative = 0.12, .common = 0.4, .source = kPerson},
    NumberError{.pattern = "*.suspension.steer_by_lateral_force", .relative = 0.12, .source = "guess: bushes"},
    NumberError{.pattern = "*.suspension.longitudinal_*", .relative = 0.2, .source = "guess: bushes"},

    // ---- Tyres
    NumberError{.pattern = "*.tyre.parameters.Re", .relative = 0.0018, .common = 0.7, .daily = 0.3, .source = kTyres},
    NumberError{
        .pattern = "*.tyre.parameters.cFy", .relative = 0.06, .per_kelvin = -0.003, .common = 0.7, .source = kTyres},
    NumberError{.pattern = "*.tyre.parameters.cFx", .relative = 0.06, .common = 0.7, .source = kTyres},
    NumberError{.pattern = "*.tyre.lambda.mu*",
                .relative = 0.02,
                .per_kelvin = -0.001,
                .common = 0.8,
                .daily = 0.5,
                .source = kTyres},
    NumberError{.pattern = "*.tyre.lambda.Kx", .relative = 0.05, .per_kelvin = -0.003, .common = 0.7, .source = kTyres},
    NumberError{
        .pattern = "*.tyre.lambda.Ky", .relative = 0.025, .per_kelvin = -0.002, .common = 0.6, .source = kTyres},
    NumberError{.pattern = "*.tyre.lambda.Kz", .relative = 0.06, .common = 0.7, .source = kTyres},
    NumberError{.pattern = "*.tyre.lambda.E*", .relative = 0.1, .common = 0.7, .source = kTyres},
    NumberError{.pattern = "*.tyre.lambda.t", .relative = 0.06, .common = 0.7, .source = kTyres},
    NumberError{.pattern = "*.tyre.lambda.Mr", .relative = 0.12, .common = 0.7, .source = kTyres},
    NumberError{.pattern = "*.tyre.lambda.xa", .relative = 0.06, .common = 0.7, .source = kTyres},
    NumberError{.pattern = "*.tyre.lambda.yk", .relative = 0.06, .common = 0.7, .source = kTyres},
    NumberError{.pattern = "*.tyre.lambda.gy", .relative = 0.1, .common = 0.7, .source = kTyres},
    NumberError{.pattern = "*.tyre.lambda.Cz", .relative = 0.03, .common = 0.7, .source = kTyres},
    NumberError{.pattern = "*.tyre.lambda.My", .relative = 0.08, .per_kelvin = -0.008, .common = 0.7, .source = kTyres},
    NumberError{.pattern = "*.tyre_surroundings.pressure.inflation",
                .relative = 0.02,
                .per_kelvin = 0.0034,
                .common = 0.3,
                .daily = 0.3,
                .source = "guess: a gauge of 0.05 bar; the gas law"},
    NumberError{.pattern = "*.tyre_surroundings.conicity", .absolute = 0.0006, .source = kTyres},
    NumberError{.pattern = "*.tyre_surroundings.ply_steer", .absolute = 0.0002, .common = 0.7, .source = kTyres},

    // ---- Steering, driveline, brakes, air
    NumberError{.pattern = "steering.ratio", .relative = 0.008, .source = kPerson},
    NumberError{.pattern = "steering.ackermann", .relative = 0.1, .source = kPerson},
    NumberError{.pattern = "steering.*_compliance", .relative = 0.15, .source = kGuess},
    NumberError{.pattern = "steering.caster_trail", .relative = 0.1, .source = kPerson},
    NumberError{.pattern = "steering.friction", .relative = 0.15, .source = kGuess},
    NumberError{.pattern = "driveline.engine.torque_scale",
                .relative = 0.015,
                .per_kelvin = -0.0017,
                .source = "guess: engines of one type; density of the air"},
    NumberError{.pattern = "driveline.engine.drag_scale",
                .relative = 0.05,
                .per_kelvin = -0.003,
                .daily = 0.3,
                .source = "guess: engines of one type; oil"},
    NumberError{.pattern = "driveline.engine.response_time", .relative = 0.15, .source = kGuess},
    NumberError{.pattern = "driveline.*.inertia", .relative = 0.1, .source = kGuess},
    NumberError{.pattern = "driveline.motor.torque", .relative = 0.02, .source = kGuess},
    NumberError{.pattern = "driveline.motor.power", .relative = 0.02, .source = kGuess},
    NumberError{.pattern = "driveline.motor.response_time", .relative = 0.15, .source = kGuess},
    NumberError{.pattern = "driveline.gearbox.efficiency", .relative = 0.008, .source = kGuess},
    NumberError{.pattern = "driveline.shaft_*", .relative = 0.12, .source = kBatch},
    NumberError{.pattern = "driveline.*_differential.*", .relative = 0.1, .source = kBatch},
    NumberError{.pattern = "brakes.full_pedal_torque",
                .relative = 0.05,
                .per_kelvin = -0.001,
                .daily = 0.4,
                .source = "guess: friction of pads of one make, bedding, moisture"},
    NumberError{.pattern = "brakes.front_share", .relative = 0.02, .daily = 0.3, .source = kBatch},
    NumberError{.pattern = "brakes.delay", .relative = 0.15, .source = kGuess},
    NumberError{.pattern = "brakes.lag", .relative = 0.15, .source = kGuess},
    NumberError{.pattern = "aero.air_density", .relative = 0.01, .per_kelvin = -0.0034, .daily = 1, .source = kWeather},
    NumberError{.pattern = "aero.drag_area", .relative = 0.025, .source = "guess: wind tunnel against road"},
    NumberError{.pattern = "aero.*_lift_area", .absolute = 0.015, .source = "guess: wind tunnel against road"},

    // ---- Instruments
    NumberError{.pattern = "instruments.*.gain", .relative = 0.0018, .source = kSheet},
    NumberError{.pattern = "instruments.ax.gain", .relative = 0.0025, .source = kSheet},
    NumberError{.pattern = "instruments.ay.gain", .relative = 0.0025, .source = kSheet},
    NumberError{.pattern = "instruments.ax.bias", .absolute = 0.018, .daily = 1, .source = kSheet},
    NumberError{.pattern = "instruments.ay.bias", .absolute = 0.018, .daily = 1, .source = kSheet},
    NumberError{.pattern = "instruments.*_rate.bias", .absolute = 6e-4, .daily = 1, .source = kSheet},
    NumberError{.pattern = "instruments.roll.bias", .absolute = 1.2e-3, .daily = 1, .source = kSheet},
    NumberError{.pattern = "instruments.steering_wheel_angle.bias",
                .absolute = 0.003,
                .daily = 1,
                .source = "guess: 0.2 deg, zero set by driving straight"},
    NumberError{.pattern = "instruments.inertial_unit.x", .absolute = 0.012, .daily = 0.2, .source = kPerson},
    NumberError{.pattern = "instruments.inertial_unit.y", .absolute = 0.012, .daily = 0.2, .source = kPerson},
    NumberError{.pattern = "instruments.inertial_unit.z", .absolute = 0.012, .daily = 0.2, .source = kPerson},
    NumberError{.pattern = "instruments.inertial_unit.roll", .absolute = 0.0018, .daily = 0.3, .source = kPerson},
    NumberError{.pattern = "instruments.inertial_unit.pitch", .absolute = 0.0018, .daily = 0.3, .source = kPerson},
};

const NumberError* errorOf(std::string_view path) {
    const auto found = std::find_if(kErrors.rbegin(), kErrors.rend(),
                                    [&](const NumberError& row) { return matches(row.pattern, path); });
    return found == kErrors.rend() ? nullptr : &*found;
}

double spreadOf(const NumberError& row, double value) {
    return row.relative * std::abs(value) + row.absolute;
}

// At an open limit, half of the distance from the nominal value to it.
double within(const Limits& limits, double wanted, double nominal) {
    const double value = std::clamp(wanted, limits.lowest, limits.highest);
    return limits.allow(value) ? value : 0.5 * (value + nominal);
}

// ---- Load ----------------------------------------------------------------------------------------------------------

// Deviation of a mass in the car from the file. Position relative to the point on the road below the front axle.
struct Load {
    double spread;               // kg, standard deviation
    double behind, left, above;  // fraction of the wheelbase, m, m
};
constexpr std::array kLoads{
    Load{10, 0.5, 0.35, 0.6},  // another driver
    Load{9, 0.85, 0, 0.35},    // fuel, a fifth of the tank
    Load{8, 1.05, 0, 0.65},    // instruments and luggage in the boot
};

void add(VehicleParams& car, const Load& load, double mass) {
    const double total = car.mass + mass, share = mass / total;
    const double dx = load.behind * car.wheelbase - car.front_axle_distance;  // m, rearwards
    const double dy = load.left - car.lateral_offset, dz = load.above - car.centre_of_gravity_height;
    // Parallel axis theorem for two masses about their common centre of gravity.
    const double reduced = mass * car.mass / total;
    car.inertia.roll += reduced * (dy * dy + dz * dz);
    car.inertia.pitch += reduced * (dx * dx + dz * dz);
    car.inertia.yaw += reduced * (dx * dx + dy * dy);
    car.front_axle_distance += share * dx;
    car.lateral_offset += share * dy;
    car.centre_of_gravity_height += share * dz;
    car.mass = total;
}

// Variance of each number by all loads, to first order.
std::map<std::string, double> varianceOfLoad(const Subject& nominal) {
    std::map<std::string, double> variance;
    for (const Load& load : kLoads) {
        Subject before = nominal, after = nominal;
        add(after.vehicle, load, load.spread);
        const std::vector<Number> olds = numbers(before), news = numbers(after);
        for (std::size_t i = 0; i < olds.size(); ++i)
            if (*news[i].value != *olds[i].value)
                variance[olds[i].path] += std::pow(*news[i].value - *olds[i].value, 2);
    }
    return variance;
}

// With `daily`, only the part that changes from day to day.
double varianceOf(const Number& number, bool daily) {
    const NumberError* row = errorOf(number.path);
    if (!row) return 0;
    const double spread = spreadOf(*row, *number.value) * (daily ? row->daily : 1);
    const double by_day = row->per_kelvin * kDaySpread * *number.value;
    return spread * spread + by_day * by_day;
}

}  // namespace

std::span<const NumberError> errorTable() {
    return kErrors;
}

void drawErrors(Subject& car, Random& random) {
    for (const Load& load : kLoads) add(car.vehicle, load, load.spread * heavyTailed(random));
    const double warmer = kDaySpread * heavyTailed(random);  // K
    std::map<std::string, double> common;                    // shared draws, by row and axle
    for (const Number& number : numbers(car)) {
        const NumberError* row = errorOf(number.path);
        if (!row) continue;
        const std::string axle = row->by_axle ? number.path.substr(0, number.path.find('.')) : "";
        const auto [shared, first] = common.try_emplace(axle + std::string(row->pattern), 0);
        if (first) shared->second = heavyTailed(random);
        const double own = heavyTailed(random);
        const double draw = row->common * shared->second + std::sqrt(1 - row->common * row->common) * own;
        const double nominal = *number.value;
        const double wanted =
            nominal * (1 + row->per_kelvin * warmer) + spreadOf(*row, nominal) * std::clamp(draw, -4.0, 4.0);
        *number.value = within(number.about.limits, wanted, nominal);
    }
}

std::vector<OpenNumber> openNumbers(const Subject& nominal) {
    Subject subject = nominal;
    const std::map<std::string, double> loaded = varianceOfLoad(nominal);
    std::vector<OpenNumber> open;
    for (const Number& number : numbers(subject)) {
        double sd = number.about.tolerance * std::abs(*number.value) / std::sqrt(3.0);
        if (number.about.tolerance == 0) {
            const auto load = loaded.find(number.path);
            sd = std::sqrt(varianceOf(number, false) + (load == loaded.end() ? 0 : load->second));
        }
        if (sd > 0 && std::isfinite(sd)) open.push_back({number.path, sd});
    }
    return open;
}

std::vector<OpenNumber> dailyNumbers(const Subject& nominal) {
    Subject subject = nominal;
    const std::map<std::string, double> loaded = varianceOfLoad(nominal);
    std::vector<OpenNumber> open;
    for (const Number& number : numbers(subject)) {
        const auto load = loaded.find(number.path);
        const double sd = std::sqrt(varianceOf(number, true) + (load == loaded.end() ? 0 : load->second));
        if (sd > 0 && std::isfinite(sd)) open.push_back({number.path, sd});
    }
    return open;
}

GroundSlope drawnGround(Random& random) {
    const double along = kGroundSlope * heavyTailed(random);
    return {along, kGroundSlope * heavyTailed(random)};
}

DriveDifference drawnDifference(const GroundSlope& ground, Random& random) {
    const double heading = 2 * std::numbers::pi * random.uniform();
    const double wind = kMostWind * random.uniform(), from = 2 * std::numbers::pi * random.uniform();
    const double c = std::cos(heading), s = std::sin(heading);
    return {.wind_x = wind * std::cos(from),
            .wind_y = wind * std::sin(from),
            .grade = c * ground.along + s * ground.across,
            .bank = -s * ground.along + c * ground.across,
            .latency = kMostLatency * random.uniform()};
}

DriveDifference differenceSpread() {
    const double wind = kMostWind / std::sqrt(6.0);  // each component has half of the mean square of the speed
    return {.wind_x = wind,
            .wind_y = wind,
            .grade = kGroundSlope,
            .bank = kGroundSlope,
            .latency = kMostLatency / std::sqrt(12.0)};
}

void apply(const DriveDifference& difference, Subject& car) {
    car.wind.x += difference.wind_x;
    car.wind.y += difference.wind_y;
    car.road.grade += difference.grade;
    car.road.bank += difference.bank;
    for (const InstrumentSheet& sheet : instrumentSheets()) {
        Instrument& instrument = car.instruments.*sheet.instrument;
        const bool first_of_its_unit = !sheet.channel.starts_with("wheel.") || sheet.channel == "wheel.front_left.spin";
        if (!measuresDriver(sheet) && first_of_its_unit) instrument.delay += difference.latency;
    }
}

}  // namespace tread::blind::world
