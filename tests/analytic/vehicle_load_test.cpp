// A load at a place of the car: mass, centre of gravity and inertia by the parallel-axis theorem, and the point to
// which the channels refer.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "shared/vehicle_run.h"
#include "shared/vehicles.h"

namespace tread::vehicle_load_test {
namespace {

constexpr double kRounding = 1e-12;

VehicleParams carWith(const LoadParams& load) {
    VehicleParams car = reference::compact();
    car.load = load;
    return car;
}

// Inertia of point masses about their common centre of gravity, computed without the theorem.
struct Point {
    double mass;
    Vector3 at;
};
Eigen::Matrix3d inertiaOf(const std::vector<Point>& points) {
    double mass = 0;
    Vector3 centre = Vector3::Zero();
    for (const Point& p : points) mass += p.mass, centre += p.mass * p.at;
    centre /= mass;
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const Point& p : points) {
        const Vector3 r = p.at - centre;
        sum += p.mass * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
    }
    return sum;
}

TEST(Load, MovesMassCentreOfGravityAndInertiaAsPointMassesDo) {
    const VehicleParams car = reference::compact();
    const LoadParams load{.mass = 200, .x = -1.2, .y = 0.2, .z = 0.29};
    const VehicleParams both = loaded(carWith(load));
    const double total = car.mass + load.mass;
    EXPECT_NEAR(both.mass, total, kRounding * total);
    EXPECT_NEAR(both.front_axle_distance, car.front_axle_distance + 200 * 1.2 / total, kRounding);
    EXPECT_NEAR(both.lateral_offset, car.lateral_offset + 200 * 0.2 / total, kRounding);
    EXPECT_NEAR(both.centre_of_gravity_height, car.centre_of_gravity_height + 200 * 0.29 / total, kRounding);

    // The car as six points on its principal axes, then with the load as a seventh.
    const InertiaParams& own = car.inertia;
    const double xx = 0.5 * (own.pitch + own.yaw - own.roll), yy = 0.5 * (own.roll + own.yaw - own.pitch),
                 zz = 0.5 * (own.roll + own.pitch - own.yaw);
    std::vector<Point> points;
    const double sixth = car.mass / 6;
    const Vector3 arms(std::sqrt(xx / sixth / 2), std::sqrt(yy / sixth / 2), std::sqrt(zz / sixth / 2));
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0}) points.push_back({sixth, sign * arms(axis) * Vector3::Unit(axis)});
    const Eigen::Matrix3d before = inertiaOf(points);
    EXPECT_NEAR(before(0, 0), own.roll, 1e-9) << "the points have the car's inertia";
    points.push_back({load.mass, {load.x, load.y, load.z}});
    const Eigen::Matrix3d after = inertiaOf(points);
    EXPECT_NEAR(both.inertia.roll - own.roll, after(0, 0) - before(0, 0), 1e-9);
    EXPECT_NEAR(both.inertia.pitch - own.pitch, after(1, 1) - before(1, 1), 1e-9);
    EXPECT_NEAR(both.inertia.yaw - own.yaw, after(2, 2) - before(2, 2), 1e-9);
    EXPECT_NEAR(both.inertia.roll_yaw - own.roll_yaw, -after(0, 2), 1e-9);
}

TEST(Load, IsTheSameByItsPlaceAndByItsMoments) {
    const VehicleParams by_place = loaded(carWith({.mass = 150, .x = -1.1, .y = 0.3, .z = 0.4}));
    const VehicleParams by_moment = loaded(carWith({.mass = 150, .moment_x = -165, .moment_y = 45, .moment_z = 60}));
    EXPECT_NEAR(by_place.front_axle_distance, by_moment.front_axle_distance, kRounding);
    EXPECT_NEAR(by_place.centre_of_gravity_height, by_moment.centre_of_gravity_height, kRounding);
    EXPECT_NEAR(by_place.lateral_offset, by_moment.lateral_offset, kRounding);
    EXPECT_NEAR(by_place.inertia.yaw, by_moment.inertia.yaw, 1e-9);
    EXPECT_NEAR(by_place.inertia.roll, by_moment.inertia.roll, 1e-9);
    EXPECT_NEAR(by_place.inertia.pitch, by_moment.inertia.pitch, 1e-9);
}

