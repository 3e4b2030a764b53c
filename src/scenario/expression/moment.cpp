#include "scenario/expression/moment.h"

#include <cmath>
#include <limits>

#include "scenario/expression/operate.h"

namespace tread {

MomentaryExpression::MomentaryExpression(const Term& term, const ChannelValue& channel)
    : root_(nodeOf(term, channel)) {}

MomentaryExpression::Node MomentaryExpression::nodeOf(const Term& term, const ChannelValue& channel) {
    Node node{.term = term};
    node.term.terms.clear();
    if (term.operation == Operation::call) node.function = functionNamed(term.name);
    if (term.operation == Operation::name && channel) node.channel = channel(term.name);
    for (const Term& inner : term.terms) node.inner.push_back(nodeOf(inner, channel));
    return node;
}

void MomentaryExpression::begin() {
    begun_ = false;
}

double MomentaryExpression::value(Node& node, double time) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    if (node.term.operation == Operation::number) return node.term.number;
    if (node.term.operation == Operation::name) return node.channel ? *node.channel : kNan;
    if (node.inner.empty()) return kNan;
    const double a = value(node.inner[0], time);
    const double b = node.inner.size() > 1 ? value(node.inner[1], time) : 0;
    if (node.term.operation != Operation::call) return operate(node.term.operation, a, b);
    const FunctionAbout* about = node.function;
    if (!about) return kNan;
    if (about->function != Function::rate) return operate(about->function, a, b);
    const double before = node.before;
    node.before = a;
    return begun_ ? (a - before) / (time - time_before_) : kNan;
}

bool MomentaryExpression::holds(double time) {
    const bool met = value(root_, time) == 1;
    begun_ = true;
    time_before_ = time;
    return met;
}

}  // namespace tread
