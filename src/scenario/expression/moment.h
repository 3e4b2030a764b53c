// The value of an expression now, step by step: what a condition of a phase asks.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "scenario/expression/functions.h"
#include "scenario/expression/term.h"

namespace tread {

// Where the value of a channel is found now; nullptr: there is none of that name.
using ChannelValue = std::function<const double*(std::string_view name)>;

class MomentaryExpression {
public:
    // Of a checked condition. Channels that are not there are not a number, which meets no comparison.
    MomentaryExpression(const Term& term, const ChannelValue& channel);

    // Forgets the step before: there is no rate of change in the first step.
    void begin();

    // Whether the condition is met at this time, s; called once in each step.
    bool holds(double time);

private:
    struct Node {
        Term term;
        const double* channel = nullptr;
        const FunctionAbout* function = nullptr;
        std::vector<Node> inner = {};
        double before = 0;  // of a rate: its argument in the step before
    };
    static Node nodeOf(const Term& term, const ChannelValue& channel);
    double value(Node& node, double time);

    Node root_;
    bool begun_ = false;
    double time_before_ = 0;  // s
};

}  // namespace tread
