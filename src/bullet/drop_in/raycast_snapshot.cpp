// Snapshot of a RaycastVehicle with its chassis, and back.
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>

#include "bullet/convert.h"
#include "bullet/drop_in/raycast_parts.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

namespace {

std::array<double, 6> toArray(const Vector3& a, const Vector3& b) {
    return {a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
}
Vector3 vectorAt(const auto& numbers, std::size_t first) {
    return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

std::array<double, 12> toArray(const btTransform& pose) {
    std::array<double, 12> numbers{};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            numbers[static_cast<std::size_t>(3 * row + column)] = pose.getBasis()[row][column];
        numbers[static_cast<std::size_t>(9 + row)] = pose.getOrigin()[row];
    }
    return numbers;
}
btTransform poseOf(const std::array<double, 12>& n) {
    const auto at = [&](std::size_t i) { return static_cast<btScalar>(n[i]); };
    return btTransform(btMatrix3x3(at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7), at(8)),
                       btVector3(at(9), at(10), at(11)));
}

}  // namespace

RaycastSnapshot::RaycastSnapshot() : state_(new State) {}
RaycastSnapshot::RaycastSnapshot(const RaycastSnapshot& other) : state_(new State(*other.state_)) {}
RaycastSnapshot& RaycastSnapshot::operator=(const RaycastSnapshot& other) {
    *state_ = *other.state_;
    return *this;
}
RaycastSnapshot::~RaycastSnapshot() {
    delete state_;
}
bool RaycastSnapshot::operator==(const RaycastSnapshot& other) const {
    return *state_ == *other.state_;
}

RaycastSnapshot RaycastVehicle::snapshot() const {
    RaycastSnapshot made;
    snapshot(made);
    return made;
}

void RaycastVehicle::snapshot(RaycastSnapshot& into) const {
    const Implementation& s = *self_;
    RaycastSnapshot::State& state = *into.state_;
    state.car = s.state;
    state.demands = s.demands;
    state.velocity = toArray(s.motion.velocity_W, s.motion.angular_velocity_W);
    state.expected = toArray(s.link.velocity, s.link.angular_velocity);
    state.planned = s.planned;
    state.pose = toArray(s.chassis.getWorldTransform());
    state.body_velocity =
        toArray(fromBullet(s.chassis.getLinearVelocity()), fromBullet(s.chassis.getAngularVelocity()));
    state.deactivation_time = s.chassis.getDeactivationTime();
    state.activation_state = s.chassis.getActivationState();
    state.wheel_count = static_cast<int>(s.wheels_before);
    state.asleep = s.asleep;
}

void RaycastVehicle::restore(const RaycastSnapshot& snapshot) {
    Implementation& s = *self_;
    const RaycastSnapshot::State& state = *snapshot.state_;
    s.met = true;
    switchOffGyroscopicForces(s.chassis);
    s.state = state.car;
    s.demands = state.demands;
    s.motion.velocity_W = vectorAt(state.velocity, 0);
    s.motion.angular_velocity_W = vectorAt(state.velocity, 3);
    s.link = {vectorAt(state.expected, 0), vectorAt(state.expected, 3)};
    s.planned = state.planned;
    s.wheels_before = std::min(static_cast<std::size_t>(std::max(state.wheel_count, 0)), s.wheelCount());
    s.asleep = state.asleep;

    s.chassis.setCenterOfMassTransform(poseOf(state.pose));
    s.chassis.setLinearVelocity(toBullet(vectorAt(state.body_velocity, 0)));
    s.chassis.setAngularVelocity(toBullet(vectorAt(state.body_velocity, 3)));
    s.chassis.setInterpolationLinearVelocity(s.chassis.getLinearVelocity());
    s.chassis.setInterpolationAngularVelocity(s.chassis.getAngularVelocity());
    s.chassis.forceActivationState(state.activation_state);
    s.chassis.setDeactivationTime(static_cast<btScalar>(state.deactivation_time));

    // As the last step before the snapshot left it, so that nothing looks like a teleport or a reset.
    s.motion.position_W = fromBullet(s.chassis.getCenterOfMassPosition());
    s.motion.orientation = fromBullet(s.chassis.getOrientation());
    s.makeCar();
    s.show(0);
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
