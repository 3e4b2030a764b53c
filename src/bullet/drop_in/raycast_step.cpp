// One step of a RaycastVehicle: take what Bullet and the game did, advance the car on a motion of its own, give the
// chassis the velocities of that motion.
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bullet/convert.h"
#include "bullet/drop_in/raycast_parts.h"
#include "vehicle/tyre_load.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

namespace {

constexpr double kLongestStep = 1.0;  // s: of a longer one, the first second counts
// A pose this far from where the chassis should be is a teleport, not a collision.
constexpr double kTeleport = 0.25;      // m
constexpr double kTeleportTurn = 0.25;  // rad
// Below this velocity from elsewhere the chassis counts as moved by gravity and its wheels alone.
constexpr double kPushed = 0.01;  // m/s
// A wheel looks at the ground again when it has gone this share of its radius.
constexpr double kLookAgain = 0.5;
// The tyre's contact rounds the edges of the ground as far as this share of its radius.
constexpr double kRounded = 0.33;

// Room for what a step hands to each of its substeps: one for the cars of a thread, since it is never cleared.
struct SubstepRoom {
    std::array<WheelDemand, kMostWheels> next, begin, end;
    std::array<RoadContact, kMostWheels> planes;
};

// A wheel is steered along the way from one step to the next; forces come at once.
WheelDemand between(const WheelDemand& a, const WheelDemand& b, double at) {
    WheelDemand demand = b;
    demand.steer = a.steer + at * (b.steer - a.steer);
    return demand;
}

}  // namespace

void RaycastVehicle::Implementation::step(const btCollisionWorld* in, double dt) {
    static thread_local Trail trail;
    const Footprint next = trail.after(footprint(), place_in_trail);
    if (next.car != addressOf(this)) {
        fetchInputs(next);
        fetchState(next);
    }
    if (!begin(in, dt)) return;
    drive(in, dt);
    finish();
}

bool RaycastVehicle::Implementation::begin(const btCollisionWorld* in, double dt) {
    simulated = 0;
    if (!(dt > 0) || !std::isfinite(dt)) return false;
    if (!met) meetChassis(dt);
    if (!chassis.isActive() && staysAsleep(in)) return false;
    takeUp(dt);
    return true;
}

// What a game's raycaster or surface throws leaves the car as it was: it falls freely over this step.
void RaycastVehicle::Implementation::drive(const btCollisionWorld* in, double dt) {
    makeCar();
    if (!mayThrow(in)) return driveUnguarded(in, dt);
    const ChassisMotion motion_before = motion;
    const WheeledBodyState state_before = state;
    const auto demands_before = demands;
    const auto grounds_before = grounds;
    const std::size_t count_before = wheels_before;
    try {
        driveUnguarded(in, dt);
    } catch (...) {
        motion = motion_before;
        state = state_before;
        demands = demands_before;
        grounds = grounds_before;
        wheels_before = count_before;
        throw;
    }
}

bool RaycastVehicle::Implementation::mayThrow(const btCollisionWorld* in) const {
    return surface || !own_rays || !in;
}

void RaycastVehicle::Implementation::driveUnguarded(const btCollisionWorld* in, double dt) {
    lookDown(in, dt);
    showSpeed(dt);
    const bool moves = car->mass > 0 && motion.position_W.allFinite() && motion.orientation.coeffs().allFinite();
    start = motion;
    if (moves) {
        move(in, std::min(dt, kLongestStep));
        simulated = std::min(dt, kLongestStep);
    }
    reached = motion;
    // The pose is Bullet's to change.
    motion.position_W = start.position_W;
    motion.orientation = start.orientation;
    show(dt);
}

void RaycastVehicle::Implementation::finish() {
    if (simulated > 0) {
        giveMotion(chassis, link, start, reached, simulated);
        planned = simulated;
        pushGround();
        expectWhatBodyHas(given, chassis);
        given_pose = chassis.getCenterOfMassTransform();
    }
    fallAsleepOrNot();
}

// At the first step: until then the chassis may not have been built.
void RaycastVehicle::Implementation::meetChassis(double dt) {
    met = true;
    switchOffGyroscopicForces(chassis);
    expectWhatBodyHas(link, chassis);
    motion.velocity_W = link.velocity;
    motion.angular_velocity_W = link.angular_velocity;
    takeMotion(motion, link, chassis, Quaternion::Identity());
    planned = dt;
}

