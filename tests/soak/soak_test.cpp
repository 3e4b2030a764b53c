// Long drives and many short ones in one process: finite states, a clock without drift, memory that does not grow, and
// the same hash of all that was seen when everything is done once more. The gate drives for seconds; for the whole:
//   TREAD_SOAK_SECONDS=3600 TREAD_SOAK_RUNS=100000 tests_soak

#include <gtest/gtest.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "base/yaml/read.h"
#include "places/places.h"
#include "run/simulate.h"
#include "shared/bullet_scene.h"
#include "shared/equipped_car.h"
#include "shared/vehicles.h"
#include "tread/c_api.h"
#include "tread/car_fleet.h"
#include "tread/road_surface.h"

namespace tread::soak_test {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kMemoryIsOurs = false;  // a sanitizer keeps what was freed
#else
constexpr bool kMemoryIsOurs = true;
#endif

// Bytes that the program has asked for and not given back. The resident memory also holds what the allocator keeps for
// each thread, which depends on how threads were scheduled; it is printed.
long bytesInUse() {
    const struct mallinfo2 all = mallinfo2();
    return static_cast<long>(all.uordblks + all.hblkhd);
}

double residentMegabytes() {
    std::ifstream file("/proc/self/statm");
    double all = 0, resident = 0;
    file >> all >> resident;
    return 1e-6 * resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

// Memory in use at the ends of both rounds of the same work.
class Memory {
public:
    void at(int round) { in_use_[round] = bytesInUse(), resident_[round] = residentMegabytes(); }
    void expectFlat(const char* what) const {
        std::printf("%s: %ld and %ld bytes in use, %.1f and %.1f MB resident at the ends of both rounds\n", what,
                    in_use_[0], in_use_[1], resident_[0], resident_[1]);
        EXPECT_TRUE(!kMemoryIsOurs || in_use_[1] - in_use_[0] <= kGrowth) << what;
    }

private:
    // What the allocator sets aside for blocks that were freed on another thread.
    static constexpr long kGrowth = 64 << 10;
    std::array<long, 2> in_use_{};
    std::array<double, 2> resident_{};
};

int wanted(const char* variable, int usual) {
    const char* const asked = std::getenv(variable);
    return asked ? std::atoi(asked) : usual;
}

// FNV-1a over the bits of numbers.
struct Hash {
    std::uint64_t value = 14695981039346656037u;
    void add(double number) {
        value = (value ^ std::bit_cast<std::uint64_t>(number)) * 1099511628211u;
        value ^= value >> 32;
    }
};

// ---- Random driving

constexpr int kCallsPerSecond = 50;  // of the host
constexpr double kCall = 1.0 / kCallsPerSecond;

class RandomDriving {
public:
    RandomDriving() {
        setRoads();
        fleet_.reset(Start{.speed = 15, .input = {}});
    }

    // One second of all cars.
    void second(int number) {
        for (int call = 0; call < kCallsPerSecond; ++call) {
            if (call % 10 == 0) drive();
            fleet_.advance(static_cast<int>(1000 * kCall), InputCourse::ramped);
            world_.dynamics.stepSimulation(kCall, 0);
            advanceHosted();
            startLostCarsAgain();
        }
        if (number % 3 == 0) snapshots();
        if (number % 5 == 0) setRoads();
        lookAt(number);
    }

    std::uint64_t hash() const { return hash_.value; }

private:
    double random(double from, double to) {
        return from + (to - from) * std::uniform_real_distribution<double>(0, 1)(random_);
    }
    std::size_t any(std::size_t count) {
        return static_cast<std::size_t>(random(0, static_cast<double>(count) - 1e-9));
    }

    VehicleInput input() {
        VehicleInput input;
        input.steering_wheel_angle = random(-1, 1) < 0.8 ? random(-1.5, 1.5) : random(-8, 8);
        input.throttle = random(0, 1) < 0.6 ? random(0, 1) : 0;
        input.brake = random(0, 1) < 0.3 ? random(0, 1) : 0;
        input.clutch = random(0, 1) < 0.1 ? 1 : 0;
        input.parking_brake = random(0, 1) < 0.05 ? 1 : 0;
        input.hands_off = random(0, 1) < 0.1 ? 1 : 0;
        return input;
    }

    void drive() {
        for (VehicleInput& one : fleet_.inputs()) one = input();
        bullet_.vehicle->setInput(input());
        const VehicleInput hosted = input();
        EXPECT_EQ(tread_car_set_inputs(hosted_.get(), &hosted.steering_wheel_angle, 6, TREAD_RAMP), TREAD_OK);
    }

    void setRoads() {
        for (std::size_t car = 0; car < fleet_.size(); ++car) {
            RoadParams road;
            road.grade = random(-0.05, 0.05);
            road.bank = random(-0.05, 0.05);
            road.friction = random(0.2, 1.1);
            if (car % 3 == 0) road.roughness = {.unevenness = random(0, 6.4e-5), .seed = static_cast<int>(any(1000))};
            fleet_.setRoad(car, makeRoad(road));
            fleet_.setWind(car, Vector3(random(-10, 10), random(-10, 10), 0));
            fleet_.reset(car, {.speed = random(0, 25), .input = {}});
        }
        startHosted(random(0.2, 1.1));
    }

    void startHosted(double friction) {
        const tread_plane plane{sizeof plane, {0, 0, 0}, {0, 0, 1}, {}, friction, 1};
        for (int wheel = 0; wheel < 4; ++wheel) ASSERT_EQ(tread_car_set_plane(hosted_.get(), wheel, &plane), TREAD_OK);
        const tread_start start{sizeof start, 0, 0, random(-3, 3), random(0, 20), nullptr};
        ASSERT_EQ(tread_car_start(hosted_.get(), &start), TREAD_OK) << tread_car_error(hosted_.get());
        hosted_steps_ = 0;
    }

    // Cars go back to where they were, and go on.
    void snapshots() {
        const std::size_t car = any(fleet_.size());
        const CarSnapshot there = fleet_.snapshot(car);
        fleet_.advance(20);
        fleet_.restore(car, there);
        kept_.resize(tread_car_state_size(hosted_.get()));
        EXPECT_EQ(tread_car_get_state(hosted_.get(), kept_.data(), kept_.size()), TREAD_OK);
        EXPECT_EQ(tread_car_advance(hosted_.get(), 0.1), TREAD_OK) << tread_car_error(hosted_.get());
        EXPECT_EQ(tread_car_set_state(hosted_.get(), kept_.data(), kept_.size()), TREAD_OK);
    }

    // The clock of a car that its host steps is the number of steps times their length.
    void advanceHosted() {
        ASSERT_EQ(tread_car_advance(hosted_.get(), kCall), TREAD_OK) << tread_car_error(hosted_.get());
        EXPECT_EQ(tread_car_time(hosted_.get()), static_cast<double>(++hosted_steps_) * kCall);
    }

    void lookAt(int number) {
        for (std::size_t car = 0; car < fleet_.size(); ++car) add(fleet_.output(car), number);
        add(bullet_.vehicle->output(), number);
        add(hosted(), number);
    }

    VehicleOutput hosted() {
        VehicleOutput output;
        EXPECT_EQ(tread_car_outputs(hosted_.get(), reinterpret_cast<double*>(&output), tread_output_count()), TREAD_OK);
        return output;
    }

    // What rolls over is no car on its wheels any more, and no state of it is promised; that of the others is.
    void startLostCarsAgain() {
        for (std::size_t car = 0; car < fleet_.size(); ++car)
            if (isLost(fleet_.output(car))) fleet_.reset(car, {.speed = random(0, 25), .input = {}});
        if (isLost(bullet_.vehicle->output())) bullet_.vehicle->restore(fresh_.motion, fresh_.state, fresh_.input);
        if (isLost(hosted())) startHosted(1);
    }

    void add(const VehicleOutput& output, int number) {
        const auto* const values = reinterpret_cast<const double*>(&output);
        for (std::size_t i = 0; i < sizeof output / sizeof(double); ++i) {
            ASSERT_TRUE(std::isfinite(values[i])) << "output " << i << " at second " << number;
            hash_.add(values[i]);
        }
    }

    static bool isLost(const VehicleOutput& output) {
        const ChassisOutput& c = output.chassis;
        return std::abs(c.roll) > 1 || std::abs(c.pitch) > 1 || std::hypot(c.vx, c.vy, c.vz) > 70 ||
               std::hypot(c.x, c.y) > 1e4;
    }

    static std::vector<VehicleParams> cars() {
        std::vector<VehicleParams> all;
        for (int i = 0; i < 8; ++i) all.push_back(i % 2 == 0 ? reference::compact() : reference::rearDriveSedan());
        all.push_back(shared::withEverything(reference::compact()));
        return all;
    }

    std::mt19937 random_{11};
    CarFleet fleet_{cars(), {.threads = 2}};
    shared::PlaneWorld world_;
    shared::TreadCar bullet_{world_.dynamics, reference::compact(), 15};
    CarSnapshot fresh_{bullet_.vehicle->motion(), bullet_.vehicle->state(), {}};
    std::unique_ptr<tread_car, decltype(&tread_car_free)> hosted_{
        tread_car_load(sourceFile("vehicles/compact.yaml").c_str(), nullptr, nullptr, 0), tread_car_free};
    long hosted_steps_ = 0;
    std::vector<unsigned char> kept_;
    Hash hash_;
};

TEST(Soak, RandomDriving) {
    const int seconds = wanted("TREAD_SOAK_SECONDS", 10);
    Memory memory;
    std::uint64_t hashes[2];
    for (int round = 0; round < 2; ++round) {
        RandomDriving driving;
        for (int second = 0; second < seconds && !HasFailure(); ++second) {
            driving.second(second);
        }
        memory.at(round);
        hashes[round] = driving.hash();
    }
    std::printf("%d s of 11 cars, twice: hash %016llx\n", seconds, static_cast<unsigned long long>(hashes[0]));
    EXPECT_EQ(hashes[0], hashes[1]);
    memory.expectFlat("random driving");
}

// ---- Many short runs

Scenario shortTurn() {
    return readYamlText<Scenario>(R"(start: {speed: 20}
log: {rate: 100}
phases:
  - name: turn
    steering: {ramp: {to: 1, rate: 10}}
    brake: {ramp: {to: 0.3, rate: 5}}
    until: {duration: 0.05 s}
)",
                                  "short.yaml");
}

TEST(Soak, ManyShortRuns) {
    const int runs = wanted("TREAD_SOAK_RUNS", 200);
    const std::vector<VehicleParams> cars{reference::compact(), reference::rearDriveSedan(),
                                          shared::withEverything(reference::compact())};
    Memory memory;
    std::uint64_t hashes[2];
    for (int round = 0; round < 2; ++round) {
        std::mt19937 random(5);
        Hash hash;
        for (int run = 0; run < runs && !HasFailure(); ++run) {
            VehicleParams car = cars[random() % cars.size()];
            car.mass *= 0.9 + 1e-3 * static_cast<double>(random() % 200);
            Scenario scenario = shortTurn();
            scenario.start.speed = 5 + 0.1 * static_cast<double>(random() % 250);
            scenario.road.friction = 0.3 + 0.01 * static_cast<double>(random() % 80);
            const Log log = simulate(car, scenario, run % 2 == 0 ? MovedBy::bullet : MovedBy::itself);
            const std::vector<double>& time = log.channels.front().values;
            for (std::size_t k = 0; k < time.size(); ++k)
                ASSERT_EQ(time[k], static_cast<double>(10 * k) * scenario.step) << "the clock";
            for (const Channel& channel : log.channels)
                for (const double value : channel.values) hash.add(value);
        }
        memory.at(round);
        hashes[round] = hash.value;
    }
    std::printf("%d short runs, twice: hash %016llx\n", runs, static_cast<unsigned long long>(hashes[0]));
    EXPECT_EQ(hashes[0], hashes[1]);
    memory.expectFlat("short runs");
}

}  // namespace
}  // namespace tread::soak_test
