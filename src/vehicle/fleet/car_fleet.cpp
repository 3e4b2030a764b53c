#include "tread/car_fleet.h"

#include <algorithm>
#include <array>
#include <bit>
#include <stdexcept>
#include <string>
#include <thread>

#include "base/crew.h"
#include "road/plane.h"

namespace tread {
namespace {

constexpr double kLongestStep = 0.002;  // s, of `advance` in vehicle.h

struct Car {
    std::shared_ptr<const Vehicle> vehicle;  // copies of a car share it
    std::shared_ptr<const Road> road;
    ChassisMotion motion{};
    VehicleState state{};
    VehicleInput reached{};  // input with which the last call ended
    // Where it started last, and how; nothing when its road is another since.
    Start start{};
    std::shared_ptr<const Equilibrium> started{};
};

bool sameStart(const Start& a, const Start& b) {
    using Numbers = std::array<double, sizeof(Start) / sizeof(double)>;
    return std::bit_cast<Numbers>(a) == std::bit_cast<Numbers>(b);
}

VehicleInput between(const VehicleInput& a, const VehicleInput& b, double share) {
    using Numbers = std::array<double, sizeof(VehicleInput) / sizeof(double)>;
    const Numbers from = std::bit_cast<Numbers>(a), to = std::bit_cast<Numbers>(b);
    Numbers mixed;
    for (std::size_t i = 0; i < mixed.size(); ++i) mixed[i] = from[i] + share * (to[i] - from[i]);
    return std::bit_cast<VehicleInput>(mixed);
}

int threadsOf(const CarFleetSettings& settings) {
    if (settings.threads > 0) return settings.threads;
    return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

void check(const CarFleetSettings& settings) {
    if (!(settings.step > 0 && settings.step <= kLongestStep))
        throw std::invalid_argument("step: found " + std::to_string(settings.step) +
                                    " s, expected more than 0 and at most 0.002 s");
    if (settings.threads < 0)
        throw std::invalid_argument("threads: found " + std::to_string(settings.threads) +
                                    ", expected 0 (one per core) or more");
}

}  // namespace

struct CarFleet::Implementation {
    explicit Implementation(const CarFleetSettings& wanted) : settings(wanted), crew(threadsOf(wanted) - 1) {}

    CarFleetSettings settings;
    std::vector<Car> cars{};
    std::vector<VehicleInput> inputs{};
    Crew crew;

    void add(const std::shared_ptr<const Vehicle>& vehicle, const std::shared_ptr<const Road>& road) {
        cars.push_back({.vehicle = vehicle, .road = road});
        inputs.emplace_back();
    }
    std::shared_ptr<const Vehicle> prepared(const VehicleParams& car) const {
        return std::make_shared<const Vehicle>(prepare(car, settings.gravity_W.norm()));
    }

    Surroundings surroundings(const Car& car) const { return {*car.road, settings.gravity_W, settings.wind_W}; }

    void findStart(Car& car, const Start& start) {
        if (car.started && sameStart(car.start, start)) return;
        car.started = std::make_shared<const Equilibrium>(equilibrium(*car.vehicle, surroundings(car), start));
        car.start = start;
    }
    void takeStart(std::size_t index) {
        Car& car = cars[index];
        car.motion = car.started->motion;
        car.state = car.started->state;
        car.reached = inputs[index] = car.started->input;
    }

    // Of several copies of a car in a row that start alike, one finds how.
    void reset(std::span<const Start> starts, const std::vector<std::size_t>& which) {
        std::vector<std::size_t> finders, finder_of;
        for (const std::size_t i : which) {
            const auto startsLike = [&](std::size_t j) {
                return cars[i].vehicle == cars[j].vehicle && cars[i].road == cars[j].road &&
                       sameStart(starts[i], starts[j]);
            };
            if (finders.empty() || !startsLike(finders.back())) finders.push_back(i);
            finder_of.push_back(finders.back());
        }
        crew.each(
            finders.size(), [&](std::size_t k) { findStart(cars[finders[k]], starts[finders[k]]); }, 1);
        for (std::size_t k = 0; k < which.size(); ++k) {
            Car& car = cars[which[k]];
            const Car& finder = cars[finder_of[k]];
            car.start = finder.start;
            car.started = finder.started;
            takeStart(which[k]);
        }
    }

