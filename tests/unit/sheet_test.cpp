#include "sheet/sheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <set>

#include "base/fields/reference_table.h"
#include "metrics/metrics.h"
#include "run/simulate.h"
#include "scenario/load.h"
#include "shared/linear_ride.h"
#include "shared/linear_single_track.h"
#include "shared/single_track.h"
#include "shared/vehicles.h"
#include "sheet/at_rest.h"
#include "sheet/steady_turn.h"

namespace tread::sheet::sheet_test {
namespace {

constexpr double kG = kStandardGravity;
constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kKmh = 3.6;

const SheetRow& row(const Sheet& sheet, std::string_view name) {
    const auto found =
        std::find_if(sheet.rows.begin(), sheet.rows.end(), [&](const auto& r) { return r.name == name; });
    if (found == sheet.rows.end()) throw std::runtime_error("no row " + std::string(name));
    return *found;
}
double value(const Sheet& sheet, std::string_view name) {
    return row(sheet, name).value;
}

double metric(const std::vector<Metric>& metrics, std::string_view name) {
    for (const Metric& m : metrics)
        if (m.name == name) return m.value;
    throw std::runtime_error("no metric " + std::string(name));
}

// No compliance, no kinematics, tyres alike on both sides that have no trail: closed forms hold.
VehicleParams simpleCar() {
    VehicleParams car = reference::simplified(reference::compact());
    for (AxleParams* axle : {&car.front, &car.rear}) axle->tyre.parameters.qDz1 = axle->tyre.parameters.qDz2 = 0;
    return car;
}

double axleMass(const VehicleParams& car, std::size_t axle) {
    const double behind = car.wheelbase - car.front_axle_distance;
    return car.mass * (axle == 0 ? behind : car.front_axle_distance) / car.wheelbase;
}

// Both tyres, N/rad.
double corneringStiffness(const VehicleParams& car, std::size_t axle) {
    const TyreParams& tyre = (axle == 0 ? car.front : car.rear).tyre;
    return 2 * steadyState(tyre, {.Fz = 0.5 * axleMass(car, axle) * kG, .gamma = 0, .Vx = 20, .Vsx = 0, .Vsy = 0}).Ky;
}

// ---- The table ----

TEST(Sheet, EveryNumberHasAUnitAFormulaAndParametersThatExist) {
    const auto known = referenceTable<VehicleParams>();
    std::set<std::string_view> names;
    const Sheet sheet = sheetOf(simpleCar());
    for (const SheetRow& r : sheet.rows) {
        EXPECT_TRUE(names.insert(r.name).second) << r.name << " twice";
        EXPECT_FALSE(r.unit.empty() || r.formula.empty() || r.label.empty() || r.group.empty()) << r.name;
        EXPECT_EQ(r.formula.find('\n'), std::string_view::npos) << r.name;
        EXPECT_FALSE(r.sources.empty()) << r.name;
        for (const std::string_view source : r.sources) {
            EXPECT_TRUE(std::any_of(known.begin(), known.end(),
                                    [&](const ReferenceRow& field) {
                                        return field.path == source ||
                                               field.path.starts_with(std::string(source) + ".");
                                    }))
                << r.name << ": " << source;
        }
        EXPECT_TRUE(std::isfinite(r.value) || !r.note.empty()) << r.name << " says why there is none";
    }
    EXPECT_GT(names.size(), 30u);
}

// ---- Weight ----

TEST(Sheet, WheelLoadsAreThoseOfALever) {
    VehicleParams car = simpleCar();
    car.lateral_offset = 0.02;
    const Sheet sheet = sheetOf(car);
    const double front = axleMass(car, 0) * kG, rear = axleMass(car, 1) * kG;
    EXPECT_NEAR(value(sheet, "load_front_left"), front * (0.5 + 0.02 / car.front.track), 2e-3 * front);
    EXPECT_NEAR(value(sheet, "load_front_right"), front * (0.5 - 0.02 / car.front.track), 2e-3 * front);
    EXPECT_NEAR(value(sheet, "load_rear_left"), rear * (0.5 + 0.02 / car.rear.track), 2e-3 * rear);
    EXPECT_NEAR(value(sheet, "load_rear_right"), rear * (0.5 - 0.02 / car.rear.track), 2e-3 * rear);
    EXPECT_NEAR(value(sheet, "front_weight_share"), 100 * front / (front + rear), 0.02);
    EXPECT_NEAR(value(sheet, "front_weight_share") + value(sheet, "rear_weight_share"), 100, 1e-9);
    EXPECT_NEAR(value(sheet, "left_weight_share") + value(sheet, "right_weight_share"), 100, 1e-9);
}

TEST(Sheet, ALoadIsPartOfTheCar) {
    VehicleParams car = simpleCar();
    car.load = {.mass = 150, .x = -1.2, .y = 0.4, .z = 0.3, .levelled = true};
    const Sheet level = sheetOf(car);
    const double mass = car.mass + 150, ahead = car.front_axle_distance + 150 * 1.2 / mass;
    const double left = 50 + 100 * 150 * 0.4 / mass / (0.5 * (car.front.track + car.rear.track));
    EXPECT_DOUBLE_EQ(value(level, "mass"), mass);
    EXPECT_NEAR(value(level, "rear_weight_share"), 100 * ahead / car.wheelbase, 0.05);
    EXPECT_NEAR(value(level, "left_weight_share"), left, 0.05);
    EXPECT_NEAR(value(level, "centre_of_gravity_height"), 1000 * (car.centre_of_gravity_height + 150 * 0.3 / mass), 2);

    // On springs alone the car sinks, and leans towards its load.
    car.load.levelled = false;
    const Sheet sunk = sheetOf(car);
    EXPECT_GT(value(sunk, "left_weight_share"), left + 0.1);
    EXPECT_LT(value(sunk, "centre_of_gravity_height"), value(level, "centre_of_gravity_height") - 10);
}

// ---- Ride ----

// The two masses of a quarter car oscillate with what the sheet says: lambda is a root of their polynomial.
TEST(Sheet, RideAndWheelHopAreRootsOfTheQuarterCar) {
    VehicleParams car = reference::linearCar(simpleCar());
    for (AxleParams* axle : {&car.front, &car.rear}) axle->tyre.parameters.pz2 = 200;
    const Sheet sheet = sheetOf(car);
    for (const std::size_t axle : {0, 1}) {
        const AxleParams& a = axle == 0 ? car.front : car.rear;
        const std::string side = axle == 0 ? "_front" : "_rear";
        const double mu = a.unsprung_mass, ms = 0.5 * axleMass(car, axle) - mu;
        const double ks = a.suspension.spring, c = a.suspension.damper.bump, kt = a.tyre.parameters.pz1, ct = 200;
        for (const std::string mode : {"ride", "wheel_hop"}) {
            const double omega = 2 * std::numbers::pi * value(sheet, mode + "_frequency" + side);
            const double zeta = value(sheet, mode + "_damping" + side);
            const std::complex<double> s = omega * std::complex<double>(-zeta, std::sqrt(1 - zeta * zeta));
            const std::complex<double> body = ms * s * s + c * s + ks, between = c * s + ks,
                                       wheel = mu * s * s + (c + ct) * s + ks + kt;
            EXPECT_LT(std::abs(body * wheel - between * between), 2e-3 * std::abs(between * between)) << mode << side;
        }
        EXPECT_NEAR(value(sheet, "ride_frequency" + side), std::sqrt(ks * kt / (ks + kt) / ms) / (2 * std::numbers::pi),
                    0.05);
    }
}

TEST(Sheet, HeaveAndPitchAreModesOfAnIndependentCarOnFourWheels) {
    for (const VehicleParams& shipped : {reference::compact(), reference::rearDriveSedan()}) {
        const VehicleParams car = reference::linearCar(shipped);
        const Sheet sheet = sheetOf(car);
        const Eigen::EigenSolver<Eigen::MatrixXd> modes(reference::linearModel(car).system());
        for (const std::string mode : {"heave", "pitch"}) {
            const double omega = 2 * std::numbers::pi * value(sheet, mode + "_frequency");
            const double zeta = value(sheet, mode + "_damping");
            double nearest = 1e9, motion = 0;
            for (int i = 0; i < 14; ++i) {
                const std::complex<double> s = modes.eigenvalues()(i);
                const double off = std::abs(s - omega * std::complex<double>(-zeta, std::sqrt(1 - zeta * zeta)));
                if (off > nearest) continue;
                nearest = off;
                const Eigen::VectorXcd shape = modes.eigenvectors().col(i);  // of a temporary
                motion = std::abs(shape(0)) / (std::abs(shape(2)) * std::sqrt(car.inertia.pitch / car.mass));
            }
            EXPECT_LT(nearest, 2e-3 * omega) << car.name << " " << mode;
            EXPECT_EQ(motion > 1, mode == "heave") << car.name;
        }
    }
}

// ---- Roll ----

TEST(Sheet, RollStiffnessIsThatOfSpringsAndBars) {
    const VehicleParams car = simpleCar();
    const Sheet sheet = sheetOf(car);
    const auto of = [](const AxleParams& a) {
        return 0.5 * a.track * a.track * (a.suspension.spring + 2 * a.suspension.anti_roll_bar) / kDegrees;
    };
    const double front = of(car.front), rear = of(car.rear);
    EXPECT_NEAR(value(sheet, "roll_stiffness_front"), front, 1e-6 * front);
    EXPECT_NEAR(value(sheet, "roll_stiffness_rear"), rear, 1e-6 * rear);
    EXPECT_NEAR(value(sheet, "roll_stiffness_front_share"), 100 * front / (front + rear), 1e-4);
}

TEST(Sheet, RollAndUndersteerAgreeWithAnIndependentLinearModel) {
    for (const VehicleParams& car : {simpleCar(), reference::compact(), reference::rearDriveSedan()}) {
        const Sheet sheet = sheetOf(car);
        const double roll = kDegrees * kG * reference::rollAt(car, 1).angle;
        const double understeer = kDegrees * kG * reference::singleTrack(car).understeer;
        std::printf("%s: roll %.4f (%.4f), understeer %.4f (%.4f) deg/g\n", car.name.c_str(),
                    value(sheet, "roll_gradient"), roll, value(sheet, "understeer_gradient"), understeer);
        EXPECT_NEAR(value(sheet, "roll_gradient"), roll, 0.02 * roll) << car.name;
        EXPECT_NEAR(value(sheet, "understeer_gradient"), understeer, 0.02 * understeer) << car.name;
    }
}

// ---- Handling: closed forms ----

TEST(Sheet, HandlingOfASimpleCarIsThatOfTheSingleTrackModel) {
    VehicleParams car = simpleCar();
    for (const double rear_stiffness : {1.0, 0.5}) {
        car.rear.tyre.lambda.Ky = rear_stiffness;  // the second car oversteers
        const Sheet sheet = sheetOf(car);
        const double cf = corneringStiffness(car, 0), cr = corneringStiffness(car, 1);
        const double understeer = axleMass(car, 0) / cf - axleMass(car, 1) / cr;  // rad s2/m
        const double a = car.front_axle_distance, b = car.wheelbase - a;
        EXPECT_NEAR(value(sheet, "cornering_stiffness_front"), cf / kDegrees, 2e-3 * cf / kDegrees);
        EXPECT_NEAR(value(sheet, "cornering_stiffness_rear"), cr / kDegrees, 2e-3 * cr / kDegrees);
        EXPECT_NEAR(value(sheet, "axle_stiffness_front"), cf / kDegrees, 2e-3 * cf / kDegrees) << "nothing yields";
        EXPECT_NEAR(value(sheet, "understeer_gradient"), kDegrees * kG * understeer, 0.02);
        EXPECT_NEAR(value(sheet, "static_margin"), 100 * (b * cr - a * cf) / (car.wheelbase * (cf + cr)), 0.1);
        const double speed = kKmh * std::sqrt(car.wheelbase / std::abs(understeer));
        const bool understeers = understeer > 0;
        EXPECT_EQ(understeers, rear_stiffness == 1);
        EXPECT_NEAR(value(sheet, understeers ? "characteristic_speed" : "critical_speed"), speed, 0.01 * speed);
        EXPECT_TRUE(std::isnan(value(sheet, understeers ? "critical_speed" : "characteristic_speed")));

        shared::SingleTrack model{.mass = car.mass, .inertia = car.inertia.yaw, .front = a, .rear = b};
        model.front_stiffness = cf;
        model.rear_stiffness = cr;
        model.speed = 80 / kKmh;
        const double omega = std::sqrt(model.a().determinant());
        if (std::isnan(omega)) {
            EXPECT_TRUE(std::isnan(value(sheet, "yaw_frequency")));
            EXPECT_NE(row(sheet, "yaw_frequency").note, "");
            continue;
        }
        EXPECT_NEAR(value(sheet, "yaw_frequency"), omega / (2 * std::numbers::pi), 0.01 * omega);
        EXPECT_NEAR(value(sheet, "yaw_damping"), -0.5 * model.a().trace() / omega, 0.01);
    }
}

// Half of the force of the axle turns each of its wheels.
TEST(Sheet, ComplianceSoftensAnAxleAndUndersteers) {
    VehicleParams car = simpleCar();
    const double stiff = value(sheetOf(car), "understeer_gradient");
    car.front.suspension.steer_by_lateral_force = -4e-6;
    const Sheet soft = sheetOf(car);
    EXPECT_NEAR(value(soft, "understeer_gradient") - stiff, kDegrees * kG * 0.5 * 4e-6 * axleMass(car, 0), 0.01);
    const double axle = 1 / (1 / corneringStiffness(car, 0) + 0.5 * 4e-6) / kDegrees;
    EXPECT_NEAR(value(soft, "axle_stiffness_front"), axle, 2e-3 * axle);
}

// ---- Handling: the simulator in the matching manoeuvre ----

// To 3 m/s2 the regression of the metric covers 0.1 to 0.18 g, to 6 m/s2 0.1 to 0.37 g, where tyres have become softer.
TEST(Sheet, GradientsAreThoseOfTheSteadyCircle) {
    Scenario circle = loadScenario(sourceFile("scenarios/steady_circle.yaml"));
    for (const VehicleParams& car : {reference::compact(), reference::rearDriveSedan()}) {
        const Sheet sheet = sheetOf(car);
        for (const auto& [to, tolerance] : {std::pair{3.0, 0.08}, std::pair{6.0, 0.15}}) {
            circle.phases.back().until.lateral_acceleration_above = to;
            const auto driven = metrics(simulate(car, circle), "steady_circle", {car.wheelbase, car.steering.ratio});
            const double understeer = metric(driven, "understeer_gradient"), roll = metric(driven, "roll_gradient");
            std::printf("%s: understeer %.3f, simulated %.3f, circle %.3f; roll %.3f, %.3f, circle %.3f deg/g\n",
                        car.name.c_str(), value(sheet, "understeer_gradient"),
                        value(sheet, "understeer_gradient_driven"), understeer, value(sheet, "roll_gradient"),
                        value(sheet, "roll_gradient_driven"), roll);
            for (const char* name : {"understeer_gradient", "understeer_gradient_driven"})
                EXPECT_NEAR(value(sheet, name), understeer, tolerance * understeer) << car.name << " to " << to;
            for (const char* name : {"roll_gradient", "roll_gradient_driven"})
                EXPECT_NEAR(value(sheet, name), roll, 0.01 * roll) << car.name << " to " << to;
        }
    }
}

// The single-track model in the frequency domain; side forces follow over the relaxation lengths, m.
struct Lagging {
    SingleTrack track;
    double speed, front_length, rear_length;

