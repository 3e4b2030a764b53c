// Cases from the other simulator: planting of effects by tread's paths, and measurement.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "blind/detectability/drive_replay.h"
#include "blind/other_detectability.h"
#include "blind/other_draw.h"
#include "blind/other_match.h"
#include "blind/other_measure.h"
#include "blind/other_outsiders.h"
#include "blind/world/instruments.h"
#include "diagnose/catalogue/effect.h"
#include "recording/subject.h"
#include "run/simulate.h"
#include "shared/other_car/compact.h"
#include "shared/vehicles.h"

namespace other_car::other_cases_test {
namespace {

using tread::blind::drives::caseDrives;
using tread::blind::drives::Drive;
using tread::blind::faults::Outsider;
using tread::blind::faults::outsiders;
using tread::blind::key::CaseKind;
using tread::blind::key::Detectability;
using tread::blind::world::InstrumentSheet;
using tread::blind::world::instrumentSheets;
using tread::blind::world::measuresDriver;

Truth known() {
    Truth truth;
    truth.car = compact();
    return truth;
}

Drive driveNamed(const std::string& name) {
    for (const Drive& drive : caseDrives())
        if (drive.name == name) return drive;
    throw std::out_of_range(name);
}

tread::recording::Subject nominal() {
    return asInFile(reference::compact());
}

Drawn drawnOf(CaseKind kind, std::uint64_t seed) {
    tread::Random random(seed);
    return draw(known(), nominal(), plantable(tread::diagnose::catalogue::effectCatalogue(), nominal()), true, kind,
                random);
}

// The largest difference of two logs, in units of the instruments' noise.
double apart(const tread::Log& a, const tread::Log& b) {
    double most = 0;
    for (const InstrumentSheet& sheet : instrumentSheets()) {
        const auto &x = a.find(sheet.channel)->values, &y = b.find(sheet.channel)->values;
        EXPECT_EQ(x.size(), y.size());
        for (std::size_t i = 0; i < x.size(); ++i) most = std::max(most, std::abs(x[i] - y[i]) / sheet.noise);
    }
    return most;
}

// Sum of squared differences of the readings over their noise, in means of 50 ms. Only effects with at least 200 are
// drawn.
constexpr double kSeen = 200;
double squares(const tread::Log& a, const tread::Log& b) {
    double sum = 0;
    for (const InstrumentSheet& sheet : instrumentSheets()) {
        if (measuresDriver(sheet)) continue;
        const std::vector<double> x = means(a, sheet.channel), y = means(b, sheet.channel);
        for (std::size_t i = 0; i < x.size(); ++i) sum += std::pow((x[i] - y[i]) / noiseOfMeans(sheet), 2);
    }
    return sum;
}

bool finite(const tread::Log& log) {
    return std::all_of(log.channels.begin(), log.channels.end(), [](const tread::Channel& channel) {
        return std::all_of(channel.values.begin(), channel.values.end(), [](double v) { return std::isfinite(v); });
    });
}

// With all numbers free, the fit would give engine, brakes and wheels values that no car has.
TEST(OtherCases, MatchedCarIsNearerAndKeepsTheNumbersThatBothModelsDefineAlike) {
    const Matching matching = matchingOf(known(), reference::compact());
    Truth before = known();
    double farther = 0, nearer = 0;
    for (const char* name : {"step_steer_80", "braking_in_turn_90", "sine_sweep_90"}) {
        const tread::Log wanted = drivenByTread(reference::compact(), driveNamed(name));
        farther += squares(wanted, replay(before, driveNamed(name)).log);
        nearer += squares(wanted, replay(plainCar(matching), driveNamed(name)).log);
    }
    EXPECT_LT(nearer, 0.25 * farther);
    Truth after = matched(matching, structureOf({"brush_tyre", "moving_roll_axis"}));
    const std::vector<SharedNumber> from = sharedNumbers(before), to = sharedNumbers(after);
    for (std::size_t i = 0; i < from.size(); ++i) {
        const std::string& path = from[i].path;
        const bool radius = path.ends_with(".Re") || path.ends_with(".Ro"),
                   of_axle = path.starts_with("front.") || path.starts_with("rear.");
        if (of_axle && !radius && !path.ends_with(".qy1") && !path.ends_with("wheel_inertia")) continue;
        const double apart = std::abs(*to[i].value - *from[i].value);
        EXPECT_LE(apart, radius ? 0.1 * *from[i].value : 0) << path;
    }
}

TEST(OtherCases, ManyEffectsOfTheCatalogueCanBePlanted) {
    const auto effects = plantable(tread::diagnose::catalogue::effectCatalogue(), nominal());
    EXPECT_GE(effects.size(), 25u);
    for (const char* name :
         {"mass", "grip", "tyre_relaxation", "wind", "steering_delay", "gyro_scale", "wheel_radius", "dampers"})
        EXPECT_TRUE(std::any_of(effects.begin(), effects.end(), [&](const auto& e) { return e.name == name; })) << name;
}

// Each shared number differs from the nominal one by the difference, or the factor, that the key states.
TEST(OtherCases, PlantedNumbersOfTheKeyAreThoseOfTheDrivenCar) {
    for (std::uint64_t seed = 1; seed < 40; ++seed) {
        const Drawn drawn = drawnOf(CaseKind::two, seed);
        ASSERT_EQ(drawn.key.effects.size(), 2u);
        EXPECT_FALSE(drawn.key.numbers.empty());
        Truth driven = drivenCar(drawn), begin = known();
        const auto have = sharedNumbers(driven), had = sharedNumbers(begin);
        for (const auto& [path, number] : drawn.key.numbers) {
            for (std::size_t i = 0; i < have.size(); ++i) {
                if (have[i].path != path || have[i].share != 1) continue;
                const double more = have[i].by_factor
                                        ? *have[i].value / *had[i].value - number.value / number.nominal
                                        : *have[i].value - *had[i].value - (number.value - number.nominal);
                EXPECT_NEAR(more, 0, 1e-9 * std::max(1.0, std::abs(number.value))) << path;
            }
            EXPECT_GT(std::abs(number.change), 0.399) << path;
            EXPECT_LT(std::abs(number.change), 2.501) << path;
        }
    }
}

TEST(OtherCases, KindsHaveWhatTheirNamesSay) {
    using enum CaseKind;
    for (const auto& [kind, effects, outsider] : {std::tuple{one, 1u, false},
                                                  {two, 2u, false},
                                                  {none, 0u, false},
                                                  {outside, 0u, true},
                                                  {mixed, 1u, true},
                                                  {small, 1u, false}}) {
        const Drawn drawn = drawnOf(kind, 5);
        EXPECT_EQ(drawn.key.effects.size(), effects);
        EXPECT_EQ(!drawn.key.outsider.empty(), outsider);
        EXPECT_EQ(faultNames(drawn).size(), effects + (outsider ? 1 : 0));
    }
    for (const auto& [path, number] : drawnOf(small, 5).key.numbers) EXPECT_LE(std::abs(number.change), 0.15) << path;
}

TEST(OtherCases, NumbersErrALittleAndNoneOfThemWildly) {
    for (std::uint64_t seed = 1; seed < 30; ++seed) {
        const Drawn none = drawnOf(CaseKind::none, seed);
        const Truth driven = drivenCar(none);
        EXPECT_NE(driven.car.mass, 1350);
        EXPECT_NEAR(driven.car.mass, 1350, 4.01 * 0.006 * 1350);
        EXPECT_NEAR(driven.car.rear.tyre.stiffness, known().car.rear.tyre.stiffness,
                    4.01 * 0.035 * known().car.rear.tyre.stiffness);
        EXPECT_GE(driven.steering_delay, 0);
    }
}

// The same car on other days: without noise and surroundings, logs differ only by circumstances of the day.
TEST(OtherCases, WithoutAFaultTheReferenceDiffersByTheDayOnly) {
    const Drive drive = driveNamed("step_steer_80");
    const Drawn none = drawnOf(CaseKind::none, 7);
    EXPECT_EQ(apart(replay(drivenCar(none), drive).log, replay(drivenCar(none, faultNames(none)), drive).log), 0);
    const Day today{1, 2}, same_day{1, 3}, other_day{4, 5};
    const auto on = [&](const Day& day) { return replay(drivenCar(none, {}, &day), drive).log; };
    const double within = apart(on(today), on(same_day)), between = apart(on(today), on(other_day));
    EXPECT_EQ(apart(on(today), on(today)), 0);
    EXPECT_GT(within, 0.1);
    EXPECT_GT(between, within);
    EXPECT_LT(between, 30);
}

// Logs of all drives; empty when one of them cannot be driven.
std::vector<tread::Log> drivenThrough(const Truth& truth) {
    std::vector<tread::Log> logs;
    try {
        for (const Drive& drive : caseDrives()) logs.push_back(replay(truth, drive).log);
    } catch (const tread::SimulationError&) {
        return {};
    }
    return logs;
}

// Large bent axles and soft rear tyres make the car spin; such cases are drawn anew.
TEST(OtherCases, EachOutsiderDrivesAllDrivesAndIsSeen) {
    const std::vector<tread::Log> healthy = drivenThrough(known());
    for (const Outsider& outsider : outsiders()) {
        std::vector<tread::Log> logs;
        Truth truth;
        for (std::uint64_t seed = 1; logs.empty() && seed <= 4; ++seed) {
            truth = known();
            tread::Random random(seed);
            plant(outsider, nominal(), truth, random);
            logs = drivenThrough(truth);
        }
        ASSERT_EQ(logs.size(), healthy.size()) << outsider.name;
        double sum = 0;
        for (std::size_t i = 0; i < logs.size(); ++i) {
            EXPECT_TRUE(finite(logs[i])) << outsider.name;
            sum += squares(logs[i], healthy[i]);
        }
        EXPECT_GT(sum, kSeen) << outsider.name;
        EXPECT_EQ(apart(logs.front(), replay(truth, caseDrives().front()).log), 0) << outsider.name;
    }
}

TEST(OtherCases, EachStructureDrivesAllDrivesAndIsSeen) {
    for (const StructuralChoice& choice : kStructuralChoices) {
        Truth truth = known();
        truth.car.structure.*choice.on = true;
        double sum = 0;
        for (const Drive& drive : caseDrives()) {
            const tread::Log log = replay(truth, drive).log;
            EXPECT_TRUE(finite(log)) << choice.name << " " << drive.name;
            EXPECT_EQ(apart(log, replay(truth, drive).log), 0) << choice.name;
            sum += squares(log, replay(known(), drive).log);
        }
        EXPECT_GT(sum, kSeen) << choice.name;
    }
}

TEST(OtherCases, TwoOrThreeStructuresAreDrawnAndKeepTheirNames) {
    for (std::uint64_t seed = 1; seed < 50; ++seed) {
        tread::Random random(seed);
        const Structure structure = drawStructure(random);
        const std::vector<std::string> names = namesOf(structure);
        EXPECT_TRUE(names.size() == 2 || names.size() == 3);
        EXPECT_EQ(structureOf(names), structure);
        EXPECT_FALSE(structure.brush_tyre && structure.hyperbolic_tyre);
    }
}

// Changes of all readings of some drives over their noise, by one knob of an effect, here and in tread's car.
struct Signatures {
    double product = 0, here = 0, there = 0;  // of both, and of each with itself
    double cosine() const { return product / std::sqrt(here * there); }
    double ratio() const { return std::sqrt(here / there); }
};

Signatures signaturesOf(const tread::diagnose::catalogue::Knob& knob, const std::vector<Drive>& drives) {
    using tread::blind::detectability::DriveReplay;
    using tread::blind::detectability::rowsOf;
    tread::blind::world::Truth as_known, as_changed;
    as_known.car = as_changed.car = nominal();
    move(as_changed.car, knob,
         knob.direction == tread::diagnose::catalogue::Direction::down ? -knob.typical : knob.typical);
    const Truth changed = withChanges(known(), nominal(), as_changed.car);
    Signatures sum;
    for (const Drive& drive : drives) {
        const Replayed first = replay(known(), drive);
        const DriveReplay again(drive, as_known);
        const Eigen::VectorXd here = rowsOf(replay(changed, drive, {.recorded = &first.recorded}).log) -
                                     rowsOf(replay(known(), drive, {.recorded = &first.recorded}).log),
                              there = again.rows(as_changed) - again.rows(as_known);
        for (const InstrumentSheet& sheet : instrumentSheets()) {
            if (measuresDriver(sheet)) continue;
            const auto [at, count] = tread::blind::detectability::rowsOfChannel(sheet.channel, here.size());
            const auto one = here.segment(at, count) / noiseOfMeans(sheet),
                       other = there.segment(at, count) / noiseOfMeans(sheet);
            sum.product += one.dot(other);
            sum.here += one.squaredNorm(), sum.there += other.squaredNorm();
        }
    }
    return sum;
}

// A number that an effect moves is the same number in both cars: planted here, it does what it does in tread's car.
// Numbers that hardly show in either are left out.
TEST(OtherCases, EffectsDoHereWhatTheyDoInTreadsCar) {
    constexpr double kHardly = 15;
    const std::vector<Drive> drives{driveNamed("sine_sweep_90"), driveNamed("straight_braking_110"),
                                    driveNamed("braking_in_turn_90"), driveNamed("slow_ramp_80"),
                                    driveNamed("acceleration_50")};
    int seen = 0;
    for (const auto& effect : plantable(tread::diagnose::catalogue::effectCatalogue(), nominal())) {
        for (const auto& knob : effect.knobs) {
            const Signatures both = signaturesOf(knob, drives);
            if (std::max(both.here, both.there) < kHardly * kHardly) continue;
            ++seen;
            EXPECT_GT(both.cosine(), 0.7) << effect.name << ": " << knob.paths.front();
            EXPECT_GT(both.ratio(), 0.6) << effect.name << ": " << knob.paths.front();
            EXPECT_LT(both.ratio(), 1.5) << effect.name << ": " << knob.paths.front();
        }
    }
    EXPECT_GT(seen, 60);
}

// Recorded inputs reproduce the drive, also when the instruments of the driver's inputs have errors.
TEST(OtherCases, ReplayedInputsMakeTheSameDrive) {
    Truth truth = known();
    truth.instruments.steering_wheel_angle = {.gain = 1.02, .bias = 0.03};
    for (const char* name : {"slow_ramp_80", "braking_in_turn_90"}) {
        const Drive drive = driveNamed(name);
        const Replayed first = replay(truth, drive);
        EXPECT_LT(apart(first.log, replay(truth, drive, {.recorded = &first.recorded}).log), 1e-6) << name;
    }
}

TEST(OtherCases, InstrumentsReadWhatTheirNumbersSay) {
    const Drive drive = driveNamed("step_steer_80");
    Truth read = known();
    read.instruments.yaw_rate = {.gain = 1.1, .bias = 0.01, .delay = 0.05};
    const tread::Log plain = replay(known(), drive).log, other = replay(read, drive).log;
    const auto &yaw = plain.find("chassis.yaw_rate")->values, &shown = other.find("chassis.yaw_rate")->values;
    for (std::size_t i = 5; i < yaw.size(); i += 20) EXPECT_NEAR(shown[i], 1.1 * yaw[i - 5] + 0.01, 1e-12);
}

TEST(OtherCases, AccelerationElsewhereFollowsFromYawing) {
    // In a steady turn a unit x ahead of the centre reads r^2 x less along the car.
    const Drive drive = driveNamed("step_steer_80");
    Truth ahead = known();
    ahead.instruments.inertial_unit.x = 1;
    const tread::Log plain = replay(known(), drive).log, other = replay(ahead, drive).log;
    const std::size_t steady = 380;
    const double r = plain.find("chassis.yaw_rate")->values[steady];
    EXPECT_NEAR(other.find("chassis.ax")->values[steady] - plain.find("chassis.ax")->values[steady], -r * r, 1e-9);
}

TEST(OtherCases, LateSteeringIsTheSameDriveLater) {
    const Drive drive = driveNamed("step_steer_80");
    Truth late = known();
    late.steering_delay = 0.05;
    const tread::Log plain = replay(known(), drive).log, other = replay(late, drive).log;
    const auto &yaw = plain.find("chassis.yaw_rate")->values, &later = other.find("chassis.yaw_rate")->values;
    for (std::size_t i = 55; i < 120; i += 5) EXPECT_NEAR(later[i], yaw[i - 5], 2e-4);
    EXPECT_EQ(plain.find("driver.steering_wheel_angle")->values, other.find("driver.steering_wheel_angle")->values);
}

TEST(OtherCases, HeadwindAndGradeHoldTheCarBack) {
    const Drive drive = driveNamed("coast_down_120");
    Truth wind = known(), grade = known();
    wind.car.wind_x = -5;
    grade.car.grade = 0.02;
    const double v = 120 / 3.6, p = known().car.drag_area * known().car.air_density / 2;
    const auto ax = [&](const Truth& truth) { return replay(truth, drive).log.find("chassis.ax")->values[20]; };
    const Params car = known().car;
    const double turning =
        2 * (car.front.wheel_inertia + car.rear.wheel_inertia) + car.engine_inertia * car.drive_ratio * car.drive_ratio;
    const double mass = car.mass + turning / (car.front.tyre.rolling_radius * car.front.tyre.loaded_radius);
    EXPECT_NEAR(ax(wind) - ax(known()), -p * ((v + 5) * (v + 5) - v * v) / mass, 1e-3);
    EXPECT_NEAR(ax(grade) - ax(known()), -0.02 * kGravity * car.mass / mass, 1e-3);
}

TEST(OtherCases, CarThatSpinsIsNotDrivenOn) {
    Truth slippery = known();
    for (const std::size_t rear : {2u, 3u}) slippery.car.wheels[rear].friction = 0.4;
    EXPECT_THROW(replay(slippery, driveNamed("step_steer_110")), tread::SimulationError);
}

TEST(OtherCases, SameSeedDrawsTheSameCaseAndAnotherOneAnother) {
    using enum CaseKind;
    EXPECT_EQ(drawnOf(mixed, 3).key, drawnOf(mixed, 3).key);
    EXPECT_NE(drawnOf(mixed, 3).key, drawnOf(mixed, 4).key);
    EXPECT_EQ(drivenCar(drawnOf(mixed, 3)).car.mass, drivenCar(drawnOf(mixed, 3)).car.mass);
}

// Evidence is proportional to the squared size. With references the gain is not uncertain, so detectability is higher.
TEST(OtherCases, EvidenceGrowsWithTheSquareOfTheSizeAndReferencesAddToIt) {
    std::vector<tread::diagnose::catalogue::Effect> effects;
    for (const tread::diagnose::catalogue::Effect& one :
         plantable(tread::diagnose::catalogue::effectCatalogue(), nominal())) {
        if (one.name == "gyro_scale" || one.name == "gyro_bias" || one.name == "mass") effects.push_back(one);
    }
    const std::vector<Drive> drives{driveNamed("step_steer_80")};
    const Directions directions = directionsOf(nominal(), effects);
    const std::vector<Pushed> pushed = pushedDrives(known(), drives);
    tread::Random random(4);
    const ProvingGround ground = drawnGround(reference::compact(), random);
    const auto shownOf = [&](double size) {
        Drawn drawn{.known = known(), .nominal = nominal(), .erring = nominal(), .planted = {}, .key = {}};
        const auto gyro =
            std::find_if(effects.begin(), effects.end(), [](const auto& e) { return e.name == "gyro_scale"; });
        drawn.planted.push_back({*gyro, {size}});
        drawn.key.effects = {"gyro_scale"};
        return shown(pushed, directions, drawn, ground);
    };
    const Shown once = shownOf(0.02), twice = shownOf(0.04);
    const Detectability with = once.with_references.at("gyro_scale"),
                        without = once.without_references.at("gyro_scale");
    EXPECT_GT(without.nats, 0.1);
    EXPECT_GT(with.nats, without.nats);
    EXPECT_LE(with.separation, with.nats);
    EXPECT_NE(with.rival, "gyro_scale");
    EXPECT_NEAR(twice.with_references.at("gyro_scale").nats / with.nats, 4, 0.1);
    EXPECT_NEAR(twice.without_references.at("gyro_scale").nats / without.nats, 4, 0.1);
}

TEST(OtherCases, RepeatsAndNoiseDifferAndTheSameSeedIsTheSame) {
    const Drive drive = driveNamed("step_steer_80");
    tread::Random random(1);
    const ProvingGround ground = drawnGround(reference::compact(), random);
    const auto ay = [&](std::uint64_t seed) {
        return measure(known(), ground, drive, seed).find("chassis.ay")->values;
    };
    EXPECT_EQ(ay(1), ay(1));
    EXPECT_NE(ay(1), ay(2));
}

}  // namespace
}  // namespace other_car::other_cases_test
