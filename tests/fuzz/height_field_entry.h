// What the fuzzer and the replay of its corpus do with a text as a height field.
#pragma once

#include <cmath>
#include <limits>
#include <string_view>

#include "fuzz/demand.h"
#include "road/height_field_file.h"

namespace tread::fuzz {

// True when the text was taken.
inline bool readHostileHeights(std::string_view text) {
    HeightField field;
    std::vector<Problem> problems;
    parseHeightField(field, text, "fuzz.csv", problems);
    for (const Problem& problem : problems) demand(problem.file == "fuzz.csv" && !problem.text.empty());
    if (!problems.empty()) return false;
    demand(field.columns >= 2 && field.rows() >= 2);
    demand(field.heights.size() % static_cast<std::size_t>(field.columns) == 0);
    if (!kGridSpacing.allow(field.x_spacing) || !kGridSpacing.allow(field.y_spacing)) return false;  // the reader's
    constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
    for (const double x : {-kInfinity, -1e300, 0.0, 0.3, 1e300, kInfinity}) {
        field.at(x, kNoNumber);
        field.at(kNoNumber, x);
        for (const double y : {-kInfinity, 0.1, 1e300}) demand(!std::isnan(field.at(x, y).height));
    }
    return true;
}

}  // namespace tread::fuzz
