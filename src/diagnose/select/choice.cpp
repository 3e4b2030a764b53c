#include "diagnose/select/choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "diagnose/select/beside_unknown.h"
#include "diagnose/select/left_out.h"
#include "diagnose/select/objections.h"

namespace tread::diagnose::select {
namespace {

// Fits of the answer, each linearised at the point of the one before, until one gains fewer nats.
constexpr int kMostAnswerFits = 3;
constexpr double kAnswerSettled = 8;

// Probability that an effect acts, if an unknown cause does. How much of the gap it closes is not known of an effect
// that is not named.
double probabilityBesideUnknown(std::size_t effect, const Calibration& car, const Judgement& judgement) {
    const std::vector<std::size_t>& named = judgement.named->effects;
    const auto place = std::find(named.begin(), named.end(), effect);
    if (place == named.end()) return actsBesideUnknown({0, 1}, std::max<std::size_t>(named.size(), 1));
    const Closest& without = judgement.closeness.without[place - named.begin()];
    return actsBesideUnknown(closedShare(gapBeyondNoise(car, judgement.closeness.with.rows),
                                         gapBeyondNoise(car, without.rows), scatterOfGap(car)),
                             named.size());
}

// The fit of a model in which the sizes of its effects are free of the prior that ranked it.
Fit released(const Calibration& car, const Candidate& named) {
    Fit fit = named.fit;
    if (named.effects.empty()) return fit;
    SharedLinearisation here = linearisationAbout(car, named);
    for (int round = 0; round < kMostAnswerFits; ++round) {
        if (round > 0) here = linearisedAt(car, fit);
        std::optional<Fit> again =
            fitted(car.problem.replays, car.drives(), car.uncertainty, *here, fit.knobs, endOf(fit), SizePrior::none);
        if (!again) break;
        fit = std::move(*again);
        if (fit.gained < kAnswerSettled) break;
    }
    return withColumnsOfItsPoint(car.problem.replays, car.drives(), car.uncertainty, *linearisedAt(car, fit), fit);
}

// The fit at the closest car with its causes, whose sizes stay.
Fit atClosest(const Calibration& car, Fit fit) {
    std::optional<Closest> closest = fit.knobs.empty() ? car.closest : closestTo(car, fit.at, {});
    if (closest) fit.at = std::move(closest->at), fit.rows = fit.of_car = std::move(closest->rows);
    return fit;
}

// Nats by which the models that were struck off are likelier than all others (D33c). What an effect that closes too
// little stands for is not visible, and needs no cause.
double rejectedOver(const Calibration& car, const Search& found, const Struck& struck) {
    if (struck.empty()) return -kInfinity;
    const Posterior all = posterior(car, found, std::vector<bool>(found.candidates.size(), true));
    double rejected = 0, others = 0;
    for (const Hypothesis& one : all.hypotheses) {
        const auto off =
            std::find_if(struck.begin(), struck.end(), [&](const auto& each) { return each.first == one.candidate; });
        if (off == struck.end()) others += one.probability;
        else if (off->second != kClosesByChance) rejected += one.probability;
    }
    return std::log(rejected) - std::log(std::max(others, std::numeric_limits<double>::min()));
}

// Judges models of a search. Models that may not be the answer are struck off, and the others share their probability.
class Judge {
public:
    Judge(const Calibration& car, Search& found, const HeldOut& held_out, answer::Vibration vibration)
        : car_(car),
          found_(found),
          held_out_(held_out),
          vibration_(std::move(vibration)),
          left_out_(car, held_out),
          possible_(found.candidates.size(), true) {}

    // The most probable model that may be the answer, less the effects that it does not need, but with those that act
    // likelier than not. Where an effect that was only screened is the most probable now, it is fitted.
    Choice choice() {
        while (true) {
            Posterior probable = posterior(car_, found_, possible_);
            const std::ptrdiff_t first = probable.hypotheses.front().candidate - found_.candidates.data();
            if (Candidate& one = found_.candidates[first]; !one.fitted) {
                possible_[first] = fitScreened(car_, found_, one);
                continue;
            }
            const Candidate* named = probable.needed();
            std::string objection;
            std::optional<Judgement> judgement = judged(*named, probable, objection);
            if (!judgement) {
                struck_.emplace_back(named, std::move(objection));
                possible_[named - found_.candidates.data()] = false;
                continue;
            }
            while (std::optional<Judgement> more = withOneMore(*judgement, probable)) judgement = std::move(more);
            return {std::move(probable), std::move(*judgement), std::move(struck_)};
        }
    }

private:
    // Nothing, and the objection, when the model may not be the answer. The tests that cost least come first.
    std::optional<Judgement> judged(const Candidate& model, const Posterior& probable, std::string& objection) {
        objection = objectionInTheFit(car_, model, found_, held_out_, probable.variance_factor);
        if (!objection.empty()) return std::nullopt;
        Fit answer = released(car_, model);
        if (implausible(car_, answer)) {
            objection = kAtItsEnd;
            return std::nullopt;
        }
        Closeness closeness = closenessOf(car_, model.effects, answer.at);
        objection = objectionInTheGap(car_, model, closeness, left_out_);
        if (!objection.empty()) return std::nullopt;
        Remains remains = whatRemains(car_, model, closeness.with);
        remains.rejected = rejectedOver(car_, found_, struck_);
        remains.vibration = vibration_;
        return Judgement{&model, atClosest(car_, std::move(answer)), std::move(closeness), std::move(remains),
                         predicted(car_, model.fit, found_.none().fit)};
    }

    // The same with one more effect of a cause that is named, if that acts likelier than not and may be named.
    std::optional<Judgement> withOneMore(const Judgement& judgement, const Posterior& probable) {
        const Candidate& named = *judgement.named;
        const Candidate* more = named.effects.empty() ? nullptr : probable.likelierWithOneMore(named);
        std::string objection;
        std::optional<Judgement> result = more ? judged(*more, probable, objection) : std::nullopt;
        if (!result) return std::nullopt;
        const auto added = std::find_if(more->effects.begin(), more->effects.end(),
                                        [&](std::size_t effect) { return !named.holds(effect); });
        if (probabilityOf(*added, car_, probable, *result) < 0.5) return std::nullopt;
        return result;
    }

    const Calibration& car_;
    Search& found_;
    const HeldOut& held_out_;
    answer::Vibration vibration_;
    LeftOut left_out_;
    std::vector<bool> possible_;  // of each candidate
    Struck struck_;
};

}  // namespace

double probabilityOf(std::size_t effect, const Calibration& car, const Posterior& posterior,
                     const Judgement& judgement) {
    const double unknown = judgement.remains.probability();
    return (1 - unknown) * posterior.genuinelyOf(effect) +
           unknown * posterior.of(effect) * probabilityBesideUnknown(effect, car, judgement);
}

Choice chosen(const Calibration& car, Search& found, const HeldOut& held_out, answer::Vibration vibration) {
    return Judge(car, found, held_out, std::move(vibration)).choice();
}

}  // namespace tread::diagnose::select
