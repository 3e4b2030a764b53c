// Cornering: the car against the linear single-track model, statics of roll and load transfer, and Newton's balance.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <numbers>

#include "shared/vehicles.h"

namespace tread {
namespace {

constexpr double kStep = 0.001;  // s
constexpr double kDegree = std::numbers::pi / 180;

std::vector<VehicleParams> cars() {
    return {reference::compact(), reference::rearDriveSedan()};
}

VehicleParams withoutAir(VehicleParams car) {
    car.aero = {};
    return car;
}

// Turns the hand wheel smoothly to an angle, then holds angle and speed.
reference::Car steadyTurn(const VehicleParams& params, const Road& road, double speed, double road_wheel_angle,
                          double duration) {
    reference::Car car = reference::settled(params, road, {.speed = speed});
    const double throttle = car.input.throttle;
    for (double t = 0; t < duration; t += kStep) {
        const double x = std::min(t / 1.0, 1.0);
        VehicleInput next = car.input;
        next.steering_wheel_angle = params.steering.ratio * road_wheel_angle * x * x * (3 - 2 * x);
        next.throttle = std::clamp(throttle + 0.5 * (speed - car.output().chassis.vx), 0.0, 1.0);
        car.step(next, kStep);
    }
    return car;
}

// ---- Roll and load transfer ----

// Left less right load of both axles, and the roll angle, for small lateral accelerations. Springs, bars and tyres in
// series; the links carry the force along the body's lateral axis (the weight has a share in it when the body leans)
// times the height of the roll centre. The spinning wheels roll the car outwards as it yaws.
struct Roll {
    double angle;                // rad
    PerAxle<double> difference;  // N, left less right
};

Roll rollAt(const VehicleParams& car, double lateral_acceleration) {
    const double weight = car.mass * kStandardGravity;
    double per_roll = weight * car.height, constant = car.mass * lateral_acceleration * car.height;
    PerAxle<double> by_roll, by_force;
    for (std::size_t axle = 0; axle < kAxles; ++axle) {
        const AxleParams& a = axle == 0 ? car.front : car.rear;
        const double share =
            (axle == 0 ? car.wheelbase - car.front_axle_distance : car.front_axle_distance) / car.wheelbase;
        const double force = share * car.mass * lateral_acceleration;
        constant += 2 * a.wheel_inertia / a.tyre.parameters.Re * lateral_acceleration;
        const double rate = a.suspension.spring + 2 * a.suspension.anti_roll_bar;
        const double series = 1 + rate / a.tyre.parameters.pz1;
        // A wheel that leans against the body moves its contact sideways.
        const double radius = a.tyre.parameters.Ro - 0.5 * share * weight / a.tyre.parameters.pz1;
        per_roll += share * weight * radius * a.suspension.camber_by_travel * 0.5 * a.track / series;
        by_roll[axle] = -(rate * a.track + 2 * a.suspension.roll_centre_height * share * weight / a.track) / series;
        by_force[axle] = -2 * a.suspension.roll_centre_height * force / a.track / series;
        per_roll += 0.5 * a.track * by_roll[axle];
        constant += 0.5 * a.track * by_force[axle];
    }
    const double angle = -constant / per_roll;
    return {angle, {by_roll.front * angle + by_force.front, by_roll.rear * angle + by_force.rear}};
}

TEST(Cornering, RollAngleAndLoadTransferFollowStatics) {
    // What the statics leave out: the car's yaw inertia is at rest, but jacking, camber and cos(roll) are of second
    // order; at 1 m/s2 they stay below 1 %.
    constexpr double kSecondOrder = 0.01;
    const PlaneRoad road;
    for (const VehicleParams& shipped : cars()) {
        const VehicleParams params = withoutAir(shipped);
        const reference::Car car = steadyTurn(params, road, 20, 0.008, 6);
        const ChassisOutput out = car.output().chassis;
        const Roll expected = rollAt(params, out.ay);
        const auto& w = car.state.wheels;
        const double front = w[0].load - w[1].load, rear = w[2].load - w[3].load;
        std::printf(
            "%s at %.2f m/s2: roll %.3f deg/g (closed form %.3f), load difference front %.1f N (%.1f), rear %.1f N "
            "(%.1f)\n",
            params.name.c_str(), out.ay, out.roll / kDegree / out.ay * kStandardGravity,
            expected.angle / kDegree / out.ay * kStandardGravity, front, expected.difference.front, rear,
            expected.difference.rear);
        EXPECT_GT(out.ay, 0.5);
        EXPECT_NEAR(out.roll, expected.angle, kSecondOrder * expected.angle);
        EXPECT_NEAR(front, expected.difference.front, kSecondOrder * std::abs(expected.difference.front));
        EXPECT_NEAR(rear, expected.difference.rear, kSecondOrder * std::abs(expected.difference.rear));
    }
}

// ---- The linear single-track model ----

// Both wheels of an axle together, per unit of slip angle, of camber (top outwards in the turn), and of load that goes
// from right to left: static toe, camber and ply-steer of the two wheels cancel only while their loads are equal.
struct AxleModel {
    double stiffness;      // N/rad
    double trail;          // m, of the force behind the axle
    double camber_force;   // N/rad, outwards
    double camber_moment;  // N m/rad, turning outwards
    double load_force;     // -, to the left, over left less right load
    double load_moment;    // m, turning to the left
};

AxleModel axleModel(const VehicleParams& car, std::size_t axle) {
    const AxleParams& a = axle == 0 ? car.front : car.rear;
    const double share =
        (axle == 0 ? car.wheelbase - car.front_axle_distance : car.front_axle_distance) / car.wheelbase;
    const double load = 0.5 * share * car.mass * kStandardGravity;
    constexpr double kSmall = 1e-4;  // rad
    AxleModel model{};
    double moment = 0;
    for (const bool left : {true, false}) {
        const TyreParams tyre = left ? a.tyre : mirrored(a.tyre);
        const WheelAngles rest = angles(a.suspension, 0, left);
        // Slip of a wheel that goes straight on while it points by its toe to the left: Vsy (to the right) of the
        // ground point along the wheel's own axis is V sin(toe).
        const auto at = [&](double slip, double camber, double extra = 0) {
            const double angle = rest.toe + slip;
            return steadyState(tyre, {.Fz = load + extra,
                                      .gamma = rest.camber + camber,
                                      .Vx = 20 * std::cos(angle),
                                      .Vsx = 0,
                                      .Vsy = 20 * std::sin(angle)});
        };
        const TyreSteadyState more = at(kSmall, 0), less = at(-kSmall, 0);
        model.stiffness += -(more.Fy - less.Fy) / (2 * kSmall);  // to the left, positive
        moment += -(more.Mz - less.Mz) / (2 * kSmall);           // about the vertical up, positive to the left
        const TyreSteadyState leant = at(0, kSmall), upright = at(0, -kSmall);
        model.camber_force += (leant.Fy - upright.Fy) / (2 * kSmall);  // to the right: outwards in a left turn
        model.camber_moment += (leant.Mz - upright.Mz) / (2 * kSmall);
        const TyreSteadyState heavy = at(0, 0, 1), light = at(0, 0, -1);
        model.load_force += (left ? 0.5 : -0.5) * -(heavy.Fy - light.Fy) / 2;
        model.load_moment += (left ? 0.5 : -0.5) * -(heavy.Mz - light.Mz) / 2;
    }
    model.trail = -moment / model.stiffness;
    return model;
}

struct SingleTrack {
    double understeer;  // rad s2/m: steer angle beyond L / R over lateral acceleration
    AxleModel front, rear;
};

SingleTrack singleTrack(const VehicleParams& car) {
    const AxleModel f = axleModel(car, 0), r = axleModel(car, 1);
    const Roll roll = rollAt(car, 1);
    const double a = car.front_axle_distance, b = car.wheelbase - a;
    // Camber against the road: roll, and travel that leans (and steers) the wheels of both sides the same way.
    const auto attitude = [&](const AxleParams& axle, double difference) {
        const double travel =
            0.5 * (axle.track * roll.angle + difference / axle.tyre.parameters.pz1);  // of the outer wheel
        return std::pair{roll.angle + axle.suspension.camber_by_travel * travel,
                         axle.suspension.toe_by_travel * travel};
    };
    const auto [camber_f, toe_f] = attitude(car.front, roll.difference.front);
    const auto [camber_r, toe_r] = attitude(car.rear, roll.difference.rear);
    // Forces of the axles per m/s2: their sum is m, their moments about the centre of gravity cancel with those of the
    // trails, of camber and of the loads.
    const double moments = f.load_moment * roll.difference.front - f.camber_moment * camber_f +
                           r.load_moment * roll.difference.rear - r.camber_moment * camber_r;
    const auto slip = [](const AxleModel& axle, double force, double camber, double difference) {
        return (force + axle.camber_force * camber - axle.load_force * difference) / axle.stiffness;
    };
    // The trail moves only the force that comes from slip; what camber and load give has its moment above.
    const double constant_f = f.camber_force * camber_f - f.load_force * roll.difference.front;
    const double constant_r = r.camber_force * camber_r - r.load_force * roll.difference.rear;
    const double twist = moments - f.trail * constant_f - r.trail * constant_r;
    const double force_f = (car.mass * (b + r.trail) - twist) / (a - f.trail + b + r.trail);
    const double force_r = car.mass - force_f;
    const double slip_f = slip(f, force_f, camber_f, roll.difference.front);
    const double slip_r = slip(r, force_r, camber_r, roll.difference.rear);
    const double steer_f = toe_f + 0.5 * car.front.suspension.steer_by_lateral_force * force_f;
    const double steer_r = toe_r + 0.5 * car.rear.suspension.steer_by_lateral_force * force_r;
    return {slip_f - slip_r - steer_f + steer_r, f, r};
}

void compareUndersteer(VehicleParams params, double tolerance) {
    // Rolling resistance grows with the load and turns the car outwards, by 0.06 deg/g: the single track knows no
    // sides.
    params.front.tyre.lambda.My = params.rear.tyre.lambda.My = 0;
    const PlaneRoad road;
    const SingleTrack model = singleTrack(params);
    for (const double speed : {15.0, 30.0}) {
        const double target = 0.2;  // m/s2
        const double steer = target * (params.wheelbase / (speed * speed) + model.understeer);
        const reference::Car car = steadyTurn(params, road, speed, steer, 8);
        const ChassisOutput out = car.output().chassis;
        const double v = std::hypot(out.vx, out.vy);
        const double lateral = v * out.yaw_rate;
        const double understeer = (steer - params.wheelbase * out.yaw_rate / v) / lateral;
        const double gain = out.yaw_rate / steer, expected = v / (params.wheelbase + model.understeer * v * v);
        std::printf(
            "%s at %.0f m/s: understeer gradient %.3f deg/g, single track %.3f; yaw-rate gain %.4f 1/s, single track "
            "%.4f\n",
            params.name.c_str(), speed, understeer / kDegree * kStandardGravity,
            model.understeer / kDegree * kStandardGravity, gain, expected);
        EXPECT_NEAR(gain, expected, tolerance * expected);
        EXPECT_NEAR(understeer, model.understeer, 4 * tolerance * std::abs(model.understeer));
    }
}

TEST(Cornering, SimplifiedCarTurnsAsTheSingleTrackModel) {
    // Load transfer at 0.04 g changes the cornering stiffness by about 1e-3; driving forces are as small.
    for (const VehicleParams& shipped : cars()) compareUndersteer(reference::simplified(shipped), 0.005);
}

TEST(Cornering, ShippedCarTurnsAsTheSingleTrackModelWithRollSteerCamberAndCompliance) {
    for (const VehicleParams& shipped : cars()) compareUndersteer(withoutAir(shipped), 0.015);
}

TEST(Cornering, EachSteerEffectShiftsTheUndersteerGradientAsCalculated) {
    struct Effect {
        const char* name;
        void (*set)(VehicleParams&);
    };
    for (const Effect& effect :
         {Effect{"front roll steer", [](VehicleParams& p) { p.front.suspension.toe_by_travel = -5 * kDegree; }},
          Effect{"rear roll steer", [](VehicleParams& p) { p.rear.suspension.toe_by_travel = 5 * kDegree; }},
          Effect{"front compliance steer", [](VehicleParams& p) { p.front.suspension.steer_by_lateral_force = -5e-6; }},
          Effect{"rear compliance steer",
                 [](VehicleParams& p) { p.rear.suspension.steer_by_lateral_force = -1e-6; }}}) {
        const VehicleParams plain = reference::simplified(reference::compact());
        VehicleParams changed = plain;
        effect.set(changed);
        std::printf("%s: shifts the single track's gradient by %+.3f deg/g\n", effect.name,
                    (singleTrack(changed).understeer - singleTrack(plain).understeer) / kDegree * kStandardGravity);
        compareUndersteer(changed, 0.005);
    }
}

// ---- Newton's balance at the limit ----

TEST(Cornering, SteadyCircleIsBalanced) {
    const PlaneRoad road;
    for (const VehicleParams& shipped : cars()) {
        const VehicleParams params = withoutAir(shipped);
        for (const double direction : {1.0, -1.0}) {
            const reference::Car car = steadyTurn(params, road, 20, direction * 0.065, 12);
            const ChassisOutput out = car.output().chassis;
            Vector3 force = Vector3::Zero(), moment = Vector3::Zero();
            for (std::size_t i = 0; i < kWheels; ++i) {
                const reference::RoadForce f = reference::roadForce(car, i);
                force += f.force_W;
                moment += (f.point_W - car.motion.position_W).cross(f.force_W);
                moment.z() += car.state.wheels[i].mz;
            }
            const double v = std::hypot(out.vx, out.vy);
            const Vector3 along = car.motion.velocity_W.normalized();
            const Vector3 inwards = Vector3::UnitZ().cross(along);
            std::printf(
                "%s, steady circle: m v r = %.1f N, tyres %.1f N (%.2f m/s2); yaw moment %.2f N m; load %.1f N\n",
                params.name.c_str(), params.mass * v * out.yaw_rate, force.dot(inwards), v * out.yaw_rate, moment.z(),
                force.z());
            EXPECT_GT(direction * v * out.yaw_rate, 5);
            EXPECT_NEAR(force.dot(inwards), params.mass * v * out.yaw_rate, 1);
            EXPECT_NEAR(moment.z(), 0, 2) << "of about 6 kN m that each axle contributes";
        }
    }
}

}  // namespace
}  // namespace tread
