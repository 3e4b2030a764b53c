// What operations and functions at one moment make of numbers. A condition is 1 or 0.
#pragma once

#include <cmath>
#include <limits>

#include "base/math/elementary.h"
#include "base/math/power.h"
#include "scenario/expression/functions.h"
#include "scenario/expression/term.h"

namespace tread {

inline double operate(Operation operation, double a, double b) {
    switch (operation) {
        case Operation::negate:
            return -a;
        case Operation::invert:
            return a == 0 ? 1 : 0;
        case Operation::add:
            return a + b;
        case Operation::subtract:
            return a - b;
        case Operation::multiply:
            return a * b;
        case Operation::divide:
            return a / b;
        case Operation::power:
            return power(a, b);
        case Operation::less:
            return a < b;
        case Operation::at_most:
            return a <= b;
        case Operation::greater:
            return a > b;
        case Operation::at_least:
            return a >= b;
        case Operation::equal:
            return a == b;
        case Operation::unequal:
            return a != b;
        case Operation::both:
            return a != 0 && b != 0;
        case Operation::either:
            return a != 0 || b != 0;
        default:
            return std::numeric_limits<double>::quiet_NaN();
    }
}

inline double operate(Function function, double a, double b) {
    switch (function) {
        case Function::abs:
            return std::abs(a);
        case Function::sign:
            return a > 0 ? 1 : a < 0 ? -1 : a;
        case Function::sqrt:
            return std::sqrt(a);
        case Function::sin:
            return sineCosineFar(a).sine;
        case Function::cos:
            return sineCosineFar(a).cosine;
        case Function::tan:
            return tangentFar(a);
        case Function::atan:
            return arctan(a);
        case Function::atan2:
            return arctan2(a, b);
        case Function::hypot:
            return hypotenuse(a, b);
        case Function::lower:
            return b < a || std::isnan(a) ? b : a;
        case Function::higher:
            return a < b || std::isnan(a) ? b : a;
        default:
            return std::numeric_limits<double>::quiet_NaN();
    }
}

}  // namespace tread
