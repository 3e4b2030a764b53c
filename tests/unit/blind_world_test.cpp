// Errors, surroundings and noise of World::own: spreads, random processes, tables.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/fields/numbers.h"
#include "base/text/pattern.h"
#include "blind/world/draws.h"
#include "blind/world/errors.h"
#include "blind/world/instruments.h"
#include "blind/world/surroundings.h"
#include "recording/subject.h"
#include "recording/subject_paths.h"
#include "shared/vehicles.h"

namespace tread::blind_world_test {
namespace {

using blind::world::addNoise;
using blind::world::apply;
using blind::world::autocovariance;
using blind::world::between;
using blind::world::dailyNumbers;
using blind::world::differenceSpread;
using blind::world::drawErrors;
using blind::world::drawnDifference;
using blind::world::drawnGround;
using blind::world::drawnNoise;
using blind::world::drawnSurroundings;
using blind::world::DriveDifference;
using blind::world::enginePhase;
using blind::world::errorTable;
using blind::world::heavyTailed;
using blind::world::InstrumentSheet;
using blind::world::instrumentSheets;
using blind::world::kMostLatency;
using blind::world::kMostWind;
using blind::world::kSourceSpeed;
using blind::world::measuresDriver;
using blind::world::NumberError;
using blind::world::OpenNumber;
using blind::world::openNumbers;
using blind::world::pushingOf;
using blind::world::PushSource;
using blind::world::ReadingNoise;
using blind::world::seedOf;
using recording::pathFault;
using recording::Subject;

Subject known() {
    return {.vehicle = reference::compact(), .road = {}, .wind = {}, .instruments = {}};
}

// Errors of many cars, by path.
std::map<std::string, std::vector<double>> errorsOfCars(int cars) {
    std::map<std::string, std::vector<double>> errors;
    Subject nominal = known();
    const std::vector<Number> right = numbers(nominal);
    for (int i = 0; i < cars; ++i) {
        Subject car = nominal;
        Random random(seedOf(1, static_cast<std::uint64_t>(i)));
        drawErrors(car, random);
        const std::vector<Number> real = numbers(car);
        for (std::size_t n = 0; n < real.size(); ++n)
            if (std::isfinite(*right[n].value)) errors[real[n].path].push_back(*real[n].value - *right[n].value);
    }
    return errors;
}

double deviation(const std::vector<double>& values) {
    double squares = 0;
    for (const double value : values) squares += value * value;
    return std::sqrt(squares / static_cast<double>(values.size()));
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum / static_cast<double>(a.size()) / deviation(a) / deviation(b);
}

TEST(BlindErrors, HeavyTailsAreThoseOfStudent) {
    Random random(1);
    constexpr int kDraws = 200000;
    double squares = 0;
    int far = 0, bound = 0;
    for (int i = 0; i < kDraws; ++i) {
        const double draw = heavyTailed(random);
        ASSERT_LE(std::abs(draw), 4);
        squares += draw * draw, far += std::abs(draw) > 4.604 / std::numbers::sqrt2, bound += std::abs(draw) == 4;
    }
    EXPECT_NEAR(far, 0.01 * kDraws, 4 * std::sqrt(0.01 * kDraws)) << "t of four degrees of freedom, 99 %";
    EXPECT_NEAR(bound, 0.0048 * kDraws, 4 * std::sqrt(0.0048 * kDraws));
    EXPECT_NEAR(squares / kDraws, 0.9, 0.1) << "of 1, less what the bound takes";
}

TEST(BlindErrors, SpreadsAreOfTheOrderOfTheToleranceOfTheFile) {
    const auto errors = errorsOfCars(300);
    Subject nominal = known();
    int compared = 0;
    for (const Number& number : numbers(nominal)) {
        const double sd = number.about.tolerance * std::abs(*number.value) / std::sqrt(3.0);
        if (!(sd > 0) || !std::isfinite(sd)) continue;
        EXPECT_LT(deviation(errors.at(number.path)), 2 * sd) << number.path;
        const bool meant = std::any_of(errorTable().begin(), errorTable().end(),
                                       [&](const NumberError& row) { return matches(row.pattern, number.path); });
        if (!meant) continue;
        EXPECT_GT(deviation(errors.at(number.path)), 0.3 * sd) << number.path;
        ++compared;
    }
    EXPECT_GT(compared, 50);
}

TEST(BlindErrors, EveryRowIsOfANumberAndSaysItsSource) {
    for (const NumberError& row : errorTable()) {
        EXPECT_EQ(pathFault(row.pattern), "") << row.pattern;
        EXPECT_FALSE(row.source.empty()) << row.pattern;
    }
}

TEST(BlindErrors, PartsOfOneBatchErrAlike) {
    const auto errors = errorsOfCars(400);
    const auto between = [&](const std::string& a, const std::string& b) {
        return correlation(errors.at(a), errors.at(b));
    };
    EXPECT_GT(between("front.suspension.damper.bump", "front.suspension.damper.rebound"), 0.3);
    EXPECT_LT(std::abs(between("front.suspension.damper.bump", "rear.suspension.damper.rebound")), 0.2);
    EXPECT_GT(between("front.tyre.lambda.Ky", "rear.tyre.lambda.Ky"), 0.3);
    EXPECT_GT(between("mass", "inertia.yaw"), 0.03) << "a load";
    EXPECT_LT(std::abs(between("steering.ratio", "brakes.front_share")), 0.2);
}

TEST(BlindErrors, ErrorsStayWithinTheLimitsOfTheirNumbers) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        Subject car = known();
        Random random(seed);
        drawErrors(car, random);
        for (const Number& number : numbers(car))
            if (std::isfinite(*number.value)) {
                EXPECT_TRUE(number.about.limits.allow(*number.value)) << number.path << ' ' << *number.value;
            }
    }
}

