// The same drive of the car as it was before: what the model lacked already is no cause.
#include "recording/reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "diagnose/answer/changed_numbers.h"
#include "diagnose/answer/diagnosis.h"
#include "diagnose/catalogue/effect.h"
#include "diagnose/diagnose.h"
#include "diagnose/model/noise.h"
#include "diagnose/model/parameter.h"
#include "diagnose/model/problem.h"
#include "diagnose/model/replays.h"
#include "diagnose/model/uncertainty.h"
#include "recording/diagnosis_file.h"
#include "recording/recorded_drive.h"
#include "recording/subject.h"
#include "shared/simple_car.h"

namespace tread::diagnose_reference_test {
namespace {

using recording::kBlock;

using diagnose::answer::Diagnosis;
using diagnose::answer::Estimate;
using diagnose::answer::Verdict;
using diagnose::catalogue::Effect;
using diagnose::model::endsOf;
using diagnose::model::nuisances;
using diagnose::model::Parameter;
using diagnose::model::Problem;
using diagnose::model::problemOf;
using diagnose::model::rowNoise;
using diagnose::model::Rows;
using diagnose::model::rowsAt;
using diagnose::model::temperatureOfTheTyres;
using recording::KnownWithin;
using recording::Recording;
using recording::Subject;
using recording::withChannelsOf;

using simple_car::effect;

constexpr double kOtherLength = 0.0004;  // m per (m/s)^2: an understeer of the real car that the model has not

// Slaloms of a car that the model is not, with a reference of it before its ratio became another.
simple_car::Case compared(double ratio) {
    VehicleParams before = simple_car::Case{}.nominal.vehicle;
    before.steering.play = kOtherLength;
    VehicleParams now = before;
    now.steering.ratio = ratio;
    const std::vector<Scenario> drives{simple_car::slalom(15), simple_car::slalom(20), simple_car::slalom(25)};
    simple_car::Case made = simple_car::recorded(now, drives, 3);
    made.recorded.references = simple_car::recorded(before, drives, 4).recorded.logs;
    for (Recording& recording : made.file.recordings) recording.reference = recording.log + " before";
    return made;
}

Diagnosis diagnosed(const simple_car::Case& made) {
    return diagnose::diagnosisOf(made.nominal, made.file, made.recorded,
                                 {effect("ratio", "steering.ratio"), effect("drag", "aero.drag_area")},
                                 simple_car::options());
}

TEST(Reference, WhatTheModelLackedAlreadyIsNoCause) {
    simple_car::Case same = compared(simple_car::Case{}.nominal.vehicle.steering.ratio);
    const Diagnosis d = diagnosed(same);
    EXPECT_EQ(d.verdict, Verdict::nothing) << d.answer;
    EXPECT_LT(d.how_far.training.nominal, 1.05) << "no more than noise";
    for (Recording& recording : same.file.recordings) recording.reference.clear();
    const Diagnosis without = diagnosed(same);
    EXPECT_NE(without.verdict, Verdict::nothing) << without.answer;
    EXPECT_GT(without.how_far.training.nominal, 2);
}

TEST(Reference, WhatChangedIsNamedWithItsSize) {
    const Diagnosis d = diagnosed(compared(15));
    ASSERT_EQ(d.causes, std::vector<std::string>{"ratio"}) << d.answer;
    const Estimate ratio = d.effects.front().parameters.at("steering.ratio");
    EXPECT_NEAR(ratio.value, 15, 3 * ratio.sd);
}

TEST(Reference, MayHaveAnotherClock) {
    const Recording drive{.log = "after.csv", .from = 2, .to = 9, .reference = "before.csv", .reference_later = 12.5};
    const Recording before = recording::referenceOf(drive);
    EXPECT_EQ(before.log, "before.csv");
    EXPECT_DOUBLE_EQ(before.from, 14.5);
    EXPECT_DOUBLE_EQ(before.to, 21.5);
    EXPECT_EQ(before.reference_later, 0);
    EXPECT_EQ(recording::referenceOf({.log = "after.csv", .reference = "before.csv"}).to, kInfinity);
}

// Both runs have their own noise.
TEST(Reference, RowsAreAsNoisyAsTwoRuns) {
    simple_car::Case made = compared(15);
    made.file.channels = {{.channel = "chassis.yaw_rate", .noise = 0.003}};
    const Problem problem =
        problemOf(made.nominal, made.file, made.recorded, std::vector<Effect>{}, simple_car::options());
    EXPECT_EQ(problem.drives.front().runs, 2);
    const std::optional<Rows> rows = rowsAt(problem.replays, problem.drives, problem.replays.origin());
    ASSERT_TRUE(rows);
    const double block = std::sqrt(kBlock / 0.01);
    EXPECT_GE(rowNoise(problem.drives, *rows, endsOf(problem.drives)).front().deviation(0),
              std::sqrt(2) * 0.003 / block * 0.999);
}

double toleranceIn(const std::vector<Parameter>& list, const std::string& path) {
    for (const Parameter& one : list)
        if (one.path() == path) return one.moves.front().by * std::sqrt(3.0);
    return 0;
}

TEST(Reference, ACarIsNearerToItselfThanToItsTolerances) {
    const Subject nominal = simple_car::Case{}.nominal;
    const std::vector<Parameter> all = nuisances(nominal, {}), fifth = nuisances(nominal, {}, 0.2);
    EXPECT_GT(toleranceIn(all, "inertia.roll"), 0);
    EXPECT_DOUBLE_EQ(toleranceIn(fifth, "inertia.roll"), 0.2 * toleranceIn(all, "inertia.roll"));
    EXPECT_DOUBLE_EQ(toleranceIn(fifth, "instruments.ay.bias"), toleranceIn(all, "instruments.ay.bias"));
}

TEST(Reference, ACarDiffersFromDayToDayAsWeatherAndLoadDoUnlessTheFileSaysLess) {
    const Subject nominal = simple_car::Case{}.nominal;
    const std::vector<Parameter> usual = nuisances(nominal, {}, 0.2),
                                 told = nuisances(nominal, {{"mass", 0, 3}, {"*.tyre.lambda.Ky", 0.5, 0}}, 0.2);
    EXPECT_NEAR(toleranceIn(usual, "mass"), 0.02 * nominal.vehicle.mass, 1e-9);
    EXPECT_NEAR(toleranceIn(usual, "front.tyre.lambda.Ky"), 0.022 * nominal.vehicle.front.tyre.lambda.Ky, 1e-12);
    EXPECT_NEAR(toleranceIn(told, "mass"), 3, 1e-9);
    EXPECT_NEAR(toleranceIn(told, "front.tyre.lambda.Ky"), 0.1 * nominal.vehicle.front.tyre.lambda.Ky, 1e-12);
}

// What one standard deviation of the temperature makes of a factor, as a share; 0: it does not move it.
double byTemperature(const Subject& nominal, const std::vector<KnownWithin>& tolerances, const std::string& path) {
    const auto temperature = temperatureOfTheTyres(nominal, tolerances);
    if (!temperature) return 0;
    for (const Parameter::Move& one : temperature->moves)
        if (one.path == path) return one.by / one.nominal;
    return 0;
}

TEST(Reference, ATemperatureIsThatOfAllTyresUnlessTheFileKnowsAFactorBetter) {
    const Subject nominal = simple_car::Case{}.nominal;
    const double usual = -0.0035 * 15 / std::sqrt(3.0);
    for (const std::string axle : {"front", "rear"}) {
        for (const std::string factor : {"Kx", "Ky", "mux", "muy"})
            EXPECT_NEAR(byTemperature(nominal, {}, axle + ".tyre.lambda." + factor), usual, 1e-12) << axle << factor;
        EXPECT_EQ(byTemperature(nominal, {}, axle + ".tyre.lambda.Kz"), 0) << "no factor of slip stiffness or friction";
    }
    const std::vector<KnownWithin> told{{"*.tyre.lambda.Ky", 0.011, 0}, {"*.tyre.lambda.mux", 0.1, 0}};
    EXPECT_NEAR(byTemperature(nominal, told, "front.tyre.lambda.Ky"), 0.5 * usual, 1e-12);
    EXPECT_NEAR(byTemperature(nominal, told, "front.tyre.lambda.mux"), usual, 1e-12);
    EXPECT_FALSE(temperatureOfTheTyres(nominal, {{"*.tyre.lambda.*", 0, 0}}));
}

// Only where two days are compared, and told in K.
TEST(Reference, TemperatureOfTheTyresIsAnUncertainNumberOfTwoDays) {
    const std::string name = "temperature of the tyres against the other day, K";
    const auto has = [&](const simple_car::Case& made) {
        const Problem problem =
            problemOf(made.nominal, made.file, made.recorded, std::vector<Effect>{}, simple_car::options());
        return std::any_of(problem.nuisances.begin(), problem.nuisances.end(),
                           [&](Eigen::Index i) { return problem.replays.parameters[i].name() == name; });
    };
    simple_car::Case made = compared(15);
    EXPECT_TRUE(has(made));
    for (Recording& recording : made.file.recordings) recording.reference.clear();
    EXPECT_FALSE(has(made));
    made.file.before = made.file.recordings;
    EXPECT_TRUE(has(made));
    EXPECT_EQ(diagnose::answer::numberInWords({name}), name);
}

TEST(Reference, AnotherDriveIsRefused) {
    simple_car::Case made = compared(15);
    std::swap(made.recorded.references[0], made.recorded.references[1]);
    try {
        diagnosed(made);
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(
            error.what(),
            "recording drive 1: starts at 15.00 m/s, its reference at 20.00 m/s, expected a reference of the same "
            "drive with the same time base; align the two logs or remove the reference");
    }
    made = compared(15);
    for (Channel& channel : made.recorded.references[2].channels)
        if (channel.name == "driver.steering_wheel_angle")
            for (double& angle : channel.values) angle = -angle;
    EXPECT_THROW(diagnosed(made), std::invalid_argument);
}

// Another zero of the steering angle may be the change that is sought. Beyond 0.2 rad, it is another drive.
TEST(Reference, MayHaveAnotherZeroOfTheSteering) {
    const auto straight = [](double by) {
        simple_car::Case made = compared(16);
        for (auto* logs : {&made.recorded.logs, &made.recorded.references})
            for (Channel& channel : (*logs)[0].channels)
                if (channel.name == "driver.steering_wheel_angle")
                    for (double& angle : channel.values) angle *= 0.1;
        for (Channel& channel : made.recorded.logs[0].channels)
            if (channel.name == "driver.steering_wheel_angle")
                for (double& angle : channel.values) angle += by;
        return made;
    };
    for (const double by : {-0.15, 0.15}) {
        const simple_car::Case made = straight(by);
        EXPECT_NO_THROW(problemOf(made.nominal, made.file, made.recorded, std::vector<Effect>{}, simple_car::options()))
            << by;
    }
    const simple_car::Case far = straight(0.4);
    EXPECT_THROW(problemOf(far.nominal, far.file, far.recorded, std::vector<Effect>{}, simple_car::options()),
                 std::invalid_argument);
}

// The pedal of a car that drags is at another level. A pedal that moves otherwise is another drive.
TEST(Reference, MayHaveAnotherLevelOfAPedal) {
    const auto pressed = [](auto&& throttle) {
        simple_car::Case made = compared(16);
        for (Recording& recording : made.file.recordings) recording.speed = recording::SpeedReplay::pedals;
        const auto set = [](Log& log, auto&& of) {
            const std::vector<double> time = log.channels.front().values;
            Channel* channel = nullptr;
            for (Channel& one : log.channels)
                if (one.name == "driver.throttle") channel = &one;
            if (!channel) channel = &log.channels.emplace_back(Channel{"driver.throttle", "-", {}});
            channel->values.resize(time.size());
            std::transform(time.begin(), time.end(), channel->values.begin(), of);
        };
        for (std::size_t i = 0; i < made.recorded.logs.size(); ++i) {
            set(made.recorded.references[i], [](double t) { return 0.2 + 0.01 * t; });
            set(made.recorded.logs[i], throttle);
        }
        return made;
    };
    const auto problem = [](const simple_car::Case& made) {
        return problemOf(made.nominal, made.file, made.recorded, std::vector<Effect>{}, simple_car::options());
    };
    EXPECT_NO_THROW(problem(pressed([](double t) { return 0.5 + 0.01 * t; })));
    EXPECT_THROW(problem(pressed([](double t) { return 0.5 + 0.4 * std::sin(3 * t); })), std::invalid_argument);
}

// Slaloms of a car whose drag became another, and other slaloms of it before. The nominal car has another ratio.
simple_car::Case changed(double drag_area) {
    VehicleParams car = simple_car::Case{}.nominal.vehicle;
    car.steering.ratio = 15.5;
    const simple_car::Case before = simple_car::recorded(car, {simple_car::slalom(12), simple_car::slalom(18)}, 4);
    car.aero.drag_area = drag_area;
    simple_car::Case made =
        simple_car::recorded(car, {simple_car::slalom(15), simple_car::slalom(20), simple_car::slalom(25)}, 3);
    made.file.before = before.file.recordings;
    made.recorded.before = before.recorded.logs;
    return made;
}

TEST(DrivesBefore, WhatTheNominalCarLackedAlreadyIsNoCause) {
    simple_car::Case same = changed(simple_car::Case{}.nominal.vehicle.aero.drag_area);
    const Diagnosis d = diagnosed(same);
    EXPECT_EQ(d.verdict, Verdict::nothing) << d.answer;
    EXPECT_NEAR(d.before.moved.at("steering.ratio").value, 15.5, 0.1);
    EXPECT_LT(d.how_far.training.nominal, 1.5) << "about the car before";
    EXPECT_FALSE(d.compared) << "nothing is subtracted";
    same.file.before.clear();
    same.recorded.before.clear();
    EXPECT_GT(diagnosed(same).how_far.training.nominal, 3);
}

TEST(DrivesBefore, WhatChangedIsNamed) {
    const Diagnosis d = diagnosed(changed(1.2));
    ASSERT_EQ(d.causes, std::vector<std::string>{"drag"}) << d.answer;
    const Estimate drag = d.effects.front().parameters.at("aero.drag_area");
    EXPECT_NEAR(drag.value, 1.2, 3 * drag.sd);
}

TEST(DrivesBefore, JoinTheReferences) {
    simple_car::Case made = compared(15);
    made.file.before = {{.log = "other.csv", .name = "other"}};
    made.recorded.before = {made.recorded.logs[0]};
    ASSERT_TRUE(recording::beforeTheChange(made.file, made.recorded));
    ASSERT_EQ(made.file.recordings.size(), 4u);
    EXPECT_EQ(made.file.recordings.back().name, "other");
    EXPECT_EQ(made.recorded.logs.size(), 4u);
    EXPECT_TRUE(made.file.before.empty() && made.recorded.before.empty());
}

TEST(Reference, OnlyChannelsOfBothAreCompared) {
    const Log log{{{"time", "s", {0}}, {"chassis.ay", "m/s2", {1}}, {"chassis.vx", "m/s", {1}}, {"own", "", {1}}}};
    const Log common = withChannelsOf(log, {{{"time", "s", {0}}, {"chassis.vx", "m/s", {1}}}});
    EXPECT_FALSE(common.find("chassis.ay"));
    EXPECT_TRUE(common.find("chassis.vx") && common.find("own"));
}

}  // namespace
}  // namespace tread::diagnose_reference_test
