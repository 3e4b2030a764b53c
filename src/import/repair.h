// What is done to the values of a channel on one recording, and to the whole log at last.
#pragma once

#include <vector>

#include "import/channel_reader.h"

namespace tread {

std::vector<double> shifted(std::vector<double> values, double by);

// Spikes, holes and delay of one channel.
void repair(const WholeChannel& channel, const ImportRepairs& repairs, const std::vector<double>& time,
            std::vector<double>& values, std::vector<Change>& changes);

// The mean of its beginning out, its offset in.
void zeroAndOffset(const WholeChannel& channel, const std::vector<double>& time, std::vector<double>& values,
                   std::vector<Change>& changes);

// Values at a fixed rate: interpolated, or averaged over the step when that is much longer than the log's.
void resampleLog(Log& log, double rate, std::vector<Change>& changes);

}  // namespace tread
