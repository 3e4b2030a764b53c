#include "run/simulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "base/pattern.h"
#include "road/plane.h"
#include "run/health.h"
#include "run/world.h"
#include "scenario/driver.h"
#include "tread/bullet_vehicle.h"
#include "tread/equilibrium.h"

namespace tread {
namespace {

constexpr double kNoEquilibrium = 0.01;  // m/s2 or rad/s2 left after settling
constexpr double kThrottleRounding = 1e-3;
constexpr double kMostStepsPerRow = 1e9;  // a row at the beginning and one at the end is the least

// What the run logs: columns, and where in the sample each number is read.
class Sample {
public:
    explicit Sample(const std::vector<std::string>& patterns) {
        std::vector<Number> all{{"time", &time, {"s", "time since the start of the manoeuvre"}}};
        for (Number& n : numbers(driver, "driver")) all.push_back(std::move(n));
        for (Number& n : numbers(car)) all.push_back(std::move(n));
        for (const Number& n : all) {
            const auto fits = [&](const std::string& pattern) { return matches(pattern, n.path); };
            if (n.path != "time" && !patterns.empty() && std::none_of(patterns.begin(), patterns.end(), fits)) continue;
            columns_.push_back({n.path, std::string(n.about.unit)});
            sources_.push_back(n.value);
        }
        row_.resize(sources_.size());
    }

    const std::vector<Column>& columns() const { return columns_; }
    std::span<const double> row() {
        for (std::size_t i = 0; i < row_.size(); ++i) row_[i] = *sources_[i];
        return row_;
    }

    double time = 0;
    VehicleInput driver;
    VehicleOutput car;

private:
    std::vector<Column> columns_;
    std::vector<double*> sources_;
    std::vector<double> row_;
};

double unwrapped(double angle, double previous) {
    return angle - 2 * std::numbers::pi * std::round((angle - previous) / (2 * std::numbers::pi));
}

Equilibrium startOf(const VehicleParams& params, const Scenario& scenario, const Surroundings& surroundings) {
    const StartParams& start = scenario.start;
    Equilibrium rest = equilibrium(prepare(params), surroundings,
                                   {.heading = start.heading, .speed = start.speed, .input = {.brake = start.brake}});
    if (!std::isfinite(rest.acceleration)) {
        throw SimulationError(
            fmt::format("the simulation broke down before the start, while the car settled on its wheels: its "
                        "acceleration is {} (a parameter far from that of a real car can do this)",
                        rest.acceleration),
            0);
    }
    if (rest.acceleration >= kNoEquilibrium) {
        throw SimulationError(
            fmt::format(
                "the car finds no equilibrium to start from: {:.3g} m/s2 are left after settling (does it stand "
                "on a slope with its brakes off, or on ice?)",
                rest.acceleration),
            0);
    }
    if (start.speed > 0 && (rest.throttle < -kThrottleRounding || rest.throttle > 1 + kThrottleRounding)) {
        throw SimulationError(
            fmt::format("the car cannot hold the {:.3g} m/s at which the scenario starts: that would take a "
                        "throttle of {:.2f}, and only 0 to 1 is possible; lower start.speed or give the car more power",
                        start.speed, rest.throttle),
            0);
    }
    rest.motion.position_W += start.drop * -surroundings.gravity_W.normalized();
    return rest;
}

}  // namespace

void simulate(const VehicleParams& params, const Scenario& scenario, const Recorder& recorder) {
    // World, car and road; the car in equilibrium.
    World world(params);
    PlaneRoad road(scenario.road.grade, scenario.road.bank, scenario.road.friction);
    const Equilibrium rest = startOf(params, scenario, {road});
    BulletVehicle car(params, world.chassis(), road);
    car.restore(rest.motion, rest.state, rest.input);
    Driver driver(scenario, rest.input, {params.wheelbase, params.steering.ratio});

    Sample sample(scenario.log.channels);
    sample.driver = rest.input;
    recorder.begin(sample.columns());

    // Step by step: look, record, decide, move.
    const double dt = scenario.step;
    const long steps_per_row = std::lround(std::clamp(1 / (scenario.log.rate * dt), 1.0, kMostStepsPerRow));
    for (long k = 0;; ++k) {
        sample.time = static_cast<double>(k) * dt;
        const double yaw_before = sample.car.chassis.yaw;
        sample.car = car.output();
        sample.car.chassis.yaw = unwrapped(sample.car.chassis.yaw, yaw_before);
        checkHealth(sample.car, sample.time);
        driver.look(sample.time, sample.car.chassis);

        const bool finished = driver.finished(sample.time);
        if (k % steps_per_row == 0 || finished) recorder.row(sample.row());
        if (finished) break;
        if (recorder.stop(sample.time)) {
            throw Interrupted(fmt::format("interrupted at t = {:.4g} s", sample.time), sample.time);
        }
        if (sample.time > scenario.time_limit) {
            throw SimulationError(
                fmt::format("the manoeuvre did not end within {:.4g} s: {}; change the scenario, or raise time_limit",
                            scenario.time_limit, driver.waitsFor()),
                sample.time);
        }

        sample.driver = driver.inputAt(static_cast<double>(k + 1) * dt);
        car.setInput(sample.driver);
        car.plan(dt);
        world.step(dt);
        car.observe();
    }
}

std::vector<Column> recordedColumns(const std::vector<std::string>& patterns) {
    return Sample(patterns).columns();
}

Recorder recorderInto(Log& log) {
    Recorder recorder;
    recorder.begin = [&](const std::vector<Column>& columns) {
        for (const Column& column : columns) log.channels.push_back({column.name, column.unit, {}});
    };
    recorder.row = [&](std::span<const double> row) {
        for (std::size_t i = 0; i < row.size(); ++i) log.channels[i].values.push_back(row[i]);
    };
    return recorder;
}

Log simulate(const VehicleParams& vehicle, const Scenario& scenario) {
    Log log;
    simulate(vehicle, scenario, recorderInto(log));
    return log;
}

}  // namespace tread
