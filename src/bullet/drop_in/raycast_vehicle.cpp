#include "tread/raycast_vehicle.h"

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "bullet/convert.h"
#include "bullet/drop_in/raycast_parts.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

namespace {

constexpr double kSharpest = 1.5;  // rad, that an edge is rounded at
constexpr double kMostGrip = 10;

btRigidBody& checked(btRigidBody* chassis) {
    if (!chassis)
        throw std::invalid_argument("tread::RaycastVehicle: the chassis is null; give it the car's btRigidBody");
    return *chassis;
}

// By their tables of virtual functions: a raycaster that was compiled without run-time type information has no typeid.
bool isBulletsOwn(const btVehicleRaycaster* raycaster) {
    static const btDefaultVehicleRaycaster bullets(nullptr);
    return !raycaster ||
           std::memcmp(static_cast<const void*>(raycaster), static_cast<const void*>(&bullets), sizeof(void*)) == 0;
}

}  // namespace

SurfaceSource::~SurfaceSource() = default;

RaycastVehicle::RaycastVehicle(const btVehicleTuning& tuning, btRigidBody* chassis, btVehicleRaycaster* raycaster)
    : ::btRaycastVehicle(tuning, &checked(chassis), raycaster),
      self_(new Implementation{.face = *this,
                               .chassis = *chassis,
                               .raycaster = raycaster,
                               .own_rays = isBulletsOwn(raycaster),
                               .file = {}}) {}

RaycastVehicle::~RaycastVehicle() {
    delete self_;
}

RaycastVehicle::Implementation& implementationOf(RaycastVehicle& vehicle) {
    return *vehicle.self_;
}

bool RaycastVehicle::Implementation::isIn(const btCollisionWorld& in) const {
    const auto& objects = in.getCollisionObjectArray();
    const int place = chassis.getWorldArrayIndex();
    return place >= 0 && place < objects.size() && objects[place] == &chassis;
}

void RaycastVehicle::updateAction(btCollisionWorld* world, btScalar step) {
    if (!world || !self_->isIn(*world)) return;
    struct Within {
        explicit Within(const btCollisionWorld*& at, const btCollisionWorld* world) : stepping(at) { stepping = world; }
        ~Within() { stepping = nullptr; }
        Within(const Within&) = delete;
        Within& operator=(const Within&) = delete;
        const btCollisionWorld*& stepping;
    } within(self_->world, world);
    updateVehicle(step);
}

void RaycastVehicle::updateVehicle(btScalar step) {
    self_->step(self_->world, step);
}

void RaycastVehicle::setSubstep(double longest) {
    self_->substep.limit(longest);
}

void RaycastVehicle::setGrip(double factor) {
    self_->grip = factor >= 0 ? std::min(factor, kMostGrip) : 0;
}

void RaycastVehicle::setWheelReaction(bool on) {
    self_->wheel_reaction = on;
}

void RaycastVehicle::takeSurface(SurfaceSource* source) {
    self_->surface.reset(source);
}

void RaycastVehicle::setCollisionFilter(int group, int mask) {
    self_->filter = {group, mask};
}

void RaycastVehicle::setEdgeAngle(double angle) {
    self_->edge_angle = angle >= 0 ? std::min(angle, kSharpest) : 0;
}

btVector3 RaycastVehicle::velocity() const {
    return toBullet(self_->seen_velocity);
}

btVector3 RaycastVehicle::angularVelocity() const {
    return toBullet(self_->seen_angular_velocity);
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
