#include "diagnose/explain/open_question.h"

#include <algorithm>

#include "diagnose/settings.h"

namespace tread::diagnose::explain {
namespace {

using answer::Diagnosis;
using model::Problem;
using select::Candidate;
using select::Search;

constexpr std::size_t kMostRivals = 2, kMostHidden = 4;  // questions asked at most
constexpr double kClose = 12;  // nats behind the answer, up to which a rival is worth separating

// The answer against each fitted set of as many effects that is close to it.
std::vector<Question> rivals(const Diagnosis& diagnosis, const Problem& problem, const Search& found) {
    std::vector<Question> questions;
    const Candidate* answer = nullptr;
    for (const Candidate& one : found.candidates) {
        if (one.fitted && problem.namesOf(one.effects) == diagnosis.causes) answer = &one;
    }
    for (const Candidate& one : found.candidates) {
        if (!answer || !one.fitted || &one == answer || one.effects.size() != answer->effects.size()) continue;
        if (one.log_evidence < answer->log_evidence - kClose || questions.size() == kMostRivals) continue;
        questions.push_back(
            {diagnosis.causes, problem.namesOf(one.effects), answer->fit.at, one.fit.at, {&answer->fit, &one.fit}});
    }
    return questions;
}

// The nominal car with an effect at its typical size.
model::Deviation withEffect(const Problem& problem, const std::string& name) {
    model::Deviation point = problem.replays.origin();
    for (std::size_t e = 0; e < problem.effects.size(); ++e) {
        if (problem.effects[e].name != name) continue;
        for (const Eigen::Index k : problem.knobs[e]) {
            const model::Parameter& knob = problem.replays.parameters[k];
            point(k) = knob.highest > 0 ? std::min(1.0, knob.highest) : std::max(-1.0, knob.lowest);
        }
    }
    return point;
}

// Effects that these drives could not show, the most probable first.
std::vector<Question> hidden(const Diagnosis& diagnosis, const Problem& problem, const Search& found) {
    std::vector<Question> questions;
    for (const answer::RankedEffect& ranked : diagnosis.effects) {
        if (questions.size() == kMostHidden) break;
        if (diagnosis.expected_evidence.at(ranked.name) >= kTestable) continue;
        questions.push_back(
            {{ranked.name}, {}, withEffect(problem, ranked.name), problem.replays.origin(), {&found.none().fit}});
    }
    return questions;
}

}  // namespace

std::vector<Question> openQuestions(const Diagnosis& diagnosis, const Problem& problem, const Search& found) {
    const bool blames =
        diagnosis.verdict == answer::Verdict::explained || diagnosis.verdict == answer::Verdict::ambiguous;
    return blames ? rivals(diagnosis, problem, found) : hidden(diagnosis, problem, found);
}

}  // namespace tread::diagnose::explain
