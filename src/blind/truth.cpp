#include "blind/truth.h"

#include <algorithm>
#include <cmath>

#include "diagnose/catalogue/effect.h"
#include "diagnose/model/parameter.h"
#include "recording/subject.h"
#include "tread/problem.h"

namespace tread {
namespace {

using diagnose::catalogue::applies;
using diagnose::catalogue::Direction;
using diagnose::catalogue::Effect;
using diagnose::catalogue::Knob;
using diagnose::model::nuisances;
using diagnose::model::Parameter;
using recording::numberAt;
using recording::Subject;

constexpr double kSmallest = 0.6, kLargest = 1.6;           // of the typical size
constexpr double kFaintest = 0.05, kStrongestFaint = 0.15;  // that no drive can show

double between(Random& random, double low, double high) {
    return low + (high - low) * random.uniform();
}

// Every number that is known within a tolerance is a little wrong, those of the instruments, too.
void err(Subject& car, Random& random) {
    const double most = std::sqrt(3.0);  // of the uniform distribution, in its standard deviations
    for (const Parameter& uncertain : nuisances(car, {}))
        move(car, uncertain, std::clamp(between(random, -most, most), uncertain.lowest, uncertain.highest));
}

bool share(const Effect& a, const Effect& b) {
    for (const Knob& of_a : a.knobs) {
        for (const Knob& of_b : b.knobs) {
            if (std::find_first_of(of_a.paths.begin(), of_a.paths.end(), of_b.paths.begin(), of_b.paths.end()) !=
                of_a.paths.end())
                return true;
        }
    }
    return false;
}

double signOf(Direction direction, Random& random) {
    const double sign = random.uniform() < 0.5 ? -1 : 1;  // drawn in any case: the rest stays as it is
    return direction == Direction::either ? sign : direction == Direction::up ? 1 : -1;
}

void plant(const Effect& effect, double size, Subject nominal, DrawnCase& drawn, Random& random) {
    drawn.key.effects.push_back(effect.name);
    for (const Knob& knob : effect.knobs) {
        const double change = size * signOf(knob.direction, random);
        move(drawn.truth.car, knob, change * knob.typical);
        for (const std::string& path : knob.paths) {
            const double *known = numberAt(nominal, path), *real = numberAt(drawn.truth.car, path);
            if (known && real) drawn.key.numbers[path] = {*known, *real, change};
        }
    }
}

}  // namespace

std::uint64_t seedOf(std::uint64_t seed, std::uint64_t n) {
    // SplitMix64 (Steele, Lea, Flood, 2014).
    std::uint64_t z = seed + (n + 1) * 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

DrawnCase drawCase(const VehicleParams& nominal, const std::vector<Effect>& effects, CaseKind kind, Random& random) {
    Subject car{.vehicle = nominal, .road = {}, .wind = {}, .instruments = {}};
    const Subject as_known = car;
    std::vector<const Effect*> choice;
    for (const Effect& effect : effects) {
        if (applies(effect, car)) choice.push_back(&effect);
    }
    err(car, random);
    DrawnCase drawn{{.car = car, .low_pass = {}, .push = {}}, {}};
    drawn.key.kind = kind;

    const auto draw = [&]() -> const Effect& {
        if (choice.empty())
            throw LoadError({{"", 0, 0, "", "found no effect that concerns this car, expected one for each cause"}});
        const auto at = choice.begin() + static_cast<long>(random.uniform() * static_cast<double>(choice.size()));
        const Effect& drawn_effect = **at;
        std::erase_if(choice, [&](const Effect* other) { return share(*other, drawn_effect); });
        return drawn_effect;
    };
    const int causes = kind == CaseKind::two ? 2 : kind == CaseKind::one || kind == CaseKind::small ? 1 : 0;
    for (int i = 0; i < causes; ++i) {
        const bool faint = kind == CaseKind::small;
        const double size = faint ? between(random, kFaintest, kStrongestFaint) : between(random, kSmallest, kLargest);
        plant(draw(), size, as_known, drawn, random);
    }
    if (kind == CaseKind::outside) {
        const auto which = static_cast<std::size_t>(random.uniform() * static_cast<double>(outsiders().size()));
        const Outsider& outsider = outsiders()[which];
        outsider.plant(drawn.truth, random);
        drawn.key.outsider = outsider.name;
        drawn.key.generalised_forces = outsider.generalised_forces;
    }
    return drawn;
}

}  // namespace tread