    using Complex = std::complex<double>;
    // Of the states sideslip speed and yaw rate: s x = a x + b steering.
    std::pair<Eigen::Matrix2cd, Eigen::Vector2cd> at(Complex s) const {
        const double m = track.mass, j = track.inertia, a = track.front_distance, b = track.wheelbase - a, v = speed;
        const Complex f = track.stiffness.front / (1.0 + s * front_length / v),
                      r = track.stiffness.rear / (1.0 + s * rear_length / v);
        Eigen::Matrix2cd system;
        system << -(f + r) / (m * v), (b * r - a * f) / (m * v) - v, (b * r - a * f) / (j * v),
            -(a * a * f + b * b * r) / (j * v);
        return {s * Eigen::Matrix2cd::Identity() - system, Eigen::Vector2cd(f / m, a * f / j)};
    }
    Complex yawRate(double frequency) const {
        const auto [left, right] = at(Complex(0, 2 * std::numbers::pi * frequency));
        return (left.inverse() * right)(1);
    }
    // The determinant at a mode over its size at rest: 0 for a mode of the model.
    double leftOver(double frequency, double damping) const {
        const double omega = 2 * std::numbers::pi * frequency;
        const Complex s = omega * Complex(-damping, std::sqrt(1 - damping * damping));
        return std::abs(at(s).first.determinant()) / (omega * omega);
    }
};

Lagging modelOf(const VehicleParams& car, bool lags) {
    const AtRest rest = atRest(car);
    const SingleTrack track = singleTrack(rest, turnSlopes(rest));
    const auto length = [&](double stiffness, const AxleParams& axle) {
        return lags ? stiffness / (2 * axle.tyre.parameters.cFy) : 0;
    };
    return {track, 80 / kKmh, length(track.stiffness.front, car.front), length(track.stiffness.rear, car.rear)};
}

// The yaw frequencies and damping ratios of the sheet are modes of this model, and its response is that of the
// simulated car: without lag for tyres on stiff carcasses, with it for those of the shipped cars.
TEST(Sheet, YawModeIsThatOfTheFrequencyResponse) {
    const Scenario sweep = loadScenario(sourceFile("scenarios/sine_sweep.yaml"));
    VehicleParams stiff = simpleCar();
    for (AxleParams* axle : {&stiff.front, &stiff.rear}) axle->tyre.parameters.cFy *= 10;
    for (const auto& [car, lags] : {std::pair{stiff, false}, std::pair{reference::compact(), true},
                                    std::pair{reference::rearDriveSedan(), true}}) {
        const Sheet sheet = sheetOf(car);
        const Lagging model = modelOf(car, lags);
        const std::string which = lags ? "_lagging" : "";
        EXPECT_LT(model.leftOver(value(sheet, "yaw_frequency" + which), value(sheet, "yaw_damping" + which)), 1e-6);
        const auto driven = metrics(simulate(car, sweep), "frequency_response");
        for (const std::string f : {"0.5", "1.0"}) {
            const double gain = metric(driven, "yaw_rate_gain_" + f + "Hz");
            const double lag = metric(driven, "yaw_rate_phase_lag_" + f + "Hz");
            const std::complex<double> expected = model.yawRate(std::stod(f)) / car.steering.ratio;
            std::printf("%s at %s Hz: gain %.4f (sweep %.4f), lag %.1f deg (%.1f)\n", car.name.c_str(), f.c_str(),
                        std::abs(expected), gain, -kDegrees * std::arg(expected), lag);
            EXPECT_NEAR(std::abs(expected), gain, 0.05 * gain) << car.name << " at " << f;
            EXPECT_NEAR(-kDegrees * std::arg(expected), lag, 5) << car.name << " at " << f;
        }
    }
}

// ---- Brakes ----

TEST(Sheet, RearLocksFirstAboveTheCrossingOfBothCurves) {
    VehicleParams car = simpleCar();
    const double b = car.wheelbase - car.front_axle_distance;
    for (const double share : {0.82, 0.7, 0.5}) {
        car.brakes.front_share = share;
        const Sheet sheet = sheetOf(car);
        const double force_share = value(sheet, "brake_front_share") / 100;
        EXPECT_NEAR(force_share, share, 0.01);
        const double crossing = (force_share * car.wheelbase - b) / car.centre_of_gravity_height;
        EXPECT_NEAR(value(sheet, "rear_locks_first_above"), std::max(crossing, 0.0), 0.005) << share;
        EXPECT_NEAR(value(sheet, "brake_ideal_front_share"),
                    100 * (b + 0.8 * car.centre_of_gravity_height) / car.wheelbase, 0.1);
    }
    car.brakes.front_share = 0.95;
    EXPECT_TRUE(std::isnan(value(sheetOf(car), "rear_locks_first_above"))) << "beyond what the brakes reach";
}

// The axle whose wheels are the first to stand, when the pedal goes down slowly on a road of some friction.
std::size_t firstToLock(const VehicleParams& car, double friction) {
    Scenario scenario = loadScenario(sourceFile("scenarios/straight_braking_100.yaml"));
    scenario.road.friction = friction;
    std::get<Ramp<Pedal>>(scenario.phases[1].brake).rate = 0.4;
    const Log log = simulate(car, scenario);
    const auto spin = [&](const char* wheel) { return log.find(std::string("wheel.") + wheel + ".spin")->values; };
    const auto front = spin("front_left"), rear = spin("rear_left");
    for (std::size_t i = 0; i < front.size(); ++i) {
        if (rear[i] < 0.1 * front[i]) return 1;
        if (front[i] < 0.1 * rear[i]) return 0;
    }
    return 2;
}

TEST(Sheet, TheAxleThatTheSheetNamesLocksFirst) {
    VehicleParams car = reference::compact();
    car.brakes.front_share = 0.72;
    const double above = value(sheetOf(car), "rear_locks_first_above");
    EXPECT_GT(above, 0.4);
    EXPECT_LT(above, 0.65);
    EXPECT_EQ(firstToLock(car, 0.25), 0u);
    EXPECT_EQ(firstToLock(car, 0.9), 1u);
    EXPECT_EQ(firstToLock(reference::compact(), 0.9), 0u);
}

// ---- Top speed ----

int gearOf(const SheetRow& top_speed) {
    return std::stoi(top_speed.note.substr(std::string("in gear ").size()));
}

// Change of speed within a second at full throttle in a gear, once the driveline has settled.
double gainAt(const VehicleParams& car, double speed, int gear) {
    const PlaneRoad road;
    reference::Car driven = reference::settled(car, road, {.speed = speed});
    DrivelineState& driveline = driven.state.driveline;
    const std::vector<double>& ratios = car.driveline.gearbox.ratios;
    const auto ratio = [&](int g) { return ratios[static_cast<std::size_t>(g - 1)]; };
    driveline.gearbox_speed *= ratio(gear) / ratio(driveline.gear);
    driveline.engine_speed = driveline.gearbox_speed;
    driveline.gear = gear;
    VehicleInput full = driven.input;
    full.throttle = 1;
    for (double t = 0; t < 1; t += 0.001) driven.step(full, 0.001);
    const double before = driven.output().chassis.vx;
    for (double t = 0; t < 1; t += 0.001) driven.step(full, 0.001);
    return driven.output().chassis.vx - before;
}

TEST(Sheet, TheCarGainsSpeedBelowItsTopSpeedAndLosesItAbove) {
    for (const char* file : {"compact", "rear_drive_sedan", "awd_suv", "pickup", "volvo_s90", "electric_hatchback"}) {
        const VehicleParams car = loadVehicle(sourceFile(std::string("vehicles/") + file + ".yaml"));
        const Sheet sheet = sheetOf(car);
        const SheetRow& top = row(sheet, "top_speed");
        EXPECT_GT(gainAt(car, 0.99 * top.value / kKmh, gearOf(top)), 0) << file;
        EXPECT_LT(gainAt(car, 1.01 * top.value / kKmh, gearOf(top)), 0) << file;
    }
}

// Through the gears, as the gearbox shifts: the Volvo stays in the last gear but one.
TEST(Sheet, FullThrottleEndsAtTheTopSpeedAndInItsGear) {
    for (const char* file : {"compact", "volvo_s90"}) {
        const VehicleParams car = loadVehicle(sourceFile(std::string("vehicles/") + file + ".yaml"));
        const Sheet sheet = sheetOf(car);
        const SheetRow& top = row(sheet, "top_speed");
        const PlaneRoad road;
        reference::Car driven = reference::settled(car, road, {.speed = 10});
        VehicleInput full = driven.input;
        full.throttle = 1;
        for (int i = 0; i < 120000; ++i) driven.step(full, 0.001);
        std::printf("%s: top speed %.2f km/h (simulated %.2f)\n", car.name.c_str(), top.value,
                    kKmh * driven.output().chassis.vx);
        EXPECT_NEAR(kKmh * driven.output().chassis.vx, top.value, 0.02 * top.value) << file << " after two minutes";
        EXPECT_EQ(driven.state.driveline.gear, gearOf(top)) << file;
    }
}

TEST(Sheet, TopSpeedIsLimitedByGearing) {
    VehicleParams car = reference::compact();
    car.driveline.gearbox.ratios = {3.55, 1.95, 1.29};
    const Sheet sheet = sheetOf(car);
    const double highest =
        car.driveline.engine->speed_limit / (1.29 * car.driveline.gearbox.final_drive) * car.front.tyre.parameters.Re;
    EXPECT_NEAR(value(sheet, "top_speed"), kKmh * highest, 0.01 * kKmh * highest);
    EXPECT_NE(row(sheet, "top_speed").note.find("gear 3: limited by gearing"), std::string::npos);

    // Without power there is none.
    car.driveline.engine->torque_scale = 0;
    const SheetRow none = row(sheetOf(car), "top_speed");
    EXPECT_TRUE(std::isnan(none.value));
    EXPECT_NE(none.note, "");
}

}  // namespace
}  // namespace tread::sheet::sheet_test
