// The faces that a wheel keeps of a mesh or height field stand for the whole world, however that changes.

#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "stock_vs_tread/scene.h"

namespace tread::raycast_near_faces_test {
namespace {

using namespace scene;

constexpr int kSide = 81;
constexpr double kGrid = 0.5;          // m
constexpr double kBulletsEdge = 1e-4;  // m: as far Bullet still takes a ray beside a face for one that meets it
constexpr double kRounding = sizeof(btScalar) == sizeof(double) ? 1e-9 : 2e-5;  // m

float bumps(int i, int j) {
    return 0.05f * std::sin(0.9f * float(i)) * std::sin(0.7f * float(j));
}

// Bumps of 5 cm as a height field, and as a mesh for a piece of them, `raised` above.
struct Grounds {
    World world;
    std::vector<float> heights = std::vector<float>(kSide * kSide);
    std::vector<std::unique_ptr<btTriangleMesh>> meshes{};

    btRigidBody& addField() {
        for (int j = 0; j < kSide; ++j) {
            for (int i = 0; i < kSide; ++i) heights[static_cast<std::size_t>(j * kSide + i)] = bumps(i, j);
        }
        auto field = std::make_unique<btHeightfieldTerrainShape>(kSide, kSide, heights.data(), -1.f, 1.f, 1, false);
        field->setLocalScaling(vector(kGrid, 1, kGrid));
        return world.add(std::move(field));
    }
    btRigidBody& addMesh(int from, int to, double raised = 0) {
        meshes.push_back(std::make_unique<btTriangleMesh>());
        const auto at = [&](int i, int j) {
            return vector(kGrid * (i - kSide / 2), bumps(i, j + from) + raised, kGrid * (j + from - kSide / 2));
        };
        addGrid(*meshes.back(), kSide, to - from, at);
        return world.add(std::make_unique<btBvhTriangleMeshShape>(meshes.back().get(), true));
    }
};

// Bullet's own closest ray past the chassis.
struct Closest : btCollisionWorld::ClosestRayResultCallback {
    Closest(const btVector3& from, const btVector3& to, const btCollisionObject* own)
        : ClosestRayResultCallback(from, to), chassis(own) {}
    bool needsCollision(btBroadphaseProxy* proxy) const override {
        return proxy->m_clientObject != chassis && ClosestRayResultCallback::needsCollision(proxy);
    }
    btScalar addSingleResult(btCollisionWorld::LocalRayResult& result, bool in_world) override {
        part = result.m_localShapeInfo->m_shapePart;
        triangle = result.m_localShapeInfo->m_triangleIndex;
        return ClosestRayResultCallback::addSingleResult(result, in_world);
    }
    const btCollisionObject* chassis;
    int part = -1, triangle = -1;
};

// A car that drives for three seconds and whose every ray is repeated by Bullet.
void expectBulletsAnswers(Grounds& grounds) {
    Car<RaycastVehicle> car(grounds.world,
                            {.height = 0.7, .place = btTransform(btQuaternion::getIdentity(), vector(0.13, 0, -12))});
    long asked = 0, beside = 0;
    car.vehicle->setSurface([&](const SurfaceQuery& query) {
        const btVector3 down = car.chassis->getWorldTransform().getBasis() * vector(0, -1, 0) * scalar(0.5);
        Closest ray(query.point - down, query.point + down, car.chassis.get());
        grounds.world.dynamics.rayTest(ray.m_rayFromWorld, ray.m_rayToWorld, ray);
        EXPECT_TRUE(ray.hasHit());
        const double apart = (ray.m_hitPointWorld - query.point).length();
        EXPECT_LT(apart, kBulletsEdge);
        ++asked;
        const bool same = ray.m_collisionObject == query.object;  // at the seam of two pieces both lie there
        beside += !same || ray.part != query.part || ray.triangle != query.triangle || apart > kRounding;
        return tread::Surface{};
    });
    car.push(3000);
    run(grounds.world, 1.5, 1000);
    car.steer(0.1);
    run(grounds.world, 1.5, 1000);
    EXPECT_GT(car.place().z(), -10);
    EXPECT_GE(asked, 12000);
    EXPECT_LE(beside, 20) << "only where Bullet takes a ray beside an edge for a hit";
}

TEST(RaycastVehicleNearFaces, OfAHeightFieldGiveWhatBulletsRayGives) {
    Grounds grounds;
    grounds.addField();
    expectBulletsAnswers(grounds);
}

TEST(RaycastVehicleNearFaces, OfAMeshInPiecesGiveWhatBulletsRayGives) {
    Grounds grounds;
    for (int from = 0; from < kSide - 1; from += 8) grounds.addMesh(from, from + 9);
    expectBulletsAnswers(grounds);
}

TEST(RaycastVehicleNearFaces, OfAMeshAboveAnotherGiveWhatBulletsRayGives) {
    Grounds grounds;
    grounds.addField();
    grounds.addMesh(18, 24, 0.03);
    grounds.addMesh(22, 30, 0.06);
    expectBulletsAnswers(grounds);
}

// How far the ground under the front left wheel of a parked car rises when `change` happens to it.
double rise(Grounds& grounds, double after, const auto& change) {
    Car<RaycastVehicle> car(grounds.world, {.height = 0.56});
    car.brake(100);
    double height = 0;
    car.vehicle->setSurface([&](const SurfaceQuery& query) {
        if (query.wheel == 0) height = query.point.y();
        return tread::Surface{};
    });
    run(grounds.world, 2, 1000);
    const double before = height;
    change();
    run(grounds.world, after, 1000);
    return height - before;
}

TEST(RaycastVehicleNearFaces, MoveWithTheirBodyAtOnce) {
    Grounds grounds;
    btRigidBody& ground = grounds.addMesh(0, kSide);
    const auto lift = [&] {
        ground.setWorldTransform(btTransform(btQuaternion::getIdentity(), vector(0, 0.01, 0)));
        grounds.world.dynamics.updateSingleAabb(&ground);
    };
    EXPECT_NEAR(rise(grounds, 0.001, lift), 0.01, 1e-4);
}

TEST(RaycastVehicleNearFaces, AreGoneWithTheirBody) {
    Grounds grounds;
    btRigidBody& ground = grounds.addMesh(0, kSide, 0.02);
    grounds.addField();
    EXPECT_NEAR(rise(grounds, 0.001, [&] { grounds.world.dynamics.removeRigidBody(&ground); }), -0.02, 1e-4);
}

TEST(RaycastVehicleNearFaces, ChangedInPlaceAreSeenWithin35Milliseconds) {
    Grounds grounds;
    grounds.addField();
    const auto lift = [&] {
        for (float& height : grounds.heights) height += 0.01f;
    };
    EXPECT_NEAR(rise(grounds, 0.035, lift), 0.01, 5e-4);
}

}  // namespace
}  // namespace tread::raycast_near_faces_test
