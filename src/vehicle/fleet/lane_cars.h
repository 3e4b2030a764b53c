// Cars in lanes, for step.h; to be included after TREAD_ISA is set: compiled once per instruction set.
//
// Functions of other files that are compiled for every processor (steering, driveline, brakes, roads) are called, but
// none that the linker could take from here: no inline function outside of TREAD_ISA is left uninlined.
#pragma once

#include <bit>
#include <cstring>

#include "tyre/contact_patch.h"
#include "vehicle/fleet/lane_kind.h"
#include "vehicle/fleet/lane_numbers.h"
#include "vehicle/step.h"

namespace tread {
inline namespace TREAD_ISA {

template <class T>
struct LaneCars : LaneNumbers<T> {
    const Vehicle* cars[kLanesOf<T>];
    // Of any of the cars; one that has not such tyres gets what leaves it as it is.
    static constexpr bool tyres_warm = true;
    bool tyres_shifted, warmth_felt;
};

template <class T>
struct LaneState {
    PerWheel<BasicWheelState<T>> wheels;
    std::array<T, 3> acceleration_W, angular_acceleration_W;
    VehicleState* states[kLanesOf<T>];  // where the rest of it is
};

template <class T>
struct LaneRoads {
    const Road* roads[kLanesOf<T>];
    std::array<T, std::tuple_size_v<GroundNumbers>> plane;
    bool planes;  // each lane's road is one

    LaneGround<T> contact(const LaneVector<T>& centre_W, std::size_t wheel) const {
        if (planes) return ground(plane);
        std::array<T, std::tuple_size_v<GroundNumbers>> asked;
        GroundNumbers one;
        for (std::size_t i = 0; i < kLanesOf<T>; ++i) {
            askRoad(*roads[i], {lane(centre_W.x(), i), lane(centre_W.y(), i), lane(centre_W.z(), i)}, wheel, one);
            for (std::size_t k = 0; k < asked.size(); ++k) setLane(asked[k], i, one[k]);
        }
        return ground(asked);
    }

private:
    static LaneGround<T> ground(const std::array<T, std::tuple_size_v<GroundNumbers>>& n) {
        return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}, n[9], n[10] != T(0)};
    }
};

// ---- The cars of step.h ----

template <class T>
VehicleState& stateOf(LaneState<T>& state, std::size_t i) {
    return *state.states[i];
}
template <class T>
const Vehicle& carOf(const LaneCars<T>& cars, std::size_t i) {
    return *cars.cars[i];
}
template <class T>
const VehicleParams& paramsOf(const LaneCars<T>& cars, std::size_t i) {
    return cars.cars[i]->params;
}
// Wheels that recede are not computed in lanes.
template <class T>
void advanceRecession(PerWheel<BasicWheelState<T>>&, const LaneCars<T>&, double) {}
template <class T>
void recede(BasicTyreMotion<T>&, const LaneCars<T>&, const BasicRecession<T>&, const BasicWheelContact<T>&) {}
template <class T>
void addRecession(BasicWrench<T>&, PerWheel<BasicWheelState<T>>&, const LaneCars<T>&,
                  const PerWheel<BasicWheelContact<T>>&, const BasicBodyFrame<T>&, double) {}

// One wheel of all cars after the other.
template <class T>
PerWheel<BasicTyreForces<T>> advanceTyres(PerWheel<BasicWheelState<T>>& wheels, const LaneCars<T>& cars,
                                          TyreStep<T>& step, double dt) {
    if (cars.tyres_shifted) shiftMotions(step.begin, step.end, cars);
    if (cars.warmth_felt) applyWarmth(step.factors, wheels, cars);
    PerWheel<BasicTyreForces<T>> forces;
    for (std::size_t i = 0; i < kWheels; ++i) {
        const auto& tyre = cars.corners[i].tyre;
        BasicTyreScaling<T> lambda = tyre.lambda;
        lambda.mux *= step.factors[i].friction;
        lambda.muy *= step.factors[i].friction;
        lambda.Kx *= step.factors[i].stiffness;
        lambda.Ky *= step.factors[i].stiffness;
        forces[i] = advance<T>(wheels[i].tyre, wheels[i].spin, TyreOf<T>{tyre.parameters, lambda}, step.begin[i],
                               step.end[i], FreeSpin<T>{step.torques[i]}, dt, Standstill::hold);
    }
    return forces;
}

// ---- Between numbers of one car and lanes ----

// Members of a struct of nothing but numbers, as lanes and of one car.
template <class T, class Lanes>
void setCar(Lanes& lanes, std::size_t i, const void* car) {
    constexpr std::size_t kMembers = sizeof(Lanes) / sizeof(T);
    double members[kMembers];
    std::memcpy(members, car, sizeof(members));
    T* to = reinterpret_cast<T*>(&lanes);
    for (std::size_t k = 0; k < kMembers; ++k) setLane(to[k], i, members[k]);
}
template <class T, class Lanes>
void getCar(const Lanes& lanes, std::size_t i, void* car) {
    constexpr std::size_t kMembers = sizeof(Lanes) / sizeof(T);
    double members[kMembers];
    const T* from = reinterpret_cast<const T*>(&lanes);
    for (std::size_t k = 0; k < kMembers; ++k) members[k] = lane(from[k], i);
    std::memcpy(car, members, sizeof(members));
}

