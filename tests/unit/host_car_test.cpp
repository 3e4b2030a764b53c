// A car that a host steps: the same numbers as the headless run, whatever the host's step; states to go back to; the
// host's body as the chassis.
#include "host/car.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "host/channels.h"
#include "host/failure.h"
#include "host/parameters.h"
#include "road/plane.h"
#include "shared/vehicle_run.h"

namespace tread::host::host_car_test {
namespace {

using shared::channel;

const double kNaN = std::numeric_limits<double>::quiet_NaN();

// A turn in which pedals and hands work, at 1000 rows per second.
Log headlessTurn(const VehicleParams& car, double step = 0.001) {
    Scenario scenario;
    scenario.start.speed = 20;
    scenario.step = step;
    scenario.log.rate = 1 / step;
    Phase& phase = scenario.phases.emplace_back();
    phase.steering = Table<Angle>{Curve{{{0.2, 0}, {0.5, 0.9}, {1, -0.9}, {1.5, 0.4}}}};
    phase.brake = Table<Pedal>{Curve{{{1.2, 0}, {1.4, 0.3}}}};
    phase.until.duration = 2;
    return simulate(car, scenario);
}

VehicleInput inputOf(const Log& log, std::size_t row) {
    VehicleInput input;
    for (const Channel& c : inputChannels()) valueOf(input, c) = channel(log, "driver." + c.name)[row];
    return input;
}

std::string saidBy(const auto& action) {
    try {
        action();
    } catch (const Failure& failure) {
        return failure.what();
    }
    return "nothing";
}

// Largest difference from the log over the largest value of each channel, along the whole drive.
double largestDifference(Car& car, const Log& log, double step) {
    std::vector<double> difference(outputChannels().size()), peak(outputChannels().size());
    for (std::size_t row = 0; row < channel(log, "time").size(); ++row) {
        if (row > 0) {
            car.setInput(inputOf(log, row), Course::ramp);
            car.advance(step);
        }
        for (std::size_t i = 0; i < difference.size(); ++i) {
            const double expected = channel(log, outputChannels()[i].name)[row];
            difference[i] = std::max(difference[i], std::abs(valueOf(car.output(), outputChannels()[i]) - expected));
            peak[i] = std::max(peak[i], std::abs(expected));
        }
    }
    double worst = 0;
    for (std::size_t i = 0; i < difference.size(); ++i) {
        if (peak[i] > 0) worst = std::max(worst, difference[i] / peak[i]);
    }
    return worst;
}

TEST(HostCar, HasTheNumbersOfTheHeadlessRun) {
    for (const auto& params : {shared::compact(), shared::sedan()}) {
        const Log log = headlessTurn(params);
        Car car(params);
        car.start({.speed = 20});
        const double worst = largestDifference(car, log, 0.001);
        std::printf("%s: %.2g of the peak\n", params.name.c_str(), worst);
        EXPECT_LT(worst, 1e-9) << params.name;
    }
}

TEST(HostCar, HasTheNumbersOfABulletStepThatTakesSeveralOfItsOwn) {
    const Log log = headlessTurn(shared::compact(), 0.01);
    Car car(shared::compact());
    car.start({.speed = 20});
    EXPECT_LT(largestDifference(car, log, 0.01), 1e-9);
}

std::vector<std::byte> afterTurn(double host_step, double duration) {
    Car car(shared::compact());
    car.start({.speed = 20});
    VehicleInput input = car.input();
    input.steering_wheel_angle = 0.8;
    car.setInput(input);
    const long steps = std::lround(duration / host_step);
    for (long i = 0; i < steps; ++i) car.advance(host_step);
    EXPECT_NEAR(car.time(), duration, 1e-9);
    Snapshot end = car.snapshot();
    end.time = end.time_rest = end.carried = 0;
    return bytesOf(end, 0);
}

TEST(HostCar, GivesTheSameBitsHoweverTheHostDividesItsTime) {
    const std::vector<std::byte> reference = afterTurn(0.001, 0.42);
    for (const double step : {0.002, 0.003, 0.007, 0.06, 0.42}) EXPECT_TRUE(afterTurn(step, 0.42) == reference) << step;
}

TEST(HostCar, TakesAnyStep) {
    // A third of a millisecond, more than one, and far less than counts.
    const auto yawRate = [](double step) {
        Car car(shared::compact());
        car.start({.speed = 20});
        VehicleInput input = car.input();
        input.steering_wheel_angle = 0.8;
        car.setInput(input);
        while (car.time() < 0.5 - 0.5 * step) car.advance(step);
        return car.output().chassis.yaw_rate;
    };
    const double reference = yawRate(0.001);
    EXPECT_GT(reference, 0.1);
    for (const double step : {1 / 3000.0, 1 / 700.0, 0.0164, 3e-6})
        EXPECT_NEAR(yawRate(step), reference, 0.003 * reference) << step;
}

TEST(HostCar, HeldInputIsThereAtOnceARampAtTheEndOfTheStep) {
    // Seen by the way that the car turns in half of the steps.
    const auto yawAfterStep = [](Course course) {
        Car car(shared::compact());
        car.start({.speed = 20});
        VehicleInput input = car.input();
        input.steering_wheel_angle = 0.5;
        car.setInput(input, course);
        car.advance(0.1);
        EXPECT_DOUBLE_EQ(car.output().steering.angle, 0.5);
        return car.output().chassis.yaw;
    };
    const double held = yawAfterStep(Course::held), ramp = yawAfterStep(Course::ramp);
    EXPECT_GT(ramp, 0);
    EXPECT_GT(held, 1.8 * ramp);
}

TEST(HostCar, GoesOnFromASnapshotBitForBit) {
    Car car(shared::sedan()), other(shared::sedan());
    for (Car* each : {&car, &other}) each->start({.speed = 25});
    const auto turn = [](Car& which, int steps) {
        for (int i = 0; i < steps; ++i) {
            which.setInput({.steering_wheel_angle = 0.7, .throttle = 0.4}, Course::ramp);
            which.advance(0.0041);
        }
    };
    turn(car, 100);
    const std::vector<std::byte> bytes = car.bytes();
    const Snapshot copy = car.snapshot();
    turn(car, 100);
    const std::vector<std::byte> end = car.bytes();
    car.restore(copy);
    EXPECT_EQ(car.bytes(), bytes);
    turn(car, 100);
    EXPECT_EQ(car.bytes(), end);
    turn(other, 7);
    other.restore(bytes);
    turn(other, 100);
    EXPECT_EQ(other.bytes(), end);
    EXPECT_EQ(other.output().chassis.yaw, car.output().chassis.yaw);
}

TEST(HostCar, BytesOfAnotherCarOrVersionAreRefused) {
    Car car(shared::compact());
    car.start({.speed = 10});
    std::vector<std::byte> bytes = car.bytes();
    EXPECT_EQ(bytes.size(), snapshotSize());
    Car sedan(shared::sedan());
    EXPECT_NE(saidBy([&] { sedan.restore(bytes); }).find("the state of another car"), std::string::npos);
    Car coarse(shared::compact(), 0.002);
    EXPECT_NE(saidBy([&] { coarse.restore(bytes); }).find("the state of another car"), std::string::npos);
    std::vector<std::byte> other = bytes;
    other[8] ^= std::byte{1};
    EXPECT_NE(saidBy([&] { car.restore(other); }).find("another version of tread"), std::string::npos);
    other = bytes;
    other.back() ^= std::byte{1};
    EXPECT_NE(saidBy([&] { car.restore(other); }).find("damaged"), std::string::npos);
    other = bytes;
    other.pop_back();
    EXPECT_NE(saidBy([&] { car.restore(other); }).find("incomplete"), std::string::npos);
    EXPECT_NE(saidBy([&] { car.restore(std::span(bytes).first(5)); }).find("no state of a car"), std::string::npos);
}

TEST(HostCar, InputsInBytesAreTakenLikeThoseOfTheHost) {
    Car car(shared::compact()), other(shared::compact());
    car.start({.speed = 10});
    Snapshot hostile = car.snapshot();
    hostile.next.clutch = 3, hostile.input.brake = -1;
    other.restore(hostile);
    car.restore(other.bytes());
    EXPECT_EQ(car.snapshot().next.clutch, 1);
    EXPECT_EQ(car.snapshot().input.brake, 0);
    hostile.next.throttle = std::numeric_limits<double>::quiet_NaN();
    other.restore(hostile);
    EXPECT_NE(saidBy([&] { car.restore(other.bytes()); }).find("input throttle: found NaN"), std::string::npos);
}

TEST(HostCar, StartsWhereItIsTold) {
    Car car(shared::compact());
    car.start({.x = 3, .y = -2, .heading = 1, .speed = 15});
    for (int i = 0; i < 1000; ++i) car.advance(0.001);
    const ChassisOutput& c = car.output().chassis;
    EXPECT_NEAR(c.x, 3 + 15 * std::cos(1.0), 0.02);
    EXPECT_NEAR(c.y, -2 + 15 * std::sin(1.0), 0.02);
    EXPECT_NEAR(c.yaw, 1, 1e-3);
    EXPECT_NEAR(c.vx, 15, 0.01);
}

TEST(HostCar, StandsOnPlanesAFunctionAndARoadAlike) {
    const double slope = 0.1;
    const Vector3 normal = Vector3(-slope, 0, 1).normalized();
    const auto heightAfter = [&](const auto& prepare) {
        Car car(shared::compact());
        prepare(car.ground());
        car.start({.speed = 10});
        for (int i = 0; i < 500; ++i) car.advance(0.001);
        return car.output().chassis.z;
    };
    const double by_planes = heightAfter([&](Ground& ground) {
        for (std::size_t i = 0; i < kWheels; ++i) ground.setPlane(i, {.normal_W = 3 * normal});
    });
    const double by_function = heightAfter([&](Ground& ground) {
        ground.use([&](const Vector3& centre, std::size_t) {
            return RoadContact{.point_W = {centre.x(), 0, slope * centre.x()}, .normal_W = normal};
        });
    });
    const double by_road = heightAfter([&](Ground& ground) { ground.use(std::make_shared<PlaneRoad>(slope)); });
    EXPECT_NEAR(by_planes, by_road, 1e-9);
    EXPECT_NEAR(by_function, by_road, 1e-9);
    EXPECT_GT(by_road, 0.8) << "5 m up a slope of 10 %";
}

TEST(HostCar, RefusesWhatIsNoNumberAndSaysWhich) {
    Car car(shared::compact());
    EXPECT_NE(saidBy([&] { car.advance(0.01); }).find("has not been started"), std::string::npos);
    EXPECT_NE(saidBy([&] { car.start({.speed = kNaN}); }).find("not finite"), std::string::npos);
    EXPECT_NE(saidBy([&] { car.start({.speed = 90}); }).find("cannot hold the 90 m/s"), std::string::npos);
    EXPECT_NE(saidBy([&] { Car(shared::compact(), 0.5); }).find("inner step of 0.5 s"), std::string::npos);
    car.start({.speed = 20});
    EXPECT_NE(saidBy([&] { car.setInput({.throttle = kNaN}); }).find("input throttle: found NaN"), std::string::npos);
    EXPECT_NE(saidBy([&] { car.advance(-1); }).find("step of -1 s"), std::string::npos);
    EXPECT_NE(saidBy([&] { car.ground().setPlane(2, {.normal_W = Vector3::Zero()}); }).find("rear left wheel"),
              std::string::npos);
    car.setInput({.throttle = 7});
    EXPECT_EQ(car.input().throttle, 1) << "a pedal ends at its stop";
    car.ground().use([](const Vector3&, std::size_t wheel) { return RoadContact{.friction = wheel == 3 ? kNaN : 1}; });
    EXPECT_NE(saidBy([&] { car.advance(0.001); }).find("rear right wheel"), std::string::npos);
}

TEST(HostCar, BreakDownNamesWhatAndStaysUntilANewStart) {
    Car car(shared::compact());
    car.start({.speed = 20});
    Snapshot spoilt = car.snapshot();
    spoilt.state.wheels[1].spin = kNaN;
    const Snapshot good = car.snapshot();
    car.restore(spoilt);
    const std::string said = saidBy([&] { car.advance(0.01); });
    EXPECT_NE(said.find("broke down at t = 0.01 s"), std::string::npos) << said;
    EXPECT_NE(said.find("is not finite"), std::string::npos) << said;
    EXPECT_NE(saidBy([&] { car.advance(0.01); }).find("broken down before"), std::string::npos);
    car.restore(good);
    car.advance(0.01);
    EXPECT_NEAR(car.output().chassis.vx, 20, 0.1);
}

// ---- The host's own body ----

// Integrates a rigid body under the force and moment that it is given, as hosts do.
struct HostBody {
    ChassisMotion motion;
    double mass;
    Eigen::Matrix3d inertia_B;

