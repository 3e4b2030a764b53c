// What a RaycastVehicle shows: the stock vehicle's wheel infos and speed, and what it has beyond them.
#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <LinearMath/btTransformUtil.h>

#include <algorithm>
#include <cmath>

#include "base/math/elementary.h"
#include "bullet/convert.h"
#include "bullet/drop_in/raycast_parts.h"
#include "vehicle/tyre_load.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

namespace {

// Below this speed slips are shown against it.
constexpr double kSlowest = 0.5;  // m/s

struct SlipShown {
    double ratio;
    double sideways;  // tangent of the slip angle; ISO 8855: positive when the wheel moves to the left

    double angle() const { return arctan(sideways); }
};
SlipShown slipOf(const BodyWheelState& wheel, const TyreParams& tyre) {
    const double speed = std::max(std::abs(wheel.motion.Vx), kSlowest);
    const double Vsx = wheel.motion.Vx - rollingRadius(tyre, wheel.motion.Fz) * wheel.spin;
    return {-Vsx / speed, -wheel.motion.Vsy / speed};
}

double length(double x, double y) {
    return std::sqrt(x * x + y * y);
}

// 1 while the tyre grips, falling towards 0 the farther its slip is beyond that of its greatest force.
double gripShown(const SlipShown& slip, double peak_ratio, double peak_angle) {
    // An angle is less than its tangent: most wheels need no more.
    if (length(slip.ratio / peak_ratio, slip.sideways / peak_angle) <= 1) return 1;
    const double beyond = length(slip.ratio / peak_ratio, slip.angle() / peak_angle);
    return beyond > 1 ? 1 / beyond : 1;
}

btVector3 turned(const btVector3& v, const btVector3& axis, const SineCosine<double>& turn) {
    const auto sine = static_cast<btScalar>(turn.sine), cosine = static_cast<btScalar>(turn.cosine);
    return v * cosine + axis.cross(v) * sine + axis * (axis.dot(v) * (1 - cosine));
}

// The wheel's axes as Bullet's updateWheelTransform turns them: about the axle, then about the strut.
btMatrix3x3 wheelAxes(const btRaycastVehicle& vehicle, const btVector3& up, const btVector3& right,
                      const ShownWheel& pose) {
    const auto roll = sineCosine(-pose.rotation), steer = sineCosine(pose.steer);
    std::array<btVector3, 3> columns;
    columns[static_cast<std::size_t>(vehicle.getRightAxis())] = -right;
    columns[static_cast<std::size_t>(vehicle.getUpAxis())] = turned(up, right, roll);
    columns[static_cast<std::size_t>(vehicle.getForwardAxis())] = turned(up.cross(right).normalized(), right, roll);
    if (pose.steer != 0) {
        for (btVector3& column : columns) column = turned(column, up, steer);
    }
    btMatrix3x3 axes;
    for (int row = 0; row < 3; ++row) axes[row].setValue(columns[0][row], columns[1][row], columns[2][row]);
    return axes;
}

}  // namespace

void RaycastVehicle::Implementation::show(double dt) {
    drawn_step = dt;
    const btTransform& pose = chassis.getCenterOfMassTransform();
    for (std::size_t i = 0; i < car->wheel_count; ++i) {
        const BodyWheel& wheel = car->wheels[i];
        const BodyWheelState& now = state.wheels[i];
        const WheelGround& ground = grounds[i];
        btWheelInfo& shown = info(i);
        const btVector3 down = pose.getBasis() * toBullet(wheel.down_B);

        const ShownWheel draw{now.steer, wheel.strut.length - now.compression, now.rotation};
        drawn_before[i] = i < wheels_drawn ? drawn[i] : draw;
        drawn[i] = draw;

        btWheelInfo::RaycastInfo& ray = shown.m_raycastInfo;
        ray.m_suspensionLength = static_cast<btScalar>(wheel.strut.length - now.compression);
        shown_length[i] = ray.m_suspensionLength;
        ray.m_hardPointWS = pose(shown.m_chassisConnectionPointCS);
        ray.m_wheelDirectionWS = pose.getBasis() * shown.m_wheelDirectionCS;
        ray.m_wheelAxleWS = pose.getBasis() * shown.m_wheelAxleCS;
        const double steer = std::clamp(static_cast<double>(shown.m_steering), -kMostSteer, kMostSteer);
        shown.m_worldTransform.setBasis(
            wheelAxes(face, -ray.m_wheelDirectionWS, ray.m_wheelAxleWS, {steer, 0, now.rotation}));
        shown.m_worldTransform.setOrigin(ray.m_hardPointWS + ray.m_wheelDirectionWS * ray.m_suspensionLength);
        ray.m_isInContact = now.touches;
        ray.m_groundObject = now.touches ? ground.handle : nullptr;
        const auto& [x, y, z] = now.contact_B;
        ray.m_contactPointWS =
            now.touches ? pose(toBullet(Vector3(x, y, z))) : ray.m_hardPointWS + down * ray.m_suspensionLength;
        ray.m_contactNormalWS = now.touches ? toBullet(ground.plane.normal_W) : -down;

        const auto rotation = static_cast<btScalar>(now.rotation);
        shown.m_rotation = rotation;
        shown.m_deltaRotation = static_cast<btScalar>(now.spin * dt);
        shown.m_skidInfo =
            now.touches
                ? static_cast<btScalar>(gripShown(slipOf(now, wheel.tyre), car->peak_ratio[i], car->peak_angle[i]))
                : btScalar(1);
        shown.m_wheelsSuspensionForce = static_cast<btScalar>(std::max(now.strut_force, 0.0));
        shown.m_suspensionRelativeVelocity = static_cast<btScalar>(-now.strut_rate);
        const btScalar lean = -ray.m_contactNormalWS.dot(down);
        shown.m_clippedInvContactDotSuspension = lean > btScalar(0.1) ? 1 / lean : btScalar(10);
    }
    wheels_drawn = car->wheel_count;
}

