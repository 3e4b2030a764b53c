// A car driven at random on some ground, and the worst that it did.
#pragma once

#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "stock_vs_tread/scene.h"
#include "tread/tyre.h"

namespace tread::random_drive {

using namespace scene;

enum class Ground { plane, box, height_field, mesh };

// Bumps of 6 cm on a grid of 1 m, 200 m wide; the same for the height field and the mesh.
class Bumps {
public:
    static constexpr int kSide = 201;
    explicit Bumps(unsigned seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> height(0, 0.06f);
        heights_.resize(kSide * kSide);
        for (float& h : heights_) h = height(random);
    }
    double highest() const { return 0.06; }

    void add(World& world, Ground ground) {
        if (ground == Ground::height_field) {
            // Bullet centres the field on its heights' middle.
            world.add(std::make_unique<btHeightfieldTerrainShape>(kSide, kSide, heights_.data(), 0.f, 0.06f, 1, false),
                      0, vector(0, 0.03, 0));
            return;
        }
        const auto at = [&](int i, int j) {
            return vector(i - 100, heights_[static_cast<std::size_t>(j * kSide + i)], j - 100);
        };
        addGrid(mesh_, kSide, kSide, at);
        world.add(std::make_unique<btBvhTriangleMeshShape>(&mesh_, true));
    }

private:
    std::vector<float> heights_;
    btTriangleMesh mesh_;
};

struct Worst {
    bool finite = true;
    double lowest_centre = 1e9;  // m, of a wheel above the lowest ground, while the car stands on its wheels
    double fastest = 0;          // m/s
    long wheel_steps = 0;
    long beyond_grip = 0;  // wheel-steps with more force than 1.05 mu Fz

    void add(const Worst& w) {
        finite &= w.finite;
        lowest_centre = std::min(lowest_centre, w.lowest_centre);
        fastest = std::max(fastest, w.fastest);
        wheel_steps += w.wheel_steps;
        beyond_grip += w.beyond_grip;
    }
};

// The friction that the tyre's own formulas give at a load.
inline double friction(const TyreParams& tyre, double load) {
    const TyreSteadyState peak = steadyState(tyre, {.Fz = load, .gamma = 0, .Vx = 20, .Vsx = 0, .Vsy = 0});
    return std::max(peak.mux, peak.muy);
}

inline Worst drive(unsigned seed, Ground ground, double rate, double seconds) {
    World world;
    Bumps bumps(seed);
    if (ground == Ground::plane) world.addPlane();
    else if (ground == Ground::box) world.addBox(500, 0.5, 500, 0, vector(0, -0.5, 0));
    else bumps.add(world, ground);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    Car<RaycastVehicle> car(world, {.height = 0.7, .speed = 20 * unit(random)});
    const TyreParams tyre = similarTyre(0.25 * 1500 * kGravity, 0.3);

    Worst worst;
    double until = 0;
    for (int i = 0; i < seconds * rate; ++i) {
        if (i / rate >= until) {
            until = i / rate + 0.1 + 0.6 * unit(random);
            car.steer(unit(random) - 0.5);
            car.push(unit(random) < 0.6 ? 16000 * unit(random) : -8000 * unit(random));
            car.brake(unit(random) < 0.7 ? 0 : 200 * unit(random));
        }
        run(world, 1 / rate, rate);
        const btVector3 at = car.place();
        const double speed = car.velocity().length();
        worst.finite &= std::isfinite(speed) && std::isfinite(at.length());
        worst.fastest = std::max(worst.fastest, speed);
        // All ground but the plane ends: back to the middle.
        const double end = ground == Ground::plane ? 1e9 : ground == Ground::box ? 480 : 80;
        if (static_cast<double>(std::max(std::abs(at.x()), std::abs(at.z()))) > end) {
            btTransform pose = car.chassis->getCenterOfMassTransform();
            pose.setOrigin(vector(0, static_cast<double>(at.y()) + 0.1, 0));
            car.chassis->setCenterOfMassTransform(pose);
        }
        const bool upright = car.chassis->getWorldTransform().getBasis()[1][1] > 0.7;
        for (int k = 0; k < 4; ++k) {
            const WheelTelemetry wheel = car.vehicle->telemetry(k);
            const double most = 1.05 * friction(tyre, std::min(wheel.load, 4 * tyre.parameters.Fzo)) * wheel.load;
            ++worst.wheel_steps;
            worst.beyond_grip += std::hypot(wheel.fx, wheel.fy) > most + 1e-9;
            const double centre = car.vehicle->getWheelTransformWS(k).getOrigin().y();
            if (upright) worst.lowest_centre = std::min(worst.lowest_centre, centre);
        }
    }
    return worst;
}

}  // namespace tread::random_drive