    void advance(std::size_t index, int steps, InputCourse course) {
        Car& car = cars[index];
        const VehicleInput& wanted = inputs[index];
        const VehicleInput from = course == InputCourse::held ? wanted : car.reached;
        const Surroundings around = surroundings(car);
        VehicleInput begin = from;
        for (int i = 1; i <= steps; ++i) {
            const VehicleInput end = i == steps ? wanted : between(from, wanted, static_cast<double>(i) / steps);
            tread::advance(car.motion, car.state, *car.vehicle, begin, end, around, settings.step);
            begin = end;
        }
        car.reached = wanted;
    }
};

CarFleet::CarFleet(const std::vector<VehicleParams>& cars, const CarFleetSettings& settings) {
    check(settings);
    self_ = std::make_unique<Implementation>(settings);
    const auto flat = std::make_shared<const PlaneRoad>();
    for (const VehicleParams& car : cars) self_->add(self_->prepared(car), flat);
    reset(Start{});
}

CarFleet::CarFleet(std::size_t count, const VehicleParams& car, const CarFleetSettings& settings) {
    check(settings);
    self_ = std::make_unique<Implementation>(settings);
    const auto flat = std::make_shared<const PlaneRoad>();
    const auto vehicle = self_->prepared(car);
    for (std::size_t i = 0; i < count; ++i) self_->add(vehicle, flat);
    reset(Start{});
}

CarFleet::CarFleet(CarFleet&&) noexcept = default;
CarFleet& CarFleet::operator=(CarFleet&&) noexcept = default;
CarFleet::~CarFleet() = default;

std::size_t CarFleet::size() const {
    return self_->cars.size();
}

double CarFleet::step() const {
    return self_->settings.step;
}

const Vehicle& CarFleet::vehicle(std::size_t car) const {
    return *self_->cars.at(car).vehicle;
}

void CarFleet::setRoad(const std::shared_ptr<const Road>& road) {
    for (std::size_t i = 0; i < size(); ++i) setRoad(i, road);
}

void CarFleet::setRoad(std::size_t index, const std::shared_ptr<const Road>& road) {
    if (!road) throw std::invalid_argument("road: found none, expected a road");
    Car& car = self_->cars.at(index);
    car.road = road;
    car.started.reset();
}

void CarFleet::reset(std::size_t car, const Start& start) {
    self_->findStart(self_->cars.at(car), start);
    self_->takeStart(car);
}

void CarFleet::reset(const Start& start) {
    reset(std::vector<Start>(size(), start));
}

void CarFleet::reset(std::span<const Start> starts) {
    reset(starts, std::vector<bool>(size(), true));
}

void CarFleet::reset(std::span<const Start> starts, const std::vector<bool>& which) {
    if (starts.size() != size() || which.size() != size())
        throw std::invalid_argument("reset: expected one start and one choice for each of " + std::to_string(size()) +
                                    " cars");
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < size(); ++i) {
        if (which[i]) chosen.push_back(i);
    }
    self_->reset(starts, chosen);
}

std::span<VehicleInput> CarFleet::inputs() {
    return self_->inputs;
}

VehicleInput& CarFleet::input(std::size_t car) {
    return self_->inputs.at(car);
}

void CarFleet::advance(int steps, InputCourse course) {
    self_->crew.each(
        size(), [&](std::size_t i) { self_->advance(i, steps, course); }, 1);
}

ChassisMotion CarFleet::motion(std::size_t car) const {
    return self_->cars.at(car).motion;
}

VehicleOutput CarFleet::output(std::size_t index) const {
    const Car& car = self_->cars.at(index);
    return observe(car.motion, car.state, *car.vehicle, self_->settings.gravity_W);
}

void CarFleet::output(std::span<VehicleOutput> outputs) const {
    if (outputs.size() != size())
        throw std::invalid_argument("output: expected room for each of " + std::to_string(size()) + " cars");
    self_->crew.each(size(), [&](std::size_t i) { outputs[i] = output(i); });
}

CarSnapshot CarFleet::snapshot(std::size_t index) const {
    const Car& car = self_->cars.at(index);
    return {car.motion, car.state, car.reached};
}

void CarFleet::restore(std::size_t index, const CarSnapshot& snapshot) {
    Car& car = self_->cars.at(index);
    car.motion = snapshot.motion;
    car.state = snapshot.state;
    car.reached = self_->inputs[index] = snapshot.input;
}

}  // namespace tread
