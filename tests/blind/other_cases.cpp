// Blind cases from a simulator that shares no vehicle code with tread (tests/shared/other_car): the diagnosis must
// stand its ground where the structure of its model is not that of the car.
//
//   other_cases base --vehicle vehicles/compact.yaml -o base           drives of the car as it is known, without
//   disturbance tread identify base/diagnosis.yaml -o identified                   the nominal car that a user would
//   have other_cases make --vehicle identified/calibrated.yaml --cases 20 --seed 1 -o cases tread blind score cases
//   cases.key.json -o score
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>

#include "blind/make.h"
#include "blind/other_measure.h"
#include "diagnose/sha256.h"
#include "shared/other_car/compact.h"
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
};

// What a user would identify: what data sheets do not tell, and what the other structure needs to come near.
constexpr const char* kIdentified = R"(tolerances:
  - {path: "*.tyre.lambda.Ky", relative: 0.3}
  - {path: "*.tyre.lambda.Kx", relative: 0.3}
  - {path: "*.tyre.parameters.cFy", relative: 0.5}
  - {path: "*.suspension.steer_by_lateral_force", absolute: 5e-6}
  - {path: "*.suspension.anti_roll_bar", relative: 0.4}
  - {path: "*.suspension.damper.*", relative: 0.4}
  - {path: "inertia.roll", relative: 0.3}
  - {path: "inertia.yaw", relative: 0.1}
  - {path: "driveline.engine.*_scale", relative: 0.2}
  - {path: "brakes.full_pedal_torque", relative: 0.1}
fit: ["*.tyre.lambda.Ky", "*.tyre.lambda.Kx", "*.tyre.parameters.cFy", "*.suspension.steer_by_lateral_force",
      "*.suspension.anti_roll_bar", "*.suspension.damper.bump", "*.suspension.damper.rebound", "inertia.roll",
      "inertia.yaw", "driveline.engine.*_scale", "brakes.full_pedal_torque"]
)";

Truth asKnown() {
    Truth truth;
    truth.car = compact();
    return truth;
}

void base(const Options& options) {
    const std::vector<tread::Drive> drives = tread::blindDrives();
    tread::writeCase(
        options.output, tread::loadVehicle(options.vehicle), tread::recordingsOf(drives, 1, 0),
        [](const tread::BlindRecording& one) { return measure(asKnown(), *one.drive, one.seed, tread::kIdeal); },
        kIdentified);
}

void make(const Options& options) {
    const tread::VehicleParams nominal = tread::loadVehicle(options.vehicle);
    const std::vector<tread::Effect> effects = plantable(tread::effectCatalogue(), nominal);
    const std::vector<tread::Drive> drives = tread::blindDrives();
    tread::BlindKey key;
    key.seed = options.seed;
    key.vehicle = options.vehicle;
    key.generator = "a double-track model";
    for (int i = 0; i < options.cases; ++i) {
        const auto index = static_cast<std::size_t>(i);
        tread::Random random(tread::seedOf(options.seed, index));
        const tread::CaseKind kind = tread::caseKind(options.kinds[index % options.kinds.size()]);
        Drawn drawn = draw(asKnown(), nominal, effects, kind, random);
        drawn.key.name = fmt::format("case_{:03}", i + 1);
        tread::writeCase(fs::path(options.output) / drawn.key.name, nominal,
                         tread::recordingsOf(drives, options.seed, i),
                         [&](const tread::BlindRecording& one) { return measure(drawn.truth, *one.drive, one.seed); });
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
    CLI::App* base = app.add_subcommand("base", "drives from which to identify a nominal car");
    CLI::App* make = app.add_subcommand("make", "cases, as `tread blind make` makes them");
    for (CLI::App* one : {base, make}) {
        one->add_option("--vehicle", options.vehicle, "nominal car (YAML)")->required();
        one->add_option("-o,--output", options.output, "folder")->required();
    }
    make->add_option("--cases", options.cases, "number of cases")->required();
    make->add_option("--seed", options.seed, "another number, other cases")->required();
    make->add_option("--kinds", options.kinds, "one or none, repeated in this order");
    app.require_subcommand(1);
    CLI11_PARSE(app, argc, argv);
    try {
        base->parsed() ? other_car::base(options) : other_car::make(options);
    } catch (const std::exception& error) {
        fmt::print(stderr, "other_cases: {}\n", error.what());
        return 2;
    }
    return 0;
}
