// What a diagnosis said of a blind case, as far as it is scored.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "diagnose/answer/diagnosis.h"

namespace tread {

struct CaseAnswer {
    std::string name;  // of the case
    diagnose::answer::Verdict verdict = diagnose::answer::Verdict::not_testable;
    std::vector<std::string> causes, credible_set;
    std::vector<std::vector<std::string>> alternatives;
    std::vector<diagnose::answer::RankedEffect> effects;  // best first
    double probability_of_nothing = 0, probability_of_unknown = 0;
    std::map<std::string, double> testable;  // nats
    std::vector<std::string> confusable;  // effects that, at their typical size, these drives cannot tell from another
    std::string generalised_force;
    diagnose::answer::Baselines baselines;
    double closure = 0, closure_low = 0, closure_high = 0;
    double closure_obtained = std::numeric_limits<double>::quiet_NaN();  // against the car without its noise
    double seconds = 0;
    int simulations = 0;
    std::string failure;  // why there is no answer
};

CaseAnswer answerOf(const std::string& name, const diagnose::answer::Diagnosis& diagnosis);

// Share of the squared gap between the nominal model and the car without its noise that is closed, over the recordings
// that were held out; not a number without any. `clean` are their drives without noise, by the names of the recordings.
double obtainedClosure(const std::vector<diagnose::answer::Overlay>& overlays, const std::map<std::string, Log>& clean);

std::string answerText(const CaseAnswer& answer);  // JSON
// Throws LoadError that names the file.
CaseAnswer parseAnswer(std::string_view text, const std::string& file);

}  // namespace tread
