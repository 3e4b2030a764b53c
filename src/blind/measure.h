// Driving the car of a blind case and measuring it.
#pragma once

#include <cstdint>
#include <string_view>

#include "blind/disturbance.h"
#include "blind/drives.h"
#include "blind/truth.h"
#include "log/log.h"

namespace tread {

inline constexpr double kSpeedScatter = 0.005;  // -, standard deviation of the speed at the start

struct Conditions {
    Disturbance disturbance;  // of World::assumed
    double speed_scatter = kSpeedScatter;
    bool noise = true;  // and vibration
    // World::own: what differs from drive to drive, and what surroundings push.
    bool surroundings = true;
    double step = 0.001;  // s, of the world; the diagnosis replays with another
};

inline constexpr Conditions kIdeal{.disturbance = {.fx = 0, .fy = 0, .yaw_moment = 0, .roll_moment = 0},
                                   .speed_scatter = 0,
                                   .noise = false,
                                   .surroundings = false};

// Channels as gauges() has them and `driveline.gear`, 100 rows a second. Throws SimulationError.
Log measure(const Truth& truth, const Drive& drive, std::uint64_t seed, const Conditions& conditions = {});

inline constexpr std::string_view kEngineSpeed = "driveline.engine_speed";

// The same without noise, and with kEngineSpeed, which shakes the instruments.
Log readingsOf(const Truth& truth, const Drive& drive, std::uint64_t seed, const Conditions& conditions);

// Adds what engine and road shake the instruments with.
void vibrate(Log& log, std::uint64_t seed);

}  // namespace tread
