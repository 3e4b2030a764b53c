// Errors of the numbers of the other cars against their file, and differences from day to day and from drive to drive.
// Independent of the assumptions of the diagnosis and of the errors of tread's own cars (src/blind/world).
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/math/random.h"
#include "recording/subject.h"

namespace other_car {

// Error of all numbers whose paths match: standard deviation relative * |number| + absolute (SI unit).
struct Spread {
    std::string_view paths;
    double relative, absolute;
    std::string_view group;  // errors of one group share half of their variance
    std::string_view source;
    bool one_sided = false;  // a delay is never early
};
std::span<const Spread> spreads();

// Draws heavy-tailed errors of all numbers (blind/world/draws.h).
void drawErrors(tread::recording::Subject& car, tread::Random& random);

// A condition that changes from day to day or from drive to drive. Unit: see `source`.
struct Circumstance {
    std::string_view name;
    double usual;                 // mean
    double each_day, each_drive;  // standard deviations
    double lowest, highest;
    void (*apply)(tread::recording::Subject&, double amount);
    std::string_view source;
};
std::span<const Circumstance> circumstances();

// Standard deviation of the error of a number; 0 for an exact one.
double spreadOf(std::string_view path, double value);

// Applies the circumstances of one drive on one day. Deterministic in the seeds.
void meet(tread::recording::Subject& car, std::uint64_t day_seed, std::uint64_t drive_seed);

}  // namespace other_car
