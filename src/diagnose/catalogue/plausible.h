// Hard ranges: where a number of a car of this kind can be at all. A tolerance says how well a number is known; a range
// says what no such car, road or instrument exceeds. A fit keeps within it, and a number that stands at its end is a
// sign of a wrong cause.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "recording/subject.h"
#include "tread/describe.h"

namespace tread::diagnose::catalogue {

// What the ends of a range are multiplied by. `itself`: the number's nominal value; the others: numbers of the nominal
// car.
enum class Scale { one, itself, mass, wheelbase, mass_wheelbase, mass_height, axle_distances };
constexpr auto enumNames(Scale) {
    return std::array<std::string_view, 7>{"",
                                           "the nominal value",
                                           "the mass",
                                           "the wheelbase",
                                           "mass x wheelbase",
                                           "mass x height of the centre of gravity",
                                           "mass x product of the distances of both axles"};
}

struct PlausibleRange {
    std::string_view path;  // pattern; * matches any characters
    double lowest, highest;
    Scale scale;
    std::string_view source;
};

// The range of the number at a path; nullptr when none is known.
const PlausibleRange* plausibleRange(std::string_view path);

// Its ends for a car, in the SI unit of the number; without ends when no range is known. A nominal value outside its
// range extends it.
Limits plausibleLimits(std::string_view path, double nominal, const VehicleParams& car);

// "0.7 to 1.6 x the nominal value", for people; empty when no range is known.
std::string plausibleText(std::string_view path);

}  // namespace tread::diagnose::catalogue
