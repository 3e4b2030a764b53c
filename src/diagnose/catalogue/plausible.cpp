#include "diagnose/catalogue/plausible.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/text/concat.h"
#include "base/text/number_text.h"
#include "base/text/pattern.h"

namespace tread::diagnose::catalogue {
namespace {

using enum Scale;

constexpr std::string_view kOtherTyre = "guess: from a worn winter tyre to a semi-slick, and water or gravel";
constexpr std::string_view kMeasured = "guess: no estimate of such a number is off by more";

// The first pattern that fits holds.
constexpr PlausibleRange kRanges[] = {
    // Mass and its distribution
    {"mass", 0.7, 1.6, itself, "kerb mass with no more than the permitted load and trailer, or a stripped car"},
    {"inertia.yaw", 0.6, 1.4, axle_distances, "passenger cars: k^2 is 0.8 to 1.2 of the product of the axle distances"},
    {"inertia.roll_yaw", -0.04, 0.04, axle_distances, "guess: principal axes lean by less than 10 deg"},
    {"inertia.*", 0.5, 2, itself, kMeasured},
    {"wheelbase", 0.97, 1.03, itself, "measured with a tape"},
    {"*.track", 0.93, 1.07, itself, "spacers and other wheels"},
    {"front_axle_distance", 0.25, 0.75, wheelbase, "axle loads of road cars are at most 3 to 1"},
    {"lateral_offset", -0.06, 0.06, wheelbase, "wheel loads of one axle differ by less than 3 to 2"},
    {"centre_of_gravity_height", 0.7, 1.4, itself, "roof loads and lowered springs"},
    {"load.mass", -0.1, 0.6, Scale::mass,
     "the permitted load; less: what a kerb mass contains, driver, fuel, spare wheel"},
    {"load.moment_x", -0.25, 0.25, mass_wheelbase, "centre of gravity within a quarter of the wheelbase"},
    {"load.moment_y", -0.06, 0.06, mass_wheelbase, "as for lateral_offset"},
    {"load.moment_z", -0.3, 0.4, mass_height, "as for centre_of_gravity_height"},
    {"*.unsprung_mass", 0.4, 2.5, itself, kMeasured},
    {"*.wheel_inertia", 0.4, 2.5, itself, kMeasured},
    // Tyres
    {"*.tyre.parameters.Re", 0.9, 1.1, itself, "other sizes that fit the wheel house, wear"},
    {"*.tyre.parameters.Ro", 0.9, 1.1, itself, "other sizes that fit the wheel house, wear"},
    {"*.tyre.parameters.pRe1", -0.06, 0.02, one, "guess: down by the whole radial deflection, up by a third of it"},
    {"*.tyre.lambda.mux", 0.1, 1.6, itself, "from ice to a semi-slick"},
    {"*.tyre.lambda.muy", 0.1, 1.6, itself, "from ice to a semi-slick"},
    {"*.tyre.lambda.Kx", 0.3, 2.5, itself, kOtherTyre},
    {"*.tyre.lambda.Ky", 0.3, 2.5, itself, kOtherTyre},
    {"*.tyre.lambda.Kz", 0.2, 5, itself, "damping of the tyre is hardly known"},
    {"*.tyre.lambda.Cz", 0.4, 2, itself, "half to twice the inflation pressure"},
    {"*.tyre.lambda.Ex", -1, 4, one, "guess: beyond, the force curve has no peak of its own"},
    {"*.tyre.lambda.Ey", -1, 4, one, "guess: beyond, the force curve has no peak of its own"},
    {"*.tyre.lambda.*", 0, 3, one, "guess: published sets of coefficients differ by less"},
    {"*.tyre.parameters.pDy2", -0.4, 0.05, one, "published sets: -0.3 to 0"},
    {"*.tyre.parameters.pKy2", 0.3, 3, itself, "published sets: 1.2 to 4 at nominal loads of 3 to 5 kN"},
    {"*.tyre.parameters.cFx", 0.2, 5, itself, "relaxation lengths of 0.1 to 2 m"},
    {"*.tyre.parameters.cFy", 0.2, 5, itself, "relaxation lengths of 0.1 to 2 m"},
    {"*.tyre.parameters.pVy3", -1.5, 1.5, one, "camber stiffness of car tyres divided by load is below 1.5"},
    {"*.tyre.parameters.czgyr", 0, 2, one, "paper: 0.5; zero without a belt"},
    {"*.tyre.parameters.cygyr", 0, 2, one, "paper: 0.5; zero without a belt"},
    {"*.tyre.parameters.qy1", 0, 0.015, one, "coefficients up to 0.05 (soft ground), times the radius"},
    {"*.left.cornering_stiffness", 0.3, 2.5, one, kOtherTyre},
    {"*.right.cornering_stiffness", 0.3, 2.5, one, kOtherTyre},
    {"*.left.slip_stiffness", 0.3, 2.5, one, kOtherTyre},
    {"*.right.slip_stiffness", 0.3, 2.5, one, kOtherTyre},
    {"*.left.grip", 0.1, 1.6, one, "from ice to a semi-slick"},
    {"*.right.grip", 0.1, 1.6, one, "from ice to a semi-slick"},
    {"*.pressure.inflation", 0.3, 1.8, itself, "from a rim on the point of unseating to the maker's maximum"},
    {"*.temperature.heat_capacity", 0.2, 5, itself, kMeasured},
    {"*.temperature.slip_share", 0, 1, one, "a share"},
    {"*.temperature.cooling*", 0.1, 10, itself, kMeasured},
    {"*.temperature.friction", -0.03, 0.03, one, "guess: friction halves or doubles over 25 K at most"},
    {"*.temperature.stiffness", -0.03, 0.03, one, "guess: stiffness halves or doubles over 25 K at most"},
    {"*.grip_difference", -1, 1, one, "one side on ice"},
    {"*.ply_steer", -0.02, 0.02, one, "residual side forces of 1.5 kN"},
    {"*.conicity", -0.1, 0.1, one, "residual side forces of 0.4 kN"},
    // Suspension
    {"*.suspension.spring", 0.3, 3, itself, "from a comfort car to a racing car"},
    {"*.suspension.anti_roll_bar", 0, 60, Scale::mass, "from none to a racing car: 80 kN/m at 1.4 t"},
    {"*.suspension.damper.bump", 0.1, 4, itself, "from an empty damper to a racing damper"},
    {"*.suspension.damper.rebound", 0.1, 4, itself, "from an empty damper to a racing damper"},
    {"*.suspension.damper.friction", 0, 0.6, Scale::mass, "leaf springs: 800 N at 1.4 t"},
    {"*stop.clearance", 0, 0.1, wheelbase, "travel of off-road cars"},
    {"*stop.*", 0.1, 10, itself, kMeasured},
    {"*.roll_centre_height", -0.06, 0.13, wheelbase, "from racing cars to live axles on leaf springs"},
    {"*.side_view_slope_*", -0.5, 0.5, one, "support angles of 27 deg"},
    {"*.camber_by_travel", -2, 2, one, "swing axles: 115 deg/m"},
    {"*.camber", -0.1, 0.1, one, "racing cars: 5 deg"},
    {"*.toe_by_travel", -0.7, 0.7, one, "40 deg/m"},
    {"*.toe", -0.035, 0.035, one, "2 deg: the tyres would not last a day"},
    {"*.steer_by_lateral_force", -3e-5, 3e-5, one, "1.7 deg/kN"},
    {"*.longitudinal_*", 0.1, 10, itself, kMeasured},
    // Steering
    {"steering.ratio", 0.6, 1.6, itself, "other racks for the same car"},
    {"steering.column_compliance", 0, 0.15, one, "9 deg/(N m): loose at once"},
    {"steering.rack_compliance", 0, 5, itself, kMeasured},
    {"steering.delay", 0, 0.5, one, "with a slower one, nobody could drive"},
    {"steering.lag", 0, 0.5, one, "with a slower one, nobody could drive"},
    {"steering.play", 0, 0.6, one, "three times what inspections allow"},
    {"steering.ackermann", -1, 2, one, "from racing cars to more than full"},
    {"steering.caster_trail", -0.03, 0.03, wheelbase, "caster angles up to 12 deg"},
    {"steering.scrub_radius", -0.04, 0.04, wheelbase, "half a tyre's width"},
    {"steering.*", 0.1, 10, itself, kMeasured},
    // Driveline and brakes
    {"driveline.*torque_scale", 0.3, 1.8, one, "from half the cylinders to a tuned engine"},
    {"driveline.*drag_scale", 0, 4, one, "from declutched to an engine brake"},
    {"driveline.motor.torque", 0.3, 1.8, itself, "as for engines"},
    {"driveline.motor.power", 0.3, 1.8, itself, "as for engines"},
    {"driveline.motor.lift_off_regeneration", 0, 1, one, "a share"},
    {"driveline.*response_time", 0, 1.5, one, "large turbochargers"},
    {"driveline.*.locking*", 0, 1, one, "from open to locked"},
    {"driveline.shaft_stiffness", 0.2, 5, itself, kMeasured},
    {"driveline.*efficiency", 0.7, 1, one, "worm gears are worse"},
    {"driveline.*", 0.1, 10, itself, kMeasured},
    {"brakes.full_pedal_torque", 0.2, 2, itself, "from one circuit to racing pads"},
    {"brakes.front_share", 0.2, 0.95, one, "from rear-heavy racing cars to small front-drive cars"},
    {"brakes.*.fade", 0, 0.004, one, "all torque lost 250 K above"},
    {"brakes.delay", 0, 0.5, one, "air brakes of lorries"},
    {"brakes.lag", 0, 0.5, one, "air brakes of lorries"},
    {"brakes.*.authority_offset", 0, 1, one, "definition: 1 is full intervention"},
    {"brakes.*", 0.2, 5, itself, kMeasured},
    {"*.brake_drag", 0, 0.5, mass_height, "400 N m at 1.4 t: 33 kW at 90 km/h"},
    // Air and road
    {"aero.drag_area", 0, 3, one, "from none to a van"},
    {"aero.*_lift_area", -3, 1.5, one, "from racing wings to a van"},
    {"aero.air_density", 0.6, 1.2, itself, "from 4000 m above to arctic cold"},
    {"wind.x", -15, 15, one, "near gale: too strong for measurements"},
    {"wind.y", -15, 15, one, "near gale: too strong for measurements"},
    {"wind.speed", 0, 15, one, "near gale: too strong for measurements"},
    {"road.grade", -0.1, 0.1, one, "a steep public road"},
    {"road.bank", -0.1, 0.1, one, "a banked public road"},
    {"road.friction", 0.1, 1.6, itself, "from ice to the best dry asphalt"},
    // Instruments
    {"instruments.*.gain", 0.7, 1.4, one, "more would be a wrong unit or a broken instrument"},
    {"instruments.*.delay", -0.1, 0.5, one, "slow GPS receivers; ahead only by a wrong clock"},
    {"instruments.command.lag", 0, 1, one, "guess: a turbocharged engine"},
    {"instruments.command.bias", -1, 1, Scale::mass, "guess: creep and drag torque, 1 m/s2"},
    {"instruments.latency", 0, 0.1, one, "buses with a full load"},
    {"instruments.further.*_rate@*.bias", -0.1, 0.1, one, "6 deg/s: ten times a bad gyro"},
    {"instruments.further.*.ax@*.bias", -1.5, 1.5, one, "0.15 g: tilted by 9 deg"},
    {"instruments.further.*.ay@*.bias", -1.5, 1.5, one, "0.15 g: tilted by 9 deg"},
    {"instruments.*_rate.bias", -0.1, 0.1, one, "6 deg/s: ten times a bad gyro"},
    {"instruments.ax.bias", -1.5, 1.5, one, "0.15 g: tilted by 9 deg"},
    {"instruments.ay.bias", -1.5, 1.5, one, "0.15 g: tilted by 9 deg"},
    {"instruments.steering_wheel_angle.bias", -0.5, 0.5, one, "30 deg: the rack is a tooth off"},
    {"instruments.speed.bias", -2, 2, one, "guess"},
    {"instruments.wheel_speed.bias", -5, 5, one, "guess"},
    {"instruments.*.bias", -0.1, 0.1, one, "6 deg, or a tenth of the pedal"},
    {"instruments.mountings.*.x", -0.8, 0.8, wheelbase, "within the car"},
    {"instruments.mountings.*.y", -0.4, 0.4, wheelbase, "within the car"},
    {"instruments.mountings.*.z", -0.3, 0.5, wheelbase, "within the car"},
    {"instruments.mountings.*.fixed_to_body", 0, 1, one, "definition"},
    {"instruments.mountings.*", -0.15, 0.15, one, "9 deg"},
    {"instruments.inertial_unit.x", -0.8, 0.8, wheelbase, "within the car"},
    {"instruments.inertial_unit.y", -0.4, 0.4, wheelbase, "within the car"},
    {"instruments.inertial_unit.z", -0.3, 0.5, wheelbase, "within the car"},
    {"instruments.inertial_unit.fixed_to_body", 0, 1, one, "definition"},
    {"instruments.inertial_unit.*", -0.15, 0.15, one, "9 deg"},
};

// Room on either side of a nominal value that lies outside its range, as a share of it: a car of another kind.
constexpr double kRoomOutside = 0.25;

double sizeOf(Scale scale, double nominal, const VehicleParams& car) {
    const double behind = car.wheelbase - car.front_axle_distance;
    switch (scale) {
        case one:
            return 1;
        case itself:
            return std::abs(nominal);
        case Scale::mass:
            return car.mass;
        case wheelbase:
            return car.wheelbase;
        case mass_wheelbase:
            return car.mass * car.wheelbase;
        case mass_height:
            return car.mass * car.centre_of_gravity_height;
        case axle_distances:
            return car.mass * car.front_axle_distance * behind;
    }
    return 1;
}

}  // namespace

const PlausibleRange* plausibleRange(std::string_view path) {
    const auto found = std::find_if(std::begin(kRanges), std::end(kRanges),
                                    [&](const PlausibleRange& one_of) { return matches(one_of.path, path); });
    return found == std::end(kRanges) ? nullptr : &*found;
}

Limits plausibleLimits(std::string_view path, double nominal, const VehicleParams& car) {
    const PlausibleRange* range = plausibleRange(path);
    if (!range || (range->scale == itself && nominal == 0)) return kAny;
    const double size = sizeOf(range->scale, nominal, car);
    double low = size * range->lowest, high = size * range->highest;
    if (range->scale == itself && nominal < 0) std::tie(low, high) = std::pair(-high, -low);
    const double room = kRoomOutside * std::abs(nominal);
    return {nominal < low ? nominal - room : low, nominal > high ? nominal + room : high};
}

std::string plausibleText(std::string_view path) {
    const PlausibleRange* range = plausibleRange(path);
    if (!range) return {};
    const std::string ends = numberText(range->lowest) + " to " + numberText(range->highest);
    const std::string_view of = enumNames(Scale{})[static_cast<std::size_t>(range->scale)];
    return of.empty() ? ends : concat({ends, " x ", of});
}

}  // namespace tread::diagnose::catalogue
