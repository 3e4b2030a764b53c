// A metric that a user defines: a name, a unit, a sentence, and the expression that gives its value.
#pragma once

#include <string>
#include <vector>

#include "base/units/units.h"
#include "scenario/expression/expression_text.h"
#include "tread/describe.h"

namespace tread {

struct OwnMetric {
    std::string name;
    std::string unit = "-";
    std::string definition;
    ExpressionText value = {};

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(name), About{"", "name, for pages, files and accept"});
        field(TREAD_FIELD(unit), About{"", "unit in which the value is shown, e.g. deg/s; -: a pure number"});
        field(TREAD_FIELD(definition), About{"", "what the metric is, in a sentence"});
        field(
            TREAD_FIELD(value),
            About{"",
                  "expression over channels, phases and parameters, e.g. \"max(abs(chassis.roll), start(2), end(2))\" "
                  "(see tread describe expressions)"});
    }
    static void check(const auto& self, auto&& complain) {
        if (self.name.empty()) complain("name", "found no name, expected the name of the metric");
        if (self.name.find_first_of(" \t,[]\"") != std::string::npos)
            complain("name", "found blanks, commas or brackets in a name, expected a word_like_this; correct it");
        if (!self.value) complain("value", "found no expression, expected what the metric is computed from");
        std::string why;
        if (!parseUnit(self.unit, why)) complain("unit", why);
    }
};
static_assert(describesEveryMember<OwnMetric>());

// The file that `--metrics` names.
struct OwnMetricsFile {
    std::vector<OwnMetric> metrics = {};

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(metrics), About{"", "metrics of your own"});
    }
};
static_assert(describesEveryMember<OwnMetricsFile>());

}  // namespace tread