TEST(Load, TakenOutAgainLeavesTheCarAsItWas) {
    const VehicleParams car = reference::compact();
    VehicleParams both = loaded(carWith({.mass = 200, .x = -1.2, .z = 0.29}));
    const double shift_x = car.front_axle_distance - both.front_axle_distance;
    const double shift_z = both.centre_of_gravity_height - car.centre_of_gravity_height;
    both.load = {.mass = -200, .x = -1.2 - shift_x, .z = 0.29 - shift_z};
    const VehicleParams again = loaded(both);
    EXPECT_NEAR(again.mass, car.mass, 1e-9);
    EXPECT_NEAR(again.front_axle_distance, car.front_axle_distance, kRounding);
    EXPECT_NEAR(again.inertia.yaw, car.inertia.yaw, 1e-9);
    EXPECT_NEAR(again.inertia.pitch, car.inertia.pitch, 1e-9);
}

TEST(Load, AMomentWithoutMassMovesTheCentreOfGravityOnly) {
    const VehicleParams car = reference::compact(), moved = loaded(carWith({.moment_x = -100}));
    EXPECT_EQ(moved.mass, car.mass);
    EXPECT_EQ(moved.inertia.yaw, car.inertia.yaw);
    EXPECT_NEAR(moved.front_axle_distance, car.front_axle_distance + 100 / car.mass, kRounding);
    // A small mass does not carry it further than the car reaches.
    const VehicleParams small = loaded(carWith({.mass = 1e-6, .moment_x = -100}));
    EXPECT_NEAR(small.inertia.yaw, car.inertia.yaw, 1e-4);
}

TEST(Load, RestsOnTheWheelsByItsLever) {
    const VehicleParams car = reference::compact();
    const double x = -1.2, mass = 200;
    const PlaneRoad road;
    const reference::Car without = reference::settled(car, road, {.input = {.brake = 0.3}});
    const reference::Car with =
        reference::settled(carWith({.mass = mass, .x = x, .levelled = true}), road, {.input = {.brake = 0.3}});
    const double on_rear = mass * kStandardGravity * (car.front_axle_distance - x) / car.wheelbase;
    const auto loads = [](const reference::Car& one, std::size_t a, std::size_t b) {
        return one.state.wheels[a].load + one.state.wheels[b].load;
    };
    EXPECT_NEAR(loads(with, 2, 3) - loads(without, 2, 3), on_rear, 0.1);
    EXPECT_NEAR(loads(with, 0, 1) - loads(without, 0, 1), mass * kStandardGravity - on_rear, 0.1);
    EXPECT_NEAR(with.output().chassis.x, 0, 0.001) << "the car stands where it stood, but for its pitch";
    EXPECT_NEAR(with.output().chassis.z, without.output().chassis.z, 1e-4) << "and at its height";
}

// The springs yield by what rests on them.
TEST(Load, SinksOnItsSprings) {
    VehicleParams car = reference::compact();
    car.front.suspension.bump_stop = car.rear.suspension.bump_stop = {};
    const double x = -1.2, mass = 200;
    VehicleParams loaded_car = car;
    loaded_car.load = {.mass = mass, .x = x};
    const PlaneRoad road;
    const Start rolling{.speed = 10};  // at rest, tyres that stick to the road hold the wheels apart
    const reference::Car without = reference::settled(car, road, rolling),
                         with = reference::settled(loaded_car, road, rolling);
    const double on_rear = mass * kStandardGravity * (car.front_axle_distance - x) / car.wheelbase;
    const auto travel = [](const reference::Car& one, std::size_t wheel) { return one.state.wheels[wheel].travel; };
    // The body pitches by 0.6 degrees, which moves its mass rearwards: 1 % of the load.
    const double rear = on_rear / (2 * car.rear.suspension.spring);
    EXPECT_NEAR(travel(with, 2) - travel(without, 2), rear, 0.03 * rear);
    const double front = (mass * kStandardGravity - on_rear) / (2 * car.front.suspension.spring);
    EXPECT_NEAR(travel(with, 0) - travel(without, 0), front, 0.1 * front);
    EXPECT_LT(with.output().chassis.z,
              without.output().chassis.z - 0.5 * rear * car.front_axle_distance / car.wheelbase);
}

