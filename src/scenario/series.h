// What one run cannot answer: a number that has to be found, a number that is varied, the highest value that passes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tread/describe.h"

namespace tread {

// Chooses a number of the scenario so that a metric of its run comes out as wanted.
struct Tune {
    std::string number;
    std::string metric;
    double target = kRequired;
    std::string lowest;
    std::string highest;
    double tolerance = 0.005;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(number), About{"", "path of the number, for example phases.1.steering.ramp.to"});
        field(TREAD_FIELD(metric), About{"", "metric of the manoeuvre"});
        field(TREAD_FIELD(target), About{"", "target value, in the unit of the metric"}.unjudged());
        field(TREAD_FIELD(lowest), About{"", "least value to try, with its unit"});
        field(TREAD_FIELD(highest), About{"", "largest value to try, with its unit"});
        field(TREAD_FIELD(tolerance),
              About{"-", "how near the metric must come, as a share of the target", kPositive}.usually(1e-5, 0.2));
    }
};
static_assert(describesEveryMember<Tune>());

// A number that is set first: a factor times what a run of another scenario shows.
struct Scale {
    std::string number;
    double factor = kRequired;
    std::string of_scenario;
    std::string of_metric;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(number), About{"", "path of the number, for example phases.1.steering.ramp.to"});
        field(TREAD_FIELD(factor), About{"-", "factor of the metric"}.unjudged());
        field(TREAD_FIELD(of_scenario), About{"", "that scenario's file, relative to this one"});
        field(TREAD_FIELD(of_metric), About{"", "that metric; its unit must fit the number"});
    }
    static void check(const auto& self, auto&& complain) {
        if (self.number.empty()) complain("number", "found no number, expected the path of the one that is set");
        if (self.of_scenario.empty() || self.of_metric.empty())
            complain("of_scenario", "expected of_scenario and of_metric, which the factor multiplies");
    }
};
static_assert(describesEveryMember<Scale>());

// One run for each value; or for each factor times what a run of another scenario shows.
struct Vary {
    std::string number;
    std::vector<std::string> values;
    std::vector<double> factors;
    std::string of_scenario;
    std::string of_metric;
    std::string least_last;
    std::string largest;
    std::string pass;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(number), About{"", "path of the number"});
        field(TREAD_FIELD(values), About{"", "its values, with their unit"});
        field(TREAD_FIELD(factors),
              About{"-", "in place of values: factors of the metric of another scenario"}.usually(0.01, 100));
        field(TREAD_FIELD(of_scenario), About{"", "that scenario's file, relative to this one"});
        field(TREAD_FIELD(of_metric), About{"", "that metric; its unit must fit the number"});
        field(TREAD_FIELD(least_last), About{"", "the last value is at least this, with its unit"});
        field(TREAD_FIELD(largest), About{"", "no value is larger than this, with its unit"});
        field(TREAD_FIELD(pass), About{"", "metric that is 1 when a run has passed; empty: no verdict"});
    }
    static void check(const auto& self, auto&& complain) {
        if (self.values.empty() == self.factors.empty())
            complain("values", "expected either values or factors, with one element at least");
        if (!self.factors.empty() && (self.of_scenario.empty() || self.of_metric.empty()))
            complain("factors", "found no of_scenario and of_metric, expected what the factors multiply");
    }
};
static_assert(describesEveryMember<Vary>());

// The highest value of a number with which a run passes, by bisection.
struct Highest {
    std::string number;
    std::string lowest;
    std::string highest;
    std::string resolution;
    std::string pass;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(number), About{"", "path of the number"});
        field(TREAD_FIELD(lowest), About{"", "least value to try, with its unit"});
        field(TREAD_FIELD(highest), About{"", "largest value to try, with its unit"});
        field(TREAD_FIELD(resolution), About{"", "how near to find it, with its unit"});
        field(TREAD_FIELD(pass), About{"", "metric that is 1 when a run has passed"});
    }
};
static_assert(describesEveryMember<Highest>());

struct SeriesParams {
    std::vector<Scale> scale = {};
    std::vector<Tune> tune;
    std::optional<Vary> vary;
    std::optional<Highest> highest;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(scale), About{"", "numbers that are set first from what other scenarios show"});
        field(TREAD_FIELD(tune), About{"", "numbers that are found first, one after the other"});
        field(TREAD_FIELD(vary), About{"", "a number that is varied from run to run"});
        field(TREAD_FIELD(highest), About{"", "a number whose highest passing value is sought"});
    }
    static void check(const auto& self, auto&& complain) {
        if (self.vary && self.highest) complain("highest", "a scenario has either vary or highest");
    }
    bool empty() const { return scale.empty() && tune.empty() && !vary && !highest; }
};
static_assert(describesEveryMember<SeriesParams>());

}  // namespace tread
