#include "diagnose/open_question.h"

#include <algorithm>

#include "diagnose/diagnosis_text.h"
#include "diagnose/thresholds.h"

namespace tread {
namespace {

constexpr std::size_t kMostRivals = 2, kMostHidden = 4;
constexpr double kClose = 12;  // nats behind the answer, up to which a rival is worth telling apart

// The answer and those that come close to it.
std::vector<Question> rivals(const Diagnosis& diagnosis, const Study& study, const Search& found) {
    std::vector<Question> questions;
    const Candidate* answer = nullptr;
    for (const Candidate& one : found.candidates) {
        if (one.fitted && study.namesOf(one.effects) == diagnosis.causes) answer = &one;
    }
    for (const Candidate& one : found.candidates) {
        if (!answer || !one.fitted || &one == answer || one.effects.size() != answer->effects.size()) continue;
        if (one.log_evidence < answer->log_evidence - kClose || questions.size() == kMostRivals) continue;
        questions.push_back({together(diagnosis.causes) + " from " + together(study.namesOf(one.effects)),
                             answer->fit.at,
                             one.fit.at,
                             {&answer->fit, &one.fit}});
    }
    return questions;
}

// The effects that could not be seen, the likeliest first, at their typical size on the nominal car.
std::vector<Question> hidden(const Diagnosis& diagnosis, const Study& study, const Search& found) {
    std::vector<Question> questions;
    const Fit& none = found.none().fit;
    for (const RankedEffect& ranked : diagnosis.effects) {
        if (diagnosis.testable.at(ranked.name) >= kThresholds.testable || questions.size() == kMostHidden) continue;
        Deviation there = study.bench.origin();
        for (std::size_t e = 0; e < study.effects.size(); ++e) {
            if (study.effects[e].name != ranked.name) continue;
            for (const Eigen::Index k : study.knobs[e]) {
                const Parameter& parameter = study.bench.parameters[static_cast<std::size_t>(k)];
                there(k) = parameter.highest > 0 ? std::min(1.0, parameter.highest) : std::max(-1.0, parameter.lowest);
            }
        }
        questions.push_back({ranked.name + " from none", there, study.bench.origin(), {&none}});
    }
    return questions;
}

}  // namespace

std::vector<Question> openQuestions(const Diagnosis& diagnosis, const Study& study, const Search& found) {
    const bool blames = diagnosis.verdict == Verdict::explained || diagnosis.verdict == Verdict::ambiguous;
    return blames ? rivals(diagnosis, study, found) : hidden(diagnosis, study, found);
}

}  // namespace tread
