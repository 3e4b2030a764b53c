// Blind cases from a simulator that shares no vehicle code with tread (tests/shared/other_car): a check of the
// diagnosis on cars whose structure differs from that of its model.
//
//   other_cases make --vehicle vehicles/compact.yaml --cases 20 --seed 1 --reference -o cases
//   tread blind score cases cases.key.json -o score
//   tread blind score cases cases.without_references.key.json --no-references -o score_without
//
// `make` writes a folder for each case, as `tread blind make` does; with --reference also the same drives of the car
// before the fault, on another day (other_errors.h). Two keys are written for the same cases: detectability for a
// diagnosis with references and for one without. Without --reference there is only the latter, as cases.key.json.
// --frozen draws outsiders of both families. --kinds sets the kinds of the cases, which are repeated and shuffled by
// the seed; by default they are those of a check.
//
//   other_cases gap --vehicle vehicles/compact.yaml --structure brush_tyre turbo_lag
//
// prints how far the matched car without errors is from tread's: root mean square difference in each drive over the
// noise of the instruments, both of means over 50 ms. `other_cases structures` lists the structural choices.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "blind/other_make.h"
#include "blind/other_measure.h"
#include "blind/world/instruments.h"
#include "shared/other_car/compact.h"
#include "store/sha256.h"
#include "tread/load.h"
#include "tread/problem.h"

namespace other_car {
namespace {

using tread::blind::drives::caseDrives;
using tread::blind::drives::Drive;
using tread::blind::key::caseKindNamed;
using tread::blind::key::keyText;
using tread::blind::key::SealedKey;
using tread::blind::world::InstrumentSheet;
using tread::blind::world::instrumentSheets;

struct Options {
    Order order;
    std::string output;
    std::vector<std::string> kinds, structure;
};

void gap(const Options& options) {
    const tread::VehicleParams vehicle = tread::loadVehicle(options.order.vehicle);
    Truth begin;
    begin.car = compact();
    const Truth truth = matched(matchingOf(begin, vehicle), structureOf(options.structure));
    fmt::print("{:<22}", "");
    for (const InstrumentSheet& sheet : instrumentSheets()) {
        const std::string name(sheet.channel);
        if (!name.starts_with("driver.")) fmt::print("{:>10}", name.substr(name.find('.') + 1, 9));
    }
    for (const Drive& drive : caseDrives()) {
        const tread::Log other = replay(truth, drive).log, own = drivenByTread(vehicle, drive);
        fmt::print("\n{:<22}", drive.name);
        for (const InstrumentSheet& sheet : instrumentSheets()) {
            if (sheet.channel.starts_with("driver.")) continue;
            const std::vector<double> x = means(other, sheet.channel), y = means(own, sheet.channel);
            double squares = 0;
            for (std::size_t i = 0; i < x.size(); ++i) squares += (x[i] - y[i]) * (x[i] - y[i]);
            fmt::print("{:>10.2f}", std::sqrt(squares / static_cast<double>(x.size())) / noiseOfMeans(sheet));
        }
    }
    fmt::print("\n");
}

void seal(const SealedKey& key, const std::string& file) {
    const std::string sealed = keyText(key);
    std::ofstream out(file, std::ios::binary);
    out << sealed;
    out.close();
    if (!out) throw std::runtime_error("cannot write " + file);
    fmt::print("SHA-256 of {}: {}\n", file, tread::sha256(sealed));
}

void make(const Options& options) {
    Order order = options.order;
    for (const std::string& kind : options.kinds) order.kinds.push_back(caseKindNamed(kind));
    const Keys keys = makeCases(order, tread::loadVehicle(order.vehicle), options.output,
                                [&](int cases) { fmt::print(stderr, "\r{} of {} cases", cases, order.cases); });
    fmt::print(stderr, "\n");
    if (order.references) seal(keys.with_references, options.output + ".key.json");
    seal(keys.without_references, options.output + (order.references ? ".without_references.key.json" : ".key.json"));
}

void structures() {
    for (const StructuralChoice& one : kStructuralChoices) fmt::print("{:<28}{}\n", one.name, one.what);
}

}  // namespace
}  // namespace other_car

int main(int argc, char** argv) {
    CLI::App app{"blind cases from another simulator"};
    other_car::Options options;
    CLI::App* make = app.add_subcommand("make", "cases, as `tread blind make` makes them");
    CLI::App* gap = app.add_subcommand("gap", "difference between a car of tread and the matched car without errors");
    CLI::App* structures = app.add_subcommand("structures", "lists the structural choices of the cars");
    for (CLI::App* one : {make, gap})
        one->add_option("--vehicle", options.order.vehicle, "nominal car (YAML)")->required();
    make->add_option("-o,--output", options.output, "folder")->required();
    make->add_option("--cases", options.order.cases, "number of cases")->required();
    make->add_option("--seed", options.order.seed, "seed of all draws")->required();
    make->add_flag("--reference", options.order.references, "also drive the car before the fault");
    make->add_flag("--frozen", options.order.frozen,
                   "draw outsiders of both families: only when the diagnosis is frozen");
    make->add_option("--kinds", options.kinds, "one, two, none, outside, mixed, small");
    gap->add_option("--structure", options.structure, "names of structural choices");
    app.require_subcommand(1);
    CLI11_PARSE(app, argc, argv);
    try {
        if (make->parsed()) other_car::make(options);
        if (gap->parsed()) other_car::gap(options);
        if (structures->parsed()) other_car::structures();
    } catch (const std::exception& error) {
        fmt::print(stderr, "other_cases: {}\n", error.what());
        return 2;
    }
    return 0;
}
