// What the wheels' rays take for ground: what lies below the hard points, and above them only what holds them.

#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "stock_vs_tread/scene.h"
#include "tread/bullet_road.h"

namespace tread::raycast_ground_test {
namespace {

using namespace scene;

// Of the car in scene.h on level ground: m, of the centre of gravity and of the hard points above wheels of 0.3 m.
constexpr double kHeight = 0.54;
constexpr double kRoof = kHeight + 0.25;  // m, top of the chassis

btTransform at(double x, double y, double z) {
    return btTransform(btQuaternion::getIdentity(), vector(x, y, z));
}

// A car whose chassis lies between its wheels, so that these alone meet what is put over or under them.
template <class Vehicle>
struct NarrowCar : Car<Vehicle> {
    explicit NarrowCar(World& world, const Setup& setup = {}, double chassis_above = 0) : Car<Vehicle>(world, setup) {
        body.addChildShape(at(0, chassis_above, 0), &box);
        this->chassis->setCollisionShape(&body);
    }
    ~NarrowCar() { this->chassis->setCollisionShape(&box); }
    btBoxShape box{vector(0.4, 0.25, 2)};
    btCompoundShape body;

    double groundUnder(int wheel) const {
        const auto& ray = this->vehicle->getWheelInfo(wheel).m_raycastInfo;
        return ray.m_isInContact ? static_cast<double>(ray.m_contactPointWS.y()) : -1;
    }
};

// How far a car comes, at most, from the height at which it stands now; `always` is called before each step.
double strays(World& world, const auto& car, double seconds, const std::function<void()>& always = {}) {
    const double before = car.place().y();
    double most = 0;
    for (int i = 0; i < 60 * seconds; ++i) {
        if (always) always();
        run(world, 1.0 / 60, 60);
        most = std::max(most, std::abs(static_cast<double>(car.place().y()) - before));
    }
    return most;
}

// ---- Shapes of a block: its corners at +-half

using Shape = std::unique_ptr<btCollisionShape>;

struct Kind {
    std::string name;
    std::function<Shape(const btVector3& half)> make;
};

// A box of twelve faces that look outward.
void addBlock(btTriangleMesh& mesh, const btVector3& half, const btVector3& centre = vector(0, 0, 0)) {
    for (int axis = 0; axis < 3; ++axis) {
        for (int sign : {1, -1}) {
            const auto corner = [&](int u, int v) {
                btVector3 c;
                c[axis] = btScalar(sign) * half[axis];
                c[(axis + 1) % 3] = btScalar(u) * half[(axis + 1) % 3];
                c[(axis + 2) % 3] = btScalar(v * sign) * half[(axis + 2) % 3];
                return c + centre;
            };
            mesh.addTriangle(corner(-1, -1), corner(1, -1), corner(1, 1));
            mesh.addTriangle(corner(-1, -1), corner(1, 1), corner(-1, 1));
        }
    }
}

struct OwnMesh {
    explicit OwnMesh(const auto& fill) { fill(triangles); }
    btTriangleMesh triangles;
};
// Keeps its triangles.
struct Mesh : OwnMesh, btBvhTriangleMeshShape {
    explicit Mesh(const auto& fill) : OwnMesh(fill), btBvhTriangleMeshShape(&triangles, true) {}
};

struct OwnParts {
    std::vector<Shape> parts;
};
struct Compound : OwnParts, btCompoundShape {
    Compound& with(const btTransform& place, Shape part) {
        addChildShape(place, part.get());
        parts.push_back(std::move(part));
        return *this;
    }
};

Shape box(const btVector3& half) {
    return std::make_unique<btBoxShape>(half);
}
Shape hull(const btVector3& half) {
    auto shape = std::make_unique<btConvexHullShape>();
    for (int k = 0; k < 8; ++k) shape->addPoint(half * vector(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1));
    shape->setMargin(btScalar(0.001));
    return shape;
}
Shape drum(const btVector3& half) {
    return std::make_unique<btCylinderShape>(half);
}
Shape twoBoxes(const btVector3& half) {
    const btVector3 part = half * vector(1, 1, 0.5);
    auto shape = std::make_unique<Compound>();
    for (int sign : {1, -1}) shape->with(at(0, 0, sign * 0.5 * static_cast<double>(half.z())), box(part));
    return shape;
}
Shape blockOfFaces(const btVector3& half) {
    return std::make_unique<Mesh>([&](btTriangleMesh& mesh) { addBlock(mesh, half); });
}
const std::array<Kind, 4> kSolids{Kind{"box", box}, {"hull", hull}, {"cylinder", drum}, {"compound", twoBoxes}};
const std::array<Kind, 5> kBlocks{
    Kind{"box", box}, {"hull", hull}, {"cylinder", drum}, {"compound", twoBoxes}, {"mesh", blockOfFaces}};

// ---- What lies on the car

template <class Vehicle>
double straysUnderCargo(const Kind& kind) {
    World world;
    world.addPlane();
    Car<Vehicle> car(world);
    car.brake(100);
    run(world, 2, 60);
    const btRigidBody& plank = world.add(kind.make(vector(1.2, 0.02, 2)), 40, vector(0, kRoof + 0.03, 0));
    const double strayed = strays(world, car, 3);
    EXPECT_NEAR(plank.getWorldTransform().getOrigin().y(), kRoof + 0.02, 0.01) << "it lies there";
    return strayed;
}

TEST(RaycastVehicleCargo, LiesOnTheChassisAsOnTheStockVehicle) {
    for (const Kind& kind : kSolids) {
        SCOPED_TRACE(kind.name);
        // 40 kg on four springs of 60 kN/m: 1.6 mm; the rest is what the plank does when it comes down.
        EXPECT_LT(straysUnderCargo<btRaycastVehicle>(kind), 0.005);
        EXPECT_LT(straysUnderCargo<RaycastVehicle>(kind), 0.005);
    }
}

// How far a car strays with cargo, or what else is fixed to it, that collides with all but the chassis, and lies from
// `low` above its hard points to 20 cm higher.
enum class Held { byConstraint, byGame };
double straysWithLoad(const Kind& kind, double low, Held held) {
    constexpr int kCar = 64, kLoad = 128, kAll = btBroadphaseProxy::AllFilter;
    World world;
    world.addPlane();
    Car<RaycastVehicle> car(world);
    world.dynamics.removeRigidBody(car.chassis.get());
    world.dynamics.addRigidBody(car.chassis.get(), kCar, kAll ^ kLoad);
    car.brake(100);
    run(world, 2, 60);
    const btTransform on_car = at(0, low + 0.1, 0);
    btRigidBody& load = world.add(kind.make(vector(1.2, 0.1, 2)), held == Held::byGame ? 0 : 40);
    world.dynamics.removeRigidBody(&load);
    load.setWorldTransform(car.chassis->getWorldTransform() * on_car);
    if (held == Held::byGame) load.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
    world.dynamics.addRigidBody(&load, kLoad, kAll);
    if (held == Held::byGame)
        return strays(world, car, 2, [&] { load.setWorldTransform(car.chassis->getWorldTransform() * on_car); });
    btFixedConstraint bolts(*car.chassis, load, on_car, btTransform::getIdentity());
    world.dynamics.addConstraint(&bolts);
    const double strayed = strays(world, car, 2);
    EXPECT_NEAR(load.getWorldTransform().getOrigin().y(), kHeight + low + 0.1, 0.01);
    world.dynamics.removeConstraint(&bolts);
    return strayed;
}

TEST(RaycastVehicleCargo, FixedToTheCarCarriesNoWheel) {
    for (const Kind& kind : kSolids) {
        for (double low : {0.05, -0.05}) {
            SCOPED_TRACE(kind.name + (low > 0 ? " above the hard points" : " that holds the hard points"));
            EXPECT_LT(straysWithLoad(kind, low, Held::byConstraint), 0.005);
            EXPECT_LT(straysWithLoad(kind, low, Held::byGame), 0.001);
        }
    }
}

// ---- What reaches over the wheels

enum class Moves { no, byGame, itself };
void make(btRigidBody& body, Moves moves) {
    if (moves == Moves::byGame) body.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
    if (moves == Moves::itself) body.setGravity(vector(0, 0, 0));
}

// A shelf from 5 cm above the hard point of the front left wheel.
TEST(RaycastVehicleShelf, OverAWheelIsNotItsGround) {
    for (const Kind& kind : kBlocks) {
        for (Moves moves : {Moves::no, Moves::byGame, Moves::itself}) {
            if (moves == Moves::itself && kind.name == "mesh") continue;  // Bullet has none that move
            for (double thick : {0.01, 0.1, 1.0}) {
                SCOPED_TRACE(kind.name + ", " + std::to_string(thick) + " m, moves: " + std::to_string(int(moves)));
                World world;
                world.addPlane();
                NarrowCar<RaycastVehicle> car(world);
                car.brake(100);
                run(world, 2, 60);
                make(world.add(kind.make(vector(0.2, 0.5 * thick, 0.6)), moves == Moves::itself ? 20 : 0,
                               vector(0.75, 0.59 + 0.5 * thick, 1.35)),
                     moves);
                EXPECT_LT(strays(world, car, 2), 0.001);
                EXPECT_NEAR(car.groundUnder(0), 0, 0.001);
            }
        }
    }
}

// A road with a roof so low that it comes between the hard points and where their rays start.
constexpr double kLowRoof = kHeight + 0.15;
using Fill = std::function<void(btTriangleMesh&)>;
void addSheet(btTriangleMesh& mesh, double height, double from, double to, bool up = true) {
    addGrid(mesh, 2, 2, [&](int i, int j) { return vector((i == 0) == up ? -5 : 5, height, j == 0 ? from : to); });
}
struct Roof {
    std::string name;
    Fill add;
};
const std::array<Roof, 4> kRoofs{
    Roof{"ceiling", [](btTriangleMesh& mesh) { addSheet(mesh, kLowRoof, 5, 15, false); }},
    {"awning", [](btTriangleMesh& mesh) { addSheet(mesh, kLowRoof, 5, 15); }},
    {"thin bridge", [](btTriangleMesh& mesh) { addBlock(mesh, vector(5, 0.02, 5), vector(0, kLowRoof + 0.02, 10)); }},
    {"thick bridge", [](btTriangleMesh& mesh) { addBlock(mesh, vector(5, 1, 5), vector(0, kLowRoof + 1, 10)); }}};

// Drives under the roof at 10 m/s.
template <class Vehicle>
double straysUnder(World& world) {
    NarrowCar<Vehicle> car(world, {.speed = 10, .place = at(0, 0, -25)}, -0.15);
    run(world, 2, 60);
    EXPECT_LT(car.place().z(), 0);
    const double strayed = strays(world, car, 3);
    EXPECT_GT(car.place().z(), 20);
    return strayed;
}

TEST(RaycastVehicleTunnel, OfOneMeshWithItsRoadIsDrivenThroughAsByTheStockVehicle) {
    for (const Roof& roof : kRoofs) {
        SCOPED_TRACE(roof.name);
        World world;
        world.add(std::make_unique<Mesh>([&](btTriangleMesh& mesh) {
            addSheet(mesh, 0, -40, 60);
            roof.add(mesh);
        }));
        EXPECT_LT(straysUnder<btRaycastVehicle>(world), 0.005);
        EXPECT_LT(straysUnder<RaycastVehicle>(world), 0.005);
    }
}

TEST(RaycastVehicleTunnel, OverAnotherRoadIsDrivenThrough) {
    for (const Roof& roof : kRoofs) {
        if (roof.name == "awning") continue;  // the same as a hill without a bottom
        SCOPED_TRACE(roof.name);
        World world;
        world.addPlane();
        world.add(std::make_unique<Mesh>(roof.add));
        EXPECT_LT(straysUnder<RaycastVehicle>(world), 0.005);
    }
}

TEST(RaycastVehicleTunnel, OfOneCompoundWithItsRoadIsDrivenThrough) {
    for (double thick : {0.04, 2.0}) {
        World world;
        auto tunnel = std::make_unique<Compound>();
        tunnel->with(at(0, -1, 20), box(vector(5, 1, 60)));
        tunnel->with(at(0, kLowRoof + 0.5 * thick, 10), box(vector(5, 0.5 * thick, 5)));
        world.add(std::move(tunnel));
        EXPECT_LT(straysUnder<RaycastVehicle>(world), 0.005);
    }
}

// ---- Obstacles that wheels start in

// All wheels start in an obstacle whose top is 15 cm above their hard points, on a plane, and the chassis above it.
constexpr double kTop = kHeight + 0.15;
double endsAt(World& world) {
    NarrowCar<RaycastVehicle> car(world, {}, 0.5);
    car.brake(100);
    run(world, 8, 60);
    return car.place().y();
}

TEST(RaycastVehicleObstacle, ThatWheelsStartInLetsThemOut) {
    for (const Kind& kind : kBlocks) {
        SCOPED_TRACE(kind.name);
        World world;
        world.addPlane();
        world.add(kind.make(vector(4, 0.5 * kTop, 4)), 0, vector(0, 0.5 * kTop, 0));
        EXPECT_NEAR(endsAt(world), kTop + kHeight, 0.002);
    }
}

TEST(RaycastVehicleObstacle, WithoutABottomLetsThemOut) {
    World world;
    world.addPlane();
    world.add(std::make_unique<Mesh>([](btTriangleMesh& mesh) { addSheet(mesh, kTop, -5, 5); }));
    EXPECT_NEAR(endsAt(world), kTop + kHeight, 0.002);
}

TEST(RaycastVehicleObstacle, OfOneCompoundWithItsRoadLetsThemOut) {
    World world;
    auto ground = std::make_unique<Compound>();
    ground->with(at(0, -1, 0), box(vector(40, 1, 40)));
    ground->with(at(0, 0.5 * kTop, 0), hull(vector(4, 0.5 * kTop, 4)));
    world.add(std::move(ground));
    EXPECT_NEAR(endsAt(world), kTop + kHeight, 0.002);
}

TEST(RaycastVehicleObstacle, OfAHeightFieldLetsThemOut) {
    World world;
    world.addPlane();
    const std::vector<float> heights(400, float(kTop));
    world.add(std::make_unique<btHeightfieldTerrainShape>(20, 20, heights.data(), -float(kTop), float(kTop), 1, false));
    EXPECT_NEAR(endsAt(world), kTop + kHeight, 0.002);
}

TEST(RaycastVehicleObstacle, ThatMovesIsNoGroundFromInside) {
    for (const Kind& kind : kBlocks) {
        SCOPED_TRACE(kind.name);
        World world;
        world.addPlane();
        constexpr double kBottom = -0.3;  // below the plane
        make(world.add(kind.make(vector(4, 0.5 * (kTop - kBottom), 4)), 0, vector(0, 0.5 * (kTop + kBottom), 0)),
             Moves::byGame);
        EXPECT_NEAR(endsAt(world), kHeight, 0.002);
    }
}

// ---- Hard landings

// Ends at its height when it comes down so fast that the hard points are 10 cm below the ground.
double landsAt(World& world) {
    NarrowCar<RaycastVehicle> car(world, {}, 0.6);
    car.chassis->setWorldTransform(at(0, -0.1, 0));
    car.chassis->setLinearVelocity(vector(0, -2, 0));
    car.brake(100);
    run(world, 8, 60);
    return car.place().y();
}

// Calls `on` with name, shape and place of each kind of level ground at height 0.
void everyGround(const auto& on) {
    on("plane", std::make_unique<btStaticPlaneShape>(vector(0, 1, 0), scalar(0)), vector(0, 0, 0));
    for (const Kind& kind : kBlocks) on(kind.name, kind.make(vector(20, 5, 20)), vector(0, -5, 0));
    const auto sheet = [](bool up) {
        return std::make_unique<Mesh>([&](btTriangleMesh& mesh) { addSheet(mesh, 0, -20, 20, up); });
    };
    on("mesh without a bottom", sheet(true), vector(0, 0, 0));
    on("mesh whose faces look down", sheet(false), vector(0, 0, 0));
    const std::vector<float> heights(400, 0.f);
    on("height field", std::make_unique<btHeightfieldTerrainShape>(20, 20, heights.data(), -1.f, 1.f, 1, false),
       vector(0, 0, 0));
}

TEST(RaycastVehicleLanding, BelowTheGroundIsCarried) {
    everyGround([](const std::string& name, Shape shape, const btVector3& place) {
        SCOPED_TRACE(name);
        World world;
        world.add(std::move(shape), 0, place);
        EXPECT_NEAR(landsAt(world), kHeight, 0.002);
    });
}

TEST(RaycastVehicleLanding, OnAHeavyPlatformStandsAsHighAsTheStockVehicle) {
    const auto stands = []<class Vehicle>(Vehicle*) {
        World world;
        world.addPlane();
        world.addBox(5, 0.5, 5, 50000, vector(0, 0.5, 0));
        Car<Vehicle> car(world, {.place = at(0, 1.2, 0)});
        run(world, 4, 60);
        return static_cast<double>(car.place().y());
    };
    const double stock = stands(static_cast<btRaycastVehicle*>(nullptr));
    EXPECT_NEAR(stock, 1 + kHeight, 0.01);
    EXPECT_NEAR(stands(static_cast<RaycastVehicle*>(nullptr)), stock, 0.003);
}

// ---- Rolled over

// A car that lies on its roof, with the ground between the hard points and where their rays start.
template <class Vehicle>
void expectToLieOnItsRoof(World& world) {
    Car<Vehicle> car(world);
    car.chassis->setWorldTransform(btTransform(btQuaternion(vector(0, 0, 1), scalar(M_PI)), vector(0, 0.26, 0)));
    for (int i = 0; i < 180; ++i) {
        run(world, 1.0 / 60, 60);
        EXPECT_NEAR(car.place().y(), 0.25, 0.05);
        for (int wheel = 0; wheel < 4; ++wheel) {
            EXPECT_FALSE(car.vehicle->getWheelInfo(wheel).m_raycastInfo.m_isInContact);
            EXPECT_EQ(car.vehicle->getWheelInfo(wheel).m_wheelsSuspensionForce, 0);
        }
        if (testing::Test::HasFailure()) return;
    }
}

TEST(RaycastVehicleRoof, LiesOnTheGroundWithoutItsWheelsAsThatOfTheStockVehicle) {
    everyGround([](const std::string& name, Shape shape, const btVector3& place) {
        SCOPED_TRACE(name);
        World world;
        world.add(std::move(shape), 0, place);
        expectToLieOnItsRoof<btRaycastVehicle>(world);
        expectToLieOnItsRoof<RaycastVehicle>(world);
    });
}

// ---- What collides with what

// A step 10 cm high, of a group of its own, that a car comes to at 5 m/s: how high it gets.
template <class Vehicle>
double climbs(int group, int mask, const std::function<void(Vehicle&)>& set = {}) {
    World world;
    world.addPlane();
    btBoxShape shape(vector(5, 0.1, 5));
    btRigidBody step(0, nullptr, &shape);
    step.setWorldTransform(at(0, 0, 15));
    world.dynamics.addRigidBody(&step, group, mask);
    Car<Vehicle> car(world, {.speed = 5});
    if (set) set(*car.vehicle);
    run(world, 1, 60);
    const double climbed = strays(world, car, 2);
    world.dynamics.removeRigidBody(&step);
    return climbed;
}

TEST(RaycastVehicleFilter, IsThatOfTheStockVehicleUnlessSet) {
    constexpr int kOwn = 64, kAll = btBroadphaseProxy::AllFilter;
    constexpr int kNotDefault = kAll ^ btBroadphaseProxy::DefaultFilter;
    EXPECT_GT(climbs<btRaycastVehicle>(kOwn, kAll), 0.09);
    EXPECT_GT(climbs<RaycastVehicle>(kOwn, kAll), 0.09);
    EXPECT_LT(climbs<btRaycastVehicle>(kOwn, kNotDefault), 0.01);
    EXPECT_LT(climbs<RaycastVehicle>(kOwn, kNotDefault), 0.01);
    const auto set = [&](int group, int mask) {
        return climbs<RaycastVehicle>(kOwn, kNotDefault,
                                      [=](RaycastVehicle& vehicle) { vehicle.setCollisionFilter(group, mask); });
    };
    EXPECT_GT(set(kOwn, kAll), 0.09);
    EXPECT_LT(set(kOwn, kNotDefault ^ kOwn), 0.01);
}

TEST(BulletRoadFilter, IsThatOfAnyRayOfBullets) {
    constexpr int kAll = btBroadphaseProxy::AllFilter, kOwn = 64;
    for (int mask : {kAll, kAll ^ btBroadphaseProxy::DefaultFilter}) {
        World world;
        world.addPlane();
        btBoxShape shape(vector(5, 0.1, 5));
        btCollisionObject step, own;
        step.setCollisionShape(&shape);
        world.dynamics.addCollisionObject(&step, kOwn, mask);
        btCollisionWorld::ClosestRayResultCallback ray(vector(1, 1, 1), vector(1, -1, 1));
        world.dynamics.rayTest(ray.m_rayFromWorld, ray.m_rayToWorld, ray);
        const BulletRoad road(world.dynamics, own, Vector3::UnitY(), 2);
        EXPECT_NEAR(road.contact({1, 0.5, 1}, 0).point_W.y(), ray.m_hitPointWorld.y(), 1e-6);
        EXPECT_NEAR(ray.m_hitPointWorld.y(), mask == kAll ? 0.1 : 0, 1e-6);
        world.dynamics.removeCollisionObject(&step);
    }
}

}  // namespace
}  // namespace tread::raycast_ground_test