TEST(BlindErrors, WhatDiffersFromDayToDayIsNoMoreThanWhatIsOpen) {
    std::map<std::string, double> open;
    for (const OpenNumber& one : openNumbers(known())) open[one.path] = one.sd;
    const std::vector<OpenNumber> daily = dailyNumbers(known());
    EXPECT_LT(daily.size(), open.size());
    for (const OpenNumber& one : daily) {
        ASSERT_TRUE(open.contains(one.path)) << one.path;
        EXPECT_LE(one.sd, 1.5 * open[one.path]) << one.path;
    }
    EXPECT_DOUBLE_EQ(open.at("steering.ratio"), 0.02 * 16.5 / std::sqrt(3.0)) << "as its description says";
    EXPECT_DOUBLE_EQ(open.at("instruments.ay.bias"), 0.018) << "as the examiner's table says";
}

TEST(BlindErrors, DriveDifferencesHaveTheirSpread) {
    Random random(3);
    std::vector<double> wind, latency, slope;
    for (int i = 0; i < 4000; ++i) {
        const DriveDifference one = drawnDifference(drawnGround(random), random);
        EXPECT_LE(std::hypot(one.wind_x, one.wind_y), kMostWind);
        wind.push_back(one.wind_y), latency.push_back(one.latency - kMostLatency / 2), slope.push_back(one.grade);
    }
    const DriveDifference spread = differenceSpread();
    EXPECT_NEAR(deviation(wind), spread.wind_y, 0.05 * spread.wind_y);
    EXPECT_NEAR(deviation(latency), spread.latency, 0.05 * spread.latency);
    EXPECT_NEAR(deviation(slope), spread.grade, 0.1 * spread.grade);
}

TEST(BlindErrors, LatencyIsOnceThatOfEveryInstrumentOfTheCar) {
    Subject car = known();
    apply({.latency = 0.004}, car);
    EXPECT_EQ(car.instruments.wheel_speed.delay, 0.004);
    EXPECT_EQ(car.instruments.yaw_rate.delay, 0.004);
    EXPECT_EQ(car.instruments.steering_wheel_angle.delay, 0);
}

// ---- Surroundings --------------------------------------------------------------------------------------------------

TEST(BlindSurroundings, SourcesVaryAsTheirAutocovarianceSays) {
    Random random(1);
    VehicleOutput car;
    car.chassis.vx = kSourceSpeed;
    for (const PushSource& source : drawnSurroundings(reference::compact(), random)) {
        PushSource unit = source;
        unit.push = {.force = {1, 0, 0}};
        // Many short drives at a constant speed.
        constexpr int kDrives = 600;
        constexpr double kLater = 0.3;  // s
        double variance = 0, later = 0;
        for (std::uint64_t seed = 0; seed < kDrives; ++seed) {
            Pushing pushing = pushingOf({unit}, seed);
            double first = 0, last = 0;
            for (int i = 0; i <= 330; ++i) {
                const double value = pushing(0.01 * i, {}, car).force.x();
                if (i == 300) first = value;
                last = value;
            }
            variance += first * first / kDrives, later += first * last / kDrives;
        }
        const double apart = source.by_distance ? kLater * kSourceSpeed : kLater;
        const double expected = autocovariance(source, 0);
        EXPECT_NEAR(variance, expected, (source.bumps_per > 0 ? 0.5 : 0.25) * expected) << source.name;
        EXPECT_NEAR(later, autocovariance(source, apart), (source.bumps_per > 0 ? 0.5 : 0.25) * expected)
            << source.name;
    }
}

