// A step of 1 ms of a car as an FMU, with all driver inputs set and all outputs read, and of the same car in C++;
// beside step_1kHz/tread, the same in a Bullet world.

#include <benchmark/benchmark.h>

#include "benchmark/step.h"
#include "fmu/package/archive.h"
#include "host/car.h"
#include "host/channels.h"
#include "shared/fmu_importer.h"
#include "shared/vehicle_run.h"

namespace tread {
namespace {

void fmuStep(benchmark::State& state, fmu::FmiVersion version) {
    const Scratch scratch;
    const std::filesystem::path object = std::filesystem::path(programFile()).replace_filename("tread_fmu.so");
    const shared::Fmu fmu(scratch.file("car.fmu", fmu::packed(shared::compact(), contentOf(object), version)));
    const auto car = shared::carOf(fmu);
    car->start({{"start.speed", 20}}, {});
    std::vector<unsigned> inputs, outputs;
    for (const host::Channel& channel : host::inputChannels())
        inputs.push_back(fmu.reference("driver." + channel.name));
    for (const host::Channel& channel : host::outputChannels()) outputs.push_back(fmu.reference(channel.name));
    std::vector<double> given(inputs.size());
    given[1] = car->get("found.throttle");
    double time = 0;
    for (auto _ : state) {
        car->setAll(inputs, given);
        car->step(time, kStep);
        time += kStep;
        benchmark::DoNotOptimize(car->getAll(outputs).data());
    }
    state.counters["speed"] = car->get("chassis.vx");
}
BENCHMARK_CAPTURE(fmuStep, fmi2, fmu::FmiVersion::fmi2)->Name("step_1kHz/fmi2");
BENCHMARK_CAPTURE(fmuStep, fmi3, fmu::FmiVersion::fmi3)->Name("step_1kHz/fmi3");

void hostStep(benchmark::State& state) {
    host::Car car(shared::compact());
    car.start({.speed = 20});
    const VehicleInput input = car.input();
    for (auto _ : state) {
        car.setInput(input);
        car.advance(kStep);
        benchmark::DoNotOptimize(car.output().chassis.vx);
    }
    state.counters["speed"] = car.output().chassis.vx;
}
BENCHMARK(hostStep)->Name("step_1kHz/host");

}  // namespace
}  // namespace tread
