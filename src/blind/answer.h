// What a diagnosis said of a blind case, as far as it is scored.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "blind/program_hash.h"
#include "diagnose/answer/diagnosis.h"
#include "tread/describe.h"

namespace tread {

struct CaseAnswer {
    std::string name;
    Program program;
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
        field(TREAD_FIELD(name), About{"", "of the case"});
        field(TREAD_FIELD(program), About{"", "that gave the answer, by the hashes of its sources"});
        field(TREAD_FIELD(compared), About{"", "every recording was compared with its reference"});
        field(TREAD_FIELD(verdict), About{"", "of the diagnosis"});
        field(TREAD_FIELD(causes), About{"", "effects that it names together"});
        field(TREAD_FIELD(alternatives), About{"", "sets of effects that it names in place of the causes"});
        field(TREAD_FIELD(credible_set), About{"", "effects, none or unknown that hold 90 % of the probability"});
        field(TREAD_FIELD(effects), About{"", "all effects, the best first"});
        field(TREAD_FIELD(probability_of_nothing), About{"-", "that no effect acts, or only such as do not show"});
        field(TREAD_FIELD(probability_of_unknown), About{"-", "that something outside of the catalogue acts"});
        field(TREAD_FIELD(expected_evidence),
              About{"nat",
                    "of each effect at its typical size, as the diagnosis expected it; for information: what counts "
                    "is in the key"});
        field(TREAD_FIELD(generalised_force), About{"", "in which the unexplained lies"});
        field(TREAD_FIELD(baselines), About{"", "what simpler methods answer; empty: not asked"});
        field(TREAD_FIELD(closure), About{"-", "share of the gap to the true car that it says it closes"});
        field(TREAD_FIELD(closure_low), About{"-", "lower end of the interval"});
        field(TREAD_FIELD(closure_high), About{"-", "upper end of the interval"});
        field(TREAD_FIELD(closure_obtained), About{"-", "against the car without its noise; none: not looked up"});
        field(TREAD_FIELD(seconds), About{"s", "that the diagnosis took"});
        field(TREAD_FIELD(simulations), About{"-", "that it needed"});
        field(TREAD_FIELD(failure), About{"", "why there is no answer; empty: there is one"});
    }
};
static_assert(describesEveryMember<CaseAnswer>());

CaseAnswer answerOf(const std::string& name, const diagnose::answer::Diagnosis& diagnosis);

// Share of the squared gap between the nominal model and the car without its noise that is closed, over the recordings
// that were held out; not a number without any. `clean` are their drives without noise, by the names of the recordings.
double obtainedClosure(const std::vector<diagnose::answer::Overlay>& overlays, const std::map<std::string, Log>& clean);

std::string answerText(const CaseAnswer& answer);  // JSON
// Throws LoadError that names the file.
CaseAnswer parseAnswer(std::string_view text, const std::string& file);

}  // namespace tread
