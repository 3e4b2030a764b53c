// What the fuzzer and the replay of its corpus do with a text as a tyre property file.
#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields/numbers.h"
#include "fuzz/demand.h"
#include "tread/problem.h"
#include "tyre/tir_file.h"

namespace tread::fuzz {

// True when the text was taken.
inline bool readHostileTir(std::string_view text) {
    std::vector<std::string> warnings;
    try {
        TyreParams tyre = parseTir(text, "fuzz.tir", warnings);
        for (const Number& number : numbers(tyre)) demand(std::isfinite(*number.value));
        for (const std::string& warning : warnings) demand(!warning.empty());
        return true;
    } catch (const LoadError& error) {
        demand(!error.problems().empty());
        for (const Problem& problem : error.problems()) demand(problem.file == "fuzz.tir" && !problem.text.empty());
        return false;
    }
}

}  // namespace tread::fuzz
