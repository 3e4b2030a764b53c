// Grip, wheel spin, and what the frame rate makes of them.
#include <algorithm>
#include <cmath>
#include <vector>

#include "problems.h"
#include "scene.h"

namespace problems {
namespace {

using namespace scene;

constexpr double kHundred = 100 / 3.6;  // m/s

// Largest deceleration of a full braking from 100 km/h, exactly straight, friction 1, in g.
template <class Vehicle>
double straightBraking() {
    World world;
    world.addPlane();
    Car<Vehicle> car(world, {.speed = kHundred});
    run(world, 1, 60);
    car.brake(5000);
    double most = 0;
    for (double before = car.velocity().z(); before > 1;) {
        run(world, 1.0 / 60, 60);
        most = std::max(most, (before - static_cast<double>(car.velocity().z())) * 60 / kGravity);
        before = car.velocity().z();
    }
    return most;
}

// Metres from 100 km/h to a stop with setBrake(50), as a game calls it, counted from the picture after the call: no
// vehicle can brake in a step that is already made.
template <class Vehicle>
double brakingDistance(double rate) {
    World world;
    world.addPlane();
    Car<Vehicle> car(world, {.speed = kHundred});
    run(world, 1, rate);
    car.brake(50);
    run(world, 1 / rate, rate);
    const double start = car.place().z();
    for (int i = 0; i < 15 * rate && car.velocity().z() > 0.01; ++i) run(world, 1 / rate, rate);
    return static_cast<double>(car.place().z()) - start;
}

template <class Vehicle>
double brakingSpread() {
    std::vector<double> distances;
    for (double rate : {30.0, 60.0, 120.0, 240.0, 1000.0}) distances.push_back(brakingDistance<Vehicle>(rate));
    const auto [least, most] = std::minmax_element(distances.begin(), distances.end());
    return 100 * (*most - *least) / *least;
}

// Heading every 50 ms after a step of 3 degrees at 20 m/s, from the `late`th step after it on.
template <class Vehicle>
std::vector<double> stepSteer(double rate, int late) {
    World world;
    world.addPlane();
    Car<Vehicle> car(world, {.speed = 20});
    run(world, 1, rate);
    std::vector<double> heading;
    const int sample = static_cast<int>(rate / 20 + 0.5);
    for (int i = 1; i <= 40 * sample + late; ++i) {
        // The wheels turn over 0.1 s, as fast as a game's keyboard makes them: the same course at every rate.
        car.steer(std::min(i / rate / 0.1, 1.0) * 3 * std::acos(-1.0) / 180);
        run(world, 1 / rate, rate);
        const btVector3 forward = car.chassis->getWorldTransform().getBasis().getColumn(2);
        if ((i - late) % sample == 0 && i > late)
            heading.push_back(std::atan2(static_cast<double>(forward.x()), static_cast<double>(forward.z())));
    }
    return heading;
}

// Largest difference of the yaw rates, means over 50 ms, at 60 Hz and at 1000 Hz, over the peak. What is steered before
// a step turns the car in that step or the next: the better of both readings counts.
template <class Vehicle>
double stepSteerDifference() {
    double least = 1e9;
    for (int late : {0, 1}) {
        const std::vector<double> coarse = stepSteer<Vehicle>(60, late), fine = stepSteer<Vehicle>(1000, late);
        double worst = 0, peak = 0;
        for (std::size_t i = 1; i < fine.size(); ++i) {
            worst = std::max(worst, std::abs(coarse[i] - coarse[i - 1] - fine[i] + fine[i - 1]));
            peak = std::max(peak, std::abs(fine[i] - fine[i - 1]));
        }
        least = std::min(least, 100 * worst / peak);
    }
    return least;
}

// Speed after two seconds of full brake and engine force together from a standstill.
template <class Vehicle>
double brakeAgainstEngine() {
    World world;
    world.addPlane();
    Car<Vehicle> car(world);
    run(world, 1, 60);
    car.brake(100);
    car.push(6000);
    run(world, 2, 60);
    return car.velocity().z();
}

// Rim speed over road speed of a driven wheel, averaged from 0.2 s to 0.7 s.
template <class Vehicle>
double rimOverRoad(double force, double brake, double speed) {
    World world;
    world.addPlane();
    Car<Vehicle> car(world, {.speed = speed});
    run(world, 1, 60);
    car.push(force);
    car.brake(brake);
    run(world, 0.2, 60);
    const double turned = car.vehicle->getWheelInfo(0).m_rotation, from = car.place().z();
    run(world, 0.5, 60);
    return 0.3 * (car.vehicle->getWheelInfo(0).m_rotation - turned) / (static_cast<double>(car.place().z()) - from);
}

// Largest sideways acceleration of a car with Bullet's default tuning of grip in a hard turn, in g.
template <class Vehicle>
double turning() {
    World world;
    world.addPlane();
    Car<Vehicle> car(world, {.friction = 10.5, .speed = 25});
    run(world, 1, 60);
    car.steer(0.2);
    double most = 0;
    for (int i = 0; i < 120; ++i) {
        const btVector3 before = car.velocity();
        run(world, 1.0 / 60, 60);
        const btVector3 right = car.chassis->getWorldTransform().getBasis().getColumn(0);
        most = std::max(most, std::abs(static_cast<double>((car.velocity() - before).dot(right))) * 60 / kGravity);
    }
    return most;
}

}  // namespace

void driving(Rows& rows) {
    using Stock = btRaycastVehicle;
    using Tread = tread::RaycastVehicle;
    rows.push_back({"full braking exactly straight, friction 1: peak deceleration", straightBraking<Stock>(),
                    straightBraking<Tread>(), "g", 0.8, 1.2});
    rows.push_back({"turn at 25 m/s with the default friction slip of 10.5: peak", turning<Stock>(), turning<Tread>(),
                    "g", 0.8, 1.3});
    rows.push_back({"stopping from 100 km/h, setBrake(50), 30 to 1000 Hz: spread", brakingSpread<Stock>(),
                    brakingSpread<Tread>(), "%", 0, 1});
    rows.push_back({"step steer at 20 m/s, yaw rate 60 Hz against 1000 Hz", stepSteerDifference<Stock>(),
                    stepSteerDifference<Tread>(), "%", 0, 1});
    rows.push_back({"brake and engine together from standstill: speed after 2 s", brakeAgainstEngine<Stock>(),
                    brakeAgainstEngine<Tread>(), "m/s", -0.01, 0.01});
    rows.push_back({"engine force of 2 g on friction 1: rim speed over road speed", rimOverRoad<Stock>(30000, 0, 1),
                    rimOverRoad<Tread>(30000, 0, 1), "-", 1.5, 100});
    rows.push_back({"full brake at 28 m/s: rim speed over road speed", rimOverRoad<Stock>(0, 400, kHundred),
                    rimOverRoad<Tread>(0, 400, kHundred), "-", -0.01, 0.01});
}

}  // namespace problems