    Eigen::Matrix3d inertia() const {
        const Eigen::Matrix3d axes = motion.orientation.toRotationMatrix();
        return axes * inertia_B * axes.transpose();
    }
    void turn(const Vector3& rotation) {
        const double angle = rotation.norm();
        if (angle > 0)
            motion.orientation =
                (Quaternion(Eigen::AngleAxisd(angle, rotation / angle)) * motion.orientation).normalized();
    }
    void step(const BodyForce& push, const Vector3& other_force, Integration integration, double dt) {
        const Vector3 weight(0, 0, -mass * kStandardGravity);
        const Vector3 v = motion.velocity_W, w = motion.angular_velocity_W;
        motion.velocity_W += dt / mass * (push.force_W + weight + other_force);
        if (integration == Integration::exact) {
            const Vector3 momentum = inertia() * w + dt * push.moment_W;
            motion.position_W += 0.5 * dt * (v + motion.velocity_W);
            const Vector3 about = inertia().inverse() * momentum;
            turn(0.5 * dt * (w + about));
            motion.angular_velocity_W = inertia().inverse() * momentum;
        } else {
            motion.position_W += dt * motion.velocity_W;
            motion.angular_velocity_W += dt * inertia().inverse() * push.moment_W;
            turn(dt * motion.angular_velocity_W);
        }
    }
};

// Yaw rate and place after two seconds of a turn, driven in three ways.
VehicleOutput driven(const auto& step) {
    Car car(shared::compact());
    car.start({.speed = 20});
    const BodyProperties properties = car.body();
    HostBody body{car.motion(), properties.mass, properties.inertia_B};
    for (int i = 0; i < 2000; ++i) {
        VehicleInput input = car.input();
        input.steering_wheel_angle = 0.8 * std::sin(0.004 * i);
        car.setInput(input, Course::ramp);
        step(car, body);
    }
    return car.output();
}

TEST(HostCar, BodyOfTheHostDrivesLikeTreadsOwn) {
    const VehicleOutput own = driven([](Car& car, HostBody&) { car.advance(0.001); });
    for (const Integration integration : {Integration::exact, Integration::semi_implicit}) {
        HostBody end{};
        const VehicleOutput with_host = driven([&](Car& car, HostBody& body) {
            body.step(car.push(body.motion, 0.001, integration), Vector3::Zero(), integration, 0.001);
            end = body;
        });
        const bool exact = integration == Integration::exact;
        // The pose of the semi-implicit body is the car's own to rounding, the other to second order of the step.
        const double tolerance = exact ? 1e-5 : 1e-8;
        EXPECT_NEAR(with_host.chassis.yaw_rate, own.chassis.yaw_rate, tolerance) << exact;
        EXPECT_NEAR(with_host.chassis.x, own.chassis.x, tolerance * 40) << exact;
        EXPECT_NEAR(with_host.chassis.y, own.chassis.y, tolerance * 40) << exact;
        EXPECT_NEAR(with_host.wheel.front_left.load, own.wheel.front_left.load, tolerance * 4000) << exact;
        EXPECT_NEAR(end.motion.position_W.x(), own.chassis.x, tolerance * 40) << exact;
        std::printf("%d: yaw rate %.2g rad/s, x %.2g m, y %.2g m, load %.2g N\n", exact,
                    with_host.chassis.yaw_rate - own.chassis.yaw_rate, with_host.chassis.x - own.chassis.x,
                    with_host.chassis.y - own.chassis.y, with_host.wheel.front_left.load - own.wheel.front_left.load);
    }
}

TEST(HostCar, FeelsWhatOthersDoToTheBodyOfTheHost) {
    for (const Integration integration : {Integration::exact, Integration::semi_implicit}) {
        Car car(shared::compact());
        car.start({.speed = 20});
        car.setInput(car.input());
        HostBody body{car.motion(), car.body().mass, car.body().inertia_B};
        // A side push of 1000 N for half a second; the tyres hold against it.
        double most = 0;
        for (int i = 0; i < 500; ++i) {
            body.step(car.push(body.motion, 0.001, integration), {0, 1000, 0}, integration, 0.001);
            most = std::max(most, car.output().chassis.vy);
        }
        EXPECT_GT(most, 0.01);
        EXPECT_NEAR(body.motion.velocity_W.y(), car.motion().velocity_W.y(), 0.01);
        double side = 0;
        for (std::size_t i = 0; i < kWheels; ++i) side += car.output().wheel[i].fy;
        EXPECT_LT(side, -300);
    }
}

TEST(HostParameters, AreSetByPathAndFaultsAreSaid) {
    VehicleParams car = shared::compact();
    setParameter(car, "mass", "1.5 t");
    EXPECT_EQ(car.mass, 1500);
    try {
        setParameter(car, "mas", "3");
        FAIL();
    } catch (const LoadError& error) {
        EXPECT_NE(std::string(error.what()).find("did you mean \"mass\"?"), std::string::npos) << error.what();
    }
    EXPECT_THROW(setParameter(car, "mass", "-3"), LoadError);
    EXPECT_EQ(car.mass, 1500);
    EXPECT_EQ(vehicleOfText(vehicleYaml(car), "car.yaml").mass, 1500);
}

TEST(HostChannels, HaveNamesUnitsAndMeaningsOfTheDescription) {
    const auto yaw_rate = indexOf(outputChannels(), "chassis.yaw_rate");
    ASSERT_TRUE(yaw_rate);
    EXPECT_EQ(outputChannels()[*yaw_rate].unit, "rad/s");
    const auto load = indexOf(outputChannels(), "wheel.rear_left.load");
    ASSERT_TRUE(load);
    EXPECT_EQ(outputChannels()[*load].meaning, "rear left wheel: normal load of the tyre");
    EXPECT_EQ(outputChannels().size() * sizeof(double), sizeof(VehicleOutput)) << "all of it is numbers";
    EXPECT_EQ(inputChannels().size() * sizeof(double), sizeof(VehicleInput));
    EXPECT_FALSE(indexOf(outputChannels(), "chassis.jaw_rate"));
    EXPECT_NE(unknownChannelText(outputChannels(), "chassis.jaw_rate").find("chassis.yaw_rate"), std::string::npos);
}

}  // namespace
}  // namespace tread::host::host_car_test
