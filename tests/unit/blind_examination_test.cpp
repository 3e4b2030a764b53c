// Detectability of faults in simulated drives: how it depends on noise, tolerances, repeats and size.
#include <gtest/gtest.h>

#include <cmath>

#include "blind/detectability/case_detectability.h"
#include "blind/detectability/drive_replay.h"
#include "blind/detectability/noise_and_pushes.h"
#include "blind/drives/measure.h"
#include "blind/faults/outsiders.h"
#include "diagnose/catalogue/effect.h"
#include "recording/subject.h"
#include "shared/vehicles.h"

namespace tread::blind_examination_test {
namespace {

using blind::detectability::detectabilities;
using blind::detectability::DriveColumns;
using blind::detectability::examination;
using blind::detectability::Examination;
using blind::detectability::ExaminedDrive;
using blind::detectability::noiseAndPushes;
using blind::detectability::products;
using blind::detectability::rowsOf;
using blind::drives::caseDrives;
using blind::drives::Drive;
using blind::drives::DriveSet;
using blind::drives::kIdeal;
using blind::drives::measure;
using blind::drives::readingsOf;
using blind::faults::drawCase;
using blind::faults::DrawnCase;
using blind::key::CaseKind;
using blind::key::Detectability;
using blind::world::openNumbers;
using blind::world::PushSource;
using blind::world::ReadingNoise;
using blind::world::Truth;
using blind::world::World;
using diagnose::catalogue::Direction;
using diagnose::catalogue::Effect;
using recording::Subject;

// Effects on the body, the recorded steering, an instrument and the engine.
const std::vector<Effect> kEffects{
    {"heavier", "", "", {{{"mass"}, 0.1, true, Direction::up}}},
    {"steering_zero", "", "", {{{"instruments.steering_wheel_angle.bias"}, 0.035}}},
    {"late_gyro", "", "", {{{"instruments.yaw_rate.delay"}, 0.02, false, Direction::up}}},
    {"weaker", "", "", {{{"driveline.engine.torque_scale"}, 0.1, true, Direction::down}}},
};

Subject known() {
    return {.vehicle = reference::compact(), .road = {}, .wind = {}, .instruments = {}};
}

std::vector<Drive> twoDrives() {
    return caseDrives(DriveSet::step_steers);
}

// A case of one effect of `size` typical sizes in a car with errors.
DrawnCase planted(const std::string& name, double size) {
    Random random(8);
    DrawnCase drawn = drawCase(reference::compact(), kEffects, CaseKind::none, random);
    drawn.key.effects = {name};
    drawn.without[name] = drawn.truth;
    for (const Effect& effect : kEffects)
        if (effect.name == name) move(drawn.truth.car, effect.knobs[0], size * effect.knobs[0].typical);
    return drawn;
}

// Without uncertain numbers: only noise and pushes limit detectability.
const Examination& knownAll() {
    static const Examination one = examination(known(), twoDrives(), {}, kEffects);
    return one;
}
const Examination& usual() {
    static const Examination one = examination(known(), twoDrives(), openNumbers(known()), kEffects);
    return one;
}

Detectability shown(const Examination& examiner, const DrawnCase& drawn) {
    return detectabilities(examiner, drawn).at(drawn.key.effects.front());
}

TEST(BlindExamination, TwiceTheNoiseAndPushesShowAQuarter) {
    const DrawnCase quiet = planted("late_gyro", 1);
    DrawnCase loud = quiet;
    for (Truth* truth : {&loud.truth, &loud.without.at("late_gyro")}) {
        for (ReadingNoise& noise : truth->own->noise) {
            for (double* size : {&noise.level, &noise.resolution, &noise.jitter, &noise.shaking, &noise.engine})
                *size *= 2;
        }
        for (PushSource& source : truth->own->surroundings) {
            source.push.force *= 2;
            source.push.moment *= 2;
        }
    }
    Examination same_start = knownAll();
    for (ExaminedDrive& drive : same_start.drives) drive.differences.setZero(), drive.by_start_speed.setZero();
    EXPECT_NEAR(shown(same_start, quiet).nats / shown(same_start, loud).nats, 4, 0.01)
        << "but for parts of the pushes that are left out";
    EXPECT_NEAR(shown(knownAll(), quiet).nats / shown(knownAll(), loud).nats, 3, 1)
        << "what differs from drive to drive does not grow";
}

TEST(BlindExamination, RepeatsAddUp) {
    Examination twice = knownAll();
    for (ExaminedDrive& drive : twice.drives) drive.drive.repeats = 2;
    const DrawnCase drawn = planted("late_gyro", 1);
    EXPECT_NEAR(shown(twice, drawn).nats / shown(knownAll(), drawn).nats, 2, 1e-9);
}

TEST(BlindExamination, LargerShowsMoreAndToleranceHides) {
    const double one = shown(knownAll(), planted("heavier", 1)).nats;
    const double two = shown(knownAll(), planted("heavier", 2)).nats;
    EXPECT_GT(one, 22);
    EXPECT_NEAR(two / one, 4, 0.8) << "but for what bends";
    const double open = shown(usual(), planted("heavier", 1)).nats;
    EXPECT_LT(open, one);
    // The mass is known within 2 %: 10 % are 8.7 standard deviations of a uniform distribution, a bound of the
    // evidence.
    EXPECT_LT(open, 0.5 * std::pow(0.1 / 0.02 * std::sqrt(3.0), 2) * 1.1);
}

TEST(BlindExamination, ErrorOfTheRecordedSteeringShowsInTheMotion) {
    const Detectability zero = shown(knownAll(), planted("steering_zero", 1));
    EXPECT_GT(zero.nats, 22);
    EXPECT_LT(zero.nats, 1e6);
}

TEST(BlindExamination, RivalLeavesNoMoreThanTolerances) {
    for (const char* name : {"heavier", "weaker", "late_gyro"}) {
        const Detectability found = shown(usual(), planted(name, 1));
        EXPECT_GT(found.separation, 0) << name;
        EXPECT_LE(found.separation, found.nats) << name;
        EXPECT_FALSE(found.rival.empty()) << name;
        EXPECT_NE(found.rival, name);
    }
}

TEST(BlindExamination, OutsiderShowsBesideTheEffect) {
    Random random(3);
    const DrawnCase mixed = drawCase(reference::compact(), kEffects, CaseKind::mixed, random);
    const auto all = detectabilities(usual(), mixed);
    ASSERT_EQ(all.size(), 2u);
    EXPECT_TRUE(all.contains(mixed.key.outsider));
    EXPECT_NE(all.at(mixed.key.outsider).rival, mixed.key.effects.front()) << "planted itself";
}

TEST(BlindExamination, NoiseAndPushesOfRealDrivesAreAsLargeAsExpected) {
    // Whitened squares of the noise of drives: expected value 1 per row.
    Random random(3);
    for (const World world : {World::own, World::assumed}) {
        DrawnCase none = drawCase(reference::compact(), {}, CaseKind::none, random, {.world = world});
        if (none.truth.own) {
            for (ReadingNoise& noise : none.truth.own->noise) noise.spikes = 0;
        }
        double squares = 0, rows = 0;
        for (const ExaminedDrive& drive : examination(none.truth.car, caseDrives(), {}, {}).drives) {
            const Log quiet = readingsOf(none.truth, drive.drive, 1, kIdeal);
            DriveColumns hidden = noiseAndPushes(drive, none.truth, quiet);
            hidden.times = 1;
            hidden.tolerances = hidden.rivals = Eigen::MatrixXd(rowsOf(quiet).size(), 0);
            for (std::uint64_t seed = 0; seed < 3; ++seed) {
                hidden.changes = rowsOf(measure(none.truth, drive.drive, seed)) - rowsOf(quiet);
                squares += products(hidden)(0, 0), rows += static_cast<double>(hidden.changes.size());
            }
        }
        EXPECT_GT(squares / rows, 0.95);
        EXPECT_LT(squares / rows, 1.25) << "pushes that are faster than the hats, and what bends";
    }
}

TEST(BlindExamination, SameForAnyNumberOfThreads) {
    const DrawnCase drawn = planted("late_gyro", 1);
    EXPECT_EQ(detectabilities(usual(), drawn, 1), detectabilities(usual(), drawn, 3));
}

}  // namespace
}  // namespace tread::blind_examination_test
