// The functions for C: what they say when something is wrong, and that they are the car of host/car.h.
#include "tread/c_api.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "host/channels.h"
#include "places/places.h"
#include "tread/vehicle_output.h"

namespace tread::c_api_test {
namespace {

using Car = std::unique_ptr<tread_car, decltype(&tread_car_free)>;

Car compact() {
    char error[400] = "";
    Car car(tread_car_load(sourceFile("vehicles/compact.yaml").c_str(), nullptr, error, sizeof error), tread_car_free);
    EXPECT_TRUE(car) << error;
    return car;
}

tread_start at(double speed) {
    return {sizeof(tread_start), 0, 0, 0, speed, nullptr};
}

std::vector<double> outputs(const Car& car) {
    std::vector<double> values(tread_output_count());
    EXPECT_EQ(tread_car_outputs(car.get(), values.data(), values.size()), TREAD_OK);
    return values;
}

double output(const Car& car, const char* name) {
    double value = 0;
    EXPECT_EQ(tread_car_output(car.get(), name, &value), TREAD_OK) << tread_car_error(car.get());
    return value;
}

TEST(CApi, ListsInputsAndOutputsOfTheDescription) {
    EXPECT_EQ(tread_input_count() * sizeof(double), sizeof(VehicleInput));
    EXPECT_EQ(tread_output_count() * sizeof(double), sizeof(VehicleOutput));
    EXPECT_LE(tread_input_count(), std::size_t{TREAD_MOST_INPUTS});
    EXPECT_LE(tread_output_count(), std::size_t{TREAD_MOST_OUTPUTS});
    for (std::size_t i = 0; i < tread_output_count(); ++i) {
        EXPECT_EQ(tread_output_name(i), host::outputChannels()[i].name);
        EXPECT_EQ(tread_output_unit(i), host::outputChannels()[i].unit);
        EXPECT_EQ(tread_output_index(tread_output_name(i)), static_cast<int>(i));
    }
    EXPECT_STREQ(tread_input_meaning(static_cast<std::size_t>(tread_input_index("throttle"))), "throttle pedal");
    EXPECT_EQ(tread_input_index("trottle"), -1);
    EXPECT_EQ(tread_output_name(tread_output_count()), nullptr);
    EXPECT_STREQ(tread_version(), "0.1.0");
}

TEST(CApi, DrivesATurnAndGoesBackBitForBit) {
    const Car car = compact();
    const tread_start start = at(20);
    ASSERT_EQ(tread_car_start(car.get(), &start), TREAD_OK);
    std::vector<double> inputs(tread_input_count());
    ASSERT_EQ(tread_car_inputs(car.get(), inputs.data(), inputs.size()), TREAD_OK);
    EXPECT_GT(inputs[static_cast<std::size_t>(tread_input_index("throttle"))], 0) << "that holds the speed";
    inputs[static_cast<std::size_t>(tread_input_index("steering_wheel_angle"))] = 0.5;
    const auto turn = [&] {
        ASSERT_EQ(tread_car_set_inputs(car.get(), inputs.data(), inputs.size(), TREAD_RAMP), TREAD_OK);
        for (int i = 0; i < 50; ++i) ASSERT_EQ(tread_car_advance(car.get(), 0.01), TREAD_OK);
    };
    turn();
    EXPECT_NEAR(tread_car_time(car.get()), 0.5, 1e-12);
    EXPECT_GT(output(car, "chassis.yaw_rate"), 0.1);
    std::vector<unsigned char> state(tread_car_state_size(car.get()));
    ASSERT_EQ(tread_car_get_state(car.get(), state.data(), state.size()), TREAD_OK);
    turn();
    const std::vector<double> end = outputs(car);
    ASSERT_EQ(tread_car_set_state(car.get(), state.data(), state.size()), TREAD_OK) << tread_car_error(car.get());
    turn();
    EXPECT_EQ(outputs(car), end);
    EXPECT_EQ(tread_car_get_state(car.get(), state.data(), 10), TREAD_FAULTY);
    EXPECT_NE(std::string(tread_car_error(car.get())).find("room for 10 bytes"), std::string::npos);
}

TEST(CApi, SaysWhatIsWrongWithAFile) {
    char error[400] = "", small[12] = "";
    EXPECT_EQ(tread_car_load("no_such.yaml", nullptr, error, sizeof error), nullptr);
    EXPECT_NE(std::string(error).find("no_such.yaml"), std::string::npos) << error;
    EXPECT_EQ(tread_car_parse("mas: 3\n", "mine.yaml", nullptr, error, sizeof error), nullptr);
    EXPECT_NE(std::string(error).find("mine.yaml:1:1: found the unknown key \"mas\""), std::string::npos) << error;
    EXPECT_EQ(tread_car_parse("mas: 3\n", "mine.yaml", nullptr, small, sizeof small), nullptr);
    EXPECT_EQ(std::string(small), std::string(error).substr(0, sizeof small - 1)) << "cut to its room";
    EXPECT_EQ(tread_car_load(nullptr, nullptr, nullptr, 0), nullptr);
    const tread_options coarse{sizeof coarse, 1};
    EXPECT_EQ(tread_car_load(sourceFile("vehicles/compact.yaml").c_str(), &coarse, error, sizeof error), nullptr);
    EXPECT_NE(std::string(error).find("inner step of 1 s"), std::string::npos) << error;
}

TEST(CApi, RefusesWithASentenceAndGoesOn) {
    const Car car = compact();
    const auto said = [&] { return std::string(tread_car_error(car.get())); };
    EXPECT_EQ(said(), "");
    EXPECT_EQ(tread_car_advance(car.get(), 0.01), TREAD_FAULTY);
    EXPECT_NE(said().find("has not been started"), std::string::npos) << said();
    const tread_start unsized{};
    EXPECT_EQ(tread_car_start(car.get(), &unsized), TREAD_FAULTY);
    EXPECT_NE(said().find("sizeof(tread_start)"), std::string::npos) << said();
    EXPECT_EQ(tread_car_start(car.get(), nullptr), TREAD_FAULTY);
    const tread_start start = at(10);
    ASSERT_EQ(tread_car_start(car.get(), &start), TREAD_OK);
    const double inputs[] = {std::nan("")};
    EXPECT_EQ(tread_car_set_inputs(car.get(), inputs, 1, TREAD_HELD), TREAD_FAULTY);
    EXPECT_NE(said().find("input steering_wheel_angle: found NaN"), std::string::npos) << said();
    double value = 0;
    EXPECT_EQ(tread_car_output(car.get(), "chassis.yawrate", &value), TREAD_FAULTY);
    EXPECT_NE(said().find("did you mean \"chassis.yaw_rate\"?"), std::string::npos) << said();
    tread_plane plane{sizeof plane, {0, 0, 0}, {0, 0, 1}, {0, 0, 0}, 1, 1};
    EXPECT_EQ(tread_car_set_plane(car.get(), 4, &plane), TREAD_FAULTY);
    EXPECT_EQ(tread_car_set_plane(car.get(), -1, &plane), TREAD_FAULTY);
    plane.friction = -1;
    EXPECT_EQ(tread_car_set_plane(car.get(), 0, &plane), TREAD_FAULTY);
    EXPECT_EQ(tread_car_advance(car.get(), 0.01), TREAD_OK);
    EXPECT_EQ(tread_car_advance(nullptr, 0.01), TREAD_FAULTY);
    tread_car_free(nullptr);
}

TEST(CApi, ParametersCountFromTheNextStart) {
    const Car car = compact();
    double mass = 0;
    ASSERT_EQ(tread_car_parameter(car.get(), "mass", &mass), TREAD_OK);
    EXPECT_EQ(tread_car_set(car.get(), "mass", "x"), TREAD_FAULTY);
    EXPECT_EQ(tread_car_set(car.get(), "front.suspension.spring", "25 kN/m"), TREAD_OK) << tread_car_error(car.get());
    ASSERT_EQ(tread_car_set(car.get(), "mass", std::to_string(1.1 * mass).c_str()), TREAD_OK);
    EXPECT_EQ(tread_car_parameter(car.get(), "mas", &mass), TREAD_FAULTY);
    const tread_start start = at(10);
    ASSERT_EQ(tread_car_start(car.get(), &start), TREAD_OK);
    tread_body body{};
    body.size = sizeof body;
    ASSERT_EQ(tread_car_body(car.get(), &body), TREAD_OK);
    EXPECT_NEAR(body.mass, 1.1 * mass, 1e-3);
    EXPECT_GT(body.inertia[2][2], body.inertia[0][0]);
    std::vector<unsigned char> state(tread_car_state_size(car.get()));
    ASSERT_EQ(tread_car_get_state(car.get(), state.data(), state.size()), TREAD_OK);
    ASSERT_EQ(tread_car_set(car.get(), "mass", "1300"), TREAD_OK);
    EXPECT_EQ(tread_car_set_state(car.get(), state.data(), state.size()), TREAD_FAULTY) << "the state of another car";
}

void slope(void* user, int wheel, const double centre[3], tread_plane* plane) {
    ++*static_cast<int*>(user);
    EXPECT_TRUE(wheel >= 0 && wheel < 4);
    EXPECT_EQ(plane->friction, 1) << "filled in with what is usual";
    plane->point[0] = centre[0];
    plane->point[2] = 0.1 * centre[0];
    plane->normal[0] = -0.1;
}

void throwing(void*, int, const double*, tread_plane*) {
    throw 7;
}

TEST(CApi, AsksTheHostForItsGround) {
    const Car car = compact();
    int calls = 0;
    ASSERT_EQ(tread_car_use_ground(car.get(), slope, &calls), TREAD_OK);
    const tread_start start = at(10);
    ASSERT_EQ(tread_car_start(car.get(), &start), TREAD_OK) << tread_car_error(car.get());
    ASSERT_EQ(tread_car_advance(car.get(), 0.1), TREAD_OK);
    EXPECT_GT(calls, 400);
    EXPECT_NEAR(output(car, "chassis.vz"), 10 * std::sin(std::atan(0.1)), 0.01);
    ASSERT_EQ(tread_car_use_ground(car.get(), throwing, nullptr), TREAD_OK);
    EXPECT_EQ(tread_car_advance(car.get(), 0.1), TREAD_FAULTY) << "nothing is thrown through C";
    EXPECT_NE(std::string(tread_car_error(car.get())), "");
}

TEST(CApi, StructOfAnOlderCallerHasDefaultsForTheRest) {
    // A start of which the caller knows the place only.
    const Car car = compact();
    tread_start start = at(10);
    start.size = offsetof(tread_start, speed);
    ASSERT_EQ(tread_car_start(car.get(), &start), TREAD_OK);
    EXPECT_EQ(output(car, "chassis.vx"), 0);
    tread_motion motion{};
    motion.size = offsetof(tread_motion, velocity);
    motion.velocity[0] = 77;
    ASSERT_EQ(tread_car_motion(car.get(), &motion), TREAD_OK);
    EXPECT_EQ(motion.velocity[0], 77) << "beyond what the caller knows";
    EXPECT_EQ(motion.size, offsetof(tread_motion, velocity));
}

TEST(CApi, CarsInThreadsDoNotKnowOfEachOther) {
    std::vector<double> yaw(3);
    std::vector<std::thread> threads;
    for (double& result : yaw) {
        threads.emplace_back([&result] {
            const Car car = compact();
            const tread_start start = at(15);
            tread_car_start(car.get(), &start);
            const double inputs[] = {0.5};
            tread_car_set_inputs(car.get(), inputs, 1, TREAD_HELD);
            for (int i = 0; i < 100; ++i) tread_car_advance(car.get(), 0.005);
            result = output(car, "chassis.yaw");
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_GT(yaw[0], 0.05);
    EXPECT_EQ(yaw[0], yaw[1]);
    EXPECT_EQ(yaw[0], yaw[2]);
}

}  // namespace
}  // namespace tread::c_api_test
