// A condition on a number, as people write it: "< 40 m", "= 0", "30 .. 40 m", "38.2 m +- 2 %".
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tread {

struct Condition {
    enum class Kind { less, at_most, greater, at_least, equal, range, around };
    Kind kind = Kind::equal;
    std::string first;   // the number with its unit; of a range the lower end
    std::string second;  // upper end of a range, tolerance around a value
};

// Nothing, and what is wrong in `fault`, when the text is no condition.
std::optional<Condition> parseCondition(std::string_view text, std::string& fault);

// The values that meet a condition, in the unit of a metric.
struct Interval {
    double lowest;
    double highest;
    bool lowest_open = false;
    bool highest_open = false;

    bool holds(double value) const;  // not a number: false
};

// Nothing, and what is wrong in `fault`, when a unit measures something else. A number without unit is in `unit`. A
// tolerance in % is a share of the value, but of a metric in % a number of percentage points.
std::optional<Interval> intervalOf(const Condition& condition, std::string_view unit, std::string& fault);

}  // namespace tread
