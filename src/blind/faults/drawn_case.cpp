#include "blind/faults/drawn_case.h"

#include <algorithm>

#include "blind/faults/outsiders.h"
#include "blind/world/draws.h"
#include "diagnose/catalogue/effect.h"
#include "recording/subject.h"
#include "tread/problem.h"

namespace tread::blind::faults {
namespace {

using diagnose::catalogue::applies;
using diagnose::catalogue::Direction;
using diagnose::catalogue::Effect;
using diagnose::catalogue::Knob;
using key::CaseKey;
using key::CaseKind;
using key::Family;
using recording::numberAt;
using recording::Subject;
using world::between;
using world::betweenFactors;
using world::drawnTruth;
using world::eitherSign;
using world::Truth;
using world::World;

// Range of the size of a planted effect, over its typical size.
struct Sizes {
    double smallest, largest;
};
constexpr Sizes kAssumed{0.6, 1.6}, kOwn{0.4, 2.5}, kFaint{0.05, 0.15};  // kFaint: undetectable

double signOf(Direction direction, Random& random) {
    const double sign = eitherSign(random);  // drawn always: later draws do not depend on the direction
    return direction == Direction::either ? sign : direction == Direction::up ? 1 : -1;
}

// A fault and the function that plants it, which does not depend on other faults.
struct Planting {
    std::string name;
    std::function<void(Truth&)> plant;
};

// Records the effect and its numbers in the key.
Planting planted(const Effect& effect, double size, Subject nominal, CaseKey& key, Random& random) {
    key.effects.push_back(effect.name);
    std::vector<double> changes;
    for (const Knob& knob : effect.knobs) {
        changes.push_back(size * signOf(knob.direction, random));
        for (const std::string& path : knob.paths) {
            if (const double* known = numberAt(nominal, path)) key.numbers[path] = {*known, *known, changes.back()};
        }
    }
    return {effect.name, [&effect, changes](Truth& truth) {
                for (std::size_t i = 0; i < changes.size(); ++i)
                    move(truth.car, effect.knobs[i], changes[i] * effect.knobs[i].typical);
            }};
}

Planting planted(const Outsider& outsider, CaseKey& key, const Random& random) {
    key.outsider = outsider.name;
    key.family = outsider.family;
    key.generalised_forces = outsider.generalised_forces;
    return {outsider.name, [&outsider, random](Truth& truth) {
                Random own = random;
                outsider.plant(truth, own);
            }};
}

Truth with(Truth truth, const std::vector<Planting>& plantings, const std::string& but = {}) {
    for (const Planting& planting : plantings)
        if (planting.name != but) planting.plant(truth);
    return truth;
}

const Outsider& drawnOutsider(bool frozen, Random& random) {
    const bool second = frozen && random.uniform() < 0.5;
    const std::vector<const Outsider*> choice = outsiders(second ? Family::second : Family::first);
    return *choice[static_cast<std::size_t>(random.uniform() * static_cast<double>(choice.size()))];
}

int causesOf(CaseKind kind) {
    return kind == CaseKind::two ? 2 : kind == CaseKind::none || kind == CaseKind::outside ? 0 : 1;
}

}  // namespace

bool sharePaths(const Effect& a, const Effect& b) {
    for (const Knob& of_a : a.knobs) {
        for (const Knob& of_b : b.knobs) {
            if (std::find_first_of(of_a.paths.begin(), of_a.paths.end(), of_b.paths.begin(), of_b.paths.end()) !=
                of_a.paths.end())
                return true;
        }
    }
    return false;
}

DrawnCase drawCase(const VehicleParams& nominal, const std::vector<Effect>& effects, CaseKind kind, Random& random,
                   const Drawing& drawing) {
    const Subject as_known{.vehicle = nominal, .road = {}, .wind = {}, .instruments = {}};
    std::vector<const Effect*> choice;
    for (const Effect& effect : effects) {
        if (applies(effect, as_known)) choice.push_back(&effect);
    }
    const Truth healthy = drawnTruth(nominal, drawing.world, random);
    DrawnCase drawn;
    drawn.key.kind = kind;

    const auto draw = [&]() -> const Effect& {
        if (choice.empty())
            throw LoadError({{"", 0, 0, "", "found no effect that concerns this car, expected one for each cause"}});
        const auto at = choice.begin() + static_cast<long>(random.uniform() * static_cast<double>(choice.size()));
        const Effect& drawn_effect = **at;
        std::erase_if(choice, [&](const Effect* other) { return sharePaths(*other, drawn_effect); });
        return drawn_effect;
    };
    std::vector<Planting> plantings;
    for (int i = 0; i < causesOf(kind); ++i) {
        const double size = kind == CaseKind::small           ? between(random, kFaint.smallest, kFaint.largest)
                            : drawing.world == World::assumed ? between(random, kAssumed.smallest, kAssumed.largest)
                                                              : betweenFactors(random, kOwn.smallest, kOwn.largest);
        plantings.push_back(planted(draw(), size, as_known, drawn.key, random));
    }
    if (kind == CaseKind::outside || kind == CaseKind::mixed)
        plantings.push_back(planted(drawnOutsider(drawing.frozen, random), drawn.key, random));

    drawn.healthy = healthy;
    drawn.truth = with(healthy, plantings);
    for (const Planting& planting : plantings) drawn.without[planting.name] = with(healthy, plantings, planting.name);
    for (auto& [path, number] : drawn.key.numbers) number.value = *numberAt(drawn.truth.car, path);
    return drawn;
}

}  // namespace tread::blind::faults