TEST(BlindSurroundings, AirPushesBySpeedAndRoadsByWay) {
    Random random(2);
    const std::vector<PushSource> sources = drawnSurroundings(reference::compact(), random);
    ASSERT_GE(sources.size(), 6u);
    VehicleOutput slow, fast;
    slow.chassis.vx = 10, fast.chassis.vx = 30;
    for (const PushSource& source : sources) {
        Pushing at_slow = pushingOf({source}, 5), at_fast = pushingOf({source}, 5);
        for (int i = 0; i < 50; ++i) {
            // Three times the speed: the same place of the road after a third of the time.
            const double time = 0.1 * i;
            const Push a = at_slow(time, {}, slow), b = at_fast(source.by_distance ? time / 3 : time, {}, fast);
            const double grows = source.by_speed ? 3 : 1;
            EXPECT_NEAR(b.force.y(), grows * a.force.y(), 1e-6 + 1e-9 * std::abs(b.force.y())) << source.name;
            EXPECT_NEAR(b.moment.x(), grows * a.moment.x(), 1e-6 + 1e-9 * std::abs(b.moment.x())) << source.name;
        }
    }
}

// ---- Instruments ---------------------------------------------------------------------------------------------------

Log still(std::size_t count) {
    Log log{{{"time", "s", {}}}};
    for (std::size_t i = 0; i < count; ++i) log.channels[0].values.push_back(0.01 * static_cast<double>(i));
    for (const InstrumentSheet& sheet : instrumentSheets())
        log.channels.push_back({std::string(sheet.channel), "", std::vector<double>(count, 1.0)});
    return log;
}

TEST(BlindGauges, NoiseHasItsLevelColourAndSteps) {
    Random random(4);
    std::vector<ReadingNoise> noises = drawnNoise(random);
    for (std::size_t i = 0; i < noises.size(); ++i) {
        EXPECT_GE(noises[i].level, 0.5 * instrumentSheets()[i].noise);
        EXPECT_LE(noises[i].level, 2 * instrumentSheets()[i].noise);
        noises[i].shaking = noises[i].engine = noises[i].spikes = 0;
        // Steps hide what is smaller: then the error depends on where between two steps the reading lies.
        noises[i].resolution = std::min(noises[i].resolution, noises[i].level);
    }
    constexpr std::size_t kCount = 40000;
    Log log = still(kCount);
    addNoise(log, noises, {}, 5);
    for (std::size_t i = 0; i < noises.size(); ++i) {
        const std::vector<double>& values = log.find(instrumentSheets()[i].channel)->values;
        double squares = 0, next = 0;
        for (std::size_t n = 1; n < kCount; ++n) {
            squares += std::pow(values[n] - 1, 2), next += (values[n] - 1) * (values[n - 1] - 1);
            const double steps = values[n] / noises[i].resolution;
            ASSERT_NEAR(steps, std::round(steps), 1e-6) << instrumentSheets()[i].channel;
        }
        const double variance = noises[i].level * noises[i].level + std::pow(noises[i].resolution, 2) / 12;
        EXPECT_NEAR(squares / kCount, variance, 0.08 * variance) << instrumentSheets()[i].channel;
        EXPECT_NEAR(next / squares, noises[i].correlation, 0.1) << instrumentSheets()[i].channel;
    }
}

TEST(BlindGauges, SpikesAreRareAndNotOnTheDriversInputs) {
    Random random(4);
    std::vector<ReadingNoise> noises = drawnNoise(random);
    constexpr std::size_t kCount = 100000;
    Log log = still(kCount);
    addNoise(log, noises, {}, 6);
    for (std::size_t i = 0; i < noises.size(); ++i) {
        const double far = 10 * noises[i].level + noises[i].shaking + noises[i].engine + noises[i].resolution;
        const std::vector<double>& values = log.find(instrumentSheets()[i].channel)->values;
        const auto spikes =
            std::count_if(values.begin(), values.end(), [&](double v) { return std::abs(v - 1) > far; });
        if (measuresDriver(instrumentSheets()[i])) EXPECT_EQ(spikes, 0);
        else EXPECT_NEAR(static_cast<double>(spikes), 8, 8) << instrumentSheets()[i].channel;
    }
}

TEST(BlindGauges, EngineTurnsItsOrder) {
    const std::vector<double> times{0, 0.01, 0.02}, speed{100, 100, 200};
    const std::vector<double> phase = enginePhase(times, speed);
    EXPECT_NEAR(phase[1], 2, 1e-12);
    EXPECT_NEAR(phase[2], 5, 1e-12);
}

}  // namespace
}  // namespace tread::blind_world_test
