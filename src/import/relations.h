// How the channels of one car depend on one another, as a rigid body that rolls: lateral acceleration on speed and yaw
// rate, longitudinal acceleration on speed, roll on lateral acceleration, wheels on speed.
#pragma once

#include <string>
#include <vector>

#include "log/log.h"

namespace tread {

// Two channels that show the same thing in this log, clearly enough to be judged.
struct BodyRelation {
    std::string channel, other;  // the channels whose signs are compared; the speed is always taken as right
    std::string says;            // "chassis.ay and chassis.vx times chassis.yaw_rate"
    double correlation = 0;      // negative: opposite signs
    double factor = 1;           // size of the channel over what the other makes of it
    bool sized = false;          // the factor is 1 in a car
};

// All relations that the channels of the log allow to judge.
std::vector<BodyRelation> bodyRelations(const Log& log);

// The fewest channels whose signs must turn for all relations to agree. Where different sets do, `either` holds the
// channels that are in some of them.
struct OddOnes {
    std::vector<std::string> turned, either;
};
OddOnes oddOnes(const std::vector<BodyRelation>& relations);

// What a factor between two channels looks like; nothing for one that a slide or noise can make.
std::string lookOfFactor(double factor);

// Channels that have changed places: yaw rate with lateral acceleration, longitudinal with lateral acceleration.
struct Swapped {
    std::string one, other;
    std::string why;
};
std::vector<Swapped> swappedChannels(const Log& log);

}  // namespace tread
