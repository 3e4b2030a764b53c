#include "tread/raycast_vehicle.h"

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <stdexcept>
#include <typeinfo>

#include "bullet/convert.h"
#include "bullet/raycast_parts.h"
#include "tread/load.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

namespace {

constexpr double kShortestSubstep = 1e-4;  // s
constexpr double kLongestGameStep = 0.02;  // s: one step of a game
constexpr double kSharpest = 1.5;          // rad, that an edge is rounded at

btRigidBody& checked(btRigidBody* chassis) {
    if (!chassis)
        throw std::invalid_argument("tread::RaycastVehicle: the chassis is null; give it the car's btRigidBody");
    return *chassis;
}

bool isBulletsOwn(const btVehicleRaycaster* raycaster) {
    return !raycaster || typeid(*raycaster) == typeid(btDefaultVehicleRaycaster);
}

}  // namespace

RaycastVehicle::RaycastVehicle(const btVehicleTuning& tuning, btRigidBody* chassis, btVehicleRaycaster* raycaster)
    : btRaycastVehicle(tuning, &checked(chassis), raycaster),
      self_(new Implementation{.face = *this,
                               .chassis = *chassis,
                               .raycaster = raycaster,
                               .own_rays = isBulletsOwn(raycaster),
                               .file = {}}) {
    Implementation& s = *self_;
    switchOffGyroscopicForces(*chassis);
    expectWhatBodyHas(s.link, *chassis);
    s.motion.velocity_W = s.link.velocity;
    s.motion.angular_velocity_W = s.link.angular_velocity;
    takeMotion(s.motion, s.link, *chassis, Quaternion::Identity());
}

RaycastVehicle::RaycastVehicle(const btVehicleTuning& tuning, btRigidBody* chassis, btVehicleRaycaster* raycaster,
                               const std::filesystem::path& vehicle_file)
    : RaycastVehicle(tuning, chassis, raycaster, loadVehicle(vehicle_file)) {}

RaycastVehicle::RaycastVehicle(const btVehicleTuning& tuning, btRigidBody* chassis, btVehicleRaycaster* raycaster,
                               const VehicleParams& params)
    : RaycastVehicle(tuning, chassis, raycaster) {
    self_->file = params;
}

RaycastVehicle::~RaycastVehicle() = default;

bool RaycastVehicle::isHeldBy(const btCollisionWorld& world) const {
    const auto& objects = world.getCollisionObjectArray();
    const int place = self_->chassis.getWorldArrayIndex();
    return place >= 0 && place < objects.size() && objects[place] == &self_->chassis;
}

void RaycastVehicle::updateAction(btCollisionWorld* world, btScalar step) {
    if (world && isHeldBy(*world)) self_->step(world, step);
}

void RaycastVehicle::updateVehicle(btScalar step) {
    self_->step(nullptr, step);
}

void RaycastVehicle::setSubstep(double longest) {
    self_->substep = longest >= kShortestSubstep ? std::min(longest, kLongestGameStep) : kShortestSubstep;
}

void RaycastVehicle::setSurface(SurfaceAt surface) {
    self_->surface = std::move(surface);
}

void RaycastVehicle::setCollisionFilter(int group, int mask) {
    self_->filter = {group, mask};
}

void RaycastVehicle::setEdgeAngle(double angle) {
    self_->edge_angle = angle >= 0 ? std::min(angle, kSharpest) : 0;
}

void RaycastVehicle::setTyre(int wheel, const TyreParams& tyre) {
    const auto i = static_cast<std::size_t>(wheel);
    if (wheel < 0 || i >= kMostWheels) throw std::out_of_range("tread::RaycastVehicle::setTyre: no such wheel");
    self_->own_tyres[i] = tyre;
    self_->made = false;
}

Vector3 RaycastVehicle::velocity() const {
    return self_->seen_velocity;
}

Vector3 RaycastVehicle::angularVelocity() const {
    return self_->seen_angular_velocity;
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