std::size_t rowsOf(const Log& log) {
    return log.find("time")->values.size();
}

Log driven(const VehicleParams& car) {
    Scenario scenario = shared::scenario("sine_with_dwell");
    scenario.step = 0.002;
    scenario.log = {.rate = 500, .channels = {"chassis.*", "wheel.*.load"}};
    return simulate(car, scenario);
}

// The car with a load and the car that is given the numbers of both move alike; channels of the first are those of the
// place where the centre of gravity was.
TEST(Load, DrivesAsTheCarThatIsGivenTheNumbersOfBoth) {
    const VehicleParams car = carWith({.mass = 200, .x = -1.2, .y = -0.1, .z = 0.29, .levelled = true});
    const VehicleParams whole = loaded(car);
    const Log with = driven(car), given = driven(whole);
    ASSERT_EQ(rowsOf(with), rowsOf(given));
    const auto column = [](const Log& log, const char* name) -> const std::vector<double>& {
        return log.find(name)->values;
    };
    const double x = whole.front_axle_distance - car.front_axle_distance, y = car.lateral_offset - whole.lateral_offset,
                 z = car.centre_of_gravity_height - whole.centre_of_gravity_height;
    double largest_move = 0;
    for (std::size_t i = 1; i + 1 < rowsOf(with); ++i) {
        EXPECT_NEAR(column(with, "chassis.yaw_rate")[i], column(given, "chassis.yaw_rate")[i], 1e-9);
        EXPECT_NEAR(column(with, "wheel.rear_left.load")[i], column(given, "wheel.rear_left.load")[i], 1e-4);
        const double yaw_rate = column(given, "chassis.yaw_rate")[i];
        const double shift = x * yaw_rate - z * column(given, "chassis.roll_rate")[i];
        // Level axes: the roll of a few degrees tilts the small arms.
        EXPECT_NEAR(column(with, "chassis.vy")[i] - column(given, "chassis.vy")[i], shift, 0.004);
        EXPECT_NEAR(column(with, "chassis.vx")[i] - column(given, "chassis.vx")[i], -y * yaw_rate, 0.02);
        const double turn =
            (column(given, "chassis.yaw_rate")[i + 1] - column(given, "chassis.yaw_rate")[i - 1]) / 0.004;
        const double tilt =
            (column(given, "chassis.roll_rate")[i + 1] - column(given, "chassis.roll_rate")[i - 1]) / 0.004;
        const double expected = x * turn - y * yaw_rate * yaw_rate - z * tilt;
        EXPECT_NEAR(column(with, "chassis.ay")[i] - column(given, "chassis.ay")[i], expected, 0.03);
        largest_move = std::max(largest_move, std::abs(expected));
    }
    EXPECT_GT(largest_move, 0.2) << "the manoeuvre tells the two places apart";
}

// Velocity and acceleration of the channels belong to the position that they log.
TEST(Load, ChannelsReferToOnePoint) {
    const Log log = driven(carWith({.mass = 200, .x = -1.2, .z = 0.29}));
    const auto at = [&](const char* name, std::size_t i) { return log.find(name)->values[i]; };
    for (std::size_t i = 1; i + 1 < rowsOf(log); ++i) {
        const double yaw = at("chassis.yaw", i);
        const auto rate = [&](const char* name) { return (at(name, i + 1) - at(name, i - 1)) / 0.004; };
        const double along = std::cos(yaw) * rate("chassis.x") + std::sin(yaw) * rate("chassis.y");
        const double aside = std::cos(yaw) * rate("chassis.y") - std::sin(yaw) * rate("chassis.x");
        EXPECT_NEAR(at("chassis.vx", i), along, 0.01) << i;
        EXPECT_NEAR(at("chassis.vy", i), aside, 0.01) << i;
    }
}

TEST(Load, AnUnloadedCarIsLeftAsItIs) {
    const VehicleParams car = reference::compact(), same = loaded(car);
    EXPECT_EQ(same.mass, car.mass);
    EXPECT_EQ(same.inertia.yaw, car.inertia.yaw);
    EXPECT_TRUE(prepare(car).reference_B.isZero(0));
    EXPECT_EQ(prepare(car).inverse_mass, prepare(same).inverse_mass);
}

}  // namespace
}  // namespace tread::vehicle_load_test
