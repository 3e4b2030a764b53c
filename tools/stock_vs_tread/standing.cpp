// A car that should stand still.
#include <algorithm>
#include <cmath>

#include "problems.h"
#include "scene.h"

namespace problems {
namespace {

using namespace scene;

// Millimetres that a braked car moves in a minute on a slope of 20 %; heading 0 is nose up. The slope is gravity's.
template <class Vehicle>
double creep(double rate, double heading) {
    World world;
    world.addPlane();
    const double slope = std::atan(0.2);
    world.dynamics.setGravity(scalar(kGravity) * vector(-std::sin(slope) * std::sin(heading), -std::cos(slope),
                                                        -std::sin(slope) * std::cos(heading)));
    Car<Vehicle> car(world);
    car.brake(5000);
    run(world, 3, rate);
    const btVector3 before = car.place();
    run(world, 60, rate);
    return 1000 * static_cast<double>((car.place() - before).length());
}

template <class Vehicle>
double worstCreep(double heading) {
    return std::max({creep<Vehicle>(30, heading), creep<Vehicle>(60, heading), creep<Vehicle>(1000, heading)});
}

// Millimetres between the highest and the lowest place of a braked car on a large box.
template <class Vehicle>
double shaking() {
    World world;
    world.addBox(150, 0.5, 150, 0, vector(0, -0.5, 0));
    Setup setup;
    setup.place.setOrigin(vector(37, 0, 21));
    Car<Vehicle> car(world, setup);
    car.brake(5000);
    run(world, 3, 60);
    double lowest = 1e9, highest = -1e9;
    for (int i = 0; i < 300; ++i) {
        run(world, 1.0 / 60, 60);
        lowest = std::min(lowest, static_cast<double>(car.place().y()));
        highest = std::max(highest, static_cast<double>(car.place().y()));
    }
    return 1000 * (highest - lowest);
}

// Metres that a car drives in three seconds after it has fallen asleep.
template <class Vehicle>
double driveOffFromSleep() {
    World world;
    world.addPlane();
    Setup setup;
    setup.sleeps = true;
    Car<Vehicle> car(world, setup);
    car.brake(50);
    run(world, 6, 60);
    if (car.chassis->isActive()) return std::nan("");  // it does not even sleep
    const btVector3 before = car.place();
    car.brake(0);
    car.push(4000);
    run(world, 3, 60);
    return static_cast<double>((car.place() - before).z());
}

}  // namespace

void standing(Rows& rows) {
    const double sideways = std::acos(-1.0) / 2;
    rows.push_back({"parked on a slope of 20 %, nose up: moves in a minute (worst of 30, 60, 1000 Hz)",
                    worstCreep<btRaycastVehicle>(0), worstCreep<tread::RaycastVehicle>(0), "mm", 0, 0.5});
    rows.push_back({"the same, at 45 degrees", worstCreep<btRaycastVehicle>(sideways / 2),
                    worstCreep<tread::RaycastVehicle>(sideways / 2), "mm", 0, 0.5});
    rows.push_back({"the same, sideways", worstCreep<btRaycastVehicle>(sideways),
                    worstCreep<tread::RaycastVehicle>(sideways), "mm", 0, 0.5});
    rows.push_back({"shaking at standstill on a box of 300 m", shaking<btRaycastVehicle>(),
                    shaking<tread::RaycastVehicle>(), "mm", 0, 0.05});
    rows.push_back({"engine force on a car that sleeps: drives in 3 s", driveOffFromSleep<btRaycastVehicle>(),
                    driveOffFromSleep<tread::RaycastVehicle>(), "m", 11, 12.5});
}

}  // namespace problems
