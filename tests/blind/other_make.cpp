#include "blind/other_make.h"

#include <fmt/format.h>

#include <array>

#include "blind/make.h"
#include "blind/other_measure.h"
#include "blind/other_outsiders.h"
#include "shared/other_car/compact.h"

namespace other_car {
namespace {

using tread::CaseKind;
using tread::Random;
using tread::seedOf;

enum Stream : std::uint64_t { case_stream = 16, structure_stream, draw_stream, day_stream, before_stream };

std::vector<const tread::Outsider*> outsidersFor(bool) {
    std::vector<const tread::Outsider*> all;
    for (const tread::Outsider& one : tread::outsiders()) all.push_back(&one);
    return all;
}

}  // namespace

Day dayOf(std::uint64_t case_seed, bool before, std::uint64_t recording_seed) {
    const std::uint64_t day = seedOf(case_seed, day_stream);
    return {seedOf(day, before), seedOf(recording_seed, day_stream)};
}

Keys makeCases(const Order& order, const tread::VehicleParams& nominal, const std::filesystem::path& folder,
               const std::function<void(int cases)>& progress) {
    Truth begin;
    begin.car = compact();
    const Matching matching = matchingOf(begin, nominal);
    const tread::Subject in_file = asInFile(nominal);
    const std::vector<tread::Effect> effects = plantable(tread::effectCatalogue(), in_file);
    const std::vector<const tread::Outsider*> outsiders = outsidersFor(order.frozen);
    const std::vector<tread::Drive> drives = tread::blindDrives();
    tread::BlindKey key;
    key.seed = order.seed;
    key.vehicle = order.vehicle;
    key.generator = "a double-track model";
    for (int i = 0; i < order.cases; ++i) {
        const auto index = static_cast<std::size_t>(i);
        const std::uint64_t seed = seedOf(order.seed, case_stream + index);
        Random structural(seedOf(seed, structure_stream)), random(seedOf(seed, draw_stream));
        const Truth known = matched(matching, drawStructure(structural));
        Drawn drawn = draw(known, in_file, effects, outsiders, order.kinds[index % order.kinds.size()], random);
        drawn.key.name = fmt::format("case_{:03}", i + 1);
        const auto driven = [&](const tread::BlindRecording& one) {
            const Day day = dayOf(seed, false, one.seed);
            return measure(drivenCar(drawn, {}, &day), *one.drive, one.seed);
        };
        const auto before = [&](const tread::BlindRecording& one) {
            const std::uint64_t own = seedOf(one.seed, before_stream);  // other noise, other surroundings
            const Day day = dayOf(seed, true, own);
            return measure(drivenCar(drawn, wrongThings(drawn), &day), *one.drive, own);
        };
        tread::writeCase(folder / drawn.key.name, nominal, tread::recordingsOf(drives, order.seed, i), driven,
                         order.references ? tread::Driven(before) : tread::Driven());
        key.cases.push_back(drawn.key);
        progress(i + 1);
    }
    Keys keys{key, key};
    keys.with_references.references = true;
    return keys;
}

}  // namespace other_car
