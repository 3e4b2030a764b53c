// What a RaycastVehicle consists of, for the files that make up its step.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "bullet/body_link.h"
#include "bullet/drop_in/fetch_ahead.h"
#include "bullet/drop_in/raycast_state.h"
#include "bullet/drop_in/shared_cars.h"
#include "bullet/drop_in/stock_tuning.h"
#include "bullet/ground/wheel_ray.h"
#include "host/substep.h"
#include "tread/bullet_precision.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

// What a wheel shows of a step.
struct ShownWheel {
    double steer = 0;     // rad
    double length = 0;    // m, of the suspension
    double rotation = 0;  // rad
};

struct RaycastVehicle::Implementation {
    RaycastVehicle& face;
    btRigidBody& chassis;
    btVehicleRaycaster* raycaster;  // as the game gave it
    bool own_rays;                  // it is Bullet's default one, or none
    std::optional<VehicleParams> file;
    std::array<std::optional<TyreParams>, kMostWheels> own_tyres{};
    std::unique_ptr<SurfaceSource> surface{};
    RayFilter filter{};
    double edge_angle = Rounding{}.angle;
    Substep substep{1.0 / 30, 1.0 / 30};  // s: a frame of a game, down to 30 a second
    double grip = 1;
    bool wheel_reaction = false;

    // What the car was made of, and the car.
    CarRecipe recipe{};
    bool made = false;  // of the recipe, file and tyres
    MadeCar car = noCar();

    ChassisMotion motion{};
    BodyLink link{};
    bool teleported = false;              // before this step
    bool second = false;                  // of one step of the world
    double simulated = 0;                 // s, of this step; 0: it moved nothing
    ChassisMotion start{};                // where this step began
    ChassisMotion reached{};              // where it ended
    std::mutex* one_at_a_time = nullptr;  // of a fleet with threads: held while the game's own code is called
    double planned = 0;                   // s, length of the step that the chassis' velocity was planned for; asleep 0
    bool met = false;                     // it has stepped: the chassis was there
    bool showing_speed = false;           // Bullet's own step runs, without wheels
    const btCollisionWorld* world = nullptr;  // that steps the vehicle, while it does
    BodyLink given{};                         // the chassis' velocities as the last step left them,
    btTransform given_pose{};                 // and its pose
    Vector3 seen_velocity = Vector3::Zero();  // at the instant of the last step; `motion` is ahead of it
    Vector3 seen_angular_velocity = Vector3::Zero();
    WheeledBodyState state{};
    std::array<WheelDemand, kMostWheels> demands{};
    std::array<WheelGround, kMostWheels> grounds{};
    NearObjects around{};
    std::array<NearFaces, kMostWheels> near{};
    std::array<Vector3, kMostWheels> impulses{};  // N s, of the ground on the wheels over the last step
    std::array<btScalar, kMostWheels> shown_length{};
    std::array<ShownWheel, kMostWheels> drawn{};         // after the last step
    std::array<ShownWheel, kMostWheels> drawn_before{};  // after the one before
    double drawn_step = 0;                               // s, between them
    std::size_t wheels_drawn = 0;
    std::size_t wheels_before = 0;
    bool asleep = false;

    bool isIn(const btCollisionWorld& in) const;
    std::size_t wheelCount() const;
    btWheelInfo& info(std::size_t wheel) { return face.m_wheelInfo[static_cast<int>(wheel)]; }
    WheelDemand demand(std::size_t wheel);
    Vector3 gravity() const;

    // raycast_fetch.cpp: the memory of the car that steps next.
    std::size_t place_in_trail = 0;
    Footprint footprint();
    void fetchInputs(const Footprint& next) const;  // what `begin` needs
    void fetchState(const Footprint& next) const;   // what `drive` needs besides
    void fetchMember(const Footprint& next, const void* member, std::size_t bytes) const;

    // raycast_car.cpp: the car follows what the game changed.
    static const MadeCar& noCar();
    void makeCar();
    CarRecipe::Body bodyNow() const;
    bool isAsMade();
    WheeledBody carOf(const CarRecipe& from);

    // raycast_step.cpp
    void step(const btCollisionWorld* in, double dt);
    // The parts of a step. What changes what others see stands in `begin` and `finish`; `drive` only looks at the
    // world.
    bool begin(const btCollisionWorld* in, double dt);  // false: there is nothing to do
    void drive(const btCollisionWorld* in, double dt);
    void finish();
    void meetChassis(double dt);
    bool isSecondStep() const;
    void takeBackGravity(double dt);
    bool isTeleported(double dt) const;
    void takeUp(double dt);
    void lookDown(const btCollisionWorld* in, double dt);
    WheelRay rayOf(std::size_t wheel, double dt) const;
    bool isFarFromRay(std::size_t wheel) const;
    void findGround(std::size_t wheel, const WheelRay& ray, const btCollisionWorld* in);
    bool mayThrow(const btCollisionWorld* in) const;
    void driveUnguarded(const btCollisionWorld* in, double dt);
    void move(const btCollisionWorld* in, double dt);
    void pushGround();

    // raycast_sleep.cpp
    bool staysAsleep(const btCollisionWorld* in);
    void fallAsleepOrNot();

    // raycast_output.cpp
    void show(double dt);
    double instantDrawn() const;
    void showSpeed(double dt);

    // raycast_stock.cpp: Bullet's own step, where a game still calls it.
    void takeBackStock(double dt);
};

RaycastVehicle::Implementation& implementationOf(RaycastVehicle& vehicle);
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
