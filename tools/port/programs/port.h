// What the programs of this folder share. Each is compiled twice: on Bullet's stock vehicle (PORT_STOCK) and on
// tread's, from the same source. Each prints its figures, `name value`; on tread it reads the figures of stock from the
// file that its argument names and compares.
#pragma once

#include <btBulletDynamicsCommon.h>
#ifndef PORT_STOCK
#include <tread/raycast_vehicle.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

#ifdef PORT_STOCK
using Vehicle = btRaycastVehicle;
#else
using Vehicle = tread::RaycastVehicle;
#endif

namespace port {

constexpr double kGravity = 9.81;  // m/s2

inline btScalar scalar(double x) {
    return static_cast<btScalar>(x);
}
inline btVector3 vector(double x, double y, double z) {
    return {scalar(x), scalar(y), scalar(z)};
}
inline double share(double value, double of) {
    return std::abs(value) * of;
}

// ---- Figures -------------------------------------------------------------------------------------------------------

class Report {
public:
    Report(int arguments, char** argument) : stock_(arguments > 1 ? std::fopen(argument[1], "r") : nullptr) {
#ifndef PORT_STOCK
        if (!stock_) wrong("no file with the figures of stock: give it as argument");
#endif
    }
    ~Report() {
        if (stock_) std::fclose(stock_);
    }
    Report(const Report&) = delete;
    Report& operator=(const Report&) = delete;

    // On tread as on stock, but for `difference`, in the figure's own unit.
    void near(const char* name, double value, double difference) {
        const double stock = ofStock(name, value);
        judge(name, value, stock - difference, stock + difference);
    }
    // The same, but for a share of stock's figure.
    void like(const char* name, double value, double part) {
        near(name, value, share(ofStock(name, value), part));
    }
    // Where tread rightly differs from stock, or stock has no say: what physics gives. Stock is not judged.
    void within(const char* name, double value, double lowest, double highest) {
#ifdef PORT_STOCK
        lowest = highest = value;
#endif
        judge(name, value, lowest, highest);
    }

    // Stock's figure; on stock its own.
    double ofStock(const char* name, double on_stock) {
        if (!stock_) return on_stock;
        char line[200], found[100];
        double value = 0;
        std::rewind(stock_);
        while (std::fgets(line, sizeof line, stock_))
            if (std::sscanf(line, "%99s %lf", found, &value) == 2 && std::strcmp(found, name) == 0) return value;
        wrong("stock has no such figure:");
        return std::nan("");
    }

    int status() const {
        return good_ ? 0 : 1;
    }

private:
    void judge(const char* name, double value, double lowest, double highest) {
        const bool met = value >= lowest && value <= highest;
        if (met) std::printf("%s %.17g\n", name, value);
        else std::printf("%s %.17g  <-- must be %g to %g\n", name, value, lowest, highest);
#ifndef PORT_STOCK
        good_ &= met;
#endif
    }
    void wrong(const char* what) {
        std::printf("%s\n", what);
        good_ = false;
    }
    std::FILE* stock_;
    bool good_ = true;
};

// ---- World ---------------------------------------------------------------------------------------------------------

class World {
public:
    explicit World(const btVector3& gravity = vector(0, -kGravity, 0)) { dynamics.setGravity(gravity); }
    ~World() {
        for (auto& body : bodies_) dynamics.removeRigidBody(body.get());
    }
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    // A body that the world keeps; without mass it does not move.
    btRigidBody& add(std::unique_ptr<btCollisionShape> shape, double mass, const btVector3& at) {
        btVector3 inertia(0, 0, 0);
        if (mass > 0) shape->calculateLocalInertia(scalar(mass), inertia);
        btRigidBody::btRigidBodyConstructionInfo info(scalar(mass), nullptr, shape.get(), inertia);
        info.m_startWorldTransform.setOrigin(at);
        bodies_.push_back(std::make_unique<btRigidBody>(info));
        shapes_.push_back(std::move(shape));
        dynamics.addRigidBody(bodies_.back().get());
        return *bodies_.back();
    }
    btRigidBody& addPlane(const btVector3& up = vector(0, 1, 0)) {
        return add(std::make_unique<btStaticPlaneShape>(up, scalar(0)), 0, vector(0, 0, 0));
    }
    btRigidBody& addBox(const btVector3& half, double mass, const btVector3& at) {
        return add(std::make_unique<btBoxShape>(half), mass, at);
    }
    // As a game does that draws `rate` pictures a second.
    void step(double rate) { dynamics.stepSimulation(scalar(1 / rate), 0); }
    void run(double seconds, double rate = 60) {
        for (int i = 0, n = static_cast<int>(seconds * rate + 0.5); i < n; ++i) step(rate);
    }

private:
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;

public:
    btDiscreteDynamicsWorld dynamics{&dispatcher_, &broadphase_, &solver_, &configuration_};
};

// ---- Car -----------------------------------------------------------------------------------------------------------

struct Axle {
    double forward;  // m, of the chassis' centre
    double left;     // m, of its left wheel
    bool steered;
};

// 1500 kg with springs of 60 kN/m, y up and z forward as in Bullet's demos, unless a program says otherwise.
struct CarNumbers {
    double mass = 1500;                     // kg
    btVector3 half = vector(0.8, 0.25, 2);  // m
    std::vector<Axle> axles = {{1.35, 0.75, true}, {-1.35, 0.75, false}};
    double radius = 0.3;      // m
    double rest = 0.3;        // m, length of the suspension
    double stiffness = 40;    // 1/s2
    double damping = 4.4;     // 1/s
    double slip = 1;          // m_frictionSlip
    double most_force = 1e5;  // N
    double roll_influence = 0.1;

