#include "blind/other_make.h"

#include <fmt/format.h>

#include "blind/key/program_hash.h"
#include "blind/make/make_cases.h"
#include "blind/other_detectability.h"
#include "blind/other_measure.h"
#include "blind/world/draws.h"
#include "diagnose/catalogue/effect.h"
#include "recording/subject.h"
#include "run/simulate.h"
#include "shared/other_car/compact.h"

namespace other_car {
namespace {

using tread::Random;
using tread::blind::drives::caseDrives;
using tread::blind::drives::Drive;
using tread::blind::key::CaseKey;
using tread::blind::key::CaseKind;
using tread::blind::key::programHash;
using tread::blind::make::CaseRecording;
using tread::blind::make::Driven;
using tread::blind::make::recordingsOf;
using tread::blind::make::writeCase;
using tread::blind::world::seedOf;

constexpr int kMostDraws = 20;
enum Stream : std::uint64_t {
    case_stream = 16,
    structure_stream,
    draw_stream,
    ground_stream,
    day_stream,
    before_stream
};

void drive(const Drawn& drawn, const ProvingGround& ground, std::uint64_t seed, bool references,
           const std::vector<CaseRecording>& recordings, const std::filesystem::path& place) {
    const auto driven = [&](const CaseRecording& one) {
        const Day day = dayOf(seed, false, one.seed);
        return measure(drivenCar(drawn, {}, &day), ground, *one.drive, one.seed);
    };
    const auto before = [&](const CaseRecording& one) {
        const std::uint64_t own = seedOf(one.seed, before_stream);  // independent noise and surroundings
        const Day day = dayOf(seed, true, own);
        return measure(drivenCar(drawn, faultNames(drawn), &day), ground, *one.drive, own);
    };
    writeCase(place, drawn.nominal.vehicle, recordings, driven, references ? Driven(before) : Driven());
}

std::vector<CaseKind> kindsOf(const Order& order) {
    tread::blind::make::Order proportions;
    proportions.cases = order.cases, proportions.seed = order.seed, proportions.kinds = order.kinds;
    return tread::blind::make::kindsOf(proportions);
}

Keys emptyKeys(const Order& order) {
    Keys keys;
    keys.without_references.program = programHash();
    keys.without_references.seed = order.seed;
    keys.without_references.vehicle = order.vehicle;
    keys.without_references.generator = "a double-track model";
    keys.without_references.frozen = order.frozen;
    keys.with_references = keys.without_references;
    keys.with_references.references = true;
    return keys;
}

void append(Keys& keys, const CaseKey& key, const Shown& nats) {
    keys.with_references.cases.push_back(key);
    keys.with_references.cases.back().shows = nats.with_references;
    keys.without_references.cases.push_back(key);
    keys.without_references.cases.back().shows = nats.without_references;
}

}  // namespace

std::uint64_t caseSeed(std::uint64_t seed, int index) {
    return seedOf(seed, case_stream + static_cast<std::uint64_t>(index));
}

Day dayOf(std::uint64_t case_seed, bool before, std::uint64_t recording_seed) {
    const std::uint64_t day = seedOf(case_seed, day_stream);
    return {seedOf(day, before), seedOf(recording_seed, day_stream)};
}

Truth knownCar(const Order& order, int index, const Matching& matching) {
    Random structural(seedOf(caseSeed(order.seed, index), structure_stream));
    return matched(matching, drawStructure(structural));
}

Drawn drawnCase(const Order& order, int index, CaseKind kind, const Truth& known, const tread::VehicleParams& nominal,
                const std::vector<tread::diagnose::catalogue::Effect>& effects, int draw_number) {
    const std::uint64_t seed = seedOf(caseSeed(order.seed, index), draw_stream);
    Random random(seedOf(seed, static_cast<std::uint64_t>(draw_number)));
    Drawn drawn = draw(known, asInFile(nominal), effects, order.frozen, kind, random);
    drawn.key.name = fmt::format("case_{:03}", index + 1);
    drawn.key.draw = draw_number;
    return drawn;
}

Keys makeCases(const Order& order, const tread::VehicleParams& nominal, const std::filesystem::path& folder,
               const std::function<void(int cases)>& progress) {
    Truth begin;
    begin.car = compact();
    const Matching matching = matchingOf(begin, nominal);
    const tread::recording::Subject in_file = asInFile(nominal);
    const std::vector<Drive> drives = caseDrives();
    const Directions directions =
        directionsOf(in_file, plantable(tread::diagnose::catalogue::effectCatalogue(), in_file));
    const std::vector<Pushed> pushed = pushedDrives(plainCar(matching), drives);
    const std::vector<tread::diagnose::catalogue::Effect> effects =
        detectableEffects(plainCar(matching), in_file, directions, drives);
    const std::vector<CaseKind> kinds = kindsOf(order);
    Keys keys = emptyKeys(order);
    for (int i = 0; i < order.cases; ++i) {
        const Truth known = knownCar(order, i, matching);
        Random place(seedOf(caseSeed(order.seed, i), ground_stream));
        const ProvingGround ground = drawnGround(nominal, place);
        for (int draw_number = 0;; ++draw_number) {
            const Drawn drawn =
                drawnCase(order, i, kinds[static_cast<std::size_t>(i)], known, nominal, effects, draw_number);
            try {
                drive(drawn, ground, caseSeed(order.seed, i), order.references, recordingsOf(drives, order.seed, i),
                      folder / drawn.key.name);
                append(keys, drawn.key, shown(pushed, directions, drawn, ground));
                break;
            } catch (const tread::SimulationError&) {  // undrivable, for instance it spins
                if (draw_number == kMostDraws) throw;
            }
        }
        progress(i + 1);
    }
    return keys;
}

}  // namespace other_car
