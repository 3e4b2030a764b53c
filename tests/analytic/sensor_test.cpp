// Sensors of a run, recovered from its log alone.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "base/yaml/read.h"
#include "compare/time_shift.h"
#include "recording/observation.h"
#include "run/sensors.h"
#include "shared/vehicle_run.h"

namespace tread::sensor_test {
namespace {

using shared::channel;

Log drive(const std::string& sensors, const std::string& name = "sine_steer", double rate = 1000) {
    Scenario scenario = shared::scenario(name);
    scenario.phases.back().until.duration = 4;
    scenario.log = readYamlText<LogParams>("sensors: " + sensors, "log.yaml");
    scenario.log.rate = rate;
    return simulate(shared::compact(), scenario);
}

struct Line {
    double gain, bias;
};

// What the sensor shows over what the channel was `delay` before, by least squares.
Line fitted(const Log& log, const std::string& sensor, const std::string& source, double delay) {
    const auto& t = channel(log, "time");
    const auto& shown = channel(log, sensor);
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < t.size(); ++i) {
        if (t[i] < 0.5) continue;
        const double value = shared::valueAt(log, source, t[i] - delay);
        n += 1, x += value, y += shown[i], xx += value * value, xy += value * shown[i];
    }
    const double gain = (n * xy - x * y) / (n * xx - x * x);
    return {gain, (y - gain * x) / n};
}

TEST(Sensors, PerfectOneShowsItsChannelBitForBitAndChangesNothing) {
    const Log with = drive("[{channel: chassis.ay}, {channel: wheel.rear_left.load, name: scales}]");
    const Log without = drive("[]");
    EXPECT_EQ(channel(with, "sensor.chassis.ay"), channel(with, "chassis.ay"));
    EXPECT_EQ(channel(with, "sensor.scales"), channel(with, "wheel.rear_left.load"));
    ASSERT_EQ(with.channels.size(), without.channels.size() + 2) << "sensors stand behind the channels";
    for (std::size_t i = 0; i < without.channels.size(); ++i) {
        EXPECT_EQ(with.channels[i].values, without.channels[i].values) << without.channels[i].name;
    }
    EXPECT_EQ(with.find("sensor.scales")->unit, "N");
}

TEST(Sensors, KnownDelayGainAndBiasAreRecoveredWithinOnePercent) {
    for (const double delay : {0.0400, 0.0257}) {
        const double gain = 1.03, bias = 0.25;
        const Log log = drive(
            "[{channel: chassis.ay, name: imu, gain: 1.03, bias: 0.25, noise: 0.02, resolution: 0.01, "
            "delay: " +
            std::to_string(delay) + "}]");
        Log reference{{log.channels.front(), *log.find("chassis.ay")}};
        Log candidate{{log.channels.front(), *log.find("sensor.imu")}};
        candidate.channels[1].name = "chassis.ay";
        const auto found = estimateTimeShift(reference, candidate, "chassis.ay", 0.2);
        ASSERT_TRUE(found);
        const Line line = fitted(log, "sensor.imu", "chassis.ay", *found);
        std::printf("sensor with delay %.4f s, gain %.3f, bias %.3f: found %.5f s, %.5f, %.5f\n", delay, gain, bias,
                    *found, line.gain, line.bias);
        EXPECT_NEAR(*found, delay, 0.01 * delay);
        EXPECT_NEAR(line.gain, gain, 0.01 * gain);
        EXPECT_NEAR(line.bias, bias, 0.01 * bias);
    }
}

// Rigid-body kinematics from the log's other channels: a level accelerometer ahead of and beside the centre of gravity.
TEST(Sensors, PositionAddsWhatTheTurningBodyDoesThere) {
    const Log log = drive(
        "[{channel: chassis.ay, name: nose, position: {x: 1.5}}, "
        "{channel: chassis.vx, name: left, position: {y: 0.8}}]");
    const auto& t = channel(log, "time");
    const auto& yaw_rate = channel(log, "chassis.yaw_rate");
    double largest = 0, peak = 0;
    for (std::size_t i = 100; i + 1 < t.size(); ++i) {
        const double turning = (yaw_rate[i + 1] - yaw_rate[i - 1]) / (t[i + 1] - t[i - 1]);
        const double extra = channel(log, "sensor.nose")[i] - channel(log, "chassis.ay")[i];
        peak = std::max(peak, std::abs(1.5 * turning));
        largest = std::max(largest, std::abs(extra - 1.5 * turning));
        EXPECT_NEAR(channel(log, "sensor.left")[i] - channel(log, "chassis.vx")[i], -0.8 * yaw_rate[i], 3e-3);
    }
    EXPECT_GT(peak, 0.5);
    EXPECT_LT(largest, 0.01 * peak);
}

TEST(Sensors, RollLeaksGravityIntoLateralAcceleration) {
    const Log log = drive(
        "[{channel: chassis.ay, name: strapped, fixed_to_body: true}, "
        "{channel: chassis.ay, name: askew, misalignment: {roll: 2 deg}}, "
        "{channel: chassis.az, name: up, misalignment: {roll: 2 deg}}]");
    constexpr double kTilt = 2 * M_PI / 180;
    double leak = 0;
    for (std::size_t i = 0; i < log.samples(); ++i) {
        const double ay = channel(log, "chassis.ay")[i], az = channel(log, "chassis.az")[i];
        const double roll = channel(log, "chassis.roll")[i];
        const double strapped = channel(log, "sensor.strapped")[i];
        EXPECT_NEAR(strapped, ay * std::cos(roll) + (az + kStandardGravity) * std::sin(roll), 0.01);
        leak = std::max(leak, std::abs(strapped - ay));
        EXPECT_NEAR(channel(log, "sensor.askew")[i], ay * std::cos(kTilt) + (az + kStandardGravity) * std::sin(kTilt),
                    1e-9);
        EXPECT_NEAR(channel(log, "sensor.up")[i],
                    -ay * std::sin(kTilt) + (az + kStandardGravity) * std::cos(kTilt) - kStandardGravity, 1e-9);
    }
    EXPECT_GT(leak, 0.1);
}

// The instruments of a diagnosis read the motion at the centre of gravity; a sensor in the run is part of the body.
TEST(Sensors, InstrumentFixedToTheBodyReadsWhatSuchASensorDoes) {
    Scenario scenario = shared::scenario("braking_in_turn");
    scenario.road.bank = 0.03;
    scenario.log.channels = {"chassis.ax", "chassis.ay", "chassis.roll", "chassis.pitch"};
    scenario.log.sensors = readYamlText<LogParams>(
                               "sensors: [{channel: chassis.ax, name: along, fixed_to_body: true}, "
                               "{channel: chassis.ay, name: across, fixed_to_body: true}]",
                               "log.yaml")
                               .sensors;
    const Log log = simulate(shared::compact(), scenario);
    recording::Instruments fixed;
    fixed.inertial_unit.fixed_to_body = 1;
    const std::vector<double>& time = channel(log, "time");
    for (const auto& [quantity, sensor] : {std::pair("chassis.ax", "sensor.along"), {"chassis.ay", "sensor.across"}}) {
        const std::vector<double> read = recording::readings(log, fixed, quantity, time);
        const std::vector<double>&level = channel(log, quantity), &shown = channel(log, sensor);
        double gravity = 0, off = 0;
        for (std::size_t i = 0; i < time.size(); ++i) {
            gravity = std::max(gravity, std::abs(shown[i] - level[i]));
            off = std::max(off, std::abs(read[i] - shown[i]));
        }
        EXPECT_GT(gravity, 0.05) << quantity;
        EXPECT_LT(off, 0.05 * gravity + 0.01) << quantity << ": vertical motion and squares of small angles";
    }
}

// At rest nothing but gravity acts: pitch with the nose down leaks it backwards.
TEST(Sensors, SignsOfMisalignmentAreThoseOfTheBody) {
    Scenario scenario = shared::scenario("parked_on_slope");
    scenario.road = {};
    scenario.phases.back().until.duration = 0.1;
    scenario.log.channels = {"chassis.ax"};
    scenario.log.sensors = readYamlText<LogParams>(
                               "sensors: [{channel: chassis.ax, name: down, misalignment: "
                               "{pitch: 0.1}}, {channel: chassis.ay, name: right, misalignment: "
                               "{roll: 0.1}}]",
                               "log.yaml")
                               .sensors;
    const Log log = simulate(shared::compact(), scenario);
    EXPECT_NEAR(channel(log, "sensor.down").back(), -kStandardGravity * std::sin(0.1), 1e-3);
    EXPECT_NEAR(channel(log, "sensor.right").back(), kStandardGravity * std::sin(0.1), 1e-3);
}

// ---- One sensor by itself, on signals of known form ----

SensorParams sensor(const std::string& yaml) {
    return readYamlText<SensorParams>("channel: chassis.ay\n" + yaml, "sensor.yaml");
}

std::vector<double> shownOf(const SensorParams& params, double step, int count, auto&& signal) {
    Sensor observed(params, step);
    const ChassisMotion motion;
    std::vector<double> shown;
    for (int k = 0; k < count; ++k) {
        observed.observe(signal(k * step), {motion, Vector3::Zero(), Vector3::Zero()});
        shown.push_back(observed.reading());
    }
    return shown;
}

TEST(Sensor, LowPassIsAButterworthOfSecondOrder) {
    constexpr double kStep = 0.001, kCorner = 20;
    for (const double frequency : {2.0, 10.0, 20.0, 40.0}) {
        const auto shown = shownOf(sensor("low_pass: 20 Hz"), kStep, 4000,
                                   [&](double t) { return std::sin(2 * M_PI * frequency * t); });
        const double amplitude = *std::max_element(shown.begin() + 2000, shown.end());
        const double expected = 1 / std::sqrt(1 + std::pow(frequency / kCorner, 4));
        EXPECT_NEAR(amplitude, expected, 0.01 * expected + 0.003) << frequency << " Hz";
    }
    for (const double value : shownOf(sensor("low_pass: 20 Hz"), kStep, 50, [](double) { return 3.0; })) {
        EXPECT_NEAR(value, 3, 1e-12) << "what has always been so is seen at once";
    }
}

TEST(Sensor, DelayNeedsNoWholeSteps) {
    const auto shown = shownOf(sensor("delay: 0.0255"), 0.01, 50, [](double t) { return 2 + t; });
    EXPECT_EQ(shown[0], 2);
    EXPECT_EQ(shown[2], 2) << "before the delay it shows the start";
    EXPECT_NEAR(shown[10], 2 + 0.1 - 0.0255, 1e-12);
    EXPECT_NEAR(shown[49], 2 + 0.49 - 0.0255, 1e-12);
}

TEST(Sensor, NoiseHasItsDeviationAndItsSeed) {
    const auto zero = [](double) { return 0.0; };
    const auto shown = shownOf(sensor("noise: 0.3"), 0.01, 100000, zero);
    double sum = 0, squares = 0, next = 0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        sum += shown[i];
        squares += shown[i] * shown[i];
        if (i > 0) next += shown[i] * shown[i - 1];
    }
    const double count = static_cast<double>(shown.size());
    EXPECT_NEAR(sum / count, 0, 4 * 0.3 / std::sqrt(count));
    EXPECT_NEAR(std::sqrt(squares / count), 0.3, 0.003);
    EXPECT_NEAR(next / squares, 0, 4 / std::sqrt(count)) << "white";
    EXPECT_EQ(shown, shownOf(sensor("noise: 0.3"), 0.01, 100000, zero));
    EXPECT_NE(shown, shownOf(sensor("noise: 0.3\nseed: 2"), 0.01, 100000, zero));
    EXPECT_NE(shown, shownOf(sensor("noise: 0.3\nname: other"), 0.01, 100000, zero));
}

