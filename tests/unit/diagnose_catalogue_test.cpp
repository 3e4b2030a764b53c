// The catalogue of effects: its rows name numbers that exist and act, and say what a reader needs.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "base/fields/numbers.h"
#include "diagnose/catalogue/effect.h"
#include "diagnose/model/parameter.h"
#include "diagnose/model/similarity.h"
#include "recording/subject.h"
#include "shared/vehicle_run.h"

namespace tread::diagnose_catalogue_test {
namespace {

namespace model = diagnose::model;
using diagnose::catalogue::applies;
using diagnose::catalogue::Direction;
using diagnose::catalogue::Effect;
using diagnose::catalogue::effectCatalogue;
using diagnose::catalogue::Knob;
using diagnose::catalogue::move;
using recording::numberAt;
using recording::Subject;

const char* const kCars[] = {"compact", "awd_suv",          "dart",       "electric_hatchback", "liu_compact",
                             "pickup",  "rear_drive_sedan", "sports_car", "volvo_s90"};

Subject subjectOf(const std::string& car) {
    Subject subject;
    subject.vehicle = loadVehicle(sourceFile("vehicles/" + car + ".yaml"));
    return subject;
}

const Effect& effectOf(std::string_view name) {
    for (const Effect& effect : effectCatalogue()) {
        if (effect.name == name) return effect;
    }
    throw std::runtime_error("no effect " + std::string(name));
}

TEST(Catalogue, HasTheEffectsThatItMustHaveAndEveryNameOnce) {
    std::set<std::string> names;
    for (const Effect& effect : effectCatalogue()) EXPECT_TRUE(names.insert(effect.name).second) << effect.name;
    EXPECT_GE(names.size(), 55u);
    for (const std::string name : {"aero_drag",
                                   "aero_lift",
                                   "wind",
                                   "rolling_resistance",
                                   "grade",
                                   "bank",
                                   "mass",
                                   "yaw_inertia",
                                   "cg_fore_aft",
                                   "cg_height",
                                   "load_offset",
                                   "load",
                                   "roof_load",
                                   "fuel",
                                   "another_tyre",
                                   "tyre_front_left",
                                   "tyre_rear_right",
                                   "grip",
                                   "grip_left_right",
                                   "cornering_stiffness_front",
                                   "cornering_stiffness_rear",
                                   "load_sensitivity",
                                   "tyre_relaxation",
                                   "pneumatic_trail",
                                   "camber_thrust",
                                   "ply_steer",
                                   "conicity",
                                   "tyre_temperature",
                                   "tyre_pressure",
                                   "wheel_radius",
                                   "wheel_inertia",
                                   "belt_gyroscopics",
                                   "steering_ratio",
                                   "steering_compliance",
                                   "steering_delay",
                                   "steering_play",
                                   "steering_zero",
                                   "roll_steer_rear",
                                   "compliance_steer_rear",
                                   "roll_stiffness_distribution",
                                   "roll_stiffness",
                                   "dampers",
                                   "bump_stops",
                                   "roll_centre_height",
                                   "brake_gain",
                                   "brake_balance",
                                   "brake_fade",
                                   "brake_delay",
                                   "drive_gain",
                                   "engine_braking",
                                   "differential_locking",
                                   "stability_control",
                                   "anti_lock",
                                   "gyro_bias",
                                   "gyro_scale",
                                   "accelerometer_bias",
                                   "accelerometer_scale",
                                   "accelerometer_position",
                                   "sensor_delay",
                                   "speed_scale"})
        EXPECT_TRUE(names.count(name)) << name;
}

TEST(Catalogue, EveryRowSaysWhatItAsksAndWhereItsSizesComeFrom) {
    for (const Effect& effect : effectCatalogue()) {
        EXPECT_NE(effect.question.find('?'), std::string::npos) << effect.name;
        EXPECT_FALSE(effect.source.empty()) << effect.name;
        ASSERT_FALSE(effect.knobs.empty()) << effect.name;
        for (const Knob& knob : effect.knobs) {
            EXPECT_GT(knob.typical, 0) << effect.name;
            EXPECT_FALSE(knob.paths.empty()) << effect.name;
            EXPECT_TRUE(knob.shares.empty() || knob.shares.size() == knob.paths.size()) << effect.name;
        }
    }
}

TEST(Catalogue, RowsThatCanImitateEachOtherNameEachOther) {
    const auto names = [](const Effect& one, const std::string& other) {
        return std::find(one.alike.begin(), one.alike.end(), other) != one.alike.end();
    };
    std::size_t pairs = 0;
    for (const Effect& effect : effectCatalogue()) {
        EXPECT_FALSE(names(effect, effect.name)) << effect.name;
        for (const std::string& other : effect.alike) {
            EXPECT_TRUE(names(effectOf(other), effect.name)) << effect.name << ", " << other;
            EXPECT_EQ(std::count(effect.alike.begin(), effect.alike.end(), other), 1) << effect.name;
            ++pairs;
        }
    }
    EXPECT_GT(pairs, 60u);
    EXPECT_TRUE(names(effectOf("wheel_radius"), "wheel_speed_scale"));
    EXPECT_TRUE(names(effectOf("cornering_stiffness_rear"), "compliance_steer_rear"));
    EXPECT_TRUE(names(effectOf("load"), "mass"));
}

TEST(Catalogue, NoFamilyNamesAnEffectThatDoesNotExist) {
    for (const Effect& effect : effectCatalogue()) {
        for (const std::string& other : effect.alike) EXPECT_NO_THROW(effectOf(other)) << effect.name;
    }
}

TEST(Catalogue, EveryPathExistsInSomeCar) {
    std::set<std::string> known;
    Subject limited = subjectOf("compact");  // no shipped car has one in front
    limited.vehicle.driveline.front_differential = LimitedSlipDifferential{};
    for (const Number& number : numbers(limited)) known.insert(number.path);
    for (const char* car : kCars) {
        Subject subject = subjectOf(car);
        for (const Number& number : numbers(subject)) known.insert(number.path);
    }
    for (const Effect& effect : effectCatalogue()) {
        for (const Knob& knob : effect.knobs) {
            for (const std::string& path : knob.paths) EXPECT_TRUE(known.count(path)) << effect.name << ": " << path;
        }
    }
}

TEST(Catalogue, EveryEffectAppliesToEveryShippedCar) {
    for (const char* car : kCars) {
        const Subject subject = subjectOf(car);
        for (const Effect& effect : effectCatalogue())
            EXPECT_TRUE(applies(effect, subject)) << car << ": " << effect.name;
    }
}

TEST(Catalogue, SizesFollowTheScaleOfTheCar) {
    const VehicleParams road = subjectOf("compact").vehicle, small = subjectOf("dart").vehicle;
    for (const char* unit : {"m", "N/m", "kg m2", "s"}) EXPECT_EQ(model::atScaleOf(road, 0.06, unit), 0.06) << unit;
    const double length = 0.1735 / 2.6, mass = 1.58 / 1400;
    EXPECT_DOUBLE_EQ(model::atScaleOf(small, 0.06, "m"), 0.06 * length);
    EXPECT_DOUBLE_EQ(model::atScaleOf(small, 20, "kg m2"), 20 * mass * length * length);
    EXPECT_NEAR(model::atScaleOf(small, 6000, "N/m"), 6000 * mass / length, 1e-9);
    EXPECT_NEAR(model::atScaleOf(small, 100, "N s/m"), 100 * mass / std::sqrt(length), 1e-9);
    EXPECT_NEAR(model::atScaleOf(small, 0.012, "rad/(N m)"), 0.012 / (mass * length), 1e-9);
    EXPECT_NEAR(model::atScaleOf(small, 0.1, "rad/m"), 0.1 / length, 1e-9);
    for (const char* unit : {"s", "m/s", "rad", "-", "m/s2", "rad/s"})
        EXPECT_EQ(model::atScaleOf(small, 4, unit), 4) << unit;
}

TEST(Catalogue, KnobsOfASmallCarAreSmall) {
    const std::vector<model::Parameter> knobs = model::knobsOf(effectOf("cg_height"), subjectOf("dart"));
    ASSERT_EQ(knobs.size(), 1u);
    EXPECT_DOUBLE_EQ(knobs.front().moves.front().by, 0.06 * 0.1735 / 2.6);
    for (const model::Parameter& one : model::nuisances(subjectOf("dart"), {})) {
        if (one.name() == "instruments.inertial_unit.x") {
            EXPECT_LT(one.moves.front().by, 0.001);
        }
    }
}

TEST(Catalogue, KnobsMoveTheirNumbersByTheTypicalSizeIntoEveryDirectionThatTheyMay) {
    const Subject nominal = subjectOf("compact");
    for (const Effect& effect : effectCatalogue()) {
        for (const Knob& knob : effect.knobs) {
            for (const double sign : {1.0, -1.0}) {
                if (knob.direction != Direction::either && (knob.direction == Direction::up) != (sign > 0)) continue;
                Subject moved = nominal;
                if (!move(moved, knob, sign * knob.typical)) continue;
                Subject before = nominal;
                for (std::size_t i = 0; i < knob.paths.size(); ++i) {
                    const double* value = numberAt(moved, knob.paths[i]);
                    if (!value) continue;
                    const double from = *numberAt(before, knob.paths[i]);
                    const double share = knob.shares.empty() ? 1 : knob.shares[i];
                    const double change = sign * share * knob.typical * (knob.relative ? from : 1);
                    EXPECT_NEAR(*value, from + change, 1e-9 * std::abs(from)) << effect.name << ": " << knob.paths[i];
                    EXPECT_NE(change, 0) << effect.name << ": " << knob.paths[i];
                }
            }
        }
    }
}

// What a car does in a manoeuvre with an effect of a size; the instruments do not matter to it.
Log driven(const Subject& subject, Scenario scenario) {
    scenario.road.grade += subject.road.grade;
    scenario.road.bank += subject.road.bank;
    scenario.road.friction *= subject.road.friction;
    scenario.wind = subject.wind;
    scenario.step = 0.002;
    scenario.log = {.rate = 10, .channels = {"chassis.*", "wheel.*.spin", "wheel.*.load"}};
    return simulate(subject.vehicle, scenario);
}

double largestChange(const Log& a, const Log& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.channels.size(); ++i) {
        const auto &x = a.channels[i].values, &y = b.channels[i].values;
        for (std::size_t k = 0; k < std::min(x.size(), y.size()); ++k) {
            const double size = std::max(std::abs(x[k]), 1.0);
            largest = std::max(largest, std::abs(x[k] - y[k]) / size);
        }
    }
    return largest;
}

TEST(Catalogue, EveryKnobThatIsNotAnInstrumentChangesSomeManoeuvre) {
    constexpr double kFelt = 1e-5;  // of each channel's value: far above rounding
    const Subject nominal = subjectOf("compact");
    std::vector<Scenario> scenarios;
    std::vector<Log> before;
    for (const std::string name : {"sine_with_dwell", "braking_in_turn", "straight_braking_100", "power_off_in_turn",
                                   "bump", "acceleration_100"}) {
        scenarios.push_back(shared::scenario(name));
        before.push_back(driven(nominal, scenarios.back()));
    }
    for (const Effect& effect : effectCatalogue()) {
        for (const Knob& knob : effect.knobs) {
            if (knob.paths.front().starts_with("instruments.")) continue;
            Subject subject = nominal;
            move(subject, knob, knob.direction == Direction::down ? -knob.typical : knob.typical);
            double change = 0;
            for (std::size_t i = 0; i < scenarios.size() && change < kFelt; ++i)
                change = largestChange(driven(subject, scenarios[i]), before[i]);
            EXPECT_GE(change, kFelt) << effect.name << ": " << knob.paths.front();
        }
    }
}

TEST(EffectKnob, StaysWithinTheLimitsOfItsNumbers) {
    Subject subject = subjectOf("compact");
    const double radius = subject.vehicle.front.tyre.parameters.Re;
    move(subject, {.paths = {"road.friction", "brakes.front_share"}}, -5);
    EXPECT_EQ(subject.road.friction, 0);
    EXPECT_EQ(subject.vehicle.brakes.front_share, 0);
    move(subject, {.paths = {"front.tyre.parameters.Re"}}, -5);
    EXPECT_EQ(subject.vehicle.front.tyre.parameters.Re, 0.5 * radius) << "0 does not belong to its range";
}

TEST(EffectKnob, LeavesOutWhatTheCarDoesNotHave) {
    Subject petrol = subjectOf("compact"), electric = subjectOf("electric_hatchback");
    const Knob& gain = effectOf("drive_gain").knobs.front();
    const double torque = electric.vehicle.driveline.motor->torque;
    EXPECT_TRUE(move(petrol, gain, 0.1));
    EXPECT_TRUE(move(electric, gain, 0.1));
    EXPECT_DOUBLE_EQ(petrol.vehicle.driveline.engine->torque_scale, 1.1);
    EXPECT_DOUBLE_EQ(electric.vehicle.driveline.motor->torque, 1.1 * torque);
    EXPECT_FALSE(move(petrol, {.paths = {"driveline.motor.torque"}}, 0.1));
}

TEST(EffectKnob, SharesMoveAxlesAgainstEachOther) {
    Subject subject = subjectOf("compact");
    const double front = subject.vehicle.front.suspension.anti_roll_bar;
    const double rear = subject.vehicle.rear.suspension.anti_roll_bar;
    move(subject, effectOf("roll_stiffness_distribution").knobs.front(), 2000);
    EXPECT_EQ(subject.vehicle.front.suspension.anti_roll_bar, front + 2000);
    EXPECT_EQ(subject.vehicle.rear.suspension.anti_roll_bar, rear - 2000);
}

TEST(EffectKnob, RollStiffnessTakesBothBarsAway) {
    const Subject with = subjectOf("compact");
    ASSERT_NE(with.vehicle.front.suspension.anti_roll_bar, with.vehicle.rear.suspension.anti_roll_bar);
    const model::Parameter knob = model::knobsOf(effectOf("roll_stiffness"), with).at(0);
    Subject without = with;
    model::move(without, knob, knob.lowest);
    EXPECT_EQ(without.vehicle.front.suspension.anti_roll_bar, 0);
    EXPECT_EQ(without.vehicle.rear.suspension.anti_roll_bar, 0);
    EXPECT_FALSE(knob.implausibleAt(knob.lowest));
}

}  // namespace
}  // namespace tread::diagnose_catalogue_test