// Instant of the chassis' motion state, as a share of the last step: Bullet keeps its clock to itself, but has moved
// the chassis by its velocity. At rest every instant shows the same.
double RaycastVehicle::Implementation::instantDrawn() const {
    constexpr double kStands = 1e-6;
    if (!chassis.getMotionState() || !(drawn_step > 0)) return 1;
    btTransform seen;
    chassis.getMotionState()->getWorldTransform(seen);
    const btTransform& last = chassis.getInterpolationWorldTransform();
    btVector3 axis;
    btScalar angle = 0;
    btTransformUtil::calculateDiffAxisAngle(last, seen, axis, angle);
    const Vector3 moved = fromBullet(seen.getOrigin() - last.getOrigin()), turned = fromBullet(axis * angle);
    const Vector3 velocity = fromBullet(chassis.getInterpolationLinearVelocity());
    const Vector3 spin = fromBullet(chassis.getInterpolationAngularVelocity());
    const double square = velocity.squaredNorm() + spin.squaredNorm();
    if (!(square > kStands)) return 1;
    return std::clamp(1 + (moved.dot(velocity) + turned.dot(spin)) / square / drawn_step, 0.0, 2.0);
}

btTransform RaycastVehicle::drawnWheel(int index) const {
    const auto i = static_cast<std::size_t>(index);
    if (index < 0 || index >= getNumWheels()) return getChassisWorldTransform();
    if (i >= self_->wheels_drawn) return m_wheelInfo[index].m_worldTransform;
    btTransform chassis = getChassisWorldTransform();
    if (const btMotionState* seen = self_->chassis.getMotionState()) seen->getWorldTransform(chassis);
    const double at = self_->instantDrawn();
    const auto mix = [at](double from, double to) { return from + at * (to - from); };
    const ShownWheel &before = self_->drawn_before[i], &after = self_->drawn[i];

    const btWheelInfo& wheel = m_wheelInfo[index];
    const btMatrix3x3 axes = wheelAxes(*this, -wheel.m_wheelDirectionCS, wheel.m_wheelAxleCS,
                                       {mix(before.steer, after.steer), 0, mix(before.rotation, after.rotation)});
    const btVector3 centre = wheel.m_chassisConnectionPointCS +
                             wheel.m_wheelDirectionCS * static_cast<btScalar>(mix(before.length, after.length));
    return chassis * btTransform(axes, centre);
}

// The speed is a private member of the base that only its own step sets: let it step without wheels.
void RaycastVehicle::Implementation::showSpeed(double dt) {
    auto& wheels = face.m_wheelInfo;
    const int count = wheels.size();
    wheels.resizeNoInitialize(0);
    showing_speed = true;
    face.::btRaycastVehicle::updateVehicle(static_cast<btScalar>(dt));
    showing_speed = false;
    wheels.resizeNoInitialize(count);
}

WheelTelemetry RaycastVehicle::telemetry(int index) const {
    const auto i = static_cast<std::size_t>(index);
    WheelTelemetry shown;
    if (index < 0 || i >= self_->car->wheel_count) return shown;
    const BodyWheelState& now = self_->state.wheels[i];
    const SlipShown slip = slipOf(now, self_->car->wheels[i].tyre);
    const btVector3& contact = m_wheelInfo[index].m_raycastInfo.m_contactPointWS;
    shown.load = now.load;
    shown.fx = now.fx;
    shown.fy = now.fy;
    shown.slip_ratio = now.touches ? slip.ratio : 0;
    shown.slip_angle = now.touches ? slip.angle() : 0;
    shown.slip_power = now.slip_power;
    shown.spin = now.spin;
    shown.compression = now.compression;
    shown.deflection = now.deflection;
    shown.steer_torque = now.steer_torque;
    shown.grip = now.grip;
    shown.contact_x = contact.x();
    shown.contact_y = contact.y();
    shown.contact_z = contact.z();
    return shown;
}

const char* RaycastVehicle::surfaceName(int index) const {
    const auto i = static_cast<std::size_t>(index);
    if (index < 0 || i >= self_->car->wheel_count || !self_->grounds[i].surface.name) return "";
    return self_->grounds[i].surface.name;
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
