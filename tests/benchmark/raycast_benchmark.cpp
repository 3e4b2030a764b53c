// tread's drop-in beside Bullet's stock vehicle in the same game: the cost of a step, driving and asleep, and of many
// cars.

#include <benchmark/benchmark.h>

#include <string>

#include "game_scene.h"
#include "tread/raycast_fleet.h"

namespace tread {
namespace {

using game::Ground;

// A step of the world at 1 kHz with one car that drives at 20 m/s, turning on the spot of the hills.
template <class Vehicle>
void drives(benchmark::State& state, Ground ground) {
    scene::World world;
    game::Hills hills;
    hills.add(world, ground);
    scene::Car<Vehicle> car(world, {.height = 0.56, .speed = 20});
    scene::run(world, 1, 1000);
    car.steer(0.05);
    car.push(300);
    for (auto _ : state) world.dynamics.stepSimulation(scene::scalar(0.001), 0);
    state.counters["speed"] = static_cast<double>(car.velocity().length());
}

// One picture at 60 Hz, with substeps of so many microseconds.
void picture(benchmark::State& state) {
    scene::World world;
    world.addPlane();
    scene::Car<RaycastVehicle> car(world, {.speed = 20, .substep = 1e-6 * static_cast<double>(state.range(0))});
    scene::run(world, 1, 60);
    car.steer(0.05);
    car.push(300);
    for (auto _ : state) world.dynamics.stepSimulation(scene::scalar(1.0 / 60), 0);
}
BENCHMARK(picture)->Name("game_60Hz/tread_substep_us")->Arg(1000)->Arg(2000)->Arg(4000)->Arg(8000)->Arg(17000);

template <class Vehicle>
void asleep(benchmark::State& state) {
    scene::World world;
    world.addPlane();
    scene::Car<Vehicle> car(world, {.sleeps = true});
    car.brake(50);
    scene::run(world, 6, 60);
    for (auto _ : state) car.vehicle->updateAction(&world.dynamics, scene::scalar(0.001));
    state.counters["asleep"] = car.chassis->isActive() ? 0 : 1;
}
BENCHMARK(asleep<btRaycastVehicle>)->Name("game_asleep/stock");
BENCHMARK(asleep<RaycastVehicle>)->Name("game_asleep/tread");

// So many cars, one picture at 60 Hz, as they are by default; `cars`: how many would keep up with real time.
template <class Vehicle>
void crowd(benchmark::State& state, Ground ground, int count, int fleet_threads) {
    scene::World world;
    game::Hills hills;
    hills.add(world, ground);
    std::vector<std::unique_ptr<scene::Car<Vehicle>>> cars;
    for (int i = 0; i < count; ++i) {
        scene::Setup setup{.height = 0.56, .speed = 5};
        setup.place.setOrigin(scene::vector(6 * (i % 40 - 20), 0, 8 * (i / 40 - 12)));
        cars.push_back(std::make_unique<scene::Car<Vehicle>>(world, setup));
        cars.back()->push(200);
    }
    std::unique_ptr<RaycastFleet> fleet;
    if constexpr (std::is_same_v<Vehicle, RaycastVehicle>) {
        if (fleet_threads > 0) fleet = std::make_unique<RaycastFleet>(fleet_threads);
        for (auto& car : cars) {
            if (!fleet) break;
            world.dynamics.removeVehicle(car->vehicle.get());
            fleet->add(*car->vehicle);
        }
        if (fleet) world.dynamics.addAction(fleet.get());
    }
    scene::run(world, 0.2, 60);
    double pictures = 0;
    for (auto _ : state) {
        world.dynamics.stepSimulation(scene::scalar(1.0 / 60), 0);
        ++pictures;
    }
    state.counters["cars"] = benchmark::Counter(pictures * count / 60, benchmark::Counter::kIsRate);
}

const bool registered = [] {
    const std::pair<const char*, Ground> grounds[] = {
        {"plane", Ground::plane}, {"height_field", Ground::height_field}, {"mesh", Ground::mesh}};
    for (const auto& [name, ground] : grounds) {
        const std::string title = std::string("game_1kHz/") + name;
        benchmark::RegisterBenchmark((title + "/stock").c_str(), drives<btRaycastVehicle>, ground);
        benchmark::RegisterBenchmark((title + "/tread").c_str(), drives<RaycastVehicle>, ground);
    }
    using benchmark::kMillisecond;
    for (const auto& [name, ground] : grounds) {
        for (int count : {100, 1000}) {
            const std::string title = "game_60Hz_" + std::to_string(count) + "/" + name;
            benchmark::RegisterBenchmark((title + "/stock").c_str(), crowd<btRaycastVehicle>, ground, count, 0)
                ->Unit(kMillisecond);
            benchmark::RegisterBenchmark((title + "/tread").c_str(), crowd<RaycastVehicle>, ground, count, 0)
                ->Unit(kMillisecond);
            for (int threads : {1, 2}) {
                const std::string fleet = title + "/fleet_of_threads_" + std::to_string(threads);
                benchmark::RegisterBenchmark(fleet.c_str(), crowd<RaycastVehicle>, ground, count, threads)
                    ->UseRealTime()
                    ->Unit(kMillisecond);
            }
        }
    }
    return true;
}();

}  // namespace
}  // namespace tread
