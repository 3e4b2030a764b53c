#include "tread/car_fleet.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

#include "base/threads/crew.h"
#include "road/plane.h"
#include "vehicle/fleet/lane_kind.h"

namespace tread {
namespace {

constexpr double kLongestStep = 0.002;  // s, of `advance` in vehicle.h

struct Car {
    std::shared_ptr<const Vehicle> vehicle;  // copies of a car share it
    std::shared_ptr<const Road> road;
    std::shared_ptr<const std::vector<double>> numbers;  // of the vehicle, for lanes; none: it does not fit in one
    std::optional<GroundNumbers> plane{};                // that the road is everywhere
    Vector3 wind_W;
    ChassisMotion motion{};
    VehicleState state{};
    VehicleInput reached{};  // input with which the last call ended
    // Where it started last, and how; nothing when its road or wind is another since.
    Start start{};
    std::shared_ptr<const Equilibrium> started{};
};

// Cars that a thread takes at once: several in lanes, or a single one.
struct Unit {
    std::vector<std::size_t> cars;
    const LaneKind* kind = nullptr;
    std::shared_ptr<void> block{};
    std::vector<VehicleState> idle{};  // of lanes that are left over: they repeat the last car
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
    if (settings.lanes < 1)
        throw std::invalid_argument("lanes: found " + std::to_string(settings.lanes) + ", expected 1 or more");
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
    std::vector<Unit> units{};
    Crew crew;

    void add(const std::shared_ptr<const Vehicle>& vehicle) {
        const bool known = !cars.empty() && cars.back().vehicle == vehicle;
        std::shared_ptr<const std::vector<double>> numbers;
        if (known) numbers = cars.back().numbers;
        else if (fitsInLane(*vehicle)) numbers = std::make_shared<const std::vector<double>>(numbersOf(*vehicle));
        cars.push_back({.vehicle = vehicle, .road = {}, .numbers = numbers, .wind_W = settings.wind_W});
        inputs.emplace_back();
    }

    // Cars in lanes as long as that pays, the others alone.
    void formUnits() {
        const LaneKind* kind = laneKind(static_cast<std::size_t>(settings.lanes));
        std::vector<std::size_t> together;
        const auto close = [&] {
            if (kind && together.size() >= kLanesPay) {
                units.push_back({.cars = together, .kind = kind, .block = memoryFor(*kind)});
                Unit& unit = units.back();
                unit.idle.resize(kind->lanes - together.size());
                const std::vector<LaneCar> lanes = lanesOf(unit);
                for (std::size_t i = 0; i < kind->lanes; ++i) kind->prepare(unit.block.get(), i, lanes[i]);
            } else {
                for (const std::size_t i : together) units.push_back({.cars = {i}});
            }
            together.clear();
        };
        for (std::size_t i = 0; i < cars.size(); ++i) {
            if (!kind || !cars[i].numbers) {
                units.push_back({.cars = {i}});
                continue;
            }
            together.push_back(i);
            if (together.size() == kind->lanes) close();
        }
        close();
    }

    static std::size_t carIn(const Unit& unit, std::size_t lane) {
        return unit.cars[std::min(lane, unit.cars.size() - 1)];
    }

    std::vector<LaneCar> lanesOf(Unit& unit) {
        std::vector<LaneCar> lanes;
        for (std::size_t i = 0; i < unit.kind->lanes; ++i) {
            Car& car = cars[carIn(unit, i)];
            VehicleState* state = &car.state;
            if (i >= unit.cars.size()) {
                state = &unit.idle[i - unit.cars.size()];
                *state = car.state;
            }
            lanes.push_back({.vehicle = car.vehicle.get(),
                             .numbers = car.numbers->data(),
                             .state = state,
                             .motion = numbersOf(car.motion),
                             .road = car.road.get(),
                             .wind_W = {car.wind_W.x(), car.wind_W.y(), car.wind_W.z()},
                             .tyres_shifted = car.vehicle->tyres_shifted,
                             .warmth_felt = car.vehicle->warmth_felt,
                             .plane = car.plane ? &*car.plane : nullptr});
        }
        return lanes;
    }
    std::shared_ptr<const Vehicle> prepared(const VehicleParams& car) const {
        return std::make_shared<const Vehicle>(prepare(car, settings.gravity_W.norm()));
    }

