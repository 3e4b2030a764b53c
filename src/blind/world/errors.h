// Errors of car, instruments and day against the nominal car in World::own. Independent of the list of uncertain
// numbers that the diagnosis uses; World::assumed draws from that list.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/math/random.h"
#include "recording/subject.h"

namespace tread::blind::world {

// Error of all numbers whose path matches `pattern`; the last matching row applies, numbers without a row are exact.
// The spread of an error is its standard deviation, relative * |number| + absolute; errors are heavy-tailed (draws.h).
struct NumberError {
    std::string_view pattern;
    double relative = 0;    // part of the spread that is proportional to the number
    double absolute = 0;    // constant part of the spread, SI unit of the number
    double per_kelvin = 0;  // 1/K, relative change with the temperature above that of the file
    // Weight, 0 to 1, of a draw that all numbers of the row share (parts of one batch, measurements by one person), per
    // car or, with by_axle, per axle. Their correlation is its square.
    double common = 0;
    bool by_axle = false;
    double daily = 0;  // share of the spread that is drawn anew each day
    std::string_view source;
};
std::span<const NumberError> errorTable();

inline constexpr double kDaySpread = 6;  // K, standard deviation of the temperature of a day

// Adds the errors of the table, of the day's temperature, and of loads that change mass, centre of gravity and inertias
// consistently.
void drawErrors(recording::Subject& car, Random& random);

// An uncertain number.
struct OpenNumber {
    std::string path;
    double sd;  // SI unit of the number
};
// All uncertain numbers. A tolerance in the description of the car is the half-width of a uniform distribution; a
// number without one has the standard deviation of the error table.
std::vector<OpenNumber> openNumbers(const recording::Subject& nominal);
// Only the part that changes from day to day: the uncertainty against a reference drive of the same car.
std::vector<OpenNumber> dailyNumbers(const recording::Subject& nominal);

// Conditions that change from drive to drive.
struct DriveDifference {
    double wind_x = 0, wind_y = 0;  // m/s
    double grade = 0, bank = 0;     // -, of a tilted ground that is driven in a random direction
    double latency = 0;             // s, of all instruments except those of the driver's inputs
};
inline constexpr double kMostWind = 3;          // m/s; speed uniform up to this, direction uniform
inline constexpr double kMostLatency = 0.005;   // s
inline constexpr double kGroundSlope = 0.0015;  // -, standard deviation of each component of the slope

struct GroundSlope {
    double along = 0, across = 0;  // -, rise over run
};
GroundSlope drawnGround(Random& random);
DriveDifference drawnDifference(const GroundSlope& ground, Random& random);

// Standard deviations.
DriveDifference differenceSpread();

void apply(const DriveDifference& difference, recording::Subject& car);

}  // namespace tread::blind::world
