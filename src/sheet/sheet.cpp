#include "sheet/sheet.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <variant>

#include "metrics/channels.h"
#include "sheet/braking.h"
#include "sheet/driven_turn.h"
#include "sheet/ride.h"
#include "sheet/steady_turn.h"
#include "sheet/top_speed.h"

namespace tread::sheet {
namespace {

constexpr double kPercent = 100;
constexpr double kKmh = 3.6;
constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kPerG = kDegrees * kStandardGravity;  // rad per m/s2 to deg per g
constexpr double kHandlingSpeed = 80 / kKmh;           // m/s
constexpr double kTurn = 0.1 * kStandardGravity;       // m/s2, of the simulated turn
constexpr double kBrakingOfTheIdeal = 0.8;             // g
constexpr double kHighestIdeal = 1.2;                  // g, end of the ideal curve

// All that the numbers come from.
struct Figures {
    AtRest rest;
    Ride ride;
    PerAxle<AxleStiffness> stiffness;
    TurnSlopes turn;
    SingleTrack track;
    YawMode yaw;        // at 80 km/h, with tyres that lag
    double turn_speed;  // m/s, of the simulated turn
    DrivenTurn driven;
    TopSpeed top;
};

Figures figuresOf(const VehicleParams& params) {
    const AtRest rest = atRest(params);
    const TurnSlopes turn = turnSlopes(rest);
    const SingleTrack track = singleTrack(rest, turn);
    const TopSpeed top = topSpeed(rest);
    const double speed = std::isfinite(top.speed) ? std::min(kHandlingSpeed, 0.6 * top.speed) : kHandlingSpeed;
    const double steering = (track.wheelbase / (speed * speed) + track.understeer()) * kTurn;
    return {.rest = rest,
            .ride = ride(rest),
            .stiffness = axleStiffness(rest),
            .turn = turn,
            .track = track,
            .yaw = yawModeWithLag(rest, track, kHandlingSpeed),
            .turn_speed = speed,
            .driven = drivenTurn(params, speed, steering),
            .top = top};
}

// What the linear model of handling leaves out.
std::string differentialNote(const VehicleParams& car) {
    const DrivelineParams& d = car.driveline;
    const auto couples = [](const auto& differential) {
        const auto* open = std::get_if<OpenDifferential>(&differential);
        return !open || open->locking > 0;
    };
    const bool any = (d.front_share > 0 && couples(d.front_differential)) ||
                     (d.front_share < 1 && couples(d.rear_differential)) || couples(d.centre_differential);
    return any ? "without the yaw moment of the differentials, which the simulated car has" : "";
}

struct Value {
    double value;
    std::string note = {};
};

double rollStiffness(const Figures& f, std::size_t axle) {
    const double track = f.rest.axle(axle).track;
    return 0.25 * track * track * (wheelRate(f.rest, 2 * axle, -1) + wheelRate(f.rest, 2 * axle + 1, -1)) / kDegrees;
}

double shareOf(double one, double other) {
    return kPercent * one / (one + other);
}

Value orNone(double value, std::string_view why) {
    return {value, std::isnan(value) ? std::string(why) : std::string()};
}

Value topSpeedValue(const Figures& f) {
    const TopSpeed& top = f.top;
    if (std::isnan(top.speed)) return {kUndefined, "full throttle does not overcome the resistance"};
    const char* const why = top.limit == SpeedLimit::power ? "driving power equals resistance"
                            : top.limit == SpeedLimit::gearing
                                ? "limited by gearing: engine or motor at its speed limit"
                                : "the next gear cannot hold it";
    return {kKmh * top.speed, fmt::format("in gear {}: {}", top.gear, why)};
}

Value rearFirst(const Figures& f) {
    const double z = rearLocksFirstAbove(f.rest);
    if (std::isnan(z)) return {z, "the front axle locks first at every deceleration that the brakes reach"};
    return {z, z < 1e-6 ? "the rear axle locks first at every deceleration" : "below, the front axle locks first"};
}

struct Definition {
    SheetRow row;
    Value (*value)(const Figures&);
};

// The table.
const std::vector<Definition>& definitions() {
    static const std::vector<Definition> table = {
        {{"Weight", "mass", "mass", "kg", "m, load included", {"mass", "load.mass"}, "{}"},
         [](const Figures& f) -> Value { return {f.rest.car().mass}; }},
        {{"Weight",
          "front_weight_share",
          "weight on the front axle",
          "%",
          "Fz,front / (m g) = 1 - a / L",
          {"front_axle_distance", "wheelbase", "load"},
          "{} on the front axle"},
         [](const Figures& f) -> Value { return {shareOf(f.rest.axleLoad(0), f.rest.axleLoad(1))}; }},
        {{"Weight",
          "rear_weight_share",
          "weight on the rear axle",
          "%",
          "Fz,rear / (m g) = a / L",
          {"front_axle_distance", "wheelbase", "load"}},
         [](const Figures& f) -> Value { return {shareOf(f.rest.axleLoad(1), f.rest.axleLoad(0))}; }},
        {{"Weight",
          "left_weight_share",
          "weight on the left wheels",
          "%",
          "(Fz,fl + Fz,rl) / (m g)",
          {"lateral_offset", "load", "front.track", "rear.track"}},
         [](const Figures& f) -> Value {
             return {shareOf(f.rest.load[0] + f.rest.load[2], f.rest.load[1] + f.rest.load[3])};
         }},
        {{"Weight",
          "right_weight_share",
          "weight on the right wheels",
          "%",
          "(Fz,fr + Fz,rr) / (m g)",
          {"lateral_offset", "load", "front.track", "rear.track"}},
         [](const Figures& f) -> Value {
             return {shareOf(f.rest.load[1] + f.rest.load[3], f.rest.load[0] + f.rest.load[2])};
         }},
        {{"Weight",
          "load_front_left",
          "static load, front left",
          "N",
          "m g b / L (1/2 + y / t), y: lateral offset; from the equilibrium of the standing car",
          {"mass", "front_axle_distance", "wheelbase", "lateral_offset", "load"}},
         [](const Figures& f) -> Value { return {f.rest.load[0]}; }},
        {{"Weight",
          "load_front_right",
          "static load, front right",
          "N",
          "m g b / L (1/2 - y / t)",
          {"mass", "front_axle_distance", "wheelbase", "lateral_offset", "load"}},
         [](const Figures& f) -> Value { return {f.rest.load[1]}; }},
        {{"Weight",
          "load_rear_left",
          "static load, rear left",
          "N",
          "m g a / L (1/2 + y / t)",
          {"mass", "front_axle_distance", "wheelbase", "lateral_offset", "load"}},
         [](const Figures& f) -> Value { return {f.rest.load[2]}; }},
        {{"Weight",
          "load_rear_right",
          "static load, rear right",
          "N",
          "m g a / L (1/2 - y / t)",
          {"mass", "front_axle_distance", "wheelbase", "lateral_offset", "load"}},
         [](const Figures& f) -> Value { return {f.rest.load[3]}; }},
        {{"Weight",
          "centre_of_gravity_height",
          "height of the centre of gravity",
          "mm",
          "h above the road, standing",
          {"centre_of_gravity_height", "load"}},
         [](const Figures& f) -> Value { return {1000 * f.rest.height}; }},

        {{"Ride",
          "ride_frequency_front",
          "ride frequency, front",
          "Hz",
          "|lambda| / 2 pi, slow mode of ms z'' = ks (w - z) + c (w' - z'), mu w'' = -kt w - ct w' - ms z''",
          {"front.suspension.spring", "front.suspension.damper", "front.unsprung_mass", "front.tyre.parameters.pz1",
           "mass", "front_axle_distance"}},
         [](const Figures& f) -> Value { return {f.ride.body.front.frequency}; }},
        {{"Ride",
          "ride_damping_front",
          "its damping ratio",
          "-",
          "-Re lambda / |lambda| of that mode; c: mean of bump and rebound",
          {"front.suspension.damper"}},
         [](const Figures& f) -> Value { return {f.ride.body.front.damping}; }},
        {{"Ride",
          "ride_frequency_rear",
          "ride frequency, rear",
          "Hz",
          "the same for the rear axle",
          {"rear.suspension.spring", "rear.suspension.damper", "rear.unsprung_mass", "rear.tyre.parameters.pz1", "mass",
           "front_axle_distance"}},
         [](const Figures& f) -> Value { return {f.ride.body.rear.frequency}; }},
        {{"Ride",
          "ride_damping_rear",
          "its damping ratio",
          "-",
          "-Re lambda / |lambda| of that mode",
          {"rear.suspension.damper"}},
         [](const Figures& f) -> Value { return {f.ride.body.rear.damping}; }},
        {{"Ride",
          "heave_frequency",
          "heave of the body",
          "Hz",
          "|lambda| / 2 pi of body and both axles; the slow mode with more heave than pitch",
          {"mass", "inertia.pitch", "front.suspension", "rear.suspension", "front_axle_distance"}},
         [](const Figures& f) -> Value { return {f.ride.heave.frequency}; }},
        {{"Ride",
          "heave_damping",
          "its damping ratio",
          "-",
          "-Re lambda / |lambda| of that mode",
          {"front.suspension.damper", "rear.suspension.damper"}},
         [](const Figures& f) -> Value { return {f.ride.heave.damping}; }},
        {{"Ride",
          "pitch_frequency",
          "pitch of the body",
          "Hz",
          "|lambda| / 2 pi of the other slow mode",
          {"inertia.pitch", "mass", "front.suspension", "rear.suspension", "front_axle_distance"}},
         [](const Figures& f) -> Value { return {f.ride.pitch.frequency}; }},
        {{"Ride",
          "pitch_damping",
          "its damping ratio",
          "-",
          "-Re lambda / |lambda| of that mode",
          {"front.suspension.damper", "rear.suspension.damper"}},
         [](const Figures& f) -> Value { return {f.ride.pitch.damping}; }},
        {{"Ride",
          "wheel_hop_frequency_front",
          "wheel hop, front",
          "Hz",
          "|lambda| / 2 pi, fast mode of the quarter car",
          {"front.unsprung_mass", "front.tyre.parameters.pz1", "front.suspension.spring"}},
         [](const Figures& f) -> Value { return {f.ride.wheel.front.frequency}; }},
        {{"Ride",
          "wheel_hop_damping_front",
          "its damping ratio",
          "-",
          "-Re lambda / |lambda| of that mode",
          {"front.suspension.damper", "front.tyre.parameters.pz2"}},
         [](const Figures& f) -> Value { return {f.ride.wheel.front.damping}; }},
        {{"Ride",
          "wheel_hop_frequency_rear",
          "wheel hop, rear",
          "Hz",
          "the same for the rear axle",
          {"rear.unsprung_mass", "rear.tyre.parameters.pz1", "rear.suspension.spring"}},
         [](const Figures& f) -> Value { return {f.ride.wheel.rear.frequency}; }},
        {{"Ride",
          "wheel_hop_damping_rear",
          "its damping ratio",
          "-",
          "-Re lambda / |lambda| of that mode",
          {"rear.suspension.damper", "rear.tyre.parameters.pz2"}},
         [](const Figures& f) -> Value { return {f.ride.wheel.rear.damping}; }},

        {{"Roll",
          "roll_stiffness_front",
          "roll stiffness, front suspension",
          "N m/deg",
          "t^2 (ks + 2 kbar) / 2, without tyres",
          {"front.track", "front.suspension.spring", "front.suspension.anti_roll_bar"}},
         [](const Figures& f) -> Value { return {rollStiffness(f, 0)}; }},
        {{"Roll",
          "roll_stiffness_rear",
          "roll stiffness, rear suspension",
          "N m/deg",
          "t^2 (ks + 2 kbar) / 2, without tyres",
          {"rear.track", "rear.suspension.spring", "rear.suspension.anti_roll_bar"}},
         [](const Figures& f) -> Value { return {rollStiffness(f, 1)}; }},
        {{"Roll",
          "roll_stiffness_front_share",
          "share of the front axle",
          "%",
          "front / (front + rear)",
          {"front.suspension.anti_roll_bar", "rear.suspension.anti_roll_bar", "front.suspension.spring",
           "rear.suspension.spring"}},
         [](const Figures& f) -> Value { return {shareOf(rollStiffness(f, 0), rollStiffness(f, 1))}; }},
        {{"Roll",
          "load_transfer_front_share",
          "front share of the lateral load transfer",
          "%",
          "dFz,front / (dFz,front + dFz,rear) in a steady turn, with tyres and roll centres",
          {"front.suspension.roll_centre_height", "rear.suspension.roll_centre_height", "front.suspension",
           "rear.suspension"}},
         [](const Figures& f) -> Value { return {shareOf(f.turn.difference.front, f.turn.difference.rear)}; }},
        {{"Roll",
          "roll_gradient",
          "roll gradient",
          "deg/g",
          "d phi / d ay = m h' / (K - m g h'), with tyres, roll centres and leaning wheels",
          {"centre_of_gravity_height", "front.suspension", "rear.suspension", "front.track", "rear.track"},
          "roll gradient {}"},
         [](const Figures& f) -> Value { return {kPerG * f.turn.roll}; }},
        {{"Roll",
          "roll_gradient_driven",
          "roll gradient, simulated",
          "deg/g",
          "phi / ay of the simulated car at 0.1 g, mean of left and right",
          {"front.suspension", "rear.suspension"}},
         [](const Figures& f) -> Value { return orNone(kPerG * f.driven.roll, "the car cannot hold such a turn"); }},

        {{"Handling",
          "cornering_stiffness_front",
          "cornering stiffness, front tyres",
          "N/deg",
          "dFy / d alpha of both tyres at static load",
          {"front.tyre", "front.left", "front.right", "mass"}},
         [](const Figures& f) -> Value { return {f.stiffness.front.tyres / kDegrees}; }},
        {{"Handling",
          "cornering_stiffness_rear",
          "cornering stiffness, rear tyres",
          "N/deg",
          "dFy / d alpha of both tyres at static load",
          {"rear.tyre", "rear.left", "rear.right", "mass"}},
         [](const Figures& f) -> Value { return {f.stiffness.rear.tyres / kDegrees}; }},
        {{"Handling",
          "axle_stiffness_front",
          "cornering stiffness, front axle",
          "N/deg",
          "1 / (1 / C + compliance by side force and aligning moment, of suspension, column and rack)",
          {"front.suspension.steer_by_lateral_force", "front.suspension.steer_by_aligning_moment",
           "front.suspension.camber_by_lateral_force", "steering.column_compliance", "steering.rack_compliance",
           "steering.caster_trail"}},
         [](const Figures& f) -> Value { return {f.stiffness.front.with_compliance / kDegrees}; }},
        {{"Handling",
          "axle_stiffness_rear",
          "cornering stiffness, rear axle",
          "N/deg",
          "1 / (1 / C + compliance by side force and aligning moment)",
          {"rear.suspension.steer_by_lateral_force", "rear.suspension.steer_by_aligning_moment",
           "rear.suspension.camber_by_lateral_force"}},
         [](const Figures& f) -> Value { return {f.stiffness.rear.with_compliance / kDegrees}; }},
        {{"Handling",
          "understeer_gradient",
          "understeer gradient",
          "deg/g",
          "m / L (b / Cf - a / Cr); Cf, Cr with compliance, roll steer, camber and load transfer",
          {"front.tyre", "rear.tyre", "front.suspension", "rear.suspension", "steering", "front_axle_distance"},
          "understeer gradient {}"},
         [](const Figures& f) -> Value {
             return {kPerG * f.track.understeer(), differentialNote(f.rest.car())};
         }},
        {{"Handling",
          "understeer_gradient_driven",
          "understeer gradient, simulated",
          "deg/g",
          "(steering-wheel angle / i - L / R) / ay of the simulated car at 0.1 g, mean of left and right",
          {"front.tyre", "rear.tyre", "front.suspension", "rear.suspension", "steering", "driveline", "aero"}},
         [](const Figures& f) -> Value {
             if (std::isnan(f.driven.understeer)) return {kUndefined, "the car cannot hold such a turn"};
             return {kPerG * f.driven.understeer, fmt::format("driven at {:.0f} km/h", kKmh * f.turn_speed)};
         }},
        {{"Handling",
          "characteristic_speed",
          "characteristic speed",
          "km/h",
          "sqrt(L / K), K the understeer gradient",
          {"wheelbase"}},
         [](const Figures& f) -> Value {
             return orNone(kKmh * f.track.characteristicSpeed(), "only a car that understeers has one");
         }},
        {{"Handling", "critical_speed", "critical speed", "km/h", "sqrt(-L / K)", {"wheelbase"}},
         [](const Figures& f) -> Value {
             return orNone(kKmh * f.track.criticalSpeed(), "only a car that oversteers has one");
         }},
        {{"Handling",
          "static_margin",
          "static margin",
          "%",
          "(b Cr - a Cf) / (L (Cf + Cr))",
          {"front.tyre", "rear.tyre", "front_axle_distance", "wheelbase"}},
         [](const Figures& f) -> Value { return {kPercent * f.track.staticMargin()}; }},
        {{"Handling",
          "yaw_frequency",
          "yaw natural frequency at 80 km/h",
          "Hz",
          "sqrt(Cf Cr L^2 / (m J v^2) (1 + K v^2 / L)) / 2 pi of the single-track model",
          {"inertia.yaw", "mass", "wheelbase"}},
         [](const Figures& f) -> Value {
             return orNone(f.track.yawFrequency(kHandlingSpeed), "80 km/h is above the critical speed");
         }},
        {{"Handling",
          "yaw_damping",
          "its damping ratio",
          "-",
          "((Cf + Cr) / (m v) + (a^2 Cf + b^2 Cr) / (J v)) / (2 omega)",
          {"inertia.yaw", "mass", "front_axle_distance"}},
         [](const Figures& f) -> Value {
             return orNone(f.track.yawDamping(kHandlingSpeed), "80 km/h is above the critical speed");
         }},
        {{"Handling",
          "yaw_frequency_lagging",
          "yaw natural frequency with tyre relaxation",
          "Hz",
          "|lambda| / 2 pi of the same model with F' = (C alpha - F) v / sigma, sigma = C / cFy of both tyres",
          {"front.tyre.parameters.cFy", "rear.tyre.parameters.cFy", "inertia.yaw", "mass", "wheelbase"}},
         [](const Figures& f) -> Value { return orNone(f.yaw.frequency, "it does not oscillate"); }},
        {{"Handling",
          "yaw_damping_lagging",
          "its damping ratio",
          "-",
          "-Re lambda / |lambda| of that mode",
          {"front.tyre.parameters.cFy", "rear.tyre.parameters.cFy", "inertia.yaw", "mass"}},
         [](const Figures& f) -> Value { return orNone(f.yaw.damping, "it does not oscillate"); }},

        {{"Brakes",
          "brake_front_share",
          "brake force on the front axle",
          "%",
          "(Tf / rf) / (Tf / rf + Tr / rr), friction brakes below the knee of a proportioning valve",
          {"brakes.front_share", "front.tyre.parameters.Ro", "rear.tyre.parameters.Ro"}},
         [](const Figures& f) -> Value { return {kPercent * frontShare(f.rest)}; }},
        {{"Brakes",
          "brake_ideal_front_share",
          "ideal share at 0.8 g",
          "%",
          "(b + z h) / L, z = 0.8",
          {"front_axle_distance", "wheelbase", "centre_of_gravity_height"}},
         [](const Figures& f) -> Value { return {kPercent * idealFrontShare(f.rest, kBrakingOfTheIdeal)}; }},
        {{"Brakes",
          "rear_locks_first_above",
          "the rear axle locks first above",
          "g",
          "z at which Fr / Fz,r = Ff / Fz,f; with a constant share: (share L - b) / h",
          {"brakes.front_share", "brakes.rear_proportioning", "front_axle_distance", "wheelbase",
           "centre_of_gravity_height"}},
         rearFirst},

        {{"Driving",
          "top_speed",
          "top speed",
          "km/h",
          "full-throttle torque at the wheels = drag and rolling resistance, level road, gear by the shift map",
          {"driveline", "aero.drag_area", "aero.air_density", "front.tyre.parameters.qy1", "rear.tyre.parameters.qy1",
           "front.tyre.parameters.Re", "mass"},
          "top speed {}"},
         topSpeedValue},
        {{"Driving",
          "power_at_top_speed",
          "power of the resistance there",
          "kW",
          "v (rho cdA v^2 / 2 + sum My / r)",
          {"aero.drag_area", "aero.air_density", "front.tyre.parameters.qy1", "rear.tyre.parameters.qy1"}},
         [](const Figures& f) -> Value { return {f.top.power / 1000}; }},
    };
    return table;
}

std::vector<SheetCurve> brakingCurves(const AtRest& rest) {
    SheetCurve installed{.name = "installed", .x = {}, .y = {}}, ideal{.name = "ideal", .x = {}, .y = {}};
    for (double pedal = 0; pedal <= 1.0005; pedal += 0.01) {
        const Braking now = brakingAt(rest, pedal);
        if (now.deceleration > kHighestIdeal) break;
        installed.x.push_back(now.force.front);
        installed.y.push_back(now.force.rear);
    }
    for (double z = 0; z <= kHighestIdeal + 0.005; z += 0.01) {
        const double front = idealFrontShare(rest, z);
        if (front > 1) break;
        ideal.x.push_back(z * front);
        ideal.y.push_back(z * (1 - front));
    }
    return {installed, ideal};
}

}  // namespace

Sheet sheetOf(const VehicleParams& params) {
    const Figures figures = figuresOf(params);
    Sheet sheet{.name = params.name, .rows = {}, .braking = brakingCurves(figures.rest)};
    for (const Definition& definition : definitions()) {
        sheet.rows.push_back(definition.row);
        const Value value = definition.value(figures);
        sheet.rows.back().value = value.value;
        sheet.rows.back().note = value.note;
    }
    return sheet;
}

}  // namespace tread::sheet
