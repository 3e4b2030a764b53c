#include "run/simulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/fields/numbers.h"
#include "base/math/elementary.h"
#include "base/math/turn.h"
#include "base/text/pattern.h"
#include "host/settled.h"
#include "run/health.h"
#include "run/pushed.h"
#include "run/sensors.h"
#include "scenario/driver.h"
#include "tread/equilibrium.h"
#include "tread/road_surface.h"
#include "tread/tyre.h"
#include "vehicle/tyre_load.h"

namespace tread {
namespace {

constexpr double kMostStepsPerRow = 1e9;  // a row at the beginning and one at the end is the least

// What the run logs: columns, and where in the sample each number is read.
class Sample {
public:
    Sample(const LogParams& params, bool in_scenario, bool on_course, double step = kInfinity) {
        std::vector<Number>& all = all_;
        all.push_back({"time", &time, {"s", "time since the start of the manoeuvre"}});
        for (Number& n : numbers(driver, "driver")) all.push_back(std::move(n));
        for (Number& n : numbers(car)) all.push_back(std::move(n));
        if (in_scenario) {
            for (Number& n : numbers(place.manoeuvre, "manoeuvre")) all.push_back(std::move(n));
        }
        if (on_course) {
            for (Number& n : numbers(place.course, "course")) all.push_back(std::move(n));
        }
        for (const Number& n : all) {
            const auto fits = [&](const std::string& pattern) { return matches(pattern, n.path); };
            const auto& patterns = params.channels;
            if (n.path != "time" && !patterns.empty() && std::none_of(patterns.begin(), patterns.end(), fits)) continue;
            columns_.push_back({n.path, std::string(n.about.unit)});
            sources_.push_back(n.value);
        }
        for (const SensorParams& sensor : params.sensors) {
            const auto source =
                std::find_if(all.begin(), all.end(), [&](const Number& n) { return n.path == sensor.channel; });
            if (source == all.end()) continue;  // refused by checkSensors()
            columns_.push_back({"sensor." + sensor.loggedName(), std::string(source->about.unit)});
            sensors_.push_back({Sensor(sensor, step), source->value});
        }
        row_.resize(columns_.size());
    }

    const std::vector<Column>& columns() const { return columns_; }
    std::span<const double> row() {
        for (std::size_t i = 0; i < sources_.size(); ++i) row_[i] = *sources_[i];
        for (std::size_t i = 0; i < sensors_.size(); ++i) row_[sources_.size() + i] = sensors_[i].sensor.reading();
        return row_;
    }

    // Whether sensors need the whole of every sample.
    bool isObserved() const { return !sensors_.empty(); }

    // Whether a look at the car finds all that the rows show.
    bool isSeenBy(const std::function<void()>& look) {
        const VehicleOutput before = car;
        for (const Number& n : numbers(car)) *n.value = std::nan("");
        look();
        const bool seen =
            std::all_of(sources_.begin(), sources_.end(), [](const double* value) { return std::isfinite(*value); });
        car = before;
        return seen;
    }

    // In every step, once the sample is complete.
    void observe(const PointMotion& body) {
        for (Observed& one : sensors_) one.sensor.observe(*one.source, body);
    }

    // Where the value of a channel is found, logged or not; nullptr: there is none of that name.
    const double* valueOf(std::string_view name) const {
        const auto found = std::find_if(all_.begin(), all_.end(), [&](const Number& n) { return n.path == name; });
        return found == all_.end() ? nullptr : found->value;
    }

