// One car in a Bullet world, tread's beside the stock vehicle in the same run; and whole headless drives.

#include <benchmark/benchmark.h>

#include <numeric>
#include <vector>

#include "base/threads/keep_memory.h"
#include "base/threads/parallel.h"
#include "benchmark/step.h"
#include "run/together.h"
#include "shared/bullet_scene.h"
#include "shared/equipped_car.h"
#include "shared/vehicle_run.h"

namespace tread {
namespace {

constexpr double kSpeed = 20;  // m/s

// The car goes straight on; it is set back before it leaves where a float world would still be exact.
template <class Car>
void driveOn(benchmark::State& state, const VehicleParams& params) {
    shared::PlaneWorld world;
    Car car(world.dynamics, params, kSpeed);
    for (int i = 0; i < 1000; ++i) world.dynamics.stepSimulation(kStep, 0);
    for (auto _ : state) world.dynamics.stepSimulation(kStep, 0);
    state.counters["speed"] = car.chassis().getLinearVelocity().x();
}
void stockStep(benchmark::State& state) {
    driveOn<shared::StockCar>(state, shared::compact());
}
void treadStep(benchmark::State& state) {
    driveOn<shared::TreadCar>(state, shared::compact());
}
void everythingStep(benchmark::State& state) {
    driveOn<shared::TreadCar>(state, shared::withEverything(shared::compact()));
}
BENCHMARK(stockStep)->Name("step_1kHz/stock");
BENCHMARK(treadStep)->Name("step_1kHz/tread");
BENCHMARK(everythingStep)->Name("step_1kHz/tread_everything");

void emptyWorld(benchmark::State& state) {
    shared::PlaneWorld world;
    for (auto _ : state) world.dynamics.stepSimulation(kStep, 0);
}
BENCHMARK(emptyWorld)->Name("step_1kHz/empty_world");

// Equilibrium, step steer of 6 s at 1 kHz, log in memory. `real_time_factor`: simulated over computed time.
void wholeRun(benchmark::State& state, const VehicleParams& car) {
    const Scenario scenario = shared::scenario("step_steer_80");
    double simulated = 0;
    for (auto _ : state) simulated += simulate(car, scenario).channels.front().values.back();
    state.counters["real_time_factor"] = benchmark::Counter(simulated, benchmark::Counter::kIsRate);
}
void shippedRun(benchmark::State& state) {
    wholeRun(state, shared::compact());
}
void everythingRun(benchmark::State& state) {
    wholeRun(state, shared::withEverything(shared::compact()));
}
BENCHMARK(shippedRun)->Name("headless/step_steer_80")->Unit(benchmark::kMillisecond);
BENCHMARK(everythingRun)->Name("headless/step_steer_80_everything")->Unit(benchmark::kMillisecond);

// The same by 64 cars that differ, as in a campaign: on one thread, one after the other and in lanes.
void campaignRun(benchmark::State& state, bool together) {
    keepMemory();
    constexpr std::size_t kRuns = 64;
    const Scenario scenario = shared::scenario("step_steer_80");
    const VehicleParams nominal = shared::compact();
    std::vector<double> simulated(kRuns);
    const auto run = [&](std::size_t i) {
        VehicleParams car = nominal;
        car.mass *= 1 + 0.001 * static_cast<double>(i);
        simulated[i] += simulate(car, scenario, MovedBy::itself).channels.front().values.back();
    };
    for (auto _ : state) {
        if (together) drivenTogether(kRuns, 1, run);
        else inParallel(kRuns, 1, run);
    }
    state.counters["real_time_factor"] =
        benchmark::Counter(std::accumulate(simulated.begin(), simulated.end(), 0.0), benchmark::Counter::kIsRate);
}
void runsAlone(benchmark::State& state) {
    campaignRun(state, false);
}
void runsInLanes(benchmark::State& state) {
    campaignRun(state, true);
}
BENCHMARK(runsAlone)->Name("campaign/alone")->Unit(benchmark::kMillisecond);
BENCHMARK(runsInLanes)->Name("campaign/in_lanes")->Unit(benchmark::kMillisecond);

void settling(benchmark::State& state) {
    const Vehicle car = prepare(shared::compact());
    struct Flat : Road {
        RoadContact contact(const Vector3&, std::size_t) const override { return {}; }
    } flat;
    for (auto _ : state) benchmark::DoNotOptimize(equilibrium(car, {flat}, {.speed = 22, .input = {}}).throttle);
}
BENCHMARK(settling)->Name("headless/equilibrium")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tread
