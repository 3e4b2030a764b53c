// A fleet's cars do what they do alone.
#include "tread/car_fleet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>

#include "shared/equipped_car.h"
#include "shared/vehicles.h"
#include "tread/load.h"
#include "tread/road_surface.h"

namespace tread::car_fleet_test {
namespace {

constexpr double kStep = 0.001;  // s

// What a fleet promises to reproduce, computed without one.
struct Alone {
    Vehicle vehicle;
    std::shared_ptr<const Road> road;
    ChassisMotion motion{};
    VehicleState state{};
    VehicleInput input{};
    Vector3 wind_W = Vector3::Zero();

    Alone(const VehicleParams& params, const Start& start, std::shared_ptr<const Road> ground)
        : vehicle(prepare(params)), road(std::move(ground)) {
        const Equilibrium found = equilibrium(vehicle, {*road}, start);
        motion = found.motion;
        state = found.state;
        input = found.input;
    }
    void advance(const VehicleInput& begin, const VehicleInput& end) {
        tread::advance(motion, state, vehicle, begin, end, {.road = *road, .wind_W = wind_W}, kStep);
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

// What drivers may do, one in each lane.
constexpr std::size_t kDrives = 6;
Start startOf(std::size_t drive) {
    constexpr double kSpeeds[kDrives]{0, 0, 30, 25, 15, 8};
    Start start{.y = 20.0 * static_cast<double>(drive), .heading = static_cast<double>(drive), .speed = kSpeeds[drive]};
    start.input.brake = drive == 1 ? 0.3 : 0;
    start.input.parking_brake = drive == 0;
    return start;
}
VehicleInput inputOf(std::size_t drive, double t) {
    VehicleInput input;
    switch (drive) {
        case 0:  // parked
            input.parking_brake = 1;
            break;
        case 1:  // away at full throttle, through the gears
            input.throttle = std::min(2 * t, 1.0);
            input.steering_wheel_angle = 0.1 * std::sin(t);
            break;
        case 2:  // emergency stop
            input.brake = std::min(10 * t, 1.0);
            break;
        case 3:  // into a spin
            input.steering_wheel_angle = std::min(20 * t, 6.0);
            input.throttle = 1;
            input.parking_brake = t > 0.5;
            break;
        case 4:  // hands off now and then, on and off the pedals
            input.steering_wheel_angle = std::sin(3 * t);
            input.hands_off = std::fmod(t, 2) > 1.5;
            input.throttle = std::fmod(t, 1) < 0.5 ? 1 : 0;
            input.brake = std::fmod(t, 1) > 0.7 ? 0.3 : 0;
            break;
        default:  // to a stop, and away again
            input.brake = t < 2 ? 0.5 : 0;
            input.throttle = t < 2 ? 0 : 0.7;
            input.clutch = std::fmod(t, 1) < 0.1 ? 1 : 0;
    }
    return input;
}

// The drives of a car among many: each shipped car takes half of them, its neighbour the other half.
std::size_t driveOf(std::size_t car) {
    return (car / 3 % 2) + 2 * (car % 3);
}

std::vector<VehicleParams> shipped() {
    std::vector<VehicleParams> cars;
    for (const char* name : {"awd_suv", "compact", "electric_hatchback", "liu_compact", "pickup", "rear_drive_sedan",
                             "sports_car", "volvo_s90"}) {
        const VehicleParams car = loadVehicle(sourceFile("vehicles/" + std::string(name) + ".yaml"));
        for (int k = 0; k < 3; ++k) {
            const std::size_t drive = driveOf(cars.size());
            VehicleParams& mine = cars.emplace_back(car);
            mine.brakes.anti_lock.enabled = drive != 5;
            mine.brakes.stability_control.enabled = drive == 4;
            mine.front.tyre.lambda.muy *= 1 - 0.01 * k;
            if (drive == 3) mine.rear.suspension.damper.friction = 100, mine.rear.tyre.lambda.muy *= 0.5;
            if (drive == 2) {
                mine.rear.tyre_surroundings.ply_steer = 0.002;
                mine.rear.tyre_surroundings.conicity = 0.01;
                mine.front.tyre_surroundings.temperature.friction = -0.001;
                mine.front.tyre_surroundings.temperature.stiffness = -0.002;
            }
            if (drive == 4) mine.front.suspension.steer_by_aligning_moment = 1e-5;
        }
    }
    return cars;
}

TEST(CarFleet, LanesHaveTheBitsOfSingleCarsInEveryKindOfDrive) {
    const std::vector<VehicleParams> params = shipped();
    RoadParams banked;
    banked.bank = 0.02;
    banked.friction_patches.push_back({.friction = 0.3, .y_to = 0});
    const std::shared_ptr<const Road> patches = makeRoad(banked);
    const auto roadOf = [&](std::size_t car) { return car % 7 == 0 ? patches : flat(); };
    const auto windOf = [](std::size_t car) { return Vector3(0, static_cast<double>(car % 5), 0); };
    std::vector<Alone> cars;
    std::vector<CarFleet> fleets;
    std::vector<Start> starts;
    for (std::size_t i = 0; i < params.size(); ++i) starts.push_back(startOf(driveOf(i)));
    for (const int lanes : {8, 4, 1}) {
        CarFleet& fleet = fleets.emplace_back(params, CarFleetSettings{.step = kStep, .lanes = lanes});
        for (std::size_t i = 0; i < params.size(); ++i) fleet.setRoad(i, roadOf(i));
        fleet.reset(starts);
        for (std::size_t i = 0; i < params.size(); ++i) fleet.setWind(i, windOf(i));
    }
    for (std::size_t i = 0; i < params.size(); ++i)
        cars.emplace_back(params[i], starts[i], roadOf(i)).wind_W = windOf(i);

    constexpr int kCalls = 200, kSteps = 20;
    bool stands = false, regulates = false, slides = false, shifts = false;
    for (int call = 0; call < kCalls; ++call) {
        const auto input = [&](std::size_t i) { return inputOf(driveOf(i), call * kSteps * kStep); };
        for (CarFleet& fleet : fleets) {
            for (std::size_t i = 0; i < params.size(); ++i) fleet.input(i) = input(i);
            fleet.advance(kSteps);
        }
        for (std::size_t i = 0; i < params.size(); ++i) {
            for (int k = 0; k < kSteps; ++k) cars[i].advance(input(i), input(i));
            const VehicleOutput out = observe(cars[i].motion, cars[i].state, cars[i].vehicle, Vector3(0, 0, -9.8));
            stands |= call > 0 && std::abs(out.chassis.vx) < 1e-6;
            regulates |= out.brakes.anti_lock > 0;
            slides |= std::abs(out.chassis.sideslip) > 1;
            shifts |= out.driveline.gear > 2;
        }
        if (call % 50 != 49) continue;
        for (const CarFleet& fleet : fleets) {
            for (std::size_t i = 0; i < params.size(); ++i) {
                expectSame(fleet, i, cars[i], params[i].name.c_str());
                EXPECT_TRUE(sameBits(fleet.snapshot(i).state.wheels, cars[i].state.wheels)) << "car " << i;
            }
        }
    }
    // Else the drives show less than they should.
    EXPECT_TRUE(stands);
    EXPECT_TRUE(regulates);
    EXPECT_TRUE(slides);
    EXPECT_TRUE(shifts);
}

TEST(CarFleet, ACommandedForceIsTaken) {
    CarFleet fleet(8, reference::compact());
    const Start start{.speed = 20, .input = {}};
    fleet.reset(start);
    Alone car(reference::compact(), start, flat());
    VehicleInput commanded = car.input;
    commanded.force_command = 1;
    commanded.longitudinal_force = -3000;
    for (VehicleInput& input : fleet.inputs()) input = commanded;
    fleet.advance(100);
    for (int k = 0; k < 100; ++k) car.advance(commanded, commanded);
    expectSame(fleet, 5, car, "command");
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
}  // namespace tread::car_fleet_test
