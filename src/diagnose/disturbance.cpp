#include "diagnose/disturbance.h"

#include <algorithm>
#include <cmath>

#include "diagnose/observation.h"
#include "diagnose/replay.h"
#include "log/resample.h"
#include "tread/tyre.h"

namespace tread {
namespace {

constexpr double kHat = 0.5;             // s, from hat to hat
constexpr double kStep = 0.01;           // s, of the linear car
constexpr double kSlowest = 3;           // m/s: below it the linear car is too stiff, and nothing of it matters
constexpr double kLeastSlope = 0.1;      // of the tyres' slope at rest, that is left at the limit
constexpr double kFollowsSpeed = 1.5;    // 1/s, how fast the driver who follows a speed corrects it
constexpr double kSlipVelocity = 0.005;  // of the forward speed, at which the tyres' slope is taken

// Usual sizes: accelerations that wind and unevenness of a good road leave, and the tremble of a road wheel.
constexpr double kLongitudinal = 0.02;  // m/s2
constexpr double kLateral = 0.04;       // m/s2
constexpr double kYaw = 0.04;           // rad/s2
constexpr double kRoll = 0.08;          // rad/s2
constexpr double kSteering = 0.0003;    // rad

// Single track with roll.
struct LinearCar {
    double mass, yaw_inertia, roll_inertia, front, rear;  // front, rear: m, from the centre of gravity to the axles
    double front_slope, rear_slope;                       // N/rad, of both wheels, at rest
    double roll_stiffness, roll_damping, roll_arm, track, radius;
    double grip;  // m/s2
};

double slopeOf(const AxleParams& axle, double load, double& friction) {
    const TyreSteadyState at =
        steadyState(axle.tyre, {.Fz = load, .gamma = 0, .Vx = 1, .Vsx = 0, .Vsy = kSlipVelocity});
    friction = at.muy;
    const double slope = std::abs(at.Fy) / kSlipVelocity;
    return 2 * slope / std::max(0.2, 1 - slope * axle.suspension.steer_by_lateral_force);
}

LinearCar linearCar(const VehicleParams& car) {
    const double rear = car.wheelbase - car.front_axle_distance;
    const double weight = car.mass * kStandardGravity / (2 * car.wheelbase);
    LinearCar linear{.mass = car.mass,
                     .yaw_inertia = car.inertia.yaw,
                     .roll_inertia = car.inertia.roll,
                     .front = car.front_axle_distance,
                     .rear = rear,
                     .front_slope = 0,
                     .rear_slope = 0,
                     .roll_stiffness = 0,
                     .roll_damping = 0,
                     .roll_arm = 0,
                     .track = 0.5 * (car.front.track + car.rear.track),
                     .radius = car.front.tyre.parameters.Re,
                     .grip = 0};
    double front_friction = 0, rear_friction = 0;
    linear.front_slope = slopeOf(car.front, weight * rear, front_friction);
    linear.rear_slope = slopeOf(car.rear, weight * car.front_axle_distance, rear_friction);
    linear.grip = kStandardGravity * std::min(front_friction, rear_friction);
    const double centre = (car.front.suspension.roll_centre_height * rear +
                           car.rear.suspension.roll_centre_height * car.front_axle_distance) /
                          car.wheelbase;
    linear.roll_arm = car.height - centre;
    for (const AxleParams* axle : {&car.front, &car.rear}) {
        const SuspensionParams& s = axle->suspension;
        const double squared = axle->track * axle->track;
        linear.roll_stiffness += squared * (0.5 * s.spring + s.anti_roll_bar);
        linear.roll_damping += squared * 0.25 * (s.damper.bump + s.damper.rebound);
    }
    linear.roll_stiffness -= car.mass * kStandardGravity * linear.roll_arm;
    linear.roll_stiffness = std::max(linear.roll_stiffness, car.mass * kStandardGravity * linear.roll_arm);
    return linear;
}

struct Course {  // of the drive about which the car is linear
    std::vector<double> speed, lateral;
};

// Small motion of the linear car under one hat; implicit Euler, for it is stiff at low speed.
Log response(const LinearCar& car, const Course& course, Disturbed kind, double peak, bool follows_speed) {
    Log log;
    for (const char* name : {"time", "chassis.pitch_rate"}) log.channels.push_back({name, "", {}});
    for (const ObservedQuantity& quantity : observedQuantities()) log.channels.push_back({quantity.channel, "", {}});
    const auto push = [&](const char* name, double value) {
        for (Channel& channel : log.channels) {
            if (channel.name == name) channel.values.push_back(value);
        }
    };
    double vx = 0, vy = 0, r = 0, roll = 0, rate = 0;
    for (std::size_t i = 0; i < course.speed.size(); ++i) {
        const double t = static_cast<double>(i) * kStep;
        const double hat = std::max(0.0, 1 - std::abs(t - peak) / kHat);
        const auto of = [&](Disturbed which, double size) { return kind == which ? hat * size : 0.0; };
        const double v = std::max(course.speed[i], kSlowest);
        const double used = course.lateral[i] / car.grip;
        const double left = std::max(kLeastSlope, 1 - used * used);
        const double cf = left * car.front_slope, cr = left * car.rear_slope;
        const double steer = of(Disturbed::steering, kSteering);
        const double ax = of(Disturbed::longitudinal, kLongitudinal) - (follows_speed ? kFollowsSpeed * vx : 0);

        Eigen::Matrix2d a;
        a << -(cf + cr) / (car.mass * v), -(car.front * cf - car.rear * cr) / (car.mass * v) - v,
            -(car.front * cf - car.rear * cr) / (car.yaw_inertia * v),
            -(car.front * car.front * cf + car.rear * car.rear * cr) / (car.yaw_inertia * v);
        const Eigen::Vector2d force(of(Disturbed::lateral, kLateral) + cf * steer / car.mass,
                                    of(Disturbed::yaw, kYaw) + car.front * cf * steer / car.yaw_inertia);
        const Eigen::Vector2d now(vy, r);
        const Eigen::Vector2d next = (Eigen::Matrix2d::Identity() - kStep * a).inverse() * (now + kStep * force);
        const double ay = (next(0) - vy) / kStep + v * next(1);
        vx += kStep * ax, vy = next(0), r = next(1);
        const double moment = of(Disturbed::roll, kRoll) + car.mass * car.roll_arm * ay / car.roll_inertia;
        const double stiffness = car.roll_stiffness / car.roll_inertia, damping = car.roll_damping / car.roll_inertia;
        rate = (rate + kStep * (moment - stiffness * roll)) / (1 + kStep * (damping + kStep * stiffness));
        roll += kStep * rate;

        push("time", t), push("chassis.pitch_rate", 0);
        push("chassis.vx", vx), push("chassis.ax", ax), push("chassis.ay", ay), push("chassis.yaw_rate", r);
        push("chassis.roll_rate", rate), push("chassis.roll", roll), push("chassis.vy", vy);
        push("chassis.sideslip", vy / v);
        const double turn = 0.5 * car.track * r;
        push("wheel.front_left.spin", (vx - turn) / car.radius),
            push("wheel.front_right.spin", (vx + turn) / car.radius);
        push("wheel.rear_left.spin", (vx - turn) / car.radius), push("wheel.rear_right.spin", (vx + turn) / car.radius);
    }
    return log;
}

Course courseOf(const RecordedDrive& drive, const Log* motion) {
    Course course;
    const std::vector<double> none(2, drive.speed), still(2, 0), ends{0, drive.duration()};
    const Channel* vx = motion ? motion->find("chassis.vx") : nullptr;
    const Channel* ay = motion ? motion->find("chassis.ay") : nullptr;
    const std::vector<double>& time = vx ? motion->channels.front().values : ends;
    const auto rows = static_cast<std::size_t>(std::ceil(drive.duration() / kStep)) + 2;
    for (std::size_t i = 0; i < rows; ++i) {
        const double t = std::clamp(static_cast<double>(i) * kStep, time.front(), time.back());
        course.speed.push_back(valueAt(time, vx ? vx->values : none, t));
        course.lateral.push_back(valueAt(time, ay ? ay->values : still, t));
    }
    return course;
}

bool followsSpeed(const ObservedChannel& channel) {
    return channel.name == "chassis.vx" || channel.name.ends_with(".spin");
}

// A change of speed changes all that the car does at that speed: as a change at the start does.
void addBySpeed(const RecordedDrive& drive, const Log& motion, const Eigen::VectorXd& by_start_speed,
                Eigen::Ref<Eigen::VectorXd> rows) {
    const std::vector<double>& time = motion.channels.front().values;
    const std::vector<double>& vx = motion.find("chassis.vx")->values;
    for (const ObservedChannel& channel : drive.channels) {
        if (followsSpeed(channel) || channel.name == "chassis.ax") continue;
        for (std::size_t i = 0; i < channel.times.size(); ++i) {
            const Eigen::Index row = channel.first_row + static_cast<Eigen::Index>(i);
            rows(row) += by_start_speed(row) * valueAt(time, vx, std::min(channel.times[i], time.back()));
        }
    }
}

}  // namespace

Disturbances disturbances(Bench& bench, std::size_t index, const Eigen::VectorXd& by_start_speed) {
    const RecordedDrive& drive = bench.drives[index];
    const std::optional<Log> motion = motionAt(bench, index, bench.nominal);
    const Course course = courseOf(drive, motion ? &*motion : nullptr);
    const LinearCar car = linearCar(bench.nominal.vehicle);
    const auto hats = static_cast<std::size_t>(std::ceil(drive.duration() / kHat)) + 1;
    Disturbances result;
    result.columns.resize(drive.rows(), static_cast<Eigen::Index>(hats * kDisturbances));
    Eigen::Index column = 0;
    for (std::size_t kind = 0; kind < kDisturbances; ++kind) {
        for (std::size_t hat = 0; hat < hats; ++hat, ++column) {
            const double peak = static_cast<double>(hat) * kHat;
            const Log small = response(car, course, static_cast<Disturbed>(kind), peak,
                                       drive.recording->speed == SpeedReplay::followed);
            result.columns.col(column) = readings(drive, small, Instruments{});
            addBySpeed(drive, small, by_start_speed, result.columns.col(column));
            result.kinds.push_back(static_cast<Disturbed>(kind));
            result.times.push_back(peak);
        }
    }
    return result;
}

}  // namespace tread
