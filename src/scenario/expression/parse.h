// Reading an expression.
//
//     condition := comparison {("and" | "or") comparison}     "and" binds more strongly; "not" stands before either
//     comparison := sum [("<" | "<=" | ">" | ">=" | "==" | "!=") sum]
//     sum := product {("+" | "-") product};  product := sign {("*" | "/") sign};  sign := ["-"] power
//     power := value ["^" value]
//     value := number [unit] | channel | parameter | function "(" [condition {"," condition}] ")" | "(" condition ")"
//
// The unit of a number reaches as far as units follow each other: "3 m/s" is a speed, "3 m / chassis.vx" a time.
#pragma once

#include <optional>
#include <string_view>

#include "scenario/expression/term.h"

namespace tread {

// Nothing, and what is wrong in `fault`, when the text is no expression.
std::optional<Term> parseExpression(std::string_view text, ExpressionFault& fault);

}  // namespace tread
