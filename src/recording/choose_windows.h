// Windows of long recordings: a diagnosis of half an hour costs as much as one of ninety drives and tells little more.
#pragma once

#include "recording/diagnosis_file.h"

namespace tread::recording {

// Replaces each recording of more than 180 s by the windows of 20 s with the largest accelerations, at most
// `file.windows` of them. They do not overlap, and begin where the car drives nearly straight on, if there are such
// places. Adds a note for each recording. Does nothing with `windows: 0`.
void chooseWindows(DiagnosisFile& file, Recorded& recorded);

}  // namespace tread::recording