    double time = 0;
    VehicleInput driver;
    VehicleOutput car;
    Place place;

private:
    std::vector<Number> all_;
    std::vector<Column> columns_;
    std::vector<double*> sources_;
    struct Observed {
        Sensor sensor;
        const double* source;
    };
    std::vector<Observed> sensors_;  // behind the channels
    std::vector<double> row_;
};

// The car starts in the part of the steady wind that blows along its heading: a side wind it meets as it starts, for
// held straight it is in no equilibrium there.
Vector3 startingWind(const Scenario& scenario) {
    const Vector3 heading(cosine(scenario.start.heading), sine(scenario.start.heading), 0);
    return windAt({.speed = scenario.wind.speed, .direction = scenario.wind.direction, .gust = {}}, 0, 0).dot(heading) *
           heading;
}

void checkSensors(const Scenario& scenario) {
    const std::vector<SensorParams>& sensors = scenario.log.sensors;
    if (sensors.empty()) return;
    const std::vector<KnownName> all = knownChannels(scenario);
    std::vector<std::string_view> names;
    for (const KnownName& channel : all) names.push_back(channel.name);
    for (const SensorFault& fault : sensorFaults(sensors, names)) {
        throw SimulationError(fmt::format("log.sensors.{}.{}: {}", fault.sensor, fault.path, fault.text), 0);
    }
}

void checkConditions(const Scenario& scenario) {
    for (const ConditionFault& fault : conditionFaults(scenario, knownChannels(scenario)))
        throw SimulationError(fmt::format("{}: {}", fault.path, fault.text), 0);
}

bool hasConditions(const Scenario& scenario) {
    return std::any_of(scenario.phases.begin(), scenario.phases.end(),
                       [](const Phase& phase) { return static_cast<bool>(phase.until.when); });
}

// The first phase does without the pedals, and so without what the engine can do.
bool startsWithoutPedals(const Scenario& scenario) {
    return !scenario.phases.empty() && commandsForce(scenario.phases.front().throttle);
}

// What a driver who follows a speed knows of the car in its equilibrium.
KnownResistance resistanceOf(const Vehicle& vehicle, const VehicleState& state) {
    KnownResistance known{.mass = vehicle.params.mass, .force = 0};
    for (std::size_t i = 0; i < kWheels; ++i) {
        const Vehicle::Corner& corner = vehicle.corners[i];
        const double radius = rollingRadius(corner.tyre, state.wheels[i].motion.Fz);
        known.mass += corner.wheel_inertia / (radius * radius);
        known.force += state.wheels[i].drive_torque / radius;
    }
    return known;
}

// What a driver who knows the course knows of the car's grip: that of the axle which reaches its end first when all its
// wheels bear their static loads, by the tyres' lateral friction (51). Load transfer costs some of it.
KnownGrip gripOf(const Vehicle& vehicle, double friction) {
    KnownGrip grip{.lateral = kInfinity};
    for (std::size_t axle = 0; axle < kWheels; axle += 2) {
        double force = 0, load = 0;
        for (std::size_t i = axle; i < axle + 2; ++i) {
            const Vehicle::Corner& corner = vehicle.corners[i];
            const double on_wheel = corner.static_force + corner.unsprung_mass * kStandardGravity;
            force += friction * steadyState(corner.tyre, {.Fz = on_wheel, .Vx = 1}).muy * on_wheel;
            load += on_wheel;
        }
        grip.lateral = std::min(grip.lateral, force / load * kStandardGravity);
    }
    return grip;
}

Settled settledAtStart(const Vehicle& vehicle, const Scenario& scenario, Road& road, MovedBy by, const Settled* from) {
    const StartParams& start = scenario.start;
    return settledBy(by, vehicle, road, startingWind(scenario),
                     {.heading = start.heading,
                      .speed = start.speed,
                      .input = {.brake = start.brake, .parking_brake = start.parking_brake}},
                     from);
}

Equilibrium startOf(const VehicleParams& params, const Scenario& scenario, Road& road, MovedBy by,
                    const Settled* from) {
    const StartParams& start = scenario.start;
    const Vehicle vehicle = prepare(params);
    Equilibrium rest = atRest(settledAtStart(vehicle, scenario, road, by, from), vehicle);
    const host::StartFault fault = host::startFault(rest, start.speed, !startsWithoutPedals(scenario));
    if (fault == host::StartFault::broke_down) {
        throw SimulationError(
            fmt::format("the simulation broke down before the start, while the car settled on its wheels: its "
                        "acceleration is {} (a parameter far from that of a real car can do this)",
                        rest.acceleration),
            0, SimulationError::Suspect::numbers);
    }
    if (fault == host::StartFault::no_equilibrium) {
        throw SimulationError(
            fmt::format(
                "the car finds no equilibrium to start from: {:.3g} m/s2 are left after settling (does it stand "
                "on a slope with its brakes off, or on ice?)",
                rest.acceleration),
            0, SimulationError::Suspect::numbers);
    }
    if (fault == host::StartFault::too_fast) {
        throw SimulationError(
            fmt::format("the car cannot hold the {:.3g} m/s at which the scenario starts: that would take a "
                        "throttle of {:.2f}, and only 0 to 1 is possible; lower start.speed or give the car more power",
                        start.speed, rest.throttle),
            0);
    }
    rest.motion.position_W += start.drop * -kGravityOfRuns_W.normalized();
    return rest;
}

}  // namespace

void simulate(const VehicleParams& params, const Scenario& scenario, const Recorder& recorder, const Pushing& pushing,
              MovedBy by, const Settled* from) {
    // Road, and the car on it in equilibrium.
    const std::unique_ptr<Road> road = makeRoad(scenario.road);
    const Equilibrium rest = startOf(params, scenario, *road, by, from);
    const std::unique_ptr<Mover> car = mover(by, params, *road, rest, scenario.substep);
    Pushed pushed(pushing, car->vehicle());
    checkSensors(scenario);
    checkConditions(scenario);
    Sample sample(scenario.log, true, hasCourse(scenario.course), scenario.step);
    Driver driver(
        scenario, rest.input, {params.wheelbase, params.steering.ratio, params.steering.ratio_curve},
        resistanceOf(car->vehicle(), rest.state), [&](std::string_view name) { return sample.valueOf(name); },
        gripOf(car->vehicle(), scenario.road.friction));
    const auto glanceAt = [&] {
        glance(sample.car, car->motion(), car->stateAtGlance(), car->vehicle(), kGravityOfRuns_W);
    };
    const bool sees_everything = sample.isObserved() || hasConditions(scenario);
    const bool pushed_unseen = !pushing || pushing.target<PushingOverTime>();
    const bool rows_at_glance = pushed_unseen && sample.isSeenBy(glanceAt);

    sample.driver = rest.input;
    recorder.begin(sample.columns());

    // Step by step: look, record, decide, move.
    const double dt = scenario.step;
    const long steps_per_row = std::lround(std::clamp(1 / (scenario.log.rate * dt), 1.0, kMostStepsPerRow));
    for (long k = -std::lround(scenario.start.run_in / dt);; ++k) {
        sample.time = static_cast<double>(k) * dt;
        const double yaw_before = sample.car.chassis.yaw;
        const bool row_due = k >= 0 && k % steps_per_row == 0;
        const auto look = [&](bool at_everything) {
            if (at_everything) {
                sample.car = observe(car->motion(), car->state(), car->vehicle(), kGravityOfRuns_W);
            } else {
                glanceAt();
            }
            sample.car.chassis.yaw = unwrapped(sample.car.chassis.yaw, yaw_before);
            pushed.felt(sample.car.chassis);
        };
        look((row_due && !rows_at_glance) || sees_everything);
        checkHealth(sample.car, sample.time);
        if (sample.isObserved())
            sample.observe(pushed.felt(referenceMotion(car->motion(), car->stateAtGlance(), car->vehicle())));
        driver.look(sample.time, sample.car.chassis, sample.car.steering.angle);
        sample.place = driver.place();

        const bool finished = driver.finished(sample.time);
        if (finished && !row_due) look(!rows_at_glance);
        if (row_due || finished) recorder.row(sample.row());
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
        car->setInput(sample.driver);
        car->setWind(windAt(scenario.wind, sample.time + 0.5 * dt, sample.car.chassis.x));
        car->move(dt, pushed.over(sample.time, sample.driver, sample.car));
    }
}

Settled settledAtStart(const VehicleParams& params, const Scenario& scenario) {
    const std::unique_ptr<Road> road = makeRoad(scenario.road);
    return settledAtStart(prepare(params), scenario, *road, MovedBy::itself, nullptr);
}

std::vector<Column> recordedColumns(const std::vector<std::string>& patterns) {
    return Sample({.channels = patterns}, false, false).columns();
}

std::vector<Column> columnsOf(const Scenario& scenario) {
    return Sample(scenario.log, true, hasCourse(scenario.course), scenario.step).columns();
}

std::vector<KnownName> knownChannels(const Scenario& scenario) {
    std::vector<KnownName> known;
    const Sample everything({}, true, hasCourse(scenario.course));
    for (const Column& column : everything.columns()) known.push_back({column.name, column.unit});
    return known;
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

Log simulate(const VehicleParams& vehicle, const Scenario& scenario, MovedBy by) {
    Log log;
    simulate(vehicle, scenario, recorderInto(log), {}, by);
    return log;
}

}  // namespace tread
