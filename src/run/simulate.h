// Drives a scenario with a car and records what happens.
#pragma once

#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "log/csv.h"
#include "log/log.h"
#include "run/mover.h"
#include "run/push.h"
#include "scenario/conditions.h"
#include "scenario/scenario.h"
#include "tread/vehicle.h"

namespace tread {

// The simulation could not go on; the rows so far have been handed out.
class SimulationError : public std::runtime_error {
public:
    // What is to be looked at: the manoeuvre, which asks too much; the numbers of the car, which breaks down.
    enum class Suspect { manoeuvre, numbers };
    SimulationError(const std::string& what, double at, Suspect of = Suspect::manoeuvre)
        : std::runtime_error(what), time(at), suspect(of) {}
    double time;  // s
    Suspect suspect;
};

// The user stopped the run.
class Interrupted : public SimulationError {
public:
    using SimulationError::SimulationError;
};

// Where the rows of a run go, while it runs.
struct Recorder {
    std::function<void(const std::vector<Column>&)> begin = [](const std::vector<Column>&) {};
    std::function<void(std::span<const double>)> row = [](std::span<const double>) {};
    std::function<bool(double time)> stop = [](double) { return false; };  // asked in every step
};

// Columns of the car with these `log.channels`; none: all.
std::vector<Column> recordedColumns(const std::vector<std::string>& patterns);

// Columns of the log of a scenario: those of the car, its place in the scenario and on the course, sensors.
std::vector<Column> columnsOf(const Scenario& scenario);

// The channels that a scenario can log, which conditions of its phases may name.
std::vector<KnownName> knownChannels(const Scenario& scenario);

// Throws SimulationError when a value is not finite or out of bounds, when the car cannot hold the speed at which the
// scenario starts, or when the manoeuvre does not end. `pushing`, when there is one, acts on the body besides. The
// rows are the same, bit for bit, whoever moves the car; with a push they differ by rounding. `from`: where a similar
// car has settled at the same start, on the same road and in the same wind, from which this one settles; null: none.
void simulate(const VehicleParams& vehicle, const Scenario& scenario, const Recorder& recorder,
              const Pushing& pushing = {}, MovedBy by = MovedBy::bullet, const Settled* from = nullptr);

// Where a car settles before a scenario begins.
Settled settledAtStart(const VehicleParams& vehicle, const Scenario& scenario);

// Records into a log in memory, which must outlive the recorder.
Recorder recorderInto(Log& log);

// The same into memory.
Log simulate(const VehicleParams& vehicle, const Scenario& scenario, MovedBy by = MovedBy::bullet);

}  // namespace tread
