#include "car.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace tread::demo {
namespace {

using scene::scalar;
using scene::vector;

constexpr double kRestLength = 0.3;
constexpr double kEngine = 7000;    // N at the rear wheels
constexpr double kBackwards = 0.4;  // of the engine
constexpr double kBrake = 52;       // N s per wheel and step, as the stock vehicle counts it: 0.8 g at 60 Hz
constexpr double kHandbrake = 90;
constexpr double kAirDrag = 0.4;  // N/(m/s)2

btRaycastVehicle::btVehicleTuning tuning() {
    btRaycastVehicle::btVehicleTuning t;
    t.m_suspensionStiffness = 34;
    t.m_suspensionCompression = scalar(3.2);
    t.m_suspensionDamping = scalar(4.2);
    t.m_maxSuspensionForce = 40000;
    t.m_frictionSlip = 1;
    return t;
}

btRigidBody::btRigidBodyConstructionInfo construction(btCompoundShape& shape, btBoxShape& box) {
    shape.addChildShape(btTransform(btQuaternion::getIdentity(), vector(0, 0.25, 0)), &box);
    btVector3 inertia;
    box.calculateLocalInertia(scalar(Car::kMass), inertia);
    return {scalar(Car::kMass), nullptr, &shape, inertia};
}

}  // namespace

CarPose between(const CarPose& a, const CarPose& b, double at) {
    const auto mix = [at](double x, double y) { return x + at * (y - x); };
    CarPose pose;
    const btQuaternion turned = a.chassis.getRotation().slerp(b.chassis.getRotation(), scalar(at));
    pose.chassis = btTransform(turned, a.chassis.getOrigin().lerp(b.chassis.getOrigin(), scalar(at)));
    for (std::size_t i = 0; i < pose.wheels.size(); ++i)
        pose.wheels[i] = {mix(a.wheels[i].steer, b.wheels[i].steer), mix(a.wheels[i].length, b.wheels[i].length),
                          mix(a.wheels[i].rotation, b.wheels[i].rotation)};
    return pose;
}

Car::Car(Track& track)
    : track_(track),
      chassis_(construction(shape_, box_)),
      flags_(chassis_.getFlags()),
      raycaster_(&track.world.dynamics) {
    chassis_.setFriction(scalar(0.4));
    track_.world.dynamics.addRigidBody(&chassis_);
    put(start(Place::plane));
    choose(kind_);
}

Car::~Car() {
    track_.world.dynamics.removeVehicle(vehicle_.get());
    track_.world.dynamics.removeRigidBody(&chassis_);
}

void Car::choose(Kind kind) {
    if (vehicle_) track_.world.dynamics.removeVehicle(vehicle_.get());
    kind_ = kind;
    chassis_.setFlags(flags_);
    // Nothing wakes a stock vehicle: games do not let it sleep.
    chassis_.forceActivationState(kind == Kind::stock ? DISABLE_DEACTIVATION : ACTIVE_TAG);
    if (kind == Kind::tread) {
        auto vehicle = std::make_unique<tread::RaycastVehicle>(tuning(), &chassis_, &raycaster_);
        vehicle->setSurface([](const SurfaceQuery& query) {
            return Surface{.friction = groundFriction(query.point), .name = groundName(query.point).data()};
        });
        vehicle_ = std::move(vehicle);
    } else {
        vehicle_ = std::make_unique<btRaycastVehicle>(tuning(), &chassis_, &raycaster_);
    }
    vehicle_->setCoordinateSystem(0, 1, 2);
    track_.world.dynamics.addVehicle(vehicle_.get());
    for (int i = 0; i < 4; ++i) {
        const bool front = i < 2, left = i % 2 == 0;
        vehicle_->addWheel(vector((left ? 0.5 : -0.5) * kTrack, 0, (front ? 0.5 : -0.5) * kWheelbase), vector(0, -1, 0),
                           vector(-1, 0, 0), kRestLength, scalar(kRadius), tuning(), front);
    }
    chassis_.activate(true);
}

void Car::put(const btTransform& place) {
    chassis_.setWorldTransform(place);
    chassis_.setInterpolationWorldTransform(place);
    chassis_.setLinearVelocity(vector(0, 0, 0));
    chassis_.setAngularVelocity(vector(0, 0, 0));
    chassis_.activate(true);
    if (vehicle_) choose(kind_);
}

