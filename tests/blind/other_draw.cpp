#include "blind/other_draw.h"

#include <algorithm>
#include <stdexcept>

#include "blind/faults/drawn_case.h"
#include "blind/other_errors.h"
#include "blind/other_outsiders.h"
#include "blind/world/draws.h"
#include "diagnose/catalogue/effect.h"
#include "recording/subject.h"

namespace other_car {
namespace {

using tread::Random;
using tread::blind::faults::Outsider;
using tread::blind::faults::sharePaths;
using tread::blind::key::CaseKind;
using tread::blind::key::Family;
using tread::blind::world::between;
using tread::blind::world::betweenFactors;
using tread::blind::world::eitherSign;
using tread::diagnose::catalogue::Direction;
using tread::diagnose::catalogue::Effect;
using tread::diagnose::catalogue::Knob;
using tread::recording::Subject;

constexpr double kSmallest = 0.4, kLargest = 2.5;           // of the typical size
constexpr double kFaintest = 0.05, kStrongestFaint = 0.15;  // of a small effect, over its typical size

std::size_t anyOf(std::size_t count, Random& random) {
    return static_cast<std::size_t>(random.uniform() * static_cast<double>(count));
}

// Effects that move no common number.
std::vector<Effect> drawEffects(std::vector<Effect> choice, int count, Random& random) {
    std::vector<Effect> drawn;
    for (int i = 0; i < count; ++i) {
        if (choice.empty()) throw std::invalid_argument("the other car can show too few of these effects");
        drawn.push_back(choice[anyOf(choice.size(), random)]);
        std::erase_if(choice, [&](const Effect& other) { return sharePaths(other, drawn.back()); });
    }
    return drawn;
}

Drawn::Planted sized(const Effect& effect, double size, Random& random) {
    Drawn::Planted planted{effect, {}};
    for (const Knob& knob : effect.knobs) {
        const double either = eitherSign(random);
        const double sign = knob.direction == Direction::either ? either : knob.direction == Direction::up ? 1 : -1;
        planted.changes.push_back(sign * size * knob.typical);
    }
    return planted;
}

Subject changed(const Drawn& drawn, const std::set<std::string>& without) {
    Subject car = drawn.erring;
    for (const Drawn::Planted& one : drawn.planted) {
        if (without.contains(one.effect.name)) continue;
        for (std::size_t i = 0; i < one.changes.size(); ++i) move(car, one.effect.knobs[i], one.changes[i]);
    }
    return car;
}

void writeNumbers(Drawn& drawn) {
    Subject nominal = drawn.nominal, real = changed(drawn, {});
    for (const Drawn::Planted& one : drawn.planted) {
        for (std::size_t i = 0; i < one.changes.size(); ++i) {
            const Knob& knob = one.effect.knobs[i];
            for (const std::string& path : knob.paths) {
                const double* known = tread::recording::numberAt(nominal, path);
                if (!known) continue;
                drawn.key.numbers[path] = {*known, *tread::recording::numberAt(real, path),
                                           one.changes[i] / knob.typical};
            }
        }
    }
}

}  // namespace

Structure drawStructure(Random& random) {
    Structure structure;
    const int count = 2 + static_cast<int>(anyOf(2, random));
    for (int chosen = 0; chosen < count;) {
        bool& on = structure.*kStructuralChoices[anyOf(kStructuralChoices.size(), random)].on;
        if (on) continue;
        on = true;
        if (structure.brush_tyre && structure.hyperbolic_tyre) on = false;
        else ++chosen;
    }
    return structure;
}

std::vector<std::string> namesOf(const Structure& structure) {
    std::vector<std::string> names;
    for (const StructuralChoice& one : kStructuralChoices) {
        if (structure.*one.on) names.emplace_back(one.name);
    }
    return names;
}

Structure structureOf(const std::vector<std::string>& names) {
    Structure structure;
    for (const std::string& name : names) {
        const auto one = std::find_if(kStructuralChoices.begin(), kStructuralChoices.end(),
                                      [&](const StructuralChoice& choice) { return choice.name == name; });
        if (one == kStructuralChoices.end()) throw std::invalid_argument("no structural choice is called " + name);
        structure.*one->on = true;
    }
    return structure;
}

Drawn draw(const Truth& known, const Subject& nominal, const std::vector<Effect>& effects, bool frozen, CaseKind kind,
           Random& random) {
    Drawn drawn{.known = known, .nominal = nominal, .erring = nominal, .planted = {}, .key = {}};
    other_car::drawErrors(drawn.erring, random);
    drawn.key.kind = kind;
    drawn.key.structure = namesOf(known.car.structure);
    const int count = kind == CaseKind::two ? 2 : kind == CaseKind::none || kind == CaseKind::outside ? 0 : 1;
    for (const Effect& effect : drawEffects(effects, count, random)) {
        const double size = kind == CaseKind::small ? between(random, kFaintest, kStrongestFaint)
                                                    : betweenFactors(random, kSmallest, kLargest);
        drawn.planted.push_back(sized(effect, size, random));
        drawn.key.effects.push_back(effect.name);
    }
    writeNumbers(drawn);
    if (kind != CaseKind::outside && kind != CaseKind::mixed) return drawn;
    const auto family = random.uniform() < 0.5 && frozen ? Family::second : Family::first;
    const std::vector<const Outsider*> outsiders = tread::blind::faults::outsiders(family);
    drawn.outsider = outsiders[anyOf(outsiders.size(), random)];
    drawn.outsider_seed = static_cast<std::uint64_t>(0x1p52 * random.uniform());
    drawn.key.outsider = drawn.outsider->name;
    drawn.key.family = drawn.outsider->family;
    drawn.key.generalised_forces = drawn.outsider->generalised_forces;
    return drawn;
}

Truth drivenCar(const Drawn& drawn, const std::set<std::string>& without, const Day* day) {
    Subject car = changed(drawn, without);
    if (day) meet(car, day->day_seed, day->drive_seed);
    Truth truth = withChanges(drawn.known, drawn.nominal, car);
    if (drawn.outsider && !without.contains(drawn.outsider->name)) {
        Random random(drawn.outsider_seed);
        plant(*drawn.outsider, drawn.erring, truth, random);
    }
    return truth;
}

std::set<std::string> faultNames(const Drawn& drawn) {
    std::set<std::string> names(drawn.key.effects.begin(), drawn.key.effects.end());
    if (drawn.outsider) names.insert(drawn.outsider->name);
    return names;
}

}  // namespace other_car
