// The end of the car at which a side force is missing, on a linear single-track car that something pushes.
#include <gtest/gtest.h>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/diagnose.h"
#include "diagnose/options.h"
#include "shared/linear_single_track.h"
#include "shared/simple_car.h"

namespace tread::diagnose_missing_force_test {
namespace {

using diagnose::answer::Shares;

constexpr double kSpeed = 22, kDuration = 6, kStep = 0.01;

shared::SingleTrack singleTrack(const VehicleParams& car) {
    return {.mass = car.mass,
            .inertia = car.inertia.yaw,
            .front = car.front_axle_distance,
            .rear = car.wheelbase - car.front_axle_distance,
            .speed = kSpeed,
            .ratio = car.steering.ratio};
}

void drive(const VehicleParams& car, const Scenario& scenario, const Recorder& recorder, const Pushing& pushing) {
    const shared::SingleTrack track = singleTrack(car);
    const std::vector<Column> columns = recordedColumns(scenario.log.channels);
    recorder.begin(columns);
    Eigen::Vector2d x(0, 0);
    const auto rows = static_cast<int>(*scenario.phases.back().until.duration / scenario.step) + 1;
    for (int k = 0; k <= rows; ++k) {
        const double t = k * scenario.step, angle = valueAt(scenario.phases.back().steering, 0, t);
        const Push push = pushing ? pushing(t, {}, {}) : Push{};
        const Eigen::Vector2d aside(push.force.y() / track.mass, push.moment.z() / track.inertia);
        const Eigen::Vector2d slope = track.a() * x + track.b() * angle + aside;
        const std::map<std::string, double> shown{{"time", t},
                                                  {"driver.steering_wheel_angle", angle},
                                                  {"chassis.vx", track.speed},
                                                  {"chassis.yaw_rate", x[1]},
                                                  {"chassis.ay", slope[0] + track.speed * x[1]}};
        std::vector<double> row(columns.size(), 0);
        for (std::size_t i = 0; i < row.size(); ++i)
            if (const auto found = shown.find(columns[i].name); found != shown.end()) row[i] = found->second;
        recorder.row(row);
        x += scenario.step * slope;
    }
}

// Shares that a diagnosis finds after a gust of a side force so far ahead of the centre of gravity, m.
Shares found(double ahead) {
    simple_car::Case made;
    Scenario scenario = simple_car::slalom(kSpeed);
    scenario.step = kStep;
    scenario.phases.back().until.duration = kDuration;
    scenario.log.channels = {"driver.steering_wheel_angle", "chassis.vx", "chassis.yaw_rate", "chassis.ay"};
    const auto gust = [&](double time, const VehicleInput&, const VehicleOutput&) {
        const double force = 1500 * std::exp(-std::pow((time - 3) / 0.5, 2));
        return Push{.force = {0, force, 0}, .moment = {0, 0, ahead * force}};
    };
    Log log;
    drive(made.nominal.vehicle, scenario, recorderInto(log), gust);
    Random random(5);
    for (Channel& channel : log.channels) {
        const double noise = channel.name == "chassis.ay" ? 0.03 : channel.name == "chassis.yaw_rate" ? 0.002 : 0;
        for (double& value : channel.values) value += noise * random.normal();
    }
    made.file.recordings = {{.log = "drive", .name = "drive"}};
    made.recorded.logs = {log};
    diagnose::Options options;
    options.simulate = drive;
    options.threads = 1;
    return diagnose::diagnosisOf(made.nominal, made.file, made.recorded, {simple_car::effect("drag", "aero.drag_area")},
                                 options)
        .where.axle_force;
}

TEST(AxleForce, IsThatOfTheAxleAtWhichTheCarIsPushed) {
    const shared::SingleTrack track = singleTrack(simple_car::Case{}.nominal.vehicle);
    EXPECT_GT(found(track.front).at("front"), 0.8);
    EXPECT_GT(found(-track.rear).at("rear"), 0.8);
}

TEST(AxleForce, OfAPushAtTheCentreOfGravityIsSharedByTheLever) {
    const shared::SingleTrack track = singleTrack(simple_car::Case{}.nominal.vehicle);
    const double f = track.rear * track.rear, r = track.front * track.front;
    const Shares shares = found(0);
    EXPECT_NEAR(shares.at("front"), f / (f + r), 0.1);
    EXPECT_NEAR(shares.at("front") + shares.at("rear"), 1, 1e-12);
}

}  // namespace
}  // namespace tread::diagnose_missing_force_test
