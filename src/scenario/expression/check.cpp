#include "scenario/expression/check.h"

#include <algorithm>
#include <cmath>

#include "base/text/concat.h"
#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "scenario/expression/functions.h"

namespace tread {
namespace {

constexpr std::size_t kSecond = 2, kRadian = 5;  // places in a Dimension
constexpr double kLargestExponent = 4;
constexpr Dimension kPure{}, kTime{0, 0, 1, 0, 0, 0}, kAngle{0, 0, 0, 0, 0, 1};

bool fits(Dimension a, Dimension b) {
    a[kRadian] = b[kRadian] = 0;
    return a == b;
}

bool isZero(const Term& term) {
    return term.operation == Operation::number && term.number == 0 && term.dimension == kPure;
}

std::string kindOf(const Dimension& dimension) {
    return dimension == kPure ? "a pure number" : dimensionName(dimension);
}

class Checker {
public:
    Checker(const KnownNames& known, ExpressionFault& fault) : known_(known), fault_(fault) {}

    bool check(Term& term) {
        const bool names_phase = term.operation == Operation::call && (term.name == "start" || term.name == "end");
        for (Term& inner : term.terms) {
            if (names_phase && inner.operation == Operation::words) continue;
            if (!check(inner)) return false;
            term.over_time = term.over_time || inner.over_time;
        }
        switch (term.operation) {
            case Operation::number:
                return true;
            case Operation::words:
                return fail(term, concat({"found ", quote(term.name),
                                          ", expected the name of a phase only in start(\"...\") and end(\"...\")"}));
            case Operation::name:
                return name(term);
            case Operation::call:
                return call(term);
            case Operation::negate:
                term.dimension = term.terms[0].dimension;
                return number(term.terms[0]);
            case Operation::invert:
            case Operation::both:
            case Operation::either:
                term.condition = true;
                return std::all_of(term.terms.begin(), term.terms.end(), [&](Term& t) { return condition(t); });
            default:
                return numbers(term);
        }
    }

    bool fail(const Term& term, std::string text) {
        fault_ = {term.at, std::move(text)};
        return false;
    }

    bool condition(const Term& term) {
        if (term.condition) return true;
        return fail(term,
                    concat({"found ", kindOf(term.dimension), ", expected a condition; compare it with a value"}));
    }

    bool number(const Term& term) {
        if (!term.condition) return true;
        return fail(term, "found a condition, expected a number; use duration(...), time_of(...) or count(...)");
    }

private:
    // Two numbers: a sum and a comparison want one unit, a product takes any.
    bool numbers(Term& term) {
        Term &left = term.terms[0], &right = term.terms[1];
        if (!number(left) || !number(right)) return false;
        switch (term.operation) {
            case Operation::multiply:
            case Operation::divide: {
                const int sign = term.operation == Operation::multiply ? 1 : -1;
                for (std::size_t i = 0; i < term.dimension.size(); ++i)
                    term.dimension[i] = left.dimension[i] + sign * right.dimension[i];
                return true;
            }
            case Operation::power:
                return power(term);
            case Operation::add:
            case Operation::subtract:
                term.dimension = isZero(left) ? right.dimension : left.dimension;
                return same(term, left, right, "added to");
            default:
                term.condition = true;
                return same(term, left, right, "compared with");
        }
    }

    bool same(const Term& term, const Term& left, const Term& right, std::string_view what) {
        if (isZero(left) || isZero(right) || fits(left.dimension, right.dimension)) return true;
        const bool bare = right.operation == Operation::number && right.dimension == kPure;
        return fail(term, concat({"found ", kindOf(right.dimension), " ", what, " ", kindOf(left.dimension),
                                  bare ? "; write the unit after the number" : "; correct one of the two"}));
    }

    bool power(Term& term) {
        const Term &base = term.terms[0], &exponent = term.terms[1];
        if (!fits(exponent.dimension, kPure))
            return fail(exponent, concat({"found ", kindOf(exponent.dimension), " as an exponent, expected a number"}));
        if (fits(base.dimension, kPure)) return true;
        const double n = exponent.number;
        if (exponent.operation != Operation::number || n != std::round(n) || std::abs(n) > kLargestExponent) {
            return fail(exponent, concat({"found an exponent of ", kindOf(base.dimension),
                                          " that is not a whole number from 0 to 4; use sqrt(...) or another one"}));
        }
        for (std::size_t i = 0; i < term.dimension.size(); ++i)
            term.dimension[i] = base.dimension[i] * static_cast<int>(n);
        return true;
    }

    bool name(Term& term) {
        const bool parameter = term.name.starts_with("vehicle.") || term.name.starts_with("scenario.");
        const std::vector<KnownName>& all = parameter ? known_.parameters : known_.channels;
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const KnownName& one) { return one.name == term.name; });
        term.over_time = !parameter;
        if (parameter && known_.at_one_moment)
            return fail(term, "found a parameter in a condition of a phase, expected channels and numbers");
        if (found == all.end()) {
            std::vector<std::string_view> names;
            for (const KnownName& one : all) names.push_back(one.name);
            if (!parameter) {
                for (const FunctionAbout& about : functions()) names.push_back(about.name);
            }
            const std::string meant = didYouMean(term.name, names);
            const std::string list =
                parameter ? "; `tread describe vehicle` and `tread describe scenario` list the parameters"
                          : "; `tread describe log` lists the channels";
            return fail(term, concat({"found ", quote(term.name), ", which is not a ",
                                      parameter ? "parameter of the run" : "channel", meant.empty() ? list : meant}));
        }
        std::string why;
        if (const auto unit = parseUnit(found->unit, why)) term.dimension = unit->dimension;
        return true;
    }

