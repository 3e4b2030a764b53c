#include "metrics/own/evaluate.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "metrics/channels.h"
#include "metrics/series.h"
#include "metrics/smoothing.h"
#include "scenario/expression/functions.h"
#include "scenario/expression/operate.h"

namespace tread {
namespace {

// A time within which a condition is met.
struct Spell {
    double from, to;  // s
};
using Spells = std::vector<Spell>;  // in their order, apart from each other

// One number, or one for each sample. A condition has 1 and 0, or the times at which it is met.
struct Value {
    std::vector<double> samples = {};
    Spells spells = {};
    double number = kUndefined;
    bool over_time = false;

    double at(std::size_t i) const { return over_time ? samples[i] : number; }
};

// By how much a comparison is met: above zero it is, at zero it is when equality is enough. Not a number meets nothing.
double margin(Operation operation, double a, double b) {
    switch (operation) {
        case Operation::less:
        case Operation::at_most:
            return b - a;
        case Operation::greater:
        case Operation::at_least:
            return a - b;
        case Operation::equal:
            return -std::abs(a - b);
        default:  // unequal
            return std::abs(a - b);
    }
}

bool isMet(Operation operation, double margin) {
    const bool equality_is_enough =
        operation == Operation::at_most || operation == Operation::at_least || operation == Operation::equal;
    return margin > 0 || (margin == 0 && equality_is_enough);
}

// Where a margin passes through zero between two samples; a jump from or to a value that is not finite counts for the
// one that is.
double crossing(double before, double after, double time_before, double time_after) {
    if (!std::isfinite(before) || before == after) return time_after;
    if (!std::isfinite(after)) return time_before;
    return time_before + before / (before - after) * (time_after - time_before);
}

Spells intersection(const Spells& a, const Spells& b) {
    Spells out;
    for (std::size_t i = 0, k = 0; i < a.size() && k < b.size();) {
        const Spell both{std::max(a[i].from, b[k].from), std::min(a[i].to, b[k].to)};
        if (both.from <= both.to) out.push_back(both);
        ++(a[i].to < b[k].to ? i : k);
    }
    return out;
}

Spells complement(const Spells& spells, double begin, double end) {
    Spells out;
    double from = begin;
    for (const Spell& spell : spells) {
        if (spell.from > from) out.push_back({from, spell.from});
        from = spell.to;
    }
    if (from < end) out.push_back({from, end});
    return out;
}

class Evaluator {
public:
    Evaluator(const Log& log, const std::vector<RunParameter>& parameters, const std::vector<std::string>& phases)
        : log_(log), time_(log.channels.front().values), parameters_(parameters), phases_(phases) {}

    Value value(const Term& term) const {
        switch (term.operation) {
            case Operation::number:
                return Value{.number = term.number};
            case Operation::name:
                return named(term.name);
            case Operation::call:
                return call(term, *functionNamed(term.name));
            default:
                return combined(term);
        }
    }

private:
    Value named(const std::string& name) const {
        const auto parameter = std::find_if(parameters_.begin(), parameters_.end(),
                                            [&](const RunParameter& one) { return one.name == name; });
        if (parameter != parameters_.end()) return Value{.number = parameter->value};
        const Channel* channel = log_.find(name);
        return channel ? Value{.samples = channel->values, .over_time = true} : Value{};
    }

    Value combined(const Term& term) const {
        const Value a = value(term.terms[0]), b = term.terms.size() > 1 ? value(term.terms[1]) : Value{.number = 0};
        const bool connects = term.operation == Operation::both || term.operation == Operation::either ||
                              term.operation == Operation::invert;
        if (!term.condition || !term.over_time)
            return each(a, b, [&](double x, double y) { return operate(term.operation, x, y); });
        return {.spells = connects ? connected(term.operation, a, b) : compared(term.operation, a, b),
                .over_time = true};
    }

    Spells spellsOf(const Value& condition) const {
        if (condition.over_time) return condition.spells;
        return condition.number == 1 ? Spells{{time_.front(), time_.back()}} : Spells{};
    }

    Spells connected(Operation operation, const Value& a, const Value& b) const {
        const auto inverse = [&](const Spells& of) { return complement(of, time_.front(), time_.back()); };
        if (operation == Operation::invert) return inverse(spellsOf(a));
        if (operation == Operation::both) return intersection(spellsOf(a), spellsOf(b));
        return inverse(intersection(inverse(spellsOf(a)), inverse(spellsOf(b))));
    }

    Spells compared(Operation operation, const Value& a, const Value& b) const {
        Spells found;
        double before = kUndefined;
        bool was_met = false;
        for (std::size_t i = 0; i < time_.size(); ++i) {
            const double now = margin(operation, a.at(i), b.at(i));
            const bool met = isMet(operation, now);
            const double change = i == 0 || met == was_met ? time_[i] : crossing(before, now, time_[i - 1], time_[i]);
            if (met && !was_met) found.push_back({change, time_[i]});
            if (met) found.back().to = time_[i];
            if (!met && was_met) found.back().to = change;
            before = now;
            was_met = met;
        }
        return found;
    }

    template <class Make>
    Value each(const Value& a, const Value& b, const Make& make) const {
        if (!a.over_time && !b.over_time) return Value{.number = make(a.number, b.number)};
        Value out{.over_time = true};
        for (std::size_t i = 0; i < time_.size(); ++i) out.samples.push_back(make(a.at(i), b.at(i)));
        return out;
    }

