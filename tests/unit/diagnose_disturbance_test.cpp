// Errors of the model's forces: their columns, against replays of a linear car that such an error pushes.
#include "diagnose/model/disturbance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "diagnose/model/problem.h"
#include "inference/ornstein_uhlenbeck.h"
#include "recording/observation.h"
#include "shared/linear_single_track.h"
#include "shared/simple_car.h"

namespace tread::diagnose_disturbance_test {
namespace {

using diagnose::model::Disturbances;
using diagnose::model::Disturbed;
using diagnose::model::motionAt;
using diagnose::model::Problem;
using recording::RecordedDrive;

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kSpeed = 22, kDuration = 8, kStep = 0.01;
constexpr double kApart = 2.5, kLasts = 5, kShare = 0.005;  // s, s, of the model's force: (D11a)
// Of the largest change: the force is a straight line over each 0.25 s, and a turn of 0.8 rad/s bends by so much in it.
constexpr double kInterpolated = 0.03;
constexpr double kRollStiffness = 8e4;  // N m/rad

// A single track that brakes and rolls: all of its motion is linear in the pushes.
void drive(const VehicleParams& car, const Scenario& scenario, const Recorder& recorder, const Pushing& pushing) {
    const shared::SingleTrack track{.mass = car.mass,
                                    .inertia = car.inertia.yaw,
                                    .front = car.front_axle_distance,
                                    .rear = car.wheelbase - car.front_axle_distance,
                                    .speed = kSpeed,
                                    .ratio = car.steering.ratio};
    const std::vector<Column> columns = recordedColumns(scenario.log.channels);
    recorder.begin(columns);
    Eigen::Vector2d x(0, 0);
    double speed = scenario.start.speed, roll = 0;
    double duration = 0;
    for (const Phase& phase : scenario.phases) duration += *phase.until.duration;
    const auto rows = static_cast<int>(duration / scenario.step) + 1;
    for (int k = 0; k <= rows; ++k) {
        const double t = k * scenario.step, angle = valueAt(scenario.phases.back().steering, 0, t);
        const Push push = pushing ? pushing(t, {}, {}) : Push{};
        const Eigen::Vector2d aside(push.force.y() / track.mass, push.moment.z() / track.inertia);
        const Eigen::Vector2d slope = track.a() * x + track.b() * angle + aside;
        const double ax = -1 - std::sin(0.7 * t) + push.force.x() / track.mass;
        const std::map<std::string, double> shown{{"time", t},
                                                  {"driver.steering_wheel_angle", angle},
                                                  {"chassis.vx", speed},
                                                  {"chassis.yaw_rate", x[1]},
                                                  {"chassis.roll", roll},
                                                  {"chassis.ax", ax},
                                                  {"chassis.ay", slope[0] + track.speed * x[1]}};
        std::vector<double> row(columns.size(), 0);
        for (std::size_t i = 0; i < row.size(); ++i)
            if (const auto found = shown.find(columns[i].name); found != shown.end()) row[i] = found->second;
        recorder.row(row);
        x += scenario.step * slope;
        speed += scenario.step * ax;
        roll += scenario.step * (push.moment.x() / kRollStiffness - roll) / 0.2;
    }
}

// A slow swing to one side: between two hats of the disturbances (0.25 s) its forces are nearly straight lines.
struct Swing {
    simple_car::Case made;
    Log nominal;
    Problem problem;

