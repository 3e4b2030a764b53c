// Cars that are advanced together, one in each lane (base/math/lanes.h): what others need of it. A set of instructions
// brings its own kind of lanes, compiled apart; nothing but plain numbers and pointers passes between.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "tread/vehicle.h"

namespace tread {

// Position, attitude (w x y z), velocity, angular velocity.
using MotionNumbers = std::array<double, 13>;
// Point and normal of the road's plane, velocity of the ground, friction, 1 where there is a road.
using GroundNumbers = std::array<double, 11>;

// The car of one lane.
struct LaneCar {
    const Vehicle* vehicle;
    const double* numbers;  // of the vehicle: lane_numbers.h
    VehicleState* state;
    MotionNumbers motion;
    const Road* road;
    std::array<double, 3> wind_W;
    bool tyres_shifted, warmth_felt;  // as in Vehicle
    const GroundNumbers* plane;       // that the road is everywhere; nullptr: it has to be asked
};

// What is done with a block of memory in which cars are in lanes; it starts filled with zeros. Every lane has a car
// before the first step.
struct LaneKind {
    std::size_t lanes, bytes, alignment;
    void (*prepare)(void* block, std::size_t lane, const LaneCar& car);  // takes a car
    void (*load)(void* block, std::size_t lane, const LaneCar& car);     // takes its state, road and wind
    void (*move)(void* block, std::size_t lane, const LaneCar& car);     // takes its motion and the rates of its wheels
    void (*blow)(void* block, std::size_t lane, const std::array<double, 3>& wind_W);
    // All cars; what the driver does is given for each.
    void (*step)(void* block, const VehicleInput* begin, const VehicleInput* end,
                 const std::array<double, 3>& gravity_W, double dt);
    // Gives motion, rates of the wheels, and what glance() of vehicle.h reads.
    void (*glance)(const void* block, std::size_t lane, LaneCar& car);
    void (*store)(const void* block, std::size_t lane, LaneCar& car);  // gives state and motion
};

// Memory for a block.
std::shared_ptr<void> memoryFor(const LaneKind& kind);

// The widest kind that this processor has, up to so many lanes; nullptr: none that is quicker than one car after the
// other.
const LaneKind* laneKind(std::size_t most_lanes);

// Lanes cost about as much as so many single cars: with fewer cars they do not pay.
inline constexpr std::size_t kLanesPay = 3;

// Whether a car can be computed in a lane: what is rare is left to single cars.
bool fitsInLane(const Vehicle& vehicle);

// What a road is everywhere; nothing when it has to be asked.
std::optional<GroundNumbers> planeOf(const Road& road);

std::vector<double> numbersOf(const Vehicle& vehicle);
MotionNumbers numbersOf(const ChassisMotion& motion);
ChassisMotion motionOf(const MotionNumbers& numbers);
GroundNumbers numbersOf(const RoadContact& contact);
void askRoad(const Road& road, const std::array<double, 3>& centre_W, std::size_t wheel, GroundNumbers& ground);

}  // namespace tread
