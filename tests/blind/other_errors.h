// How far the numbers of the other cars are off from their file, and what differs from day to day and from drive to
// drive. A source of its own: neither what the diagnosis assumes nor what tread's own cars are drawn from.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/random.h"
#include "recording/subject.h"

namespace other_car {

// Of all numbers whose paths match: standard deviation, as a fraction of the number and in its SI unit.
struct Spread {
    std::string_view paths;
    double relative, absolute;
    std::string_view group;  // errors of one group have half of their variance in common
    std::string_view source;
    bool one_sided = false;  // a delay is never early
};
std::span<const Spread> spreads();

// Errors with heavy tails (blind/draws.h).
void err(tread::recording::Subject& car, tread::Random& random);

// Something that is not the same from day to day or from drive to drive, in a unit of its own.
struct Circumstance {
    std::string_view name;
    double usual;                 // mean
    double each_day, each_drive;  // standard deviations
    double lowest, highest;
    void (*apply)(tread::recording::Subject&, double amount);
    std::string_view source;
};
std::span<const Circumstance> circumstances();

// Standard deviation of the error of a number; 0 when it has none.
double spreadOf(std::string_view path, double value);

// Applies what the drive `drive` of a day meets; the same seed, the same day.
void meet(tread::recording::Subject& car, std::uint64_t day_seed, std::uint64_t drive_seed);

}  // namespace other_car
