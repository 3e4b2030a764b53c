// What disturbances do to a drive, as a few replays tell it, against pushing the car each time anew.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "diagnose/model/disturbance.h"
#include "diagnose/model/replays.h"
#include "planted/planted.h"
#include "recording/recorded_drive.h"
#include "recording/replay.h"
#include "run/simulate.h"
#include "tread/tyre.h"

namespace tread::disturbance_test {
namespace {

using diagnose::model::Disturbances;
using diagnose::model::Disturbed;
using diagnose::model::Hats;
using diagnose::model::motionAt;
using diagnose::model::nameOf;
using diagnose::model::placeOf;
using diagnose::model::Replays;
using diagnose::model::Rows;
using diagnose::model::rowsAt;
using diagnose::model::usualSize;
using recording::ObservedChannel;
using recording::RecordedDrive;
using recording::recordedDrive;

Push pushOf(Disturbed kind, double size) {
    switch (kind) {
        case Disturbed::longitudinal:
            return {.force = {size, 0, 0}};
        case Disturbed::lateral:
            return {.force = {0, size, 0}};
        case Disturbed::yaw:
            return {.moment = {0, 0, size}};
        default:
            return {.moment = {size, 0, 0}};
    }
}

double noise(const ObservedChannel& channel) {
    const auto of = std::find_if(planted::kNoise.begin(), planted::kNoise.end(),
                                 [&](const planted::Noise& one) { return one.channel == channel.name; });
    return of == planted::kNoise.end() ? 0 : of->sd;
}

// Steers ever more, far beyond the grip of the front tyres.
Scenario spiral() {
    Phase turn = planted::phase(8.5);
    turn.steering = Ramp<Angle>{.to = 200 * planted::kDegree, .rate = 25 * planted::kDegree};
    return planted::drive(22, {turn});
}

TEST(Disturbances, PushesDoWhatTheyDoAloneAlsoAtTheLimitAndLongAfter) {
    const planted::Case made = planted::recorded(
        {.vehicle = planted::nominalCar(), .road = {}, .wind = {}, .instruments = {}}, {{"spiral", spiral()}});
    Replays replays;
    replays.replayer = {made.nominal, made.file.step, [](const auto&... all) { simulate(all..., MovedBy::itself); }};
    const std::vector<RecordedDrive> drives{recordedDrive(made.file.recordings.front(), made.logs.front(), made.file)};
    const RecordedDrive& drive = drives.front();
    const Rows rows = *rowsAt(replays, drives, replays.origin());
    const Disturbances told = disturbances(replays, drive, made.nominal);
    // Without what lingers of each impulse in the hats after it.
    for (const Disturbed kind : {Disturbed::longitudinal, Disturbed::lateral, Disturbed::yaw, Disturbed::roll}) {
        const Hats& hats = told.of(kind);
        const Eigen::MatrixXd columns =
            told.columns.middleCols(hats.first, hats.count()) * hats.correlation_factor.inverse();
        for (const double peak : {1.0, 4.0, 6.5}) {
            const auto pushing = [&](double time, const VehicleInput&, const VehicleOutput&) {
                const double height = std::max(0.0, 1 - std::abs(time - peak) / hats.apart);
                return pushOf(kind, height * usualSize(kind, made.nominal.vehicle));
            };
            const std::optional<Log> motion = motionAt(replays, drive, made.nominal, {.pushing = pushing});
            ASSERT_TRUE(motion);
            const Eigen::VectorXd really = readings(drive, *motion, made.nominal.instruments) - rows.front();
            const Eigen::VectorXd column = columns.col(static_cast<Eigen::Index>(std::lround(peak / hats.apart)));
            for (const ObservedChannel& channel : drive.channels) {
                const auto count = static_cast<Eigen::Index>(channel.times.size());
                const Eigen::VectorXd real = really.segment(channel.first_row, count);
                const Eigen::VectorXd off = column.segment(channel.first_row, count) - real;
                EXPECT_LT(off.lpNorm<Eigen::Infinity>(), 0.1 * real.lpNorm<Eigen::Infinity>() + 0.02 * noise(channel))
                    << channel.name << ", " << nameOf(kind) << " at " << peak << " s";
            }
        }
    }
}

// Force per slip of a front tyre at static load, N.
double slipStiffness(const VehicleParams& car) {
    constexpr double kSlip = 1e-3;
    const double load = car.mass * kStandardGravity * (1 - car.front_axle_distance / car.wheelbase) / 2;
    const auto force = [&](double slip) {
        return steadyState(car.front.tyre, {.Fz = load, .gamma = 0, .Vx = 22, .Vsx = -22 * slip, .Vsy = 0}).Fx;
    };
    return (force(kSlip) - force(-kSlip)) / (2 * kSlip);
}

// The car moves on as recorded, but the driven wheels slip by what the force takes. They slip 7 % more than expected
// here: half of this is their slip stiffness, which is 84 instead of 87 kN with the camber and the loads of the drive.
TEST(Disturbances, AreOvercomeByTheDrivenTyresWhereTheSpeedIsFollowed) {
    constexpr double kSpeed = 22;
    planted::Case made =
        planted::recorded({.vehicle = planted::nominalCar(), .road = {}, .wind = {}, .instruments = {}},
                          {{"straight", planted::drive(kSpeed, {planted::phase(8)})}});
    made.file.recordings.front().speed = recording::SpeedReplay::followed;
    Replays replays;
    replays.replayer = {made.nominal, made.file.step, [](const auto&... all) { simulate(all..., MovedBy::itself); }};
    const RecordedDrive drive = recordedDrive(made.file.recordings.front(), made.logs.front(), made.file);
    const Disturbances told = disturbances(replays, drive, made.nominal);
    const VehicleParams& car = made.nominal.vehicle;
    const Hats& hats = told.of(Disturbed::longitudinal);
    const Eigen::VectorXd column =
        (told.columns.middleCols(hats.first, hats.count()) * hats.correlation_factor.inverse()).col(16);
    ASSERT_NEAR(hats.peak(16), 4, 1e-9);
    const double slip = -usualSize(Disturbed::longitudinal, car) / (2 * slipStiffness(car));
    const double expected = slip * kSpeed / car.front.tyre.parameters.Re * hats.apart;  // of a wheel, rad
    int wheels = 0;
    for (const ObservedChannel& channel : drive.channels) {
        if (!channel.name.starts_with("wheel.")) continue;
        const double turned = recording::kBlock * column.segment(channel.first_row, channel.rows()).sum();
        const bool driven = channel.name.starts_with("wheel.front_");
        EXPECT_NEAR(turned, driven ? expected : 0, 0.1 * std::abs(expected)) << channel.name;
        ++wheels;
    }
    EXPECT_EQ(wheels, 4);
}

}  // namespace
}  // namespace tread::disturbance_test