TEST(Sensor, ResolutionRoundsToWholeSteps) {
    const auto shown = shownOf(sensor("resolution: 0.25"), 0.01, 100, [](double t) { return t; });
    EXPECT_EQ(shown[12], 0);
    EXPECT_EQ(shown[13], 0.25);
    EXPECT_EQ(shown[37], 0.25);
    EXPECT_EQ(shown[38], 0.5);
}

TEST(SensorFaults, NameTheSensorAndWhatIsWrong) {
    const std::vector<std::string_view> channels{"chassis.ay", "chassis.yaw_rate", "wheel.front_left.load"};
    const auto faultOf = [&](const std::string& yaml) {
        const auto faults =
            sensorFaults(readYamlText<LogParams>("sensors: [" + yaml + "]", "log.yaml").sensors, channels);
        return faults.empty() ? "" : faults.front().path + ": " + faults.front().text;
    };
    EXPECT_EQ(faultOf("{channel: chassis.ay, position: {x: 1}, misalignment: {roll: 1}}"), "");
    EXPECT_NE(faultOf("{channel: chassis.ya}").find("channel: found \"chassis.ya\""), std::string::npos);
    EXPECT_NE(faultOf("{channel: chassis.ay}, {channel: chassis.ay}").find("name: found a second sensor"),
              std::string::npos);
    EXPECT_NE(faultOf("{channel: chassis.yaw_rate, position: {x: 1}}").find("position: "), std::string::npos);
    EXPECT_NE(faultOf("{channel: wheel.front_left.load, fixed_to_body: true}").find("fixed_to_body: "),
              std::string::npos);
    EXPECT_THROW(readYamlText<LogParams>("sensors: [{gain: 2}]", "log.yaml"), LoadError);
    Scenario scenario = shared::scenario("sine_steer");
    scenario.log.sensors = {sensor("name: x")};
    scenario.log.sensors[0].channel = "nothing";
    EXPECT_THROW(simulate(shared::compact(), scenario), SimulationError);
}

}  // namespace
}  // namespace tread::sensor_test
