// Choice of the next drive: a short manoeuvre that separates the answers that the recordings leave open, or that shows
// effects which these recordings could not show.
#pragma once

#include <vector>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/select/search.h"

namespace tread::diagnose::explain {

// For each open question a manoeuvre and its expected evidence, in nats, between the two answers, whichever is true.
// All that is uncertain in car and drive is first used to make one answer look like the other. The manoeuvres that
// promise most per second of driving are studied until one separates the answers clearly (D51). Manoeuvres that are
// much faster than the recordings are left out. Empty when nothing is open or none of those studied separates the
// answers.
std::vector<answer::NextDrive> nextDrives(const answer::Diagnosis& diagnosis, const select::Calibration& car,
                                          const select::Search& found, const std::vector<PossibleDrive>& possible);

}  // namespace tread::diagnose::explain
