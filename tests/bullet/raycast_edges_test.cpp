// Wheels over the edges between triangles: those of a surface are rounded, true ones are not.

#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "stock_vs_tread/scene.h"
#include "tread/vector.h"

namespace tread::raycast_edges_test {
namespace {

using namespace scene;
using Height = std::function<double(double x, double z)>;

// A surface over a grid, 8 m wide and 40 m long, as a mesh or as a height field.
class Surface {
public:
    Surface(const Height& height, double grid, bool as_mesh) : across_(int(8 / grid) + 1), along_(int(40 / grid) + 1) {
        const auto at = [&](int i, int j) {
            const double x = grid * (i - 0.5 * (across_ - 1)), z = grid * (j - 0.5 * (along_ - 1));
            return vector(x, height(x, z), z);
        };
        if (as_mesh) {
            addGrid(mesh_, across_, along_, at);
            world.add(std::make_unique<btBvhTriangleMeshShape>(&mesh_, true));
            return;
        }
        for (int j = 0; j < along_; ++j) {
            for (int i = 0; i < across_; ++i) heights_.push_back(static_cast<float>(at(i, j).y()));
        }
        auto field = std::make_unique<btHeightfieldTerrainShape>(across_, along_, heights_.data(), -1.f, 1.f, 1, false);
        field->setLocalScaling(vector(grid, 1, grid));
        world.add(std::move(field));
    }

private:
    int across_, along_;
    btTriangleMesh mesh_;
    std::vector<float> heights_;

public:
    World world;
};

struct Ride {
    double normal_jump = 0;   // rad, most between two steps of a millisecond
    double normal_error = 0;  // rad, most against the surface
    double kick = 0;          // m/s2, most that the body's vertical acceleration changes within a step
};

// Two seconds at 8 m/s and 1 kHz along the surface.
Ride ride(Surface& surface, double edge_angle, const std::function<Vector3(double x, double z)>& normal_at) {
    Car<RaycastVehicle> car(surface.world,
                            {.height = 0.56, .place = btTransform(btQuaternion::getIdentity(), vector(0.3, 0, -12))});
    car.vehicle->setEdgeAngle(edge_angle);
    run(surface.world, 1, 1000);
    car.chassis->setLinearVelocity(vector(0, 0, 8));
    run(surface.world, 0.5, 1000);
    Ride seen;
    std::array<btVector3, 4> before{};
    std::array<bool, 4> touched{};  // in the step before: a wheel that comes down again finds another normal
    double speed = 0, acceleration = 0;
    for (int step = 0; step < 2000; ++step) {
        run(surface.world, 0.001, 1000);
        for (int i = 0; i < 4; ++i) {
            const auto& ray = car.vehicle->getWheelInfo(i).m_raycastInfo;
            const btVector3 normal = ray.m_contactNormalWS, at = ray.m_contactPointWS;
            btVector3& last = before[static_cast<std::size_t>(i)];
            const bool stays = std::exchange(touched[static_cast<std::size_t>(i)], ray.m_isInContact);
            if (!ray.m_isInContact) continue;
            if (stays) seen.normal_jump = std::max(seen.normal_jump, double((normal - last).length()));
            const Vector3 expected = normal_at(at.x(), at.z());
            const Vector3 off = Vector3(normal.x(), normal.y(), normal.z()) - expected;
            seen.normal_error = std::max(seen.normal_error, off.norm());
            last = normal;
        }
        const double now = car.vehicle->velocity().y(), change = (now - speed) / 0.001;
        if (step > 1) seen.kick = std::max(seen.kick, std::abs(change - acceleration));
        speed = now;
        acceleration = change;
    }
    return seen;
}

// Bumps of 3 cm, 4 m long, in triangles of 10 cm.
constexpr double kBump = 0.03, kWave = 2 * M_PI / 4;
double bumps(double x, double z) {
    return kBump * std::sin(kWave * x) * std::sin(kWave * z);
}
Vector3 normalOfBumps(double x, double z) {
    return Vector3(-kBump * kWave * std::cos(kWave * x) * std::sin(kWave * z), 1,
                   -kBump * kWave * std::sin(kWave * x) * std::cos(kWave * z))
        .normalized();
}

TEST(RaycastVehicleEdges, OfAFineMeshAreRoundedToTheSurfaceThatItStandsFor) {
    for (bool as_mesh : {true, false}) {
        SCOPED_TRACE(as_mesh ? "mesh" : "height field");
        Surface faceted(bumps, 0.1, as_mesh), rounded(bumps, 0.1, as_mesh);
        const Ride plain = ride(faceted, 0, normalOfBumps), smooth = ride(rounded, 0.45, normalOfBumps);
        // The analytic normal turns by at most the curvature times the way of a step.
        const double turns = 2 * kBump * kWave * kWave * 8 * 0.001;
        EXPECT_GT(plain.normal_jump, 3 * turns) << "faceted, it jumps from face to face";
        EXPECT_LT(smooth.normal_jump, 2 * turns);
        EXPECT_LT(smooth.normal_error, 0.5 * plain.normal_error);
        EXPECT_LT(smooth.kick, plain.kick);
    }
}

// A roof of two planes: 8 degrees in one edge across the way.
TEST(RaycastVehicleEdges, OfTwoLargeTrianglesTurnTheNormalGradually) {
    const double slope = std::tan(0.07);
    const auto roof = [&](double, double z) { return -slope * std::abs(z + 2); };
    const auto normal = [&](double, double z) { return Vector3(0, 1, z < -2 ? -slope : slope).normalized(); };
    Surface faceted(roof, 2, true), rounded(roof, 2, true);
    const Ride plain = ride(faceted, 0, normal), smooth = ride(rounded, 0.45, normal);
    EXPECT_NEAR(plain.normal_jump, 0.14, 0.001);
    // Over twice a third of the wheel's radius, at 8 mm a step; parabolas are twice as steep as a straight line.
    EXPECT_LT(smooth.normal_jump, 2.5 * 0.14 * 0.008 / (2 * 0.33 * 0.3));
    EXPECT_LT(smooth.kick, plain.kick);
}

TEST(RaycastVehicleEdges, OfAKerbStayAsTheyAre) {
    // 10 cm up over 5 cm: 63 degrees.
    const auto kerb = [](double, double z) { return std::clamp(2 * (z + 2), 0.0, 0.1); };
    const auto any = [](double, double) { return Vector3(0, 1, 0); };
    Surface plain(kerb, 0.05, true), rounded(kerb, 0.05, true);
    const Ride sharp = ride(plain, 0, any), same = ride(rounded, 0.45, any);
    EXPECT_NEAR(same.normal_jump, sharp.normal_jump, 1e-3);
    EXPECT_GT(same.normal_jump, 0.9);
}

TEST(RaycastVehicleEdges, OfAFlatMeshAreNotFelt) {
    Surface flat([](double, double) { return 0.0; }, 0.5, true);
    const Ride seen = ride(flat, 0.45, [](double, double) { return Vector3(0, 1, 0); });
    EXPECT_LT(seen.normal_error, sizeof(btScalar) == sizeof(double) ? 1e-12 : 1e-6);
}

}  // namespace
}  // namespace tread::raycast_edges_test
