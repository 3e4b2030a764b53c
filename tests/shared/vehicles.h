// The shipped cars, cars made simple on purpose, and a car on a road to drive in a test.
#pragma once

#include <string>

#include "places/places.h"
#include "road/plane.h"
#include "tread/equilibrium.h"
#include "tread/load.h"
#include "tread/vehicle.h"
#include "vehicle/fields.h"

namespace reference {

inline tread::VehicleParams compact() {
    return tread::loadVehicle(tread::sourceFile("vehicles/compact.yaml"));
}
inline tread::VehicleParams rearDriveSedan() {
    return tread::loadVehicle(tread::sourceFile("vehicles/rear_drive_sedan.yaml"));
}

// Tyre without what has no closed form or tells left from right: ply-steer, conicity, camber thrust, belt gyroscopics.
inline void simplify(tread::TyreParams& tyre) {
    tread::TyreCoefficients& p = tyre.parameters;
    for (double* odd : {&p.pEy3, &p.pHy1, &p.pHy2, &p.pVy1, &p.pVy2, &p.rBy3, &p.rHx1, &p.rVy1, &p.rVy2, &p.qBz4,
                        &p.qDz3, &p.qDz6, &p.qDz7, &p.qEz4, &p.qHz1, &p.qHz2, &p.ssz1})
        *odd = 0;
    for (double* shift : {&p.pHx1, &p.pHx2, &p.pVx1, &p.pVx2, &p.pEx4, &p.rHy1}) *shift = 0;
    for (double* by_camber : {&p.pDy3, &p.pEy4, &p.pKy3, &p.pHy3, &p.pVy3, &p.pVy4, &p.rVy3, &p.qBz5, &p.qDz4, &p.qDz8,
                              &p.qDz9, &p.qEz5, &p.qHz3, &p.qHz4, &p.ssz3, &p.ssz4, &p.pTy8, &p.pTy9})
        *by_camber = 0;
    for (double* belt : {&p.czgyr, &p.cygyr, &p.cpsigyr}) *belt = 0;
}

// A car whose suspension neither steers, leans nor carries tyre forces past the springs, without aerodynamics.
inline tread::VehicleParams simplified(tread::VehicleParams car) {
    for (tread::AxleParams* axle : {&car.front, &car.rear}) {
        simplify(axle->tyre);
        tread::SuspensionParams& s = axle->suspension;
        const tread::StopParams no_stop;
        s.bump_stop = s.rebound_stop = no_stop;
        for (double* number :
             {&s.roll_centre_height, &s.side_view_slope_braking, &s.side_view_slope_driving, &s.camber,
              &s.camber_by_travel, &s.toe, &s.toe_by_travel, &s.steer_by_lateral_force, &s.damper.friction})
            *number = 0;
    }
    car.steering.ackermann = 0;
    car.inertia.roll_yaw = 0;
    car.aero = {};
    return car;
}

// A road that is not there.
class NoRoad final : public tread::Road {
public:
    tread::RoadContact contact(const tread::Vector3&, std::size_t) const override { return {.exists = false}; }
};

// A car on a road, advanced by hand.
struct Car {
    tread::Vehicle vehicle;
    const tread::Road& road;
    tread::ChassisMotion motion = {};
    tread::VehicleState state = {};
    tread::VehicleInput input = {};
    tread::Vector3 gravity_W{0, 0, -tread::kStandardGravity};
    tread::Vector3 wind_W{0, 0, 0};

    void step(const tread::VehicleInput& next, double dt) {
        tread::advance(motion, state, vehicle, input, next, {road, gravity_W, wind_W}, dt);
        input = next;
    }
    void step(double dt) { step(input, dt); }
    tread::VehicleOutput output() const { return tread::observe(motion, state, vehicle, gravity_W); }
};

// In equilibrium at the start.
inline Car settled(const tread::VehicleParams& params, const tread::Road& road, const tread::Start& start) {
    Car car{.vehicle = tread::prepare(params), .road = road};
    const tread::Equilibrium rest = tread::equilibrium(car.vehicle, {road, car.gravity_W}, start);
    car.motion = rest.motion;
    car.state = rest.state;
    car.input = rest.input;
    return car;
}

inline tread::Vector3 toVector(const std::array<double, 3>& a) {
    return {a[0], a[1], a[2]};
}

// Force of the road on one wheel and the point where it acts, in the world.
struct RoadForce {
    tread::Vector3 force_W;
    tread::Vector3 point_W;
};

// From the logged forces alone: wheel axes are the wheel's heading projected onto the road.
inline RoadForce roadForce(const Car& car, std::size_t wheel) {
    const tread::WheelState& w = car.state.wheels[wheel];
    const Eigen::Matrix3d body = car.motion.orientation.toRotationMatrix();
    const tread::Vector3 hub_W =
        car.motion.position_W + body * (car.vehicle.corners[wheel].hub_B + tread::Vector3(0, 0, w.travel));
    const tread::Vector3 n = car.road.contact(hub_W, wheel).normal_W;
    const tread::WheelAngles lean = tread::angles(
        wheel < 2 ? car.vehicle.params.front.suspension : car.vehicle.params.rear.suspension, w.travel, wheel % 2 == 0);
    const tread::Vector3 axis =
        body * (Eigen::AngleAxisd(w.steer, tread::Vector3::UnitZ()) *
                Eigen::AngleAxisd(lean.camber, tread::Vector3::UnitX()) * tread::Vector3::UnitY());
    const tread::Vector3 forward = axis.cross(n).normalized();
    const tread::Vector3 left = n.cross(forward);
    return {w.fx * forward + w.fy * left + w.load * n, hub_W - w.radius * forward.cross(axis)};
}

}  // namespace reference
