// First line of the answer.
#pragma once

#include <string>

#include "diagnose/answer/diagnosis.h"

namespace tread::diagnose::answer {

// The verdict and its causes in one sentence, with their probabilities and what remains of the gap, without a full
// stop.
std::string headline(const Diagnosis& diagnosis);

}  // namespace tread::diagnose::answer
