// Blind cases from a simulator that shares no vehicle code with tread (tests/shared/other_car): the diagnosis must
// stand its ground where the structure of its model is not that of the car.
//
//   other_cases make --vehicle vehicles/compact.yaml --cases 20 --seed 1 --reference -o cases
//   tread blind score cases cases.key.json -o score
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "blind/gauges.h"
#include "blind/make.h"
#include "blind/other_match.h"
#include "blind/other_measure.h"
#include "diagnose/catalogue/effect.h"
#include "shared/other_car/compact.h"
#include "store/sha256.h"
#include "tread/load.h"
#include "tread/problem.h"

namespace other_car {
namespace {

namespace fs = std::filesystem;

struct Options {
    std::string vehicle, output;
    std::vector<std::string> kinds{"one", "one", "none"};
    int cases = 0;
    std::uint64_t seed = 0;
    bool reference = false;
};

constexpr std::uint64_t kBefore = 1;  // another run, other noise

Truth asKnown(const tread::VehicleParams& vehicle) {
    Truth truth;
    truth.car = compact();
    return matched(truth, vehicle);
}

// How far tread's car is from this one without noise and disturbances: root mean square in units of the instruments'
// noise over means of 50 ms, as a diagnosis counts it.
void gap(const Options& options) {
    const tread::VehicleParams vehicle = tread::loadVehicle(options.vehicle);
    const Truth truth = asKnown(vehicle);
    fmt::print("{:<22}", "");
    for (const tread::Gauge& gauge : tread::gauges()) {
        const std::string name(gauge.channel);
        if (!name.starts_with("driver.")) fmt::print("{:>10}", name.substr(name.find('.') + 1, 9));
    }
    for (const tread::Drive& drive : tread::blindDrives()) {
        const tread::Log other = measure(truth, drive, 1, tread::kIdeal), own = drivenByTread(vehicle, drive);
        fmt::print("\n{:<22}", drive.name);
        for (const tread::Gauge& gauge : tread::gauges()) {
            if (gauge.channel.starts_with("driver.")) continue;
            const std::vector<double> x = means(other, gauge.channel), y = means(own, gauge.channel);
            double squares = 0;
            for (std::size_t i = 0; i < x.size(); ++i) squares += (x[i] - y[i]) * (x[i] - y[i]);
            fmt::print("{:>10.2f}", std::sqrt(squares / static_cast<double>(x.size())) / noiseOfMeans(gauge));
        }
    }
    fmt::print("\n");
}

void make(const Options& options) {
    const tread::VehicleParams nominal = tread::loadVehicle(options.vehicle);
    const Truth known = asKnown(nominal);
    const std::vector<tread::diagnose::catalogue::Effect> effects =
        plantable(tread::diagnose::catalogue::effectCatalogue(), nominal);
    const std::vector<tread::Drive> drives = tread::blindDrives();
    tread::BlindKey key;
    key.seed = options.seed;
    key.vehicle = options.vehicle;
    key.generator = "a double-track model";
    for (int i = 0; i < options.cases; ++i) {
        const auto index = static_cast<std::size_t>(i);
        tread::Random random(tread::seedOf(options.seed, index));
        const tread::CaseKind kind = tread::caseKind(options.kinds[index % options.kinds.size()]);
        Drawn drawn = draw(known, nominal, effects, kind, random);
        drawn.key.name = fmt::format("case_{:03}", i + 1);
        tread::Driven before;
        if (options.reference) {
            before = [&](const tread::BlindRecording& one) {
                return measure(drawn.before, *one.drive, tread::seedOf(one.seed, kBefore));
            };
        }
        tread::writeCase(
            fs::path(options.output) / drawn.key.name, nominal, tread::recordingsOf(drives, options.seed, i),
            [&](const tread::BlindRecording& one) { return measure(drawn.truth, *one.drive, one.seed); }, before);
        key.cases.push_back(drawn.key);
    }
    const std::string sealed = tread::keyText(key);
    std::ofstream(options.output + ".key.json") << sealed;
    fmt::print("{} cases of {} effects in {}\nSHA-256 of the key: {}\n", options.cases, effects.size(), options.output,
               tread::sha256(sealed));
}

}  // namespace
}  // namespace other_car

int main(int argc, char** argv) {
    CLI::App app{"blind cases from another simulator"};
    other_car::Options options;
    CLI::App* make = app.add_subcommand("make", "cases, as `tread blind make` makes them");
    CLI::App* gap = app.add_subcommand("gap", "how far a car of tread is from the one that errs in nothing");
    for (CLI::App* one : {make, gap}) one->add_option("--vehicle", options.vehicle, "nominal car (YAML)")->required();
    make->add_option("-o,--output", options.output, "folder")->required();
    make->add_option("--cases", options.cases, "number of cases")->required();
    make->add_option("--seed", options.seed, "another number, other cases")->required();
    make->add_flag("--reference", options.reference, "with the same drives of the car before the effect");
    make->add_option("--kinds", options.kinds, "one or none, repeated in this order");
    app.require_subcommand(1);
    CLI11_PARSE(app, argc, argv);
    try {
        if (make->parsed()) other_car::make(options);
        if (gap->parsed()) other_car::gap(options);
    } catch (const std::exception& error) {
        fmt::print(stderr, "other_cases: {}\n", error.what());
        return 2;
    }
    return 0;
}