    TimeSeries series(const Value& value) const {
        return {time_, value.over_time ? value.samples : std::vector<double>(time_.size(), value.number)};
    }

    Value call(const Term& term, const FunctionAbout& about) const {
        if (about.function == Function::start || about.function == Function::end)
            return Value{.number = phaseTime(term, about.function == Function::start)};
        const Value first = value(term.terms[0]);
        if (about.function == Function::rate) return rate(first);
        if (about.function == Function::smoothed) {
            const double half_width = value(term.terms[1]).number;
            if (!first.over_time || !(half_width > 0)) return first;
            return Value{.samples = averaged(series(first), half_width).value, .over_time = true};
        }
        if (!about.reduces) {
            const Value second = term.terms.size() > 1 ? value(term.terms[1]) : Value{.number = 0};
            return each(first, second, [&](double x, double y) { return operate(about.function, x, y); });
        }
        if (about.function == Function::at) return Value{.number = valueAt(first, value(term.terms[1]).number)};
        double from = time_.front(), to = time_.back();
        if (term.terms.size() > 1) from = value(term.terms[1]).number;
        if (term.terms.size() > 2) to = value(term.terms[2]).number;
        // A window is that part of it which lies in the log; one whose ends are not known is none.
        if (std::isnan(from) || std::isnan(to)) return {};
        from = std::max(from, time_.front());
        to = std::min(to, time_.back());
        if (from > to) return {};
        if (about.of_condition)
            return Value{.number = ofSpells(about.function, intersection(spellsOf(first), {{from, to}}))};
        return Value{.number = reduced(about.function, series(first), from, to)};
    }

    double valueAt(const Value& of, double time) const {
        if (!(time >= time_.front() && time <= time_.back())) return kUndefined;
        return tread::at(series(of), time);
    }

    Value rate(const Value& of) const {
        if (!of.over_time) return Value{.number = 0};
        const std::size_t n = time_.size();
        Value out{.samples = std::vector<double>(n, kUndefined), .over_time = true};
        if (n < 2) return out;
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t before = i == 0 ? 0 : i - 1, after = i + 1 == n ? i : i + 1;
            out.samples[i] = (of.samples[after] - of.samples[before]) / (time_[after] - time_[before]);
        }
        return out;
    }

    static double reduced(Function function, const TimeSeries& whole, double from, double to) {
        const TimeSeries in = part(whole, from, to);
        switch (function) {
            case Function::max:
                return range(in).most;
            case Function::min:
                return range(in).least;
            case Function::mean:
                return mean(whole, from, to);
            case Function::integral:
                return integral(whole, from, to);
            case Function::first:
                return in.value.front();
            case Function::last:
                return in.value.back();
            default:
                return std::sqrt(meanSquare(in));
        }
    }

    // Of straight lines between the samples.
    static double meanSquare(const TimeSeries& in) {
        if (in.end() == in.begin()) return in.value.front() * in.value.front();
        double sum = 0;
        for (std::size_t i = 1; i < in.size(); ++i) {
            const double a = in.value[i - 1], b = in.value[i];
            sum += (in.time[i] - in.time[i - 1]) * (a * a + a * b + b * b) / 3;
        }
        return sum / (in.end() - in.begin());
    }

    static double ofSpells(Function function, const Spells& spells) {
        double sum = 0, longest = 0;
        for (const Spell& spell : spells) {
            sum += spell.to - spell.from;
            longest = std::max(longest, spell.to - spell.from);
        }
        if (function == Function::duration) return sum;
        if (function == Function::longest) return longest;
        if (function == Function::count) return static_cast<double>(spells.size());
        return spells.empty() ? kUndefined : spells.front().from;
    }

    double phaseTime(const Term& term, bool start) const {
        if (term.terms.empty()) return start ? time_.front() : time_.back();
        const Term& which = term.terms[0];
        double number = which.number;
        if (which.operation == Operation::words) {
            const auto named = std::find(phases_.begin(), phases_.end(), which.name);
            if (named == phases_.end()) return kUndefined;
            number = static_cast<double>(named - phases_.begin()) + 1;
        }
        const Channel *phase = log_.find("manoeuvre.phase"), *began = log_.find("manoeuvre.phase_start");
        if (!phase || !began) return kUndefined;
        const auto first = [&](auto fits) -> std::optional<std::size_t> {
            const auto at = std::find_if(phase->values.begin(), phase->values.end(), fits);
            if (at == phase->values.end()) return {};
            return at - phase->values.begin();
        };
        const auto here = first([&](double p) { return p == number; });
        if (!here) return kUndefined;
        if (start) return std::max(began->values[*here], time_.front());
        const auto next = first([&](double p) { return p > number; });
        return next ? began->values[*next] : time_.back();
    }

    const Log& log_;
    const std::vector<double>& time_;
    const std::vector<RunParameter>& parameters_;
    const std::vector<std::string>& phases_;
};

}  // namespace

double evaluate(const Term& term, const Log& log, const std::vector<RunParameter>& parameters,
                const std::vector<std::string>& phases) {
    if (log.samples() == 0) return kUndefined;
    const Value found = Evaluator(log, parameters, phases).value(term);
    if (found.over_time) return kUndefined;
    return found.number;
}

}  // namespace tread
