// Hard ranges: every number that a fit can move has one, and its parameters keep within.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/fields/numbers.h"
#include "diagnose/catalogue/effect.h"
#include "diagnose/catalogue/plausible.h"
#include "diagnose/model/imperfection.h"
#include "diagnose/model/parameter.h"
#include "shared/vehicles.h"

namespace tread::diagnose_plausible_test {
namespace {

using diagnose::catalogue::Effect;
using diagnose::catalogue::effectCatalogue;
using diagnose::catalogue::Knob;
using diagnose::catalogue::plausibleLimits;
using diagnose::catalogue::plausibleRange;
using diagnose::catalogue::plausibleText;
using diagnose::model::knobsOf;
using diagnose::model::nuisances;
using diagnose::model::Parameter;
using diagnose::model::partOf;
using recording::Subject;

const char* const kCars[] = {"compact", "awd_suv",          "electric_hatchback", "liu_compact",
                             "pickup",  "rear_drive_sedan", "sports_car",         "volvo_s90"};

Subject subjectOf(const std::string& car) {
    Subject subject;
    subject.vehicle = loadVehicle(sourceFile("vehicles/" + car + ".yaml"));
    return subject;
}

TEST(Imperfection, EveryNumberOfTheCatalogueBelongsToAPart) {
    using diagnose::model::Part;
    const std::vector<std::pair<std::string, Part>> some{
        {"front.tyre.lambda.Ky", Part::tyre},
        {"front.left.grip", Part::tyre},
        {"rear.wheel_inertia", Part::tyre},
        {"rear.tyre_surroundings.conicity", Part::tyre},
        {"front.suspension.toe", Part::suspension},
        {"rear.unsprung_mass", Part::suspension},
        {"steering.ratio", Part::steering},
        {"brakes.delay", Part::drive},
        {"driveline.shaft_stiffness", Part::drive},
        {"load.mass", Part::body},
        {"aero.drag_area", Part::body},
        {"road.bank", Part::surroundings},
        {"wind.x", Part::surroundings},
        {"instruments.further.chassis.vx@can.gain", Part::instruments}};
    for (const auto& [path, part] : some) EXPECT_EQ(partOf(path), part) << path;
    // What is left over for the body is of the body.
    for (const Effect& effect : effectCatalogue())
        for (const Knob& knob : effect.knobs)
            for (const std::string& path : knob.paths) {
                if (partOf(path) != Part::body) continue;
                const std::string first = path.substr(0, path.find('.'));
                EXPECT_TRUE(first == "mass" || first == "inertia" || first == "load" || first == "aero" ||
                            first == "front_axle_distance" || first == "centre_of_gravity_height" ||
                            first == "lateral_offset")
                    << path;
            }
}

TEST(PlausibleRange, IsKnownForEveryNumberThatAFitCanMove) {
    for (const char* car : kCars) {
        for (const Parameter& one : nuisances(subjectOf(car), {}))
            EXPECT_TRUE(plausibleRange(one.path())) << one.path();
    }
    for (const Effect& effect : effectCatalogue()) {
        for (const Knob& knob : effect.knobs) {
            for (const std::string& path : knob.paths) EXPECT_TRUE(plausibleRange(path)) << effect.name << ": " << path;
        }
    }
}

TEST(PlausibleRange, LeavesEveryEffectRoomForItsTypicalSize) {
    for (const char* car : kCars) {
        for (const Effect& effect : effectCatalogue()) {
            for (const Parameter& knob : knobsOf(effect, subjectOf(car)))
                EXPECT_GE(std::max(knob.highest, -knob.lowest), 1) << car << ": " << effect.name << " " << knob.path();
        }
    }
}

TEST(PlausibleRange, HoldsTheShippedCars) {
    for (const char* car : kCars) {
        Subject subject = subjectOf(car);
        for (const Number& number : numbers(subject)) {
            if (!plausibleRange(number.path) || number.path.ends_with("ackermann")) continue;
            const Limits limits = plausibleLimits(number.path, *number.value, subject.vehicle);
            EXPECT_TRUE(limits.allow(*number.value)) << car << ": " << number.path;
        }
    }
}

TEST(PlausibleRange, IsAFactorOnTheNumberOrAMultipleOfTheCar) {
    VehicleParams car = reference::compact();
    car.mass = 1000, car.wheelbase = 2.5, car.front_axle_distance = 1, car.centre_of_gravity_height = 0.5;
    const auto ends = [&](const char* path, double nominal, double low, double high) {
        const Limits limits = plausibleLimits(path, nominal, car);
        EXPECT_NEAR(limits.lowest, low, 1e-9) << path;
        EXPECT_NEAR(limits.highest, high, 1e-9) << path;
    };
    ends("mass", 1000, 700, 1600);
    ends("load.mass", 0, -100, 600);
    ends("load.moment_x", 0, -625, 625);
    ends("inertia.yaw", 1500, 0.6 * 1000 * 1 * 1.5, 1.4 * 1000 * 1 * 1.5);
    ends("front_axle_distance", 1, 0.625, 1.875);
    ends("rear.tyre.parameters.Re", 0.3, 0.27, 0.33);
    ends("front.tyre.lambda.Ky", 1, 0.3, 2.5);
    ends("wind.y", 0, -15, 15);
    ends("instruments.yaw_rate.delay", 0, -0.1, 0.5);
    EXPECT_EQ(plausibleText("mass"), "0.7 to 1.6 x the nominal value");
    EXPECT_EQ(plausibleText("road.bank"), "-0.1 to 0.1");
    EXPECT_EQ(plausibleText("no.such.number"), "");
}

// A car of another kind, such as a model car: its own number and the surroundings of it are plausible.
TEST(PlausibleRange, GrowsAroundANominalValueOutsideIt) {
    VehicleParams car = reference::compact();
    car.mass = 1000, car.wheelbase = 2.5, car.front_axle_distance = 1;
    const Limits limits = plausibleLimits("inertia.yaw", 600, car);
    EXPECT_NEAR(limits.lowest, 450, 1e-9);
    EXPECT_NEAR(limits.highest, 2100, 1e-9);
}

TEST(PlausibleRange, BoundsTheParameters) {
    const Subject nominal = subjectOf("compact");
    for (const Parameter& one : nuisances(nominal, {})) {
        if (one.path() != "mass") continue;
        const Parameter::Move& mass = one.moves.front();
        EXPECT_NEAR(mass.nominal + one.lowest * mass.by, 0.7 * nominal.vehicle.mass, 1e-6);
        EXPECT_NEAR(mass.nominal + one.highest * mass.by, 1.6 * nominal.vehicle.mass, 1e-6);
    }
    // The tightest of all numbers that move together: more fuel can be behind the centre of gravity, not far above.
    const Effect both{.name = "both",
                      .question = "",
                      .source = "",
                      .knobs = {{.paths = {"load.mass", "load.moment_z"}, .typical = 10, .shares = {1, -1}}}};
    const Parameter knob = knobsOf(both, nominal).front();
    const double height = nominal.vehicle.mass * nominal.vehicle.centre_of_gravity_height;
    EXPECT_NEAR(10 * knob.highest, std::min(0.6 * nominal.vehicle.mass, 0.3 * height), 1e-9);
    EXPECT_NEAR(10 * knob.lowest, -std::min(0.1 * nominal.vehicle.mass, 0.4 * height), 1e-9);
}

// The load has the numbers of the fuel, and a wider range.
TEST(PlausibleRange, OfAnEffectMayBeNarrowerThanThatOfItsNumbers) {
    const Subject nominal = subjectOf("compact");
    Effect tank{.name = "tank",
                .question = "",
                .source = "",
                .knobs = {{.paths = {"load.mass"}, .typical = 20, .largest = 50}}};
    const Parameter knob = knobsOf(tank, nominal).front();
    EXPECT_NEAR(knob.highest, 2.5, 1e-12);
    EXPECT_NEAR(knob.lowest, -2.5, 1e-12);
    EXPECT_TRUE(knob.implausibleAt(2.5));
    tank.knobs.front().largest = 1e6;
    EXPECT_NEAR(20 * knobsOf(tank, nominal).front().highest, 0.6 * nominal.vehicle.mass, 1e-9);
}

}  // namespace
}  // namespace tread::diagnose_plausible_test
