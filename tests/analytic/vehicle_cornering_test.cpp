// Cornering: the car against the linear single-track model, statics of roll and load transfer, and Newton's balance.

#include <gtest/gtest.h>

#include <cstdio>

#include "shared/single_track.h"

namespace tread::vehicle_cornering_test {
namespace {

using reference::kDegree;
using reference::Roll;
using reference::rollAt;
using reference::singleTrack;
using reference::SingleTrack;
using reference::steadyTurn;

std::vector<VehicleParams> cars() {
    return {reference::compact(), reference::rearDriveSedan()};
}

VehicleParams withoutAir(VehicleParams car) {
    car.aero = {};
    return car;
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
}  // namespace tread::vehicle_cornering_test
