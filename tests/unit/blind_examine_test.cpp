// What real drives show of what is wrong: against the size of noise, of tolerances, and of what is known of the car.
#include <gtest/gtest.h>

#include <cmath>

#include "blind/examine.h"
#include "blind/measure.h"
#include "blind/outsiders.h"
#include "diagnose/catalogue/effect.h"
#include "recording/subject.h"
#include "shared/vehicles.h"

namespace tread {
namespace {

using diagnose::catalogue::Direction;
using diagnose::catalogue::Effect;
using recording::Subject;

// Of a car, of how its steering was recorded, of an instrument that reads late, and of its engine.
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
    return blindDrives(DriveSet::step_steers);
}

// A case of one effect at a size of so many typical ones, in a car that errs.
DrawnCase planted(const std::string& name, double size) {
    Random random(8);
    DrawnCase drawn = drawCase(reference::compact(), kEffects, CaseKind::none, random);
    drawn.key.effects = {name};
    drawn.without[name] = drawn.truth;
    for (const Effect& effect : kEffects)
        if (effect.name == name) move(drawn.truth.car, effect.knobs[0], size * effect.knobs[0].typical);
    return drawn;
}

// With nothing left open: only noise and pushes hide something.
const Examination& knownAll() {
    static const Examination one = examination(known(), twoDrives(), {}, kEffects);
    return one;
}
const Examination& usual() {
    static const Examination one = examination(known(), twoDrives(), openNumbers(known()), kEffects);
    return one;
}

Shows shown(const Examination& examiner, const DrawnCase& drawn) {
    return examined(examiner, drawn).at(drawn.key.effects.front());
}

TEST(BlindExamine, TwiceTheNoiseAndPushesShowAQuarter) {
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

TEST(BlindExamine, RepeatsAddUp) {
    Examination twice = knownAll();
    for (ExaminedDrive& drive : twice.drives) drive.drive.repeats = 2;
    const DrawnCase drawn = planted("late_gyro", 1);
    EXPECT_NEAR(shown(twice, drawn).nats / shown(knownAll(), drawn).nats, 2, 1e-9);
}

TEST(BlindExamine, LargerShowsMoreAndToleranceHides) {
    const double one = shown(knownAll(), planted("heavier", 1)).nats;
    const double two = shown(knownAll(), planted("heavier", 2)).nats;
    EXPECT_GT(one, 22);
    EXPECT_NEAR(two / one, 4, 0.8) << "but for what bends";
    const double open = shown(usual(), planted("heavier", 1)).nats;
    EXPECT_LT(open, one);
    // The mass is known within 2 %: ten percent are 8.7 deviations of a uniform distribution, and no evidence is more.
    EXPECT_LT(open, 0.5 * std::pow(0.1 / 0.02 * std::sqrt(3.0), 2) * 1.1);
}

TEST(BlindExamine, ErrorOfTheRecordedSteeringShowsInTheMotion) {
    const Shows zero = shown(knownAll(), planted("steering_zero", 1));
    EXPECT_GT(zero.nats, 22);
    EXPECT_LT(zero.nats, 1e6);
}

TEST(BlindExamine, RivalLeavesNoMoreThanTolerances) {
    for (const char* name : {"heavier", "weaker", "late_gyro"}) {
        const Shows found = shown(usual(), planted(name, 1));
        EXPECT_GT(found.separation, 0) << name;
        EXPECT_LE(found.separation, found.nats) << name;
        EXPECT_FALSE(found.rival.empty()) << name;
        EXPECT_NE(found.rival, name);
    }
}

TEST(BlindExamine, OutsiderShowsBesideTheEffect) {
    Random random(3);
    const DrawnCase mixed = drawCase(reference::compact(), kEffects, CaseKind::mixed, random);
    const auto all = examined(usual(), mixed);
    ASSERT_EQ(all.size(), 2u);
    EXPECT_TRUE(all.contains(mixed.key.outsider));
    EXPECT_NE(all.at(mixed.key.outsider).rival, mixed.key.effects.front()) << "planted itself";
}

TEST(BlindExamine, NoiseAndPushesOfRealDrivesAreAsLargeAsExpected) {
    // Squares of what disturbs real drives, in units of its covariance: one for each row.
    Random random(3);
    for (const World world : {World::own, World::assumed}) {
        DrawnCase none = drawCase(reference::compact(), {}, CaseKind::none, random, {.world = world});
        if (none.truth.own) {
            for (ReadingNoise& noise : none.truth.own->noise) noise.spikes = 0;
        }
        double squares = 0, rows = 0;
        for (const ExaminedDrive& drive : examination(none.truth.car, blindDrives(), {}, {}).drives) {
            const Log quiet = readingsOf(none.truth, drive.drive, 1, kIdeal);
            ShownDrive hidden = hiding(drive, none.truth, quiet);
            hidden.times = 1;
            hidden.tolerances = hidden.rivals = Eigen::MatrixXd(shownRows(quiet).size(), 0);
            for (std::uint64_t seed = 0; seed < 3; ++seed) {
                hidden.changes = shownRows(measure(none.truth, drive.drive, seed)) - shownRows(quiet);
                squares += products(hidden)(0, 0), rows += static_cast<double>(hidden.changes.size());
            }
        }
        EXPECT_GT(squares / rows, 0.95);
        EXPECT_LT(squares / rows, 1.25) << "pushes that are faster than the hats, and what bends";
    }
}

TEST(BlindExamine, SameForAnyNumberOfThreads) {
    const DrawnCase drawn = planted("late_gyro", 1);
    EXPECT_EQ(examined(usual(), drawn, 1), examined(usual(), drawn, 3));
}

}  // namespace
}  // namespace tread
