// The part of a diagnosis of a blind case that is scored.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "blind/key/program_hash.h"
#include "diagnose/answer/diagnosis.h"
#include "tread/describe.h"

namespace tread::blind::answers {

struct CaseAnswer {
    std::string name;
    key::Program program;
    bool compared = false;
    diagnose::answer::Verdict verdict = diagnose::answer::Verdict::not_testable;
    std::vector<std::string> causes;
    std::vector<std::vector<std::string>> alternatives;
    std::vector<std::string> credible_set;
    std::vector<diagnose::answer::RankedEffect> effects;
    double probability_of_nothing = 0, probability_of_unknown = 0;
    std::map<std::string, double> expected_evidence;
    std::string generalised_force;
    diagnose::answer::Baselines baselines;
    double closure = 0, closure_low = 0, closure_high = 0;
    double closure_obtained = std::numeric_limits<double>::quiet_NaN();
    double seconds = 0;
    int simulations = 0;
    std::string failure;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(name), About{"", "name of the case"});
        field(TREAD_FIELD(program), About{"", "program that gave the answer, by the hashes of its sources"});
        field(TREAD_FIELD(compared), About{"", "every recording was compared with its reference"});
        field(TREAD_FIELD(verdict), About{"", "verdict of the diagnosis"});
        field(TREAD_FIELD(causes), About{"", "effects that it names jointly as causes"});
        field(TREAD_FIELD(alternatives), About{"", "sets of effects that it names as possible instead of the causes"});
        field(TREAD_FIELD(credible_set),
              About{"", "set of effects, none and unknown that holds 90 % of the probability"});
        field(TREAD_FIELD(effects), About{"", "all effects, most probable first"});
        field(TREAD_FIELD(probability_of_nothing), About{"-", "probability that there is no detectable fault"});
        field(TREAD_FIELD(probability_of_unknown), About{"-", "probability of a cause outside the catalogue"});
        field(TREAD_FIELD(expected_evidence),
              About{"nat",
                    "evidence that the diagnosis expects of each effect at its typical size; for information, the "
                    "key decides"});
        field(TREAD_FIELD(generalised_force), About{"", "generalised force of the unexplained part"});
        field(TREAD_FIELD(baselines), About{"", "answers of simpler methods; empty: not computed"});
        field(TREAD_FIELD(closure), About{"-", "stated share of the gap to the true car that is closed"});
        field(TREAD_FIELD(closure_low), About{"-", "lower end of its interval"});
        field(TREAD_FIELD(closure_high), About{"-", "upper end of its interval"});
        field(TREAD_FIELD(closure_obtained),
              About{"-", "share closed against noise-free drives of the true car; none: not computed"});
        field(TREAD_FIELD(seconds), About{"s", "duration of the diagnosis"});
        field(TREAD_FIELD(simulations), About{"-", "number of simulations"});
        field(TREAD_FIELD(failure), About{"", "reason why there is no answer; empty: there is one"});
    }
};
static_assert(describesEveryMember<CaseAnswer>());

CaseAnswer answerOf(const std::string& name, const diagnose::answer::Diagnosis& diagnosis);

// Share of the squared gap between nominal model and true car that the diagnosed model closes in the held-out
// recordings; NaN without any. `clean`: noise-free logs of the true car, by name of the recording.
double obtainedClosure(const std::vector<diagnose::answer::Overlay>& overlays, const std::map<std::string, Log>& clean);

std::string answerText(const CaseAnswer& answer);  // JSON
// Throws LoadError that names the file.
CaseAnswer parseAnswer(std::string_view text, const std::string& file);

}  // namespace tread::blind::answers
