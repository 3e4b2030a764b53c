// Recordings of the car as it was before something changed. The structure of a model is never that of a car: what it
// lacked already, in the same drive, is no news, and is taken off what it lacks now.
#pragma once

#include "recording/replay.h"

namespace tread::recording {

// The recording that a reference is, under a name that tells so.
Recording referenceOf(const Recording& recording);

// Leaves of a diagnosis the car as it was before: references in place of the recordings, and only those that have one.
// False, and nothing is changed, where there is none.
bool beforeTheChange(DiagnosisFile& file, Recorded& recorded);

// A log without those measured channels that the reference has not.
Log withChannelsOf(const Log& log, const Log& reference);

// The recordings from which to learn, or those held out, each less what the nominal car lacks in its reference where it
// has one. Throws std::invalid_argument when a reference is another drive, or cannot be driven. `threads`: 0: one per
// core.
std::vector<RecordedDrive> recordedDrives(const DiagnosisFile& file, const Recorded& recorded, bool held_out,
                                          const Replayer& replayer, int threads);

}  // namespace tread::recording
