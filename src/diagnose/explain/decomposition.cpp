#include "diagnose/explain/decomposition.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <tuple>

#include "base/math/random.h"
#include "diagnose/explain/resamples.h"
#include "diagnose/model/gap.h"

namespace tread::diagnose::explain {
namespace {

using answer::CausePart;
using answer::Decomposition;
using answer::Part;
using model::Deviation;
using select::Calibration;

using OfDrives = std::vector<double>;

// Squared gap of each drive, at a point.
using GapAt = std::function<std::optional<OfDrives>(const Deviation&)>;

// The points that a decomposition compares.
struct Points {
    Deviation nominal, calibrated, answer;
    std::vector<std::string> names;         // of the causes
    std::vector<Deviation> alone, without;  // with each cause alone, and with all others
};

Points pointsOf(const Calibration& car, const select::Judgement& judgement) {
    const std::vector<std::size_t>& effects = judgement.named->effects;
    const Deviation& answer = judgement.closeness.with.at;
    Points points{car.problem.replays.origin(), car.closest.at, answer, car.problem.namesOf(effects), {}, {}};
    for (const select::Closest& less : judgement.closeness.without) points.without.push_back(less.at);
    if (effects.size() == 1) points.alone = {answer};
    else if (effects.size() == 2) points.alone = {points.without[1], points.without[0]};
    else
        for (const std::size_t e : effects) points.alone.push_back(select::closestWith(car, {e}, answer).at);
    return points;
}

// A share as a function of the drives that count, and how often.
Part partOf(std::size_t drives, const std::function<double(const std::vector<std::size_t>&)>& share) {
    std::vector<std::size_t> all(drives);
    std::iota(all.begin(), all.end(), std::size_t{0});
    Part part{.share = share(all)};
    Random random(1);
    std::vector<double> shares;
    for (int i = 0; i < kResamples && drives > 1; ++i) {
        std::vector<std::size_t> some(drives);
        for (std::size_t& one : some) one = static_cast<std::size_t>(random.uniform() * static_cast<double>(drives));
        shares.push_back(share(some));
    }
    std::tie(part.low, part.high) = ninetyPercentInterval(part.share, std::move(shares));
    return part;
}

// Decomposition of the gap of some drives. `floor`: per drive, the squared gap of a perfect model.
Decomposition decomposed(const OfDrives& floor, const GapAt& gap_at, const Points& points) {
    Decomposition result;
    const auto nominal = gap_at(points.nominal), calibrated = gap_at(points.calibrated), answer = gap_at(points.answer);
    if (!nominal || !calibrated || !answer) return result;
    const std::size_t n = floor.size();
    const auto sum = [](const OfDrives& values, const std::vector<std::size_t>& some) {
        double all = 0;
        for (const std::size_t d : some) all += values[d];
        return all;
    };
    const auto part = [&](auto&& of) {
        return partOf(n, [&](const std::vector<std::size_t>& some) {
            const double whole = sum(*nominal, some);
            return whole > 0 ? of(some) / whole : 0;
        });
    };
    const auto between = [&](const OfDrives& before, const OfDrives& after) {
        return part([&](const auto& some) { return sum(before, some) - sum(after, some); });
    };
    std::vector<std::size_t> all(n);
    std::iota(all.begin(), all.end(), std::size_t{0});
    result.gap = sum(floor, all) > 0 ? sum(*nominal, all) / sum(floor, all) : 0;
    result.tolerances = between(*nominal, *calibrated);
    result.causes = between(*calibrated, *answer);
    result.remainder = part([&](const auto& some) { return std::max(0.0, sum(*answer, some) - sum(floor, some)); });
    result.noise = part([&](const auto& some) { return std::min(sum(*answer, some), sum(floor, some)); });
    for (std::size_t i = 0; i < points.names.size(); ++i) {
        const auto alone = gap_at(points.alone[i]), without = gap_at(points.without[i]);
        CausePart cause{.name = points.names[i], .first = {}, .last = {}};
        if (alone) cause.first = between(*calibrated, *alone);
        if (without) cause.last = between(*without, *answer);
        result.each.push_back(std::move(cause));
    }
    return result;
}

OfDrives floorOf(const model::Uncertainty& uncertainty) {
    OfDrives floor;
    for (std::size_t d = 0; d < uncertainty.noise.size(); ++d) floor.push_back(model::comparedRows(uncertainty, d));
    return floor;
}

}  // namespace

void decompose(answer::Diagnosis& diagnosis, const Calibration& car, const select::Judgement& judgement,
               const select::HeldOut& held_out) {
    const Points points = pointsOf(car, judgement);
    const auto learnt = [&](const Deviation& at) -> std::optional<OfDrives> {
        const auto rows = model::rowsAt(car.problem.replays, car.drives(), at);
        if (!rows) return std::nullopt;
        return model::squaredGaps(car.drives(), car.uncertainty, *rows);
    };
    diagnosis.training = decomposed(floorOf(car.uncertainty), learnt, points);
    if (held_out.uncertainty.noise.empty()) return;
    diagnosis.held_out = decomposed(
        floorOf(held_out.uncertainty), [&](const Deviation& at) { return held_out.gapOf(at); }, points);
}

}  // namespace tread::diagnose::explain
