// Reading and writing log files, in values per second.
#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>

#include "log/csv.h"

namespace tread {
namespace {

// As wide as a log of a whole car, with numbers of full length.
Log fullLog(std::size_t channels, std::size_t samples) {
    Log log{{{"time", "s", {}}}};
    for (std::size_t i = 0; i < samples; ++i) log.channels[0].values.push_back(static_cast<double>(i) * 0.001);
    for (std::size_t c = 1; c < channels; ++c) {
        Channel channel{"channel." + std::to_string(c), "m", {}};
        for (double t : log.channels[0].values) channel.values.push_back(std::sin(t * static_cast<double>(c)) / 3);
        log.channels.push_back(std::move(channel));
    }
    return log;
}

std::filesystem::path file() {
    return std::filesystem::temp_directory_path() / "tread_log_benchmark.csv";
}

void writeLogFile(benchmark::State& state) {
    const Log log = fullLog(84, 10'000);
    for (auto _ : state) writeLog(file(), log);
    state.SetItemsProcessed(state.iterations() * 84 * 10'000);
    std::filesystem::remove(file());
}
BENCHMARK(writeLogFile)->Unit(benchmark::kMillisecond);

void readLogFile(benchmark::State& state) {
    writeLog(file(), fullLog(84, 10'000));
    for (auto _ : state) benchmark::DoNotOptimize(readLog(file()));
    state.SetItemsProcessed(state.iterations() * 84 * 10'000);
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(std::filesystem::file_size(file())));
    std::filesystem::remove(file());
}
BENCHMARK(readLogFile)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tread