void Car::setSpeed(double forward) {
    chassis_.setLinearVelocity(scalar(forward) * chassis_.getWorldTransform().getBasis().getColumn(2));
    choose(kind_);  // wheels that roll along
}

void Car::drive(const Pedals& pedals) {
    const double engine = std::clamp(pedals.throttle, -kBackwards, 1.0) * kEngine;
    const double brake = kBrake * std::clamp(pedals.brake, 0.0, 1.0);
    for (int i = 0; i < 4; ++i) {
        const bool front = i < 2;
        vehicle_->applyEngineForce(front ? 0 : scalar(0.5 * engine), i);
        vehicle_->setBrake(scalar(front ? brake : std::max(0.6 * brake, kHandbrake * pedals.handbrake)), i);
        vehicle_->setSteeringValue(front ? scalar(std::clamp(pedals.steer, -kSteerMost, kSteerMost)) : 0, i);
        // A game with the stock vehicle looks itself what is under the wheels.
        btWheelInfo& wheel = vehicle_->getWheelInfo(i);
        if (kind_ == Kind::stock) wheel.m_frictionSlip = scalar(groundFriction(wheel.m_raycastInfo.m_contactPointWS));
    }
    if (pedals.throttle != 0 || pedals.steer != 0) chassis_.activate(true);
    const btVector3 v = chassis_.getLinearVelocity();
    if (chassis_.isActive()) chassis_.applyCentralForce(scalar(-kAirDrag) * v.length() * v);
}

CarPose Car::pose() const {
    CarPose pose;
    pose.chassis = chassis_.getWorldTransform();
    for (int i = 0; i < 4; ++i) {
        const btWheelInfo& wheel = vehicle_->getWheelInfo(i);
        pose.wheels[static_cast<std::size_t>(i)] = {wheel.m_steering, wheel.m_raycastInfo.m_suspensionLength,
                                                    wheel.m_rotation};
    }
    return pose;
}

double Car::speed() const {
    return static_cast<double>(chassis_.getLinearVelocity().dot(chassis_.getWorldTransform().getBasis().getColumn(2)));
}

WheelSight Car::look(int index) const {
    const btWheelInfo& wheel = vehicle_->getWheelInfo(index);
    const btWheelInfo::RaycastInfo& ray = wheel.m_raycastInfo;
    WheelSight sight;
    sight.touches = ray.m_isInContact;
    if (!sight.touches) return sight;
    sight.contact = ray.m_contactPointWS;
    sight.normal = ray.m_contactNormalWS;
    const btVector3 across = wheel.m_worldTransform.getBasis().getColumn(0);
    sight.axle = (across - sight.normal * sight.normal.dot(across)).normalized();  // to the left
    const btVector3 forward = sight.axle.cross(sight.normal);
    btVector3 v = chassis_.getVelocityInLocalPoint(sight.contact - chassis_.getCenterOfMassPosition());
    if (const auto* body = btRigidBody::upcast(static_cast<btCollisionObject*>(ray.m_groundObject)))
        v -= body->getVelocityInLocalPoint(sight.contact - body->getCenterOfMassPosition());
    sight.slide = sight.axle * v.dot(sight.axle);  // the stock wheel rolls whatever it does
    sight.load = static_cast<double>(wheel.m_wheelsSuspensionForce);
    if (const auto* own = dynamic_cast<const tread::RaycastVehicle*>(vehicle_.get())) {
        const WheelTelemetry told = own->telemetry(index);
        sight.slide -= forward * scalar(told.slip_ratio * std::max(std::abs(static_cast<double>(v.dot(forward))), 0.5));
        sight.force = forward * scalar(told.fx) + sight.axle * scalar(told.fy);
        sight.load = told.load;
        sight.has_force = true;
    }
    return sight;
}

std::string_view Car::ground(int wheel) const {
    const btWheelInfo::RaycastInfo& ray = vehicle_->getWheelInfo(wheel).m_raycastInfo;
    return ray.m_isInContact ? groundName(ray.m_contactPointWS) : "air";
}

btTransform Car::wheelInChassis(int wheel, const WheelPose& pose) const {
    const btVector3 top = vehicle_->getWheelInfo(wheel).m_chassisConnectionPointCS;
    const btQuaternion turned =
        btQuaternion(vector(0, 1, 0), scalar(pose.steer)) * btQuaternion(vector(1, 0, 0), scalar(pose.rotation));
    return btTransform(turned, top - vector(0, pose.length, 0));
}

}  // namespace tread::demo