// Whether the world has not moved the chassis since the last step, as where a game calls updateVehicle besides it. (At
// rest without gravity it makes no difference.)
bool RaycastVehicle::Implementation::isSecondStep() const {
    BodyLink now;
    expectWhatBodyHas(now, chassis);
    return now.velocity == given.velocity && now.angular_velocity == given.angular_velocity &&
           chassis.getCenterOfMassTransform() == given_pose;
}

// Bullet has moved the chassis on with the velocity that was planned for a step of the length before, and with gravity
// for the length that the step had. In the difference, as after waking, nothing held the car: that is taken back.
void RaycastVehicle::Implementation::takeBackGravity(double dt) {
    const bool pulled = !asleep || chassis.getTotalForce().dot(chassis.getGravity()) > 0;
    if (!pulled) chassis.applyGravity();  // woken within a call of stepSimulation: for what is left of it
    asleep = false;
    if (!pulled || dt == planned) return;
    const Vector3 factor = fromBullet(chassis.getLinearFactor());
    const Vector3 extra = (dt - planned) * gravity().cwiseProduct(factor);
    link.velocity += extra;
    if ((fromBullet(chassis.getLinearVelocity()) - link.velocity).norm() > kPushed) return;
    btTransform pose = chassis.getCenterOfMassTransform();
    pose.setOrigin(pose.getOrigin() - toBullet(Vector3(dt * extra)));
    chassis.setCenterOfMassTransform(pose);
}

// Whether the chassis is elsewhere than its velocity has taken it. Of a turn counts the chord, 2 sin(angle/2): what two
// attitudes differ by.
bool RaycastVehicle::Implementation::isTeleported(double dt) const {
    const Vector3 velocity = fromBullet(chassis.getLinearVelocity());
    const Vector3 moved = fromBullet(chassis.getCenterOfMassPosition()) - motion.position_W;
    const Eigen::Matrix3d axes = fromBullet(chassis.getCenterOfMassTransform().getBasis());
    const double turned = (axes - motion.orientation.toRotationMatrix()).norm() / std::numbers::sqrt2;
    return (moved - dt * velocity).norm() > kTeleport ||
           turned > kTeleportTurn + 1.2 * dt * static_cast<double>(chassis.getAngularVelocity().length());
}

// Takes the chassis' motion.
void RaycastVehicle::Implementation::takeUp(double dt) {
    second = isSecondStep();
    teleported = !second && isTeleported(dt);
    if (teleported) asleep = false;
    else if (second) link = given;
    else takeBackGravity(dt);
    takeMotion(motion, link, chassis, Quaternion::Identity());
    if (teleported || !motion.velocity_W.allFinite() || !motion.angular_velocity_W.allFinite()) {
        motion.velocity_W = link.velocity;
        motion.angular_velocity_W = link.angular_velocity;
        state.acceleration_W = state.angular_acceleration_W = {};
    }
    seen_velocity = motion.velocity_W;
    seen_angular_velocity = motion.angular_velocity_W;
}

// The ground under each wheel; one that was put somewhere else starts anew there.
void RaycastVehicle::Implementation::lookDown(const btCollisionWorld* in, double dt) {
    std::array<WheelRay, kMostWheels> rays_down;
    for (std::size_t i = 0; i < car->wheel_count; ++i) rays_down[i] = rayOf(i, dt);
    around.known = false;
    if (own_rays && in) {
        lookAround(around, *in, {rays_down.data(), car->wheel_count});
    }
    for (std::size_t i = 0; i < car->wheel_count; ++i) {
        const bool added = i >= wheels_before;
        const bool reset = !added && info(i).m_raycastInfo.m_suspensionLength != shown_length[i];
        if (added) state.wheels[i] = {};
        if (reset) state.wheels[i].compression = 0;
        near[i].age += dt;
        findGround(i, rays_down[i], in);
        if (teleported || reset || added) {
            setDown(state, motion, *car, i, grounds[i].plane);
            demands[i] = demand(i);
        }
    }
    wheels_before = car->wheel_count;
}

WheelRay RaycastVehicle::Implementation::rayOf(std::size_t wheel, double dt) const {
    const BodyWheel& w = car->wheels[wheel];
    const double radius = w.tyre.parameters.Ro;
    return {.top_W = strutTop(motion, w),
            .down_W = motion.orientation * w.down_B,
            .raised = radius,
            .length = w.strut.length + radius,
            .ahead = motion.velocity_W.norm() * dt + 0.5 * radius,
            .wheel = static_cast<int>(wheel)};
}

