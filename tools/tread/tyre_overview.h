// What to know of a tyre at a glance: for the overview, the cards of the page of curves, and the JSON result.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tread/tyre.h"

namespace tread::program {

// A number that characterises the tyre; the shown value is the SI value times the scale.
struct TyreFact {
    std::string_view key;
    std::string_view label;
    double value;
    std::string_view unit;
    std::string_view shown_unit;
    double scale = 1;
};

// Size, friction, stiffnesses, trail and relaxation lengths at the nominal load, without camber.
std::vector<TyreFact> tyreFacts(const TyreParams& tyre);

// The tyre's name, or a word in its place.
std::string tyreName(const TyreParams& tyre);

// The facts as text, the answer in the first line.
std::string overviewText(const TyreParams& tyre, const std::vector<TyreFact>& facts);

}  // namespace tread::program
