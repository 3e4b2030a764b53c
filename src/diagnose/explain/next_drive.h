// What to drive next: the manoeuvre that would best tell apart what the recordings leave open, or show what they
// could not show.
#pragma once

#include <vector>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/select/search.h"

namespace tread::diagnose::explain {

// Manoeuvres for the questions that a diagnosis leaves open, each with the evidence to expect from it: nats between the
// two answers, whichever is true, after all that is uncertain in car and drive was used to imitate the one by the
// other. None where nothing is open, or where no manoeuvre would tell.
std::vector<answer::NextDrive> nextDrives(const answer::Diagnosis& diagnosis, const select::Calibration& car,
                                          const select::Search& found, const std::vector<PossibleDrive>& possible);

}  // namespace tread::diagnose::explain
