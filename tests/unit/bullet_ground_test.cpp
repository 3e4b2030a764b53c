// The wheels' road and Bullet's collision shape are the same ground.

#include "tread/bullet_ground.h"

#include <btBulletDynamicsCommon.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/math/random.h"
#include "base/yaml/read.h"
#include "shared/bullet_scene.h"
#include "tread/road_surface.h"

namespace tread::bullet_ground_test {
namespace {

constexpr double kSame = 1e-9;  // m, and of a normal

// A world with a height field as its ground.
class FieldWorld {
public:
    explicit FieldWorld(const HeightField& field)
        : ground_(field), body_(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &ground_.shape())) {
        body_.setWorldTransform(ground_.place());
        world_.addRigidBody(&body_);
    }
    ~FieldWorld() { world_.removeRigidBody(&body_); }

    RoadContact contact(double x, double y) const {
        const BulletRoad road(world_, car_, Vector3::UnitZ(), 30);
        return road.contact({x, y, 10}, 0);
    }

private:
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    BulletGround ground_;
    btRigidBody body_;
    btCollisionObject car_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
};

RoadParams everything() {
    return readYamlText<RoadParams>(
        "{grade: 0.05, bank: -0.02, crown: 0.03, contact_length: 0,"
        " obstacles: [{x: 3, length: 2, height: 0.1}, {x: 8, y: 1, length: 1, width: 1, height: -0.08, shape: plank},"
        " {x: 11, length: 2, height: 0.12, heading: 0.3, shape: {ramp: {rise: 0.4}}}],"
        " roughness: {road_class: D, seed: 5}}",
        "road.yaml");
}

TEST(BulletGround, HasTheHeightsOfTheRoadAtTheNodes) {
    const RoadSurface road(everything());
    const HeightField field = sampled(road, {0, 15, -3, 3}, 0.2);
    const FieldWorld world(field);
    double largest = 0;
    // A ray through the outermost nodes may pass by the border.
    for (std::size_t i = 1; i + 1 < field.rows(); ++i) {
        for (int j = 1; j + 1 < field.columns; ++j) {
            const double x = static_cast<double>(i) * 0.2, y = -3 + j * 0.2;
            const RoadContact found = world.contact(x, y);
            ASSERT_TRUE(found.exists) << x << ", " << y;
            largest = std::max(largest, std::abs(found.point_W.z() - road.at(x, y).height));
        }
    }
    std::printf("collision shape against road at its nodes: %.1e m\n", largest);
    EXPECT_LT(largest, kSame);
}

// A road that is given as a grid is the same everywhere: heights and normals, inside the triangles. Bullet's rays take
// a triangle for 1e-4 larger than it is, so that they miss no edge: that near to an edge they may find the neighbour.
TEST(BulletGround, HasTheTrianglesOfTheHeightField) {
    constexpr double kFromEdges = 2e-4;  // of a cell
    const RoadSurface hills(everything());
    RoadParams params;
    params.contact_length = 0;
    params.height_field = sampled(hills, {0, 15, -3, 3}, 0.25);
    const RoadSurface road(params);
    const FieldWorld world(*params.height_field);
    Random random(1);
    double height = 0, normal = 0;
    int compared = 0;
    for (int k = 0; k < 20000; ++k) {
        const double u = 60 * random.uniform(), v = 24 * random.uniform();
        const double in_u = u - std::floor(u), in_v = v - std::floor(v);
        const double to_edge = std::min({in_u, 1 - in_u, in_v, 1 - in_v, std::abs(in_u + in_v - 1)});
        if (to_edge < kFromEdges) continue;
        const double x = 0.25 * u, y = -3 + 0.25 * v;
        const RoadContact found = world.contact(x, y), expected = road.contact({x, y, 10}, 0);
        ASSERT_TRUE(found.exists) << x << ", " << y;
        height = std::max(height, std::abs(found.point_W.z() - expected.point_W.z()));
        normal = std::max(normal, (found.normal_W - expected.normal_W).norm());
        ++compared;
    }
    std::printf("collision shape against height field in %d places: %.1e m, normals %.1e\n", compared, height, normal);
    EXPECT_GT(compared, 19000);
    EXPECT_LT(height, kSame);
    EXPECT_LT(normal, kSame);
}

TEST(BulletGround, EndsWhereTheFieldEnds) {
    const FieldWorld world(sampled(RoadSurface(everything()), {0, 15, -3, 3}, 0.25));
    EXPECT_FALSE(world.contact(-0.1, 0).exists);
    EXPECT_FALSE(world.contact(15.1, 0).exists);
    EXPECT_FALSE(world.contact(5, 3.1).exists);
    EXPECT_TRUE(world.contact(5, 2.9).exists);
}

}  // namespace
}  // namespace tread::bullet_ground_test
