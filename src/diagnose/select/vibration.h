// Vibrations that the car has after the change and had not before. The fit does not see them: its rows are averages
// over 50 ms, and the model drives on a smooth road.
#pragma once

#include "diagnose/answer/diagnosis.h"
#include "recording/diagnosis_file.h"

namespace tread::diagnose::select {

// Compares the spectrum of each recording with that of its reference (D33e). Empty where no recording has one.
answer::Vibration vibrationOf(const recording::Recorded& recorded);

}  // namespace tread::diagnose::select
