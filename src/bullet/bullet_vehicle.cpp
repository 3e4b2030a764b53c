#include "tread/bullet_vehicle.h"

#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <LinearMath/btIDebugDraw.h>

#include "base/math/elementary.h"
#include "bullet/body_link.h"
#include "bullet/convert.h"
#include "bullet/planned_pose.h"
#include "host/step_inputs.h"
#include "host/substep.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

namespace {

Quaternion attitudeOf(const BodyAxes& axes) {
    Eigen::Matrix3d m;
    m.col(0) = fromBullet(axes.forward);
    m.col(1) = fromBullet(axes.left);
    m.col(2) = m.col(0).cross(m.col(1));
    return Quaternion(m).normalized();
}

}  // namespace

struct BulletVehicle::Implementation {
    btRigidBody& chassis;
    Road& road;
    Vehicle vehicle;
    Quaternion axes;  // ISO 8855 vehicle axes to the body's own

    ChassisMotion motion;  // at the time of the last step, velocities at that instant
    VehicleState state;
    VehicleInput input;  // at the time of the last step
    VehicleInput next;   // at the end of the next one
    Vector3 wind = Vector3::Zero();
    Substep substep{0.001, Substep::kLongest};  // s: 60 Hz and 1000 Hz then differ by rounding of the step alone
    BodyLink link;
    ChassisMotion shown;  // pose of the body when it was looked at last
    PlannedPose planned;

    void look() { shown = poseOf(chassis, axes); }
    void expectMotion() {
        expectWhatBodyHas(link, chassis);
        planned = PlannedPose(chassis, motion, motion, 0);
    }

    Vector3 gravity() const { return fromBullet(chassis.getGravity()); }

    void setMass() {
        const InertiaParams& inertia = vehicle.params.inertia;
        const Vector3 moments = (axes * Vector3(inertia.roll, inertia.pitch, inertia.yaw)).cwiseAbs();
        const btVector3 acceleration = chassis.getGravity();
        chassis.setMassProps(static_cast<btScalar>(vehicle.params.mass), toBullet(moments));
        chassis.setGravity(acceleration);
        chassis.updateInertiaTensor();
    }
};

BulletVehicle::BulletVehicle(const VehicleParams& params, btRigidBody& chassis, Road& road, const BodyAxes& axes)
    : self_(new Implementation{.chassis = chassis,
                               .road = road,
                               .vehicle = prepare(params),
                               .axes = attitudeOf(axes),
                               .motion = {},
                               .state = {},
                               .input = {},
                               .next = {},
                               .wind = Vector3::Zero(),
                               .link = {},
                               .shown = {},
                               .planned = {}}) {
    self_->setMass();
    switchOffGyroscopicForces(chassis);
    self_->look();
    self_->motion = self_->shown;
    self_->motion.velocity_W = fromBullet(chassis.getLinearVelocity());
    self_->motion.angular_velocity_W = fromBullet(chassis.getAngularVelocity());
    self_->expectMotion();
}

BulletVehicle::~BulletVehicle() = default;

void BulletVehicle::setInput(const VehicleInput& input) {
    self_->next = input;
}

void BulletVehicle::setWind(const Vector3& velocity_W) {
    self_->wind = velocity_W;
}

void BulletVehicle::setSubstep(double longest) {
    self_->substep.limit(longest);
}

void BulletVehicle::restore(const ChassisMotion& motion, const VehicleState& state, const VehicleInput& input) {
    self_->motion = motion;
    self_->state = state;
    self_->input = self_->next = input;
    const Quaternion attitude = motion.orientation * self_->axes.conjugate();
    const btTransform pose(toBullet(attitude), toBullet(motion.position_W));
    self_->chassis.setCenterOfMassTransform(pose);
    self_->chassis.setInterpolationWorldTransform(pose);
    self_->chassis.setLinearVelocity(toBullet(motion.velocity_W));
    self_->chassis.setAngularVelocity(toBullet(motion.angular_velocity_W));
    self_->look();
    self_->expectMotion();
}

const ChassisMotion& BulletVehicle::motion() const {
    return self_->motion;
}
const VehicleState& BulletVehicle::state() const {
    return self_->state;
}
const Vehicle& BulletVehicle::vehicle() const {
    return self_->vehicle;
}

VehicleOutput BulletVehicle::output() const {
    return tread::observe(self_->motion, self_->state, self_->vehicle, self_->gravity());
}

void BulletVehicle::observe() {
    Implementation& s = *self_;
    s.look();
    if (s.planned.isShownBy(s.chassis, s.shown, s.link)) {
        s.planned.giveTo(s.motion);
    } else {
        takeMotion(s.motion, s.link, s.chassis, s.axes);
    }
    s.expectMotion();
}

void BulletVehicle::plan(double dt) {
    Implementation& s = *self_;
    if (!s.chassis.isActive()) return;

    // Advance the car on a motion of its own.
    s.road.beginStep();
    ChassisMotion end = s.motion;
    const Surroundings surroundings{s.road, s.gravity(), s.wind};
    const StepInputs inputs(s.input, s.next, s.substep.within(dt));
    for (int k = 0; k < inputs.steps(); ++k) {
        advance(end, s.state, s.vehicle, inputs.after(k), inputs.after(k + 1), surroundings, dt / inputs.steps());
    }
    s.input = s.next;

    s.planned = PlannedPose(s.chassis, s.shown, end, dt);
    giveMotion(s.chassis, s.link, s.shown, end, dt);
    s.motion.velocity_W = end.velocity_W;
    s.motion.angular_velocity_W = end.angular_velocity_W;
}

void BulletVehicle::updateAction(btCollisionWorld*, btScalar dt) {
    observe();
    plan(dt);
}

void BulletVehicle::debugDraw(btIDebugDraw* drawer) {
    // Wheel axes and contact forces, 1 m for 4 kN.
    constexpr double kForceScale = 1 / 4000.0;
    const Implementation& s = *self_;
    for (std::size_t i = 0; i < kWheels; ++i) {
        const WheelState& wheel = s.state.wheels[i];
        const Vector3 hub = s.vehicle.corners[i].hub_B + Vector3(0, 0, wheel.travel);
        const Vector3 ground = hub - Vector3(0, 0, wheel.radius);
        const Vector3 steer(cosine(wheel.steer), sine(wheel.steer), 0);
        const Vector3 left(-steer.y(), steer.x(), 0);
        const Vector3 force = wheel.fx * steer + wheel.fy * left + wheel.load * Vector3::UnitZ();
        const auto world = [&](const Vector3& at_B) {
            return toBullet(Vector3(s.motion.position_W + s.motion.orientation * at_B));
        };
        drawer->drawLine(world(hub - wheel.radius * steer), world(hub + wheel.radius * steer), btVector3(0, 0, 1));
        drawer->drawLine(world(ground), world(ground + kForceScale * force), btVector3(1, 0, 0));
    }
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