    Surroundings surroundings(const Car& car) const { return {*car.road, settings.gravity_W, car.wind_W}; }

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

    // Input of a car after i of the steps of one call.
    VehicleInput inputAt(std::size_t car, int i, int steps, InputCourse course) const {
        if (course == InputCourse::held || i == steps) return inputs[car];
        return between(cars[car].reached, inputs[car], static_cast<double>(i) / steps);
    }

    void advanceAlone(std::size_t index, int steps, InputCourse course) {
        Car& car = cars[index];
        const Surroundings around = surroundings(car);
        VehicleInput begin = inputAt(index, 0, steps, course);
        for (int i = 1; i <= steps; ++i) {
            const VehicleInput end = inputAt(index, i, steps, course);
            tread::advance(car.motion, car.state, *car.vehicle, begin, end, around, settings.step);
            begin = end;
        }
    }

    void advanceInLanes(Unit& unit, int steps, InputCourse course) {
        std::vector<LaneCar> lanes = lanesOf(unit);
        for (std::size_t k = 0; k < lanes.size(); ++k) unit.kind->load(unit.block.get(), k, lanes[k]);
        const Vector3& g = settings.gravity_W;
        const std::array<double, 3> gravity_W{g.x(), g.y(), g.z()};
        std::vector<VehicleInput> begin, end(lanes.size());
        for (std::size_t k = 0; k < lanes.size(); ++k) begin.push_back(inputAt(carIn(unit, k), 0, steps, course));
        for (int i = 1; i <= steps; ++i) {
            for (std::size_t k = 0; k < lanes.size(); ++k) end[k] = inputAt(carIn(unit, k), i, steps, course);
            unit.kind->step(unit.block.get(), begin.data(), end.data(), gravity_W, settings.step);
            begin.swap(end);
        }
        for (std::size_t k = 0; k < unit.cars.size(); ++k) {
            unit.kind->store(unit.block.get(), k, lanes[k]);
            cars[unit.cars[k]].motion = motionOf(lanes[k].motion);
        }
    }

    void advance(Unit& unit, int steps, InputCourse course) {
        if (unit.kind) {
            advanceInLanes(unit, steps, course);
        } else {
            for (const std::size_t i : unit.cars) advanceAlone(i, steps, course);
        }
        for (const std::size_t i : unit.cars) cars[i].reached = inputs[i];
    }
};

CarFleet::CarFleet(const std::vector<VehicleParams>& cars, const CarFleetSettings& settings) {
    check(settings);
    self_ = std::make_unique<Implementation>(settings);
    for (const VehicleParams& car : cars) self_->add(self_->prepared(car));
    begin();
}

CarFleet::CarFleet(std::size_t count, const VehicleParams& car, const CarFleetSettings& settings) {
    check(settings);
    self_ = std::make_unique<Implementation>(settings);
    const auto vehicle = self_->prepared(car);
    for (std::size_t i = 0; i < count; ++i) self_->add(vehicle);
    begin();
}

void CarFleet::begin() {
    setRoad(std::make_shared<const PlaneRoad>());
    self_->formUnits();
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
    car.plane = planeOf(*road);
    car.started.reset();
}

void CarFleet::setWind(const Vector3& wind_W) {
    for (std::size_t i = 0; i < size(); ++i) setWind(i, wind_W);
}

void CarFleet::setWind(std::size_t index, const Vector3& wind_W) {
    Car& car = self_->cars.at(index);
    car.wind_W = wind_W;
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
    auto& units = self_->units;
    self_->crew.each(
        units.size(), [&](std::size_t i) { self_->advance(units[i], steps, course); }, 1);
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
