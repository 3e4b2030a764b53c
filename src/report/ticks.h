// Axis ticks at 1, 2 or 5 times a power of ten.
#pragma once

#include <string>
#include <vector>

namespace tread {

struct AxisRange {
    double lowest;
    double highest;

    double span() const { return highest - lowest; }
};

// The 1-2-5 step that divides the span into at most `most` parts.
double niceStep(double span, int most);

// The multiples of the step inside the range.
std::vector<double> ticks(AxisRange range, double step);

// A tick with as many decimals as its step needs.
std::string tickLabel(double value, double step);

}  // namespace tread
