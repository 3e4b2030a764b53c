// References: recordings of the same car before something on it was changed. The structure of a model always differs
// from that of the car. The gap that the reference already shows in the same drive is therefore subtracted from the gap
// after the change.
#pragma once

#include "recording/replay.h"

namespace tread::recording {

// The reference of a recording as a recording of its own, with a name that says so.
Recording referenceOf(const Recording& recording);

// Reduces a diagnosis to the car before the change: its recordings become the references, and the drives under
// `before`. Returns false and changes nothing when there are none.
bool beforeTheChange(DiagnosisFile& file, Recorded& recorded);

// The same drive of the car before it was changed.
struct Reference {
    Recording recording;
    RecordedDrive drive;
    Eigen::VectorXd nominal;  // rows of the nominal car in it
};

// Rows of a reference at the times of the drive's rows.
Eigen::VectorXd atRowsOf(const RecordedDrive& drive, const RecordedDrive& reference, const Eigen::VectorXd& rows);

// The log without those measured channels that the reference lacks.
Log withChannelsOf(const Log& log, const Log& reference);

// The drives to fit (or those held out). Where a drive has a reference, the gap of the nominal car to it is subtracted.
// Throws std::invalid_argument when a reference is a different drive or cannot be driven. `threads`: 0: one per core.
std::vector<RecordedDrive> recordedDrives(const DiagnosisFile& file, const Recorded& recorded, bool held_out,
                                          const Replayer& replayer, int threads);

}  // namespace tread::recording