void RaycastVehicle::Implementation::findGround(std::size_t wheel, const WheelRay& ray, const btCollisionWorld* in) {
    const bool by_user = !own_rays || !in;
    const Rounding rounding{.angle = edge_angle, .reach = kRounded * car->wheels[wheel].tyre.parameters.Ro};
    const RaySource source{chassis, in,         by_user ? raycaster : nullptr, filter, surface.get(), rounding,
                           around,  near[wheel]};
    std::unique_lock<std::mutex> alone;
    if (one_at_a_time && (by_user || surface)) alone = std::unique_lock(*one_at_a_time);
    grounds[wheel] = castRay(ray, source);
}

bool RaycastVehicle::Implementation::isFarFromRay(std::size_t wheel) const {
    const Vector3 gone = strutTop(motion, car->wheels[wheel]) - grounds[wheel].cast_at;
    return gone.norm() > kLookAgain * car->wheels[wheel].tyre.parameters.Ro;
}

// Moves `motion` to the end of the step.
void RaycastVehicle::Implementation::move(const btCollisionWorld* in, double dt) {
    const int substeps = substep.within(dt, longestStep(*car, state));
    const double h = dt / substeps;
    const Vector3 pull = second ? Vector3(Vector3::Zero()) : gravity();  // the world's acts once
    static thread_local SubstepRoom room;
    auto& [next, begin, end, planes] = room;
    for (std::size_t i = 0; i < car->wheel_count; ++i) {
        next[i] = demand(i);
        impulses[i].setZero();
    }
    for (int k = 0; k < substeps; ++k) {
        for (std::size_t i = 0; i < car->wheel_count; ++i) {
            begin[i] = between(demands[i], next[i], static_cast<double>(k) / substeps);
            end[i] = between(demands[i], next[i], (k + 1.0) / substeps);
            if (k > 0 && isFarFromRay(i)) findGround(i, rayOf(i, dt - k * h), in);
            planes[i] = grounds[i].plane;
            planes[i].point_W += (k + 1) * h * planes[i].velocity_W;
        }
        const std::size_t n = car->wheel_count;
        advance(motion, state, *car, {begin.data(), n}, {end.data(), n}, {planes.data(), n}, pull, h);
        for (std::size_t i = 0; i < n; ++i)
            impulses[i] +=
                h * Vector3(state.wheels[i].force_W[0], state.wheels[i].force_W[1], state.wheels[i].force_W[2]);
    }
    for (std::size_t i = 0; i < car->wheel_count; ++i) demands[i] = next[i];

    if (!motion.position_W.allFinite() || !motion.velocity_W.allFinite() || !motion.angular_velocity_W.allFinite()) {
        // No demand is known that leads here. Whatever does, the car goes on as it was, its wheels anew.
        motion = start;
        wheels_before = 0;
        state = {};
        for (Vector3& impulse : impulses) impulse.setZero();
    }
}

// What the wheels push, they push back. A body that is so light that the tyres' springs would throw it about within one
// step takes less than the whole.
void RaycastVehicle::Implementation::pushGround() {
    for (std::size_t i = 0; i < car->wheel_count; ++i) {
        btRigidBody* body = bodyUnder(grounds[i]);
        if (!body || body->getInvMass() <= 0 || impulses[i].isZero()) continue;
        const auto& [x, y, z] = state.wheels[i].contact_B;
        const Vector3 contact = reached.position_W + reached.orientation * Vector3(x, y, z);
        const btVector3 arm = toBullet(contact) - body->getCenterOfMassPosition();
        const btVector3 normal = toBullet(grounds[i].plane.normal_W);
        const btVector3 turn = (body->getInvInertiaTensorWorld() * arm.cross(normal)).cross(arm);
        const double inverse_mass = body->getInvMass() + static_cast<double>(normal.dot(turn));
        const TyreParams& tyre = car->wheels[i].tyre;
        const double taken = std::min(1.0, 1 / (simulated * simulated * radialStiffness(tyre) * inverse_mass));
        body->activate();
        body->applyImpulse(toBullet(Vector3(-taken * impulses[i])), arm);
    }
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
