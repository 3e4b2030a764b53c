// One car in a Bullet world, tread's beside the stock vehicle in the same run; and a whole headless drive.

#include <benchmark/benchmark.h>

#include "shared/bullet_scene.h"
#include "shared/vehicle_run.h"

namespace tread {
namespace {

constexpr double kStep = 0.001;  // s
constexpr double kSpeed = 20;    // m/s

// The car goes straight on; it is set back before it leaves where a float world would still be exact.
template <class Car>
void driveOn(benchmark::State& state) {
    shared::PlaneWorld world;
    Car car(world.dynamics, shared::compact(), kSpeed);
    for (int i = 0; i < 1000; ++i) world.dynamics.stepSimulation(kStep, 0);
    for (auto _ : state) world.dynamics.stepSimulation(kStep, 0);
    state.counters["speed"] = car.chassis().getLinearVelocity().x();
}
BENCHMARK(driveOn<shared::StockCar>)->Name("step_1kHz/stock");
BENCHMARK(driveOn<shared::TreadCar>)->Name("step_1kHz/tread");

void emptyWorld(benchmark::State& state) {
    shared::PlaneWorld world;
    for (auto _ : state) world.dynamics.stepSimulation(kStep, 0);
}
BENCHMARK(emptyWorld)->Name("step_1kHz/empty_world");

// Equilibrium, step steer of 6 s at 1 kHz, log in memory. `real_time_factor`: simulated over computed time.
void wholeRun(benchmark::State& state) {
    const VehicleParams car = shared::compact();
    const Scenario scenario = shared::scenario("step_steer_80");
    double simulated = 0;
    for (auto _ : state) simulated += simulate(car, scenario).channels.front().values.back();
    state.counters["real_time_factor"] = benchmark::Counter(simulated, benchmark::Counter::kIsRate);
}
BENCHMARK(wholeRun)->Name("headless/step_steer_80")->Unit(benchmark::kMillisecond);

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
