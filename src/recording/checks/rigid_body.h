// Agreement of the measured channels as those of one rigid body, without any model of the car.
#pragma once

#include <string>
#include <vector>

#include "recording/diagnosis_file.h"

namespace tread::recording::checks {

// An error of an instrument that explains a disagreement.
struct InstrumentError {
    // sideslip: what lateral velocity that is not measured adds to ay in proportion to its rate; never an error.
    enum class Kind { delay, gain, bias, place, skew, sideslip } kind;
    double size;          // s, relative, SI unit of the channel, m, rad, s
    std::string channel;  // whose instrument it is
};

// One relation between channels of a recording: `channel` is compared with what follows from the other channels. Both
// are means over 0.2 s, so that a rate of change is a difference between the ends of such a window.
struct Agreement {
    std::string channel;
    std::string follows_from;         // "vx times yaw rate plus the rate of vy"
    std::vector<std::string> others;  // channels from which it follows
    std::string unit;
    bool complete = true;  // false: lateral velocity is unknown, so that only gain and sign can be judged
    double size = 0;       // standard deviation of the channel
    double apart = 0;      // rms of the difference as recorded
    double left = 0;       // rms that remains with `errors`
    std::vector<InstrumentError> errors;
    bool contradicts = false;           // more remains, slowly varying, than noise and small errors leave
    std::vector<std::string> suspects;  // channels of which one must be wrong if it does
};

// All relations that a recording allows: between instruments of one quantity; ay = vy' + vx r; ax = vx' - vy r; yaw
// rate and heading; roll rate and roll angle. Gains, biases and delays that `instruments` describe are taken out first.
std::vector<Agreement> agreements(const Log& log, const Instruments& instruments);

// The channel that a contradiction is put down to: the one that is suspected in most contradictions and takes part in
// fewest agreements. Among equals it is the one that is hardest to measure. Empty if there is no contradiction.
std::string oddChannel(const std::vector<Agreement>& all);

// "differs from chassis.vx times chassis.yaw_rate plus the rate of chassis.vy by 0.62 m/s2 rms; ..."
std::string toText(const Agreement& agreement);

// Removes channels, one after the other, that contradict the others in at least half of the recordings that show them,
// from recordings and references, unless the file says `contradictions: keep`. Returns a sentence for each.
std::vector<std::string> leaveOutContradictions(const DiagnosisFile& file, Recorded& recorded);

}  // namespace tread::recording::checks
