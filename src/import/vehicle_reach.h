// What a road vehicle can do: which unit makes the values of a column plausible, and how fast a channel can change.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tread {

struct PlausibleUnit {
    std::string unit;
    std::string why;  // one clause: "values peak at 40, plausible in deg"; empty: it can be no other
};

// Of the units that such a channel is usually logged in, the first in which its values are those of a road vehicle; the
// SI unit when no values are finite or none fits.
PlausibleUnit plausibleUnit(std::string_view channel, std::string_view si, const std::vector<double>& values);

// Empty when values in that unit are those of a road vehicle or the channel has no limits; else one clause.
std::string implausible(std::string_view channel, std::string_view unit, const std::vector<double>& values);

// Whether the peak of the values is that of a road vehicle in one unit only.
bool fitsOnlyOneUnit(std::string_view channel, const std::vector<double>& values);

// The largest rate of change of a channel that the car, its driver or a collision-free road can bring about, in its SI
// unit per second; infinite for channels that may change at once (pedals, gear) or that tread does not know.
double fastestChange(std::string_view channel);

// The largest magnitude of a channel in a road vehicle, in its SI unit; infinite where none is known.
double largestValue(std::string_view channel);

}  // namespace tread