    // Height of the chassis' centre at rest, its wheels being hung there: each spring carries its part.
    double height() const { return radius + rest - kGravity / (2 * static_cast<double>(axles.size()) * stiffness); }
    btRaycastVehicle::btVehicleTuning tuning() const {
        btRaycastVehicle::btVehicleTuning t;
        t.m_suspensionStiffness = scalar(stiffness);
        t.m_suspensionCompression = t.m_suspensionDamping = scalar(damping);
        t.m_frictionSlip = scalar(slip);
        t.m_maxSuspensionForce = scalar(most_force);
        return t;
    }
};

// Wheels left, right, left, right, from the front on.
inline void addWheels(btRaycastVehicle& vehicle, const CarNumbers& n) {
    vehicle.setCoordinateSystem(0, 1, 2);
    for (const Axle& axle : n.axles) {
        for (double side : {1.0, -1.0}) {
            btWheelInfo& wheel =
                vehicle.addWheel(vector(side * axle.left, 0, axle.forward), vector(0, -1, 0), vector(-1, 0, 0),
                                 scalar(n.rest), scalar(n.radius), n.tuning(), axle.steered);
            wheel.m_rollInfluence = scalar(n.roll_influence);
        }
    }
}

inline btRigidBody::btRigidBodyConstructionInfo chassisInfo(double mass, btCollisionShape& shape, const btVector3& at) {
    btVector3 inertia;
    shape.calculateLocalInertia(scalar(mass), inertia);
    btRigidBody::btRigidBodyConstructionInfo info(scalar(mass), nullptr, &shape, inertia);
    info.m_startWorldTransform.setOrigin(at);
    return info;
}

class Car {
public:
    Car(btDynamicsWorld& world, const CarNumbers& numbers = {}, const btVector3& ground = vector(0, 0, 0))
        : world_(world),
          numbers_(numbers),
          shape_(numbers.half),
          raycaster_(&world),
          chassis(chassisInfo(numbers.mass, shape_, ground + vector(0, numbers.height(), 0))),
          vehicle(numbers.tuning(), &chassis, &raycaster_) {
        chassis.setActivationState(DISABLE_DEACTIVATION);
        world.addRigidBody(&chassis);
        world.addVehicle(&vehicle);
        addWheels(vehicle, numbers);
    }
    ~Car() {
        world_.removeVehicle(&vehicle);
        world_.removeRigidBody(&chassis);
    }
    Car(const Car&) = delete;
    Car& operator=(const Car&) = delete;

    // N in all, forward.
    void push(double force) {
        for (int i = 0; i < vehicle.getNumWheels(); ++i)
            vehicle.applyEngineForce(scalar(force / vehicle.getNumWheels()), i);
    }
    void brake(double impulse) {
        for (int i = 0; i < vehicle.getNumWheels(); ++i) vehicle.setBrake(scalar(impulse), i);
    }
    // rad, of the steered wheels.
    void steer(double angle) {
        for (int i = 0; i < vehicle.getNumWheels(); ++i)
            if (numbers_.axles[static_cast<std::size_t>(i / 2)].steered) vehicle.setSteeringValue(scalar(angle), i);
    }
    btVector3 place() const { return chassis.getCenterOfMassPosition(); }
    double height() const { return place().y(); }
    double speed() const { return chassis.getLinearVelocity().dot(vehicle.getForwardVector()); }
    double yawRate() const { return chassis.getAngularVelocity().y(); }
    // 1 upright, 0 on its side.
    double upright() const { return chassis.getWorldTransform().getBasis()[1][1]; }

private:
    btDynamicsWorld& world_;
    CarNumbers numbers_;
    btBoxShape shape_;
    btDefaultVehicleRaycaster raycaster_;

public:
    btRigidBody chassis;
    Vehicle vehicle;
};

// Range of `value()` over a time, seen after each step.
struct Range {
    double lowest, highest;
    double width() const { return highest - lowest; }
};
template <class Value>
Range watch(World& world, double seconds, double rate, const Value& value) {
    Range range{value(), value()};
    for (int i = 0, n = static_cast<int>(seconds * rate + 0.5); i < n; ++i) {
        world.step(rate);
        range = {std::min(range.lowest, value()), std::max(range.highest, value())};
    }
    return range;
}

}  // namespace port
