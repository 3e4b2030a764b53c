// A drive repeated by a changed car with the driver inputs that were recorded in it.
#pragma once

#include <Eigen/Dense>
#include <string_view>

#include "blind/drives/drives.h"
#include "blind/world/truth.h"
#include "log/log.h"

namespace tread::blind::detectability {

// Rows of a log: block means (world::blockMeans) of every channel but those of the driver's inputs, channel by channel
// in the order of instrumentSheets().
Eigen::VectorXd rowsOf(const Log& log);

// Rows of one channel; all channels have as many.
struct ChannelRows {
    Eigen::Index first, count;
};
ChannelRows rowsOfChannel(std::string_view channel, Eigen::Index rows);

class DriveReplay {
public:
    // Drives `truth` without noise and surroundings and records it. Throws SimulationError.
    DriveReplay(const drives::Drive& drive, const world::Truth& truth);

    // Noise-free readings of another car. Its driver repeats the recorded inputs as that car's own instruments would
    // have shown them, in the gear of the recorded drive. `faster`: m/s, change of the speed at the start.
    Log readings(const world::Truth& truth, double faster = 0) const;
    Eigen::VectorXd rows(const world::Truth& truth, double faster = 0) const { return rowsOf(readings(truth, faster)); }

private:
    drives::Drive drive_;
    Log recorded_;
};

}  // namespace tread::blind::detectability
