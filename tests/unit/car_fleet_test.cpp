// A fleet's cars do what they do alone.
#include "tread/car_fleet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <stdexcept>

#include "shared/equipped_car.h"
#include "shared/vehicles.h"

namespace tread {
namespace {

constexpr double kStep = 0.001;  // s

// What a fleet promises to reproduce, computed without one.
struct Alone {
    Vehicle vehicle;
    std::shared_ptr<const Road> road;
    ChassisMotion motion{};
    VehicleState state{};
    VehicleInput input{};

    Alone(const VehicleParams& params, const Start& start, std::shared_ptr<const Road> ground)
        : vehicle(prepare(params)), road(std::move(ground)) {
        const Equilibrium found = equilibrium(vehicle, {*road}, start);
        motion = found.motion;
        state = found.state;
        input = found.input;
    }
    void advance(const VehicleInput& begin, const VehicleInput& end) {
        tread::advance(motion, state, vehicle, begin, end, {*road}, kStep);
    }
};

std::shared_ptr<const Road> flat() {
    return std::make_shared<const PlaneRoad>();
}

// The bits that a user can see of a car.
template <class T>
bool sameBits(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof(T)) == 0;
}
void expectSame(const CarFleet& fleet, std::size_t i, const Alone& car, const char* what) {
    const VehicleOutput seen = fleet.output(i);
    const VehicleOutput expected = observe(car.motion, car.state, car.vehicle, {0, 0, -kStandardGravity});
    EXPECT_TRUE(sameBits(seen, expected))
        << what << ", car " << i << ": x " << seen.chassis.x << " and " << expected.chassis.x;
    EXPECT_EQ(fleet.motion(i).position_W, car.motion.position_W) << what << ", car " << i;
}

// Cars of several structures, none like the other.
std::vector<VehicleParams> mixed(std::size_t count) {
    std::vector<VehicleParams> cars;
    for (std::size_t i = 0; i < count; ++i) {
        VehicleParams car = i % 3 == 1 ? reference::rearDriveSedan() : reference::compact();
        if (i % 3 == 2) car = shared::withEverything(car);
        car.mass *= 1 + 0.01 * static_cast<double>(i);
        cars.push_back(car);
    }
    return cars;
}

// A drive of each car's own: away from rest, steering, braking.
VehicleInput driver(std::size_t car, int call) {
    VehicleInput input;
    const double phase = 0.3 * static_cast<double>(car) + 0.4 * call;
    input.steering_wheel_angle = 0.8 * std::sin(phase);
    input.throttle = call % 7 < 4 ? 0.5 + 0.5 * std::sin(2 * phase) : 0;
    input.brake = call % 7 >= 5 ? 0.1 * static_cast<double>(car % 8 + 1) : 0;
    return input;
}

TEST(CarFleet, EachCarDoesWhatItDoesAloneForAnyNumberOfCarsAndThreads) {
    for (const auto& [count, threads] : {std::pair<std::size_t, int>{1, 1}, {5, 2}, {11, 3}}) {
        const std::vector<VehicleParams> params = mixed(count);
        CarFleet fleet(params, {.step = kStep, .threads = threads});
        std::vector<Alone> cars;
        std::vector<Start> starts;
        for (std::size_t i = 0; i < count; ++i) {
            starts.push_back({.x = 10.0 * static_cast<double>(i),
                              .heading = 0.1 * static_cast<double>(i),
                              .speed = 7.0 * static_cast<double>(i % 4),
                              .input = {}});
            cars.emplace_back(params[i], starts.back(), flat());
        }
        fleet.reset(starts);
        for (int call = 0; call < 20; ++call) {
            for (std::size_t i = 0; i < count; ++i) fleet.input(i) = driver(i, call);
            fleet.advance(10);
            for (std::size_t i = 0; i < count; ++i) {
                for (int k = 0; k < 10; ++k) cars[i].advance(driver(i, call), driver(i, call));
            }
        }
        for (std::size_t i = 0; i < count; ++i) expectSame(fleet, i, cars[i], "held inputs");
    }
}

TEST(CarFleet, RampedInputsBeginWhereTheLastOnesEnded) {
    CarFleet fleet(3, reference::compact());
    const Start start{.speed = 20, .input = {}};
    fleet.reset(start);
    Alone car(reference::compact(), start, flat());
    VehicleInput wanted = car.input;
    wanted.steering_wheel_angle = 0.4;
    fleet.input(1).steering_wheel_angle = 0.4;
    fleet.advance(4, InputCourse::ramped);
    for (int k = 0; k < 4; ++k) {
        VehicleInput begin = wanted, end = wanted;  // the throttle stays
        begin.steering_wheel_angle = k / 4.0 * 0.4;
        if (k < 3) end.steering_wheel_angle = (k + 1) / 4.0 * 0.4;
        car.advance(begin, end);
    }
    expectSame(fleet, 1, car, "ramp");
    // A call that changes nothing is a held one.
    fleet.advance(5, InputCourse::ramped);
    for (int k = 0; k < 5; ++k) car.advance(wanted, wanted);
    expectSame(fleet, 1, car, "no change");
}

TEST(CarFleet, OnlyTheCarsThatAreChosenStartAnew) {
    CarFleet fleet(4, reference::compact(), {.threads = 2});
    fleet.reset({.speed = 10, .input = {}});
    fleet.advance(50);
    const CarSnapshot before = fleet.snapshot(2);
    std::vector<Start> starts(4);
    starts[1] = {.x = 5, .y = -3, .heading = 1, .speed = 15, .input = {}};
    fleet.reset(starts, {false, true, false, true});
    expectSame(fleet, 1, Alone(reference::compact(), starts[1], flat()), "moving");
    expectSame(fleet, 3, Alone(reference::compact(), starts[3], flat()), "standing");
    EXPECT_EQ(fleet.motion(2).position_W, before.motion.position_W);
    EXPECT_NEAR(fleet.motion(0).position_W.x(), 10 * 50 * kStep, 0.01);
    // The throttle that holds the speed is set.
    EXPECT_GT(fleet.input(1).throttle, 0);
}

TEST(CarFleet, ASnapshotIsDrivenAgainBitForBit) {
    CarFleet fleet(5, reference::rearDriveSedan());
    fleet.reset({.speed = 25, .input = {}});
    for (VehicleInput& input : fleet.inputs()) input.steering_wheel_angle = 1;
    fleet.advance(100, InputCourse::ramped);
    const CarSnapshot middle = fleet.snapshot(3);
    fleet.input(3).brake = 0.4;
    fleet.advance(200, InputCourse::ramped);
    const VehicleOutput first = fleet.output(3);
    fleet.restore(3, middle);
    fleet.input(3).brake = 0.4;
    fleet.advance(200, InputCourse::ramped);
    EXPECT_TRUE(sameBits(first, fleet.output(3)));
}

TEST(CarFleet, CarsDriveOnRoadsOfTheirOwn) {
    CarFleet fleet(3, reference::compact());
    const std::shared_ptr<const Road> ice = std::make_shared<const PlaneRoad>(0, 0, 0.2),
                                      slope = std::make_shared<const PlaneRoad>(0.1);
    fleet.setRoad(1, ice);
    fleet.setRoad(2, slope);
    const Start start{.speed = 20, .input = {}};
    fleet.reset(start);
    Alone cars[]{{reference::compact(), start, flat()},
                 {reference::compact(), start, ice},
                 {reference::compact(), start, slope}};
    VehicleInput braking;
    braking.brake = 0.6;
    for (VehicleInput& input : fleet.inputs()) input = braking;
    fleet.advance(300);
    for (std::size_t i = 0; i < 3; ++i) {
        for (int k = 0; k < 300; ++k) cars[i].advance(braking, braking);
        expectSame(fleet, i, cars[i], "road");
    }
}

TEST(CarFleet, SaysWhatIsWrongWithItsArguments) {
    EXPECT_THROW(CarFleet(1, reference::compact(), {.step = 0.01}), std::invalid_argument);
    EXPECT_THROW(CarFleet(1, reference::compact(), {.threads = -1}), std::invalid_argument);
    CarFleet fleet(2, reference::compact());
    EXPECT_THROW(fleet.setRoad(nullptr), std::invalid_argument);
    EXPECT_THROW(fleet.output(2), std::out_of_range);
    EXPECT_THROW(fleet.reset(std::vector<Start>(3)), std::invalid_argument);
}

}  // namespace
}  // namespace tread
