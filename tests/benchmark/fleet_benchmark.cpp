// Cars without Bullet: one alone, and a fleet in lanes of each width that this processor has.

#include <benchmark/benchmark.h>

#include "benchmark/step.h"
#include "shared/vehicle_run.h"
#include "tread/car_fleet.h"

namespace tread {
namespace {

constexpr std::size_t kCars = 64;
constexpr int kSteps = 10;  // a call

// A fleet that turns at 80 km/h; argument: lanes, 1 being one car after the other. `real_time_factor` counts the
// simulated time of every car.
void fleetSteps(benchmark::State& state) {
    CarFleet fleet(kCars, shared::compact(), {.step = kStep, .lanes = static_cast<int>(state.range(0))});
    fleet.reset({.speed = 22, .input = {}});
    for (VehicleInput& input : fleet.inputs()) input.steering_wheel_angle = 0.3;
    fleet.advance(500, InputCourse::ramped);
    for (auto _ : state) fleet.advance(kSteps);
    const double car_steps = static_cast<double>(state.iterations()) * kCars * kSteps;
    using Counter = benchmark::Counter;
    state.counters["car_step"] = Counter(car_steps, Counter::kIsRate | Counter::kInvert);
    state.counters["real_time_factor"] = Counter(car_steps * kStep, Counter::kIsRate);
}
BENCHMARK(fleetSteps)->Name("fleet/lanes")->Arg(1)->Arg(4)->Arg(8)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace tread
