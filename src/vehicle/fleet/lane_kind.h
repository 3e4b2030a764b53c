// Cars that are advanced together, one in each lane (base/lanes.h): what the fleet needs of it. A set of instructions
// brings its own kind of lanes, compiled apart; nothing but plain numbers and pointers passes between.
#pragma once

#include <array>
#include <cstddef>
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

struct LaneKind {
    std::size_t lanes, bytes, alignment;
    void (*prepare)(void* block, const LaneCar* cars);  // takes the cars
    void (*load)(void* block, const LaneCar* cars);     // takes their states, roads and winds
    void (*step)(void* block, const VehicleInput* begin, const VehicleInput* end,
                 const std::array<double, 3>& gravity_W, double dt);
    void (*store)(const void* block, LaneCar* cars);  // gives the states back
};

// The widest kind that this processor has, up to so many lanes; nullptr: none that is quicker than one car after the
// other.
const LaneKind* laneKind(std::size_t most_lanes);

// Whether a car can be computed in a lane: what is rare is left to single cars.
bool fitsInLane(const Vehicle& vehicle);

std::vector<double> numbersOf(const Vehicle& vehicle);
MotionNumbers numbersOf(const ChassisMotion& motion);
ChassisMotion motionOf(const MotionNumbers& numbers);
GroundNumbers numbersOf(const RoadContact& contact);
void askRoad(const Road& road, const std::array<double, 3>& centre_W, std::size_t wheel, GroundNumbers& ground);

}  // namespace tread