    bool call(Term& term) {
        const FunctionAbout* about = functionNamed(term.name);
        if (!about) {
            std::vector<std::string_view> names;
            for (const FunctionAbout& one : functions()) names.push_back(one.name);
            const std::string meant = didYouMean(term.name, names);
            return fail(term, concat({"found ", quote(term.name + "("), ", which is not a function",
                                      meant.empty() ? "; `tread describe expressions` lists them" : meant}));
        }
        const std::size_t count = term.terms.size();
        if (count < about->least || count > about->most) {
            return fail(term, concat({"found ", std::to_string(count), " arguments of ", about->name, ", expected ",
                                      callOf(*about)}));
        }
        const bool whole_log = about->reduces || about->unit == UnitOf::time || about->function == Function::smoothed;
        if (whole_log && known_.at_one_moment) {
            return fail(term, concat({"found ", about->name,
                                      "(...), which needs a whole log, expected what a phase knows at one moment: "
                                      "channels, rate(...), abs(...)"}));
        }
        return arguments(term, *about) && unit(term, *about);
    }

    bool arguments(Term& term, const FunctionAbout& about) {
        if (about.function == Function::start || about.function == Function::end) return true;
        for (std::size_t i = 0; i < term.terms.size(); ++i) {
            const Term& argument = term.terms[i];
            const bool wants_time = i + about.times >= about.most;
            if (about.of_condition && i == 0 ? !condition(argument) : !number(argument)) return false;
            if (!wants_time) continue;
            if (argument.over_time)
                return fail(argument,
                            "found values over time, expected one time; use time_of(...), start(...) or a "
                            "number in s");
            if (!fits(argument.dimension, kTime) && !isZero(argument))
                return fail(argument, concat({"found ", kindOf(argument.dimension),
                                              ", expected a time; write a unit, "
                                              "e.g. 2 s"}));
        }
        if (about.reduces) term.over_time = false;
        return true;
    }

    bool unit(Term& term, const FunctionAbout& about) {
        const Dimension first = term.terms.empty() ? kPure : term.terms[0].dimension;
        if (about.most == 2 && about.times == 0 && !same(term, term.terms[0], term.terms[1], "beside")) return false;
        term.dimension = first;
        switch (about.unit) {
            case UnitOf::same:
                break;
            case UnitOf::pure:
            case UnitOf::angle:
                term.dimension = about.unit == UnitOf::angle ? kAngle : kPure;
                if (about.function == Function::sign || about.most == 2 || about.of_condition || fits(first, kPure))
                    break;
                return fail(term.terms[0], concat({"found ", kindOf(first), ", expected ",
                                                   about.unit == UnitOf::angle ? "a pure number" : "an angle"}));
            case UnitOf::root:
                term.dimension[kRadian] = 0;
                for (int& exponent : term.dimension) {
                    if (exponent % 2 != 0)
                        return fail(term, concat({"found the square root of ", kindOf(first),
                                                  ", which has no unit; square something first"}));
                    exponent /= 2;
                }
                break;
            case UnitOf::over_time:
                term.dimension[kSecond] -= 1;
                break;
            case UnitOf::times_time:
                term.dimension[kSecond] += 1;
                break;
            case UnitOf::time:
                term.dimension = kTime;
                if (about.function == Function::start || about.function == Function::end) return phase(term);
        }
        return true;
    }

    bool phase(const Term& term) {
        if (term.terms.empty()) return true;
        const Term& which = term.terms[0];
        const auto& phases = known_.phases;
        if (which.operation == Operation::number) {
            const bool there = which.number >= 1 && which.number <= static_cast<double>(phases.size());
            if ((there || known_.any_phase) && which.number == std::round(which.number)) return true;
            return fail(which, concat({"found the phase ", numberText(which.number), ", expected a number from 1 to ",
                                       std::to_string(phases.size())}));
        }
        if (known_.any_phase)
            return fail(which,
                        "found the name of a phase, but the scenario is not known; name it with --scenario, or "
                        "give the number of the phase");
        if (std::find(phases.begin(), phases.end(), which.name) != phases.end()) return true;
        std::vector<std::string_view> names(phases.begin(), phases.end());
        std::erase(names, "");
        return fail(which, concat({"found ", quote(which.name), ", which is not a phase of the scenario",
                                   didYouMean(which.name, names), names.empty() ? "; give its number" : ""}));
    }

    const KnownNames& known_;
    ExpressionFault& fault_;
};

}  // namespace

bool checkTerm(Term& term, const KnownNames& known, ExpressionFault& fault) {
    return Checker(known, fault).check(term);
}

bool checkCondition(Term& term, const KnownNames& known, ExpressionFault& fault) {
    Checker checker(known, fault);
    return checker.check(term) && checker.condition(term);
}

bool checkMetric(Term& term, std::string_view unit, const KnownNames& known, ExpressionFault& fault) {
    Checker checker(known, fault);
    if (!checker.check(term)) return false;
    if (term.over_time) {
        return checker.fail(term,
                            "found values over time, expected one number; put them into max(...), mean(...) or "
                            "at(..., time)");
    }
    std::string why;
    const auto stated = parseUnit(unit, why);
    const Dimension wanted = stated ? stated->dimension : kPure;
    const bool bare_angle = wanted == kPure && term.dimension == kAngle;
    if (isZero(term) || (fits(term.dimension, wanted) && !bare_angle)) return true;
    return checker.fail(term, concat({"found ", kindOf(term.dimension), ", but the metric states the unit ",
                                      quote(unit), "; correct the expression or the unit"}));
}

}  // namespace tread