template <class T>
struct LaneBlock {
    LaneCars<T> cars;
    LaneState<T> state;
    LaneMotion<T> motion;
    LaneRoads<T> roads;
    std::array<T, 3> wind_W;
    struct {
        bool tyres_shifted, warmth_felt, plane;
    } of_lane[kLanesOf<T>];

    static LaneBlock& at(void* memory) { return *static_cast<LaneBlock*>(memory); }
    static const LaneBlock& at(const void* memory) { return *static_cast<const LaneBlock*>(memory); }

    static void prepare(void* memory, std::size_t i, const LaneCar& car) {
        LaneBlock& block = at(memory);
        static_assert(sizeof(LaneNumbers<T>) == kLaneNumbers * sizeof(T));
        setCar<T>(static_cast<LaneNumbers<T>&>(block.cars), i, car.numbers);
        block.cars.cars[i] = car.vehicle;
        block.of_lane[i].tyres_shifted = car.tyres_shifted;
        block.of_lane[i].warmth_felt = car.warmth_felt;
        block.cars.tyres_shifted = block.cars.warmth_felt = false;
        for (const auto& lane : block.of_lane) {
            block.cars.tyres_shifted |= lane.tyres_shifted;
            block.cars.warmth_felt |= lane.warmth_felt;
        }
    }

    static void load(void* memory, std::size_t i, const LaneCar& car) {
        LaneBlock& block = at(memory);
        block.state.states[i] = car.state;
        setCar<T>(block.state.wheels, i, &car.state->wheels);
        setCar<T>(block.state.acceleration_W, i, &car.state->acceleration_W);
        setCar<T>(block.state.angular_acceleration_W, i, &car.state->angular_acceleration_W);
        move(memory, i, car);
        blow(memory, i, car.wind_W);
        block.roads.roads[i] = car.road;
        block.of_lane[i].plane = car.plane != nullptr;
        if (car.plane) setCar<T>(block.roads.plane, i, car.plane);
        block.roads.planes = true;
        for (const auto& lane : block.of_lane) block.roads.planes &= lane.plane;
    }

    static void move(void* memory, std::size_t i, const LaneCar& car) {
        static_assert(sizeof(MotionNumbers) / sizeof(double) == sizeof(LaneMotion<T>) / sizeof(T));
        LaneBlock& block = at(memory);
        setCar<T>(block.motion, i, &car.motion);
        for (std::size_t k = 0; k < kWheels; ++k) setLane(block.state.wheels[k].rate, i, car.state->wheels[k].rate);
    }

    static void blow(void* memory, std::size_t i, const std::array<double, 3>& wind_W) {
        setCar<T>(at(memory).wind_W, i, &wind_W);
    }

    static void step(void* memory, const VehicleInput* begin, const VehicleInput* end,
                     const std::array<double, 3>& gravity_W, double dt) {
        LaneBlock& block = at(memory);
        const BasicSurroundings<T, LaneRoads<T>> surroundings{
            block.roads, LaneVector<T>(gravity_W[0], gravity_W[1], gravity_W[2]), toVector(block.wind_W)};
        tread::step<T>(block.motion, block.state, block.cars, Inputs{begin, end}, surroundings, dt);
    }

    static void glance(const void* memory, std::size_t i, LaneCar& car) {
        const LaneBlock& block = at(memory);
        for (std::size_t k = 0; k < kWheels; ++k) {
            car.state->wheels[k].spin = lane(block.state.wheels[k].spin, i);
            car.state->wheels[k].rate = lane(block.state.wheels[k].rate, i);
        }
        getCar<T>(block.state.acceleration_W, i, &car.state->acceleration_W);
        getCar<T>(block.state.angular_acceleration_W, i, &car.state->angular_acceleration_W);
        getCar<T>(block.motion, i, &car.motion);
    }

    static void store(const void* memory, std::size_t i, LaneCar& car) {
        glance(memory, i, car);
        getCar<T>(at(memory).state.wheels, i, &car.state->wheels);
    }
};

template <class T>
inline constexpr LaneKind kKindOf{.lanes = kLanesOf<T>,
                                  .bytes = sizeof(LaneBlock<T>),
                                  .alignment = alignof(LaneBlock<T>),
                                  .prepare = LaneBlock<T>::prepare,
                                  .load = LaneBlock<T>::load,
                                  .move = LaneBlock<T>::move,
                                  .blow = LaneBlock<T>::blow,
                                  .step = LaneBlock<T>::step,
                                  .glance = LaneBlock<T>::glance,
                                  .store = LaneBlock<T>::store};

}  // namespace TREAD_ISA
}  // namespace tread
