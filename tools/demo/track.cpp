#include "track.h"

#include <cmath>
#include <memory>

namespace tread::demo {
namespace {

using scene::scalar;
using scene::vector;

// Profiles are points (y, z) from the foot, anticlockwise or not: they are convex.
btVector3 point(double y, double z) {
    return vector(0, y, z);
}
std::vector<btVector3> box(double height, double length) {
    return {point(0, 0), point(height, 0), point(height, length), point(0, length)};
}

constexpr double kHillX = 40, kHillZ = 30, kHillHeight = 6, kHillRun = 30, kHillTop = 12;  // 20 %
constexpr double kJumpX = -80, kJumpZ = 40, kJumpHeight = 1.8, kJumpRun = 14;
constexpr double kPlatformX = -54, kPlatformZ = 35, kPlatformHeight = 0.12, kPlatformSize = 12;
constexpr double kPlatformSwing = 6, kPlatformPeriod = 9;  // m, s
constexpr double kKerbX = 18, kKerbZ = 25;
constexpr double kRideHeight = 0.55;  // m, of the car's centre of gravity above its ground

btTransform at(double x, double y, double z, double pitch = 0) {
    return btTransform(btQuaternion(vector(1, 0, 0), scalar(pitch)), vector(x, y, z));
}

bool onIce(const btVector3& p) {
    return p.x() < kIce.left && p.x() > kIce.right && p.z() > kIce.near && p.z() < kIce.far && p.y() < scalar(0.1);
}

}  // namespace

btTransform start(Place place) {
    const double grade = std::atan(kHillHeight / kHillRun);
    switch (place) {
        case Place::plane:
            break;
        case Place::slope:
            return at(kHillX, 0.5 * kHillHeight + kRideHeight + 0.02, kHillZ + 0.5 * kHillRun, -grade);
        case Place::kerbs:
            return at(kKerbX, kRideHeight, kKerbZ - 15);
        case Place::ice:
            return at(0.5 * (kIce.left + kIce.right), kRideHeight, kIce.near - 30);
        case Place::platform:
            return at(kPlatformX, kPlatformHeight + kRideHeight, kPlatformZ + 0.5 * kPlatformSize);
        case Place::jump:
            return at(kJumpX, kRideHeight, kJumpZ - 50);
    }
    return at(0, kRideHeight, 0);
}

std::string_view groundName(const btVector3& point) {
    return onIce(point) ? "ice" : "asphalt";
}

double groundFriction(const btVector3& point) {
    return onIce(point) ? kIceFriction : 1;
}

Track::Track() {
    world.addPlane();
    add({point(0, 0), point(kHillHeight, kHillRun), point(kHillHeight, kHillRun + kHillTop),
         point(0, 2 * kHillRun + kHillTop)},
        9, Paint::concrete, vector(kHillX, 0, kHillZ));
    add({point(0, 0), point(kJumpHeight, kJumpRun), point(0, kJumpRun)}, 4, Paint::ramp, vector(kJumpX, 0, kJumpZ));
    addKerbs();
    addCrates();
    platform_ = &add(box(kPlatformHeight, kPlatformSize), 0.5 * kPlatformSize, Paint::platform,
                     vector(kPlatformX, 0, kPlatformZ));
    platform_->setCollisionFlags(platform_->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    platform_->setActivationState(DISABLE_DEACTIVATION);
    signs_ = {{vector(kHillX, kHillHeight + 2, kHillZ + kHillRun), "hill, 20 %"},
              {vector(kKerbX, 1.5, kKerbZ), "kerbs, 5 to 15 cm"},
              {vector(0.5 * (kIce.left + kIce.right), 1.5, kIce.near), "ice, friction 0.12"},
              {vector(kPlatformX, 2, kPlatformZ + kPlatformSize), "moving platform"},
              {vector(kJumpX, kJumpHeight + 1.5, kJumpZ + kJumpRun), "jump"}};
}

void Track::addKerbs() {
    for (int i = 0; i < 3; ++i) add(box(0.05 * (i + 1), 1.2), 5, Paint::kerb, vector(kKerbX, 0, kKerbZ + 9 * i));
    // One side only, in turns.
    for (int i = 0; i < 6; ++i)
        add(box(0.08, 0.5), 1.5, Paint::kerb, vector(kKerbX + (i % 2 == 0 ? 1.6 : -1.6), 0, kKerbZ + 30 + 3 * i));
}

void Track::addCrates() {
    constexpr double kSize = 0.8, kMass = 25;
    for (int layer = 0; layer < 3; ++layer)
        for (int i = 0; i < 4 - layer; ++i)
            add(box(kSize, kSize), 0.5 * kSize, Paint::crate,
                vector(0.9 * (i - 0.5 * (3 - layer)), 0.01 + layer * (kSize + 0.002), 70), kMass);
}

btRigidBody& Track::add(std::vector<btVector3> profile, double half_width, Paint paint, const btVector3& place,
                        double mass) {
    // Bodies turn about their centres.
    btVector3 centre(0, 0, 0);
    for (const btVector3& p : profile) centre += p / scalar(static_cast<double>(profile.size()));
    if (mass == 0) centre.setZero();
    auto shape = std::make_unique<btConvexHullShape>();
    for (btVector3& p : profile) {
        p -= centre;
        for (double side : {-half_width, half_width}) shape->addPoint(p + vector(side, 0, 0));
    }
    shape->setMargin(0);
    btRigidBody& body = world.add(std::move(shape), mass, place + centre);
    if (mass > 0) movable_.emplace_back(&body, body.getWorldTransform());
    blocks_.push_back({&body, std::move(profile), half_width, paint});
    return body;
}

void Track::movePlatform(double time) {
    const double x = kPlatformX + kPlatformSwing * std::sin(2 * M_PI * time / kPlatformPeriod);
    platform_->setWorldTransform(
        btTransform(btQuaternion::getIdentity(), vector(x, 0, platform_->getWorldTransform().getOrigin().z())));
}

void Track::reset() {
    movePlatform(0);
    platform_->setInterpolationWorldTransform(platform_->getWorldTransform());  // no way that it went
    for (auto& [body, place] : movable_) {
        body->setWorldTransform(place);
        body->setInterpolationWorldTransform(place);
        body->setLinearVelocity(vector(0, 0, 0));
        body->setAngularVelocity(vector(0, 0, 0));
        body->activate(true);
    }
}

}  // namespace tread::demo
