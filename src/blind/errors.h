// How far a real car, its instruments and the day are off from what the car's file says: the examiner's own source. It
// shares nothing with the list of uncertain numbers of the diagnosis (World::assumed draws by that one).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/random.h"
#include "diagnose/subject.h"

namespace tread {

// Numbers that err alike: of each whose path fits the pattern the error has this spread (standard deviation), drawn
// with heavy tails (draws.h). A number goes by the last row that fits. Numbers without a row are right.
struct NumberError {
    std::string_view pattern;
    double relative = 0;    // spread as a share of the number ...
    double absolute = 0;    // ... and in its SI unit, besides
    double per_kelvin = 0;  // relative change with a day that is warmer than the file assumes
    // Weight of a draw that all numbers of the row have in common, of one axle or of the car: parts of one batch,
    // measures of one person.
    double common = 0;
    bool by_axle = false;
    double daily = 0;  // share of the spread that is another one the next day
    std::string_view source;
};
std::span<const NumberError> numberErrors();

inline constexpr double kDaySpread = 6;  // K, standard deviation of how much warmer a day is

// Draws all errors of a car: those of the table, a day, and a load that moves mass, centre of gravity and inertias
// together.
void err(Subject& car, Random& random);

// A number and the standard deviation of what is left open of it.
struct OpenNumber {
    std::string path;
    double sd;
};
// Half the width of a uniform distribution is the tolerance that the car's own description states; where it states
// none, the errors above hold.
std::vector<OpenNumber> openNumbers(const Subject& nominal);
// Only what differs from one day to the next: what is left open of a car beside a reference of itself.
std::vector<OpenNumber> dailyNumbers(const Subject& nominal);

// What differs from drive to drive.
struct DriveDifference {
    double wind_x = 0, wind_y = 0;  // m/s
    double grade = 0, bank = 0;     // -, of a ground that leans, met in another direction each time
    double latency = 0;             // s, of all instruments but those of the driver's inputs
};
inline constexpr double kMostWind = 3;          // m/s, from any direction, each speed as likely
inline constexpr double kMostLatency = 0.005;   // s
inline constexpr double kGroundSlope = 0.0015;  // -, standard deviation of the ground's slope in each direction

struct GroundSlope {
    double along = 0, across = 0;  // rise over run
};
GroundSlope drawnGround(Random& random);
DriveDifference drawnDifference(const GroundSlope& ground, Random& random);

// Standard deviation of each difference.
DriveDifference differenceSpread();

void apply(const DriveDifference& difference, Subject& car);

}  // namespace tread
