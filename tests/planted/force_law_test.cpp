// A force that follows the motion of the car, and that no effect of the catalogue is: found as such, with its size.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "blind/drives/measure.h"
#include "blind/world/instruments.h"
#include "diagnose/answer/diagnosis.h"
#include "diagnose/catalogue/effect.h"
#include "diagnose/diagnose.h"
#include "planted/planted.h"
#include "recording/diagnosis_file.h"
#include "recording/subject.h"

namespace tread::force_law_test {
namespace {

using blind::drives::caseDrives;
using blind::drives::Drive;
using blind::drives::DriveSet;
using blind::drives::measure;
using blind::world::InstrumentSheet;
using blind::world::instrumentSheets;
using blind::world::Truth;
using diagnose::answer::Diagnosis;
using diagnose::answer::ForceLaw;
using diagnose::answer::Verdict;
using diagnose::catalogue::Effect;
using diagnose::catalogue::effectCatalogue;
using recording::DiagnosisFile;
using recording::MeasuredChannel;
using recording::Recording;
using recording::Subject;

Diagnosis diagnosed(const std::function<Pushing()>& push, DriveSet drives = DriveSet::step_steers) {
    Subject nominal;
    nominal.vehicle = planted::nominalCar();
    Truth truth;
    truth.car = nominal;
    truth.push = push;
    DiagnosisFile file;
    file.vehicle = "car";
    for (const InstrumentSheet& sheet : instrumentSheets()) {
        MeasuredChannel& channel = file.channels.emplace_back();
        channel.channel = sheet.channel, channel.noise = sheet.noise;
    }
    std::vector<Log> logs;
    for (const Drive& drive : caseDrives(drives)) {
        if (drive.hold_out) continue;
        Recording& recording = file.recordings.emplace_back();
        recording.log = recording.name = drive.name;
        logs.push_back(measure(truth, drive, 40 + logs.size()));
    }
    file.tolerances = {{"*", 0, 0}, {"mass", 0.02, 0}, {"front.tyre.lambda.Ky", 0.02, 0}};
    std::vector<Effect> effects;
    for (const Effect& effect : effectCatalogue()) {
        for (const char* name : {"mass", "grip", "camber_thrust", "yaw_inertia", "cornering_stiffness_rear"})
            if (effect.name == name) effects.push_back(effect);
    }
    return diagnose::diagnosisOf(nominal, file, {logs}, effects);
}

TEST(ForceLaw, OfAMassThatSwingsAcrossTheCarIsFoundWithItsMass) {
    constexpr double kMass = 150, kFrequency = 0.65;
    const Diagnosis d = diagnosed([] {
        return
            [place = 0.0, rate = 0.0, last = 0.0](double time, const VehicleInput&, const VehicleOutput& car) mutable {
                constexpr double kOmega = 2 * 3.141592653589793 * kFrequency;
                const double dt = time - last, pull = kOmega * kOmega * place + 0.2 * kOmega * rate;
                last = time;
                rate += dt * (-pull - car.chassis.ay);
                place += dt * rate;
                return Push{.force = {0, kMass * pull, 0}, .moment = {}};
            };
    });
    EXPECT_EQ(d.verdict, Verdict::unknown) << d.answer;
    EXPECT_NE(d.unexplained.law.follows.find("oscillates laterally at 0.65 Hz"), std::string::npos) << d.answer;
    EXPECT_EQ(d.unexplained.generalised_force, "lateral");
    EXPECT_NEAR(d.unexplained.law.coefficients.at("lateral"), kMass, 0.2 * kMass);
}

// A force in proportion to the lateral acceleration is an error of the model's forces, and is told as one.
TEST(ForceLaw, OfARearAxleThatPushesAsideInEveryTurnIsAnErrorOfTheForces) {
    constexpr double kForce = 80, kArm = 1.4;  // N per m/s2, m
    const Diagnosis d = diagnosed([] {
        return [](double, const VehicleInput&, const VehicleOutput& car) {
            const double force = kForce * std::abs(car.chassis.ay);
            return Push{.force = {0, force, 0}, .moment = {0, 0, -kArm * force}};
        };
    });
    EXPECT_EQ(d.verdict, Verdict::unknown) << d.answer;
    const auto largest = std::max_element(d.unexplained.sizes.begin(), d.unexplained.sizes.end(),
                                          [](const auto& a, const auto& b) { return a.second < b.second; });
    EXPECT_TRUE(largest->first == "yaw error" || largest->first == "lateral error") << largest->first;
    EXPECT_GT(largest->second, 7);
}

TEST(ForceLaw, OfARollSpringWithSlackIsFoundWithItsMoment) {
    constexpr double kMoment = 400;  // N m, of a spring that carries nothing before the car leans at 1 m/s2
    const Diagnosis d = diagnosed([] {
        return [](double, const VehicleInput&, const VehicleOutput& car) {
            return Push{.force = {}, .moment = {kMoment * std::clamp(car.chassis.ay, -1.0, 1.0), 0, 0}};
        };
    });
    EXPECT_EQ(d.verdict, Verdict::unknown) << d.answer;
    EXPECT_EQ(d.unexplained.law.follows, "the lateral acceleration up to 1 m/s2") << d.answer;
    EXPECT_EQ(d.unexplained.generalised_force, "roll");
    EXPECT_NEAR(d.unexplained.law.coefficients.at("roll"), kMoment, 0.2 * kMoment);
}

// Its estimated size, which is not tested, is three quarters of the true one.
TEST(ForceLaw, OfARollSpringThatStiffensIsFound) {
    constexpr double kMoment = 15;  // N m per m2/s4: 400 N m at 0.5 g
    const Diagnosis d = diagnosed([] {
        return [](double, const VehicleInput&, const VehicleOutput& car) {
            return Push{.force = {}, .moment = {-kMoment * car.chassis.ay * std::abs(car.chassis.ay), 0, 0}};
        };
    });
    EXPECT_EQ(d.verdict, Verdict::unknown) << d.answer;
    EXPECT_EQ(d.unexplained.law.follows, "the signed square of the lateral acceleration") << d.answer;
    EXPECT_EQ(d.unexplained.generalised_force, "roll");
    EXPECT_LT(d.unexplained.law.coefficients.at("roll"), 0);
}

// As of half-shafts of different length.
TEST(ForceLaw, OfADriveThatPullsToOneSideIsFoundWithItsMoment) {
    constexpr double kMoment = 250;  // N m per m/s2
    const auto drivePulls = [] {
        return [](double, const VehicleInput&, const VehicleOutput& car) {
            return Push{.force = {}, .moment = {0, 0, kMoment * std::max(car.chassis.ax, 0.0)}};
        };
    };
    const Diagnosis d = diagnosed(drivePulls, DriveSet::coast_and_accelerate);
    EXPECT_EQ(d.verdict, Verdict::unknown) << d.answer;
    EXPECT_EQ(d.unexplained.law.follows, "the longitudinal acceleration while the car speeds up") << d.answer;
    EXPECT_EQ(d.unexplained.generalised_force, "yaw");
    EXPECT_NEAR(d.unexplained.law.coefficients.at("yaw"), kMoment, 0.2 * kMoment);
}

TEST(ForceLaw, IsNotSeenInACarThatIsAsItsFileSays) {
    const Diagnosis d = diagnosed({});
    EXPECT_TRUE(d.unexplained.law.follows.empty()) << d.unexplained.law.follows;
    EXPECT_EQ(d.unexplained.law.gain, 0) << "none is told";
}

}  // namespace
}  // namespace tread::force_law_test
