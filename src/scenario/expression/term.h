// An expression taken apart: numbers with units, channels, parameters, and what is made of them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/units/units.h"

namespace tread {

enum class Operation {
    number,
    name,   // of a channel or, behind "vehicle." and "scenario.", of a parameter
    words,  // in quotes: the name of a phase
    call,
    negate,
    invert,  // not
    add,
    subtract,
    multiply,
    divide,
    power,
    less,
    at_most,
    greater,
    at_least,
    equal,
    unequal,
    both,   // and
    either  // or
};

struct Term {
    Operation operation = Operation::number;
    std::size_t at = 0;     // byte of the text
    std::string name = {};  // channel, parameter, function, or what stands in quotes
    double number = 0;      // SI
    std::vector<Term> terms = {};

    // Of a number from the beginning, of everything else once it is checked.
    Dimension dimension = {};
    bool condition = false;  // true or false instead of a number
    bool over_time = false;  // one value for each moment
};

// What is wrong with an expression: one sentence, and where.
struct ExpressionFault {
    std::size_t at = 0;  // byte of the text
    std::string text;
};

}  // namespace tread
