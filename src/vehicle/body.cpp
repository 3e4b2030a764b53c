#include "vehicle/body.h"

namespace tread {
namespace {

Vector3 toVector(const std::array<double, 3>& a) {
    return {a[0], a[1], a[2]};
}

}  // namespace

ChassisMotion predicted(const ChassisMotion& from, const std::array<double, 3>& acceleration_W,
                        const std::array<double, 3>& angular_acceleration_W, double dt) {
    const Vector3 a = toVector(acceleration_W);
    const Vector3 alpha = toVector(angular_acceleration_W);
    ChassisMotion to;
    to.position_W = from.position_W + dt * (from.velocity_W + 0.5 * dt * a);
    const Vector3 turn = dt * (from.angular_velocity_W + 0.5 * dt * alpha);
    const double angle = turn.norm();
    to.orientation = from.orientation;
    if (angle > 0)
        to.orientation = (Quaternion(Eigen::AngleAxisd(angle, turn / angle)) * from.orientation).normalized();
    to.velocity_W = from.velocity_W + dt * a;
    to.angular_velocity_W = from.angular_velocity_W + dt * alpha;
    return to;
}

void correct(ChassisMotion& motion, std::array<double, 3>& acceleration_W,
             std::array<double, 3>& angular_acceleration_W, const Accelerations& end, double dt) {
    motion.velocity_W += 0.5 * dt * (end.linear_W - toVector(acceleration_W));
    motion.angular_velocity_W += 0.5 * dt * (end.angular_W - toVector(angular_acceleration_W));
    acceleration_W = toArray(end.linear_W);
    angular_acceleration_W = toArray(end.angular_W);
}

Wrench weight(const Vehicle& vehicle, const BodyFrame& body) {
    Wrench wrench;
    wrench.force_B = vehicle.params.mass * body.gravity_B;
    for (std::size_t i = 0; i < kWheels; ++i) {
        const Vehicle::Corner& corner = vehicle.corners[i];
        wrench.add({0, 0, -corner.unsprung_mass * body.gravity_B.z()}, corner.hub_B);
    }
    return wrench;
}

Wrench displacedWheels(const Vehicle& vehicle, const PerWheel<WheelState>& wheels, const BodyFrame& body) {
    const Vector3& w = body.motion.angular_velocity_B;
    const auto accelerationAt = [&](const Vector3& point) -> Vector3 {
        return body.acceleration_B + body.angular_acceleration_B.cross(point) + w.cross(w.cross(point));
    };
    Wrench wrench;
    for (std::size_t i = 0; i < kWheels; ++i) {
        const Vehicle::Corner& corner = vehicle.corners[i];
        const Vector3 there = corner.hub_B + Vector3(0, 0, wheels[i].travel);
        const Vector3 coriolis = 2 * w.cross(Vector3(0, 0, wheels[i].rate));
        Vector3 is = corner.unsprung_mass * (body.gravity_B - accelerationAt(there) - coriolis);
        Vector3 counted = corner.unsprung_mass * (body.gravity_B - accelerationAt(corner.hub_B));
        is.z() = counted.z() = 0;
        wrench.add(is, there);
        wrench.add(-counted, corner.hub_B);
    }
    return wrench;
}

Wrench aeroWrench(const Vehicle& vehicle, const BodyFrame& body, const Vector3& wind_W) {
    const VehicleParams& params = vehicle.params;
    const AeroForces air = forces(params.aero, body.motion.velocity_B - body.motion.to_world.transpose() * wind_W);
    Wrench wrench;
    const double centre = -params.lateral_offset;
    wrench.add(air.drag_B, {0, centre, params.aero.height - params.centre_of_gravity_height});
    wrench.add({0, 0, air.front_lift}, {params.front_axle_distance, centre, 0});
    wrench.add({0, 0, air.rear_lift}, {params.front_axle_distance - params.wheelbase, centre, 0});
    const double middle = params.front_axle_distance - 0.5 * params.wheelbase;
    wrench.add({0, air.side_force, 0}, {middle, 0, params.aero.height - params.centre_of_gravity_height});
    wrench.moment_B += Vector3(air.roll_moment, 0, air.yaw_moment);
    return wrench;
}

void addWheel(Wrench& wrench, const WheelAction& wheel, const BodyFrame& body) {
    const WheelContact& contact = wheel.contact;
    const Vector3 road_force =
        wheel.tyre.Fx * contact.forward_B + wheel.tyre.Fy * contact.left_B + wheel.load * contact.normal_B;

    // Along x and y the wheel moves with the body; along z only the suspension and the links push, at the hub. The
    // vertical force acts at the contact, beside the hub: the links carry that couple.
    wrench.add({road_force.x(), road_force.y(), 0}, contact.point_B);
    wrench.add({0, 0, wheel.suspension_force - wheel.link_force}, wheel.corner.hub_B);
    const Vector3 beside(contact.point_B.x() - contact.hub_B.x(), contact.point_B.y() - contact.hub_B.y(), 0);
    wrench.moment_B += beside.cross(Vector3(0, 0, road_force.z()));

    const BodyMotion& motion = body.motion;
    wrench.moment_B += wheelMoment(contact, wheel.tyre,
                                   {.inertia = wheel.corner.wheel_inertia,
                                    .spin = wheel.spin,
                                    .spin_rate = wheel.spin_rate,
                                    .carrier_B = motion.angular_velocity_B + Vector3(0, 0, wheel.steer_rate)});
}

void correct(ChassisMotion& motion, VehicleState& state, const Vehicle& vehicle, const BodyFrame& body,
             const Wrench& wrench, double dt) {
    const InertiaParams& inertia = vehicle.params.inertia;
    const Vector3& w = body.motion.angular_velocity_B;
    const Vector3 spin(inertia.roll * w.x() - inertia.roll_yaw * w.z(), inertia.pitch * w.y(),
                       inertia.yaw * w.z() - inertia.roll_yaw * w.x());
    Wrench total = wrench;
    total.moment_B -= w.cross(spin);
    // The centrifugal force of an unsprung mass along z pulls at its spring, not at the body.
    for (std::size_t i = 0; i < kWheels; ++i) {
        const Vehicle::Corner& corner = vehicle.corners[i];
        total.add({0, 0, corner.unsprung_mass * w.cross(w.cross(corner.hub_B)).z()}, corner.hub_B);
    }
    Eigen::Vector<double, 6> load;
    load << total.force_B, total.moment_B;
    const Eigen::Vector<double, 6> acceleration = vehicle.inverse_mass * load;

    const Eigen::Matrix3d& to_world = body.motion.to_world;
    correct(motion, state.acceleration_W, state.angular_acceleration_W,
            {to_world * acceleration.head<3>(), to_world * acceleration.tail<3>()}, dt);

    // The wheels keep their own velocity along z: their travel takes the opposite of the hub's correction.
    const Vector3 change = acceleration.head<3>() - body.acceleration_B;
    const Vector3 turn = acceleration.tail<3>() - body.angular_acceleration_B;
    for (std::size_t i = 0; i < kWheels; ++i)
        state.wheels[i].rate -= 0.5 * dt * (change + turn.cross(vehicle.corners[i].hub_B)).z();
}

}  // namespace tread