    explicit Swing(const recording::Recording& recording = {.log = "drive", .name = "drive"}) {
        Scenario scenario = simple_car::slalom(kSpeed);
        Curve angle;
        for (double t = 0; t < kDuration; t += 0.05) angle.points.push_back({t, 0.25 * (1 - std::cos(0.8 * t))});
        scenario.phases.front().steering = Table<Angle>{angle};
        scenario.step = kStep;
        scenario.phases.back().until.duration = kDuration;
        scenario.log.channels = {"driver.steering_wheel_angle",
                                 "chassis.vx",
                                 "chassis.yaw_rate",
                                 "chassis.roll",
                                 "chassis.ax",
                                 "chassis.ay"};
        drive(made.nominal.vehicle, scenario, recorderInto(nominal), {});
        made.file.recordings = {recording};
        made.file.step = kStep;
        made.recorded.logs = {nominal};
        diagnose::Options options;
        options.simulate = drive;
        options.threads = 1;
        problem = diagnose::model::problemOf(made.nominal, made.file, made.recorded,
                                             std::vector<diagnose::catalogue::Effect>{}, options);
    }
    double acceleration(const char* channel, double t) const {
        const std::vector<double>& values = nominal.find(channel)->values;
        return values[std::min<std::size_t>(static_cast<std::size_t>(std::lround(t / kStep)), values.size() - 1)];
    }
    // An error that follows the impulse `column` of a process of unit variance.
    Push error(Disturbed kind, const MatrixXd& factor, Index column, double t) const {
        const VehicleParams& car = made.nominal.vehicle;
        double size = 0;
        for (Index h = 0; h < factor.rows(); ++h)
            size += factor(h, column) * std::max(0.0, 1 - std::abs(t / kApart - static_cast<double>(h)));
        const double along = kShare * car.mass * std::abs(acceleration("chassis.ax", t)) * size,
                     across = kShare * car.mass * std::abs(acceleration("chassis.ay", t)) * size;
        const double front = car.front_axle_distance, rear = car.wheelbase - front;
        switch (kind) {
            case Disturbed::longitudinal_error:
                return {.force = {along, 0, 0}};
            case Disturbed::lateral_error:
                return {.force = {0, across, 0}};
            case Disturbed::yaw_error:
                return {.moment = {0, 0, across * front * rear / car.wheelbase}};
            default:
                return {.moment = {across * car.centre_of_gravity_height, 0, 0}};
        }
    }
};

TEST(ErrorsOfForces, DoWhatAForceInProportionToTheAccelerationDoes) {
    const Swing swing;
    const RecordedDrive& drive = swing.problem.drives.front();
    const Disturbances told = disturbances(swing.problem.replays, drive, swing.made.nominal);
    const auto read = [&](const Pushing& pushing) {
        const std::optional<Log> motion =
            motionAt(swing.problem.replays, drive, swing.made.nominal, {.pushing = pushing});
        return readings(drive, motion.value(), swing.made.nominal.instruments);
    };
    const VectorXd before = read({});
    Index first = told.random();
    for (const Disturbed kind : diagnose::model::kForceErrors) {
        const auto count = static_cast<Index>(std::count(told.kinds.begin(), told.kinds.end(), kind));
        ASSERT_GE(count, 4) << "hats of an error, 2.5 s apart, in 8 s";
        const MatrixXd factor = inference::correlationFactor(count, kApart, kLasts);
        MatrixXd really(drive.rows(), count);
        for (Index i = 0; i < count; ++i) {
            ASSERT_EQ(told.kinds[first + i], kind);
            EXPECT_NEAR(told.times[first + i], kApart * static_cast<double>(i), 1e-12);
            really.col(i) = read([&](double t, const VehicleInput&, const VehicleOutput&) {
                                return swing.error(kind, factor, i, t);
                            }) -
                            before;
        }
        const MatrixXd off = told.columns.middleCols(first, count) - really;
        for (const recording::ObservedChannel& channel : drive.channels) {
            const double largest = really.middleRows(channel.first_row, channel.rows()).cwiseAbs().maxCoeff();
            EXPECT_LE(off.middleRows(channel.first_row, channel.rows()).cwiseAbs().maxCoeff(),
                      kInterpolated * largest + 1e-9)
                << nameOf(kind) << ", " << channel.name;
        }
        first += count;
    }
    EXPECT_EQ(told.kinds[first], Disturbed::speed_reading) << "errors of the readings come next";
}

// A drift of one channel: a line between values 1 s apart, which correlate over 2 s, and nothing in the other channels.
TEST(ErrorsOfReadings, ChangeTheReadingsOfOneChannelAlone) {
    const Swing swing;
    const RecordedDrive& drive = swing.problem.drives.front();
    const Disturbances told = disturbances(swing.problem.replays, drive, swing.made.nominal);
    const std::map<std::string, std::pair<Disturbed, double>> expected{
        {"chassis.vx", {Disturbed::speed_reading, 0.005}},
        {"chassis.yaw_rate", {Disturbed::rate_reading, 5e-5}},
        {"chassis.roll", {Disturbed::angle_reading, 1e-3}},
        {"chassis.ax", {Disturbed::acceleration_reading, 0.003}},
        {"chassis.ay", {Disturbed::acceleration_reading, 0.003}}};
    const auto values = static_cast<Index>(std::ceil(drive.duration())) + 1;
    Index first = 0;
    while (told.kinds[first] != Disturbed::speed_reading) ++first;
    for (const recording::ObservedChannel& channel : drive.channels) {
        const auto& [kind, size] = expected.at(channel.name);
        const MatrixXd all = told.columns.middleCols(first, values);
        for (Index a = 0; a < values; ++a) {
            EXPECT_EQ(told.kinds[first + a], kind) << channel.name;
            EXPECT_EQ(told.times[first + a], static_cast<double>(a));
        }
        const auto between = [&](Index row, Index value) {
            return std::max(0.0, 1 - std::abs(channel.times[row] - static_cast<double>(value)));
        };
        for (Index i = 0; i < channel.rows(); i += 7) {
            for (Index j = 0; j < channel.rows(); j += 5) {
                double correlated = 0;
                for (Index a = 0; a < values; ++a)
                    for (Index b = 0; b < values; ++b)
                        correlated +=
                            between(i, a) * between(j, b) * std::exp(-0.5 * static_cast<double>(std::abs(a - b)));
                const double found = all.row(channel.first_row + i).dot(all.row(channel.first_row + j));
                EXPECT_NEAR(found, size * size * correlated, 1e-9 * size * size) << channel.name;
            }
        }
        EXPECT_EQ(all.topRows(channel.first_row).cwiseAbs().sum(), 0) << channel.name;
        EXPECT_EQ(all.bottomRows(drive.rows() - channel.first_row - channel.rows()).cwiseAbs().sum(), 0);
        first += values + (kind == Disturbed::speed_reading ? 1 : 2);  // errors of scale and timing
    }
}

// A reading that is too large by a thousandth, but for speeds, or a millisecond late, throughout a drive.
TEST(ErrorsOfReadings, ScaleAndDelayOneChannelByAThousandth) {
    const Swing swing;
    const RecordedDrive& drive = swing.problem.drives.front();
    recording::Subject subject = swing.made.nominal;
    subject.instruments.yaw_rate.bias = 0.02;
    const Disturbances told = disturbances(swing.problem.replays, drive, subject);
    const std::optional<Log> motion = motionAt(swing.problem.replays, drive, subject);
    ASSERT_TRUE(motion);
    const VectorXd right = recording::readings(drive, *motion, subject.instruments);
    Index column = 0;
    for (const recording::ObservedChannel& channel : drive.channels) {
        const diagnose::model::ReadingErrors errors = diagnose::model::readingErrorsOf(channel.name);
        const Index end = channel.first_row + channel.rows();
        const auto isOf = [&](Index row) { return row >= channel.first_row && row < end; };
        EXPECT_EQ(errors.scale.has_value(), channel.name != "chassis.vx");
        if (errors.scale) {
            while (told.kinds[column] != *errors.scale) ++column;
            for (Index row = 0; row < drive.rows(); ++row)
                EXPECT_NEAR(told.columns(row, column), isOf(row) ? 0.001 * right(row) : 0, 1e-15) << channel.name;
        }
        recording::Instruments late = subject.instruments;
        (late.*recording::observedQuantity(channel.name)->instrument).delay = 0.001;
        const VectorXd later = recording::readings(drive, *motion, late) - right;
        const double most = later.segment(channel.first_row, channel.rows()).cwiseAbs().maxCoeff();
        while (told.kinds[column] != errors.timing) ++column;
        for (Index row = 0; row < drive.rows(); ++row) {
            if (!isOf(row)) {
                EXPECT_EQ(told.columns(row, column), 0) << channel.name;
            } else if (row > channel.first_row && row < end - 2) {  // the last block is short
                EXPECT_NEAR(told.columns(row, column), later(row), 0.02 * most) << channel.name << ", row " << row;
            }
        }
        ++column;
    }
}

TEST(ErrorsOfReadings, AreOfTheInstrumentThatReadsTheChannel) {
    using diagnose::model::readingErrorsOf;
    EXPECT_EQ(readingErrorsOf("chassis.yaw_rate@can").drift, Disturbed::rate_reading);
    EXPECT_EQ(readingErrorsOf("chassis.roll_rate").scale, Disturbed::rate_scale);
    EXPECT_EQ(readingErrorsOf("chassis.sideslip").timing, Disturbed::angle_timing);
    EXPECT_EQ(readingErrorsOf("chassis.vy@position").drift, Disturbed::speed_reading);
    EXPECT_EQ(readingErrorsOf("wheel.rear_left.spin").timing, Disturbed::wheel_speed_timing);
    const VehicleParams car = Swing().made.nominal.vehicle;
    EXPECT_NEAR(usualSize(Disturbed::wheel_speed_reading, car) * car.front.tyre.parameters.Re, 0.005, 1e-12);
}

// Their usual size is the share of the force, so that it does not depend on that of the disturbances.
TEST(ErrorsOfForces, AreNamedAfterTheForceAndComeAfterTheDisturbances) {
    using namespace diagnose::model;
    for (std::size_t i = 0; i < kForceErrors.size(); ++i) {
        EXPECT_EQ(nameOf(kForceErrors[i]), std::string(nameOf(kDisturbedKinds[i])) + " error");
        EXPECT_EQ(placeOf(kForceErrors[i]), kDisturbedKinds.size() + i);
    }
}

}  // namespace
}  // namespace tread::diagnose_disturbance_test
