// Simulates a drive of the true car and the readings of its instruments.
#pragma once

#include <cstdint>
#include <string_view>

#include "blind/drives/drives.h"
#include "blind/world/disturbance.h"
#include "blind/world/truth.h"
#include "log/log.h"

namespace tread::blind::drives {

inline constexpr double kSpeedScatter = 0.005;  // -, relative standard deviation of the speed at the start

struct Conditions {
    world::Disturbance disturbance;  // World::assumed only
    double speed_scatter = kSpeedScatter;
    bool noise = true;         // of the instruments, vibration included
    bool surroundings = true;  // World::own only: pushes and drive-to-drive differences
    double step = 0.001;       // s, of the simulation; shorter than that of the diagnosis
};

inline constexpr Conditions kIdeal{.disturbance = {.fx = 0, .fy = 0, .yaw_moment = 0, .roll_moment = 0},
                                   .speed_scatter = 0,
                                   .noise = false,
                                   .surroundings = false};

// Log of the channels of world::instrumentSheets() and `driveline.gear` at 100 Hz. Throws SimulationError.
Log measure(const world::Truth& truth, const Drive& drive, std::uint64_t seed, const Conditions& conditions = {});

inline constexpr std::string_view kEngineSpeed = "driveline.engine_speed";

// The same without noise, and with the channel kEngineSpeed, which determines the engine's vibration.
Log readingsOf(const world::Truth& truth, const Drive& drive, std::uint64_t seed, const Conditions& conditions);

// Adds the vibration of World::assumed.
void vibrate(Log& log, std::uint64_t seed);

}  // namespace tread::blind::drives
