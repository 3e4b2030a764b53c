// The demo's ground: plane, hill, kerbs, ice, moving platform, jump and some crates, in a Bullet world. No drawing
// here.
//
// y is up, z forward, x to the left; metres.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "tools/stock_vs_tread/scene.h"

namespace tread::demo {

// Where a car can begin.
enum class Place { plane, slope, kerbs, ice, platform, jump };
constexpr auto enumNames(Place) {
    return std::array<std::string_view, 6>{"plane", "slope", "kerbs", "ice", "platform", "jump"};
}
btTransform start(Place place);

enum class Paint { concrete, kerb, platform, ramp, crate };

// A solid thing: a profile in its y-z plane, convex, as wide to the left as to the right.
struct Block {
    const btRigidBody* body;
    std::vector<btVector3> profile;  // x is 0
    double half_width;
    Paint paint;
};

struct Sign {
    btVector3 at;
    std::string_view text;
};

// A rectangle of ice on the plane.
struct Ice {
    double left, right, near, far;
};
inline constexpr Ice kIce{-18, -34, 30, 80};
inline constexpr double kIceFriction = 0.12;

// What is under a point: the name and the friction of tyres on it.
std::string_view groundName(const btVector3& point);
double groundFriction(const btVector3& point);

class Track {
public:
    Track();

    // Puts the platform where it is at a time, s; once before each step.
    void movePlatform(double time);
    // Everything that moves back to where it began.
    void reset();

    const std::vector<Block>& blocks() const { return blocks_; }
    const std::vector<Sign>& signs() const { return signs_; }

    scene::World world;

private:
    btRigidBody& add(std::vector<btVector3> profile, double half_width, Paint paint, const btVector3& at,
                     double mass = 0);
    void addKerbs();
    void addCrates();

    std::vector<Block> blocks_;
    std::vector<Sign> signs_;
    std::vector<std::pair<btRigidBody*, btTransform>> movable_;
    btRigidBody* platform_ = nullptr;
};

}  // namespace tread::demo
