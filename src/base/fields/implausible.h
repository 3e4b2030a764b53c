// Numbers that a described object may have and yet hardly should: outside the plausible values of their description.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "base/fields/field_path.h"
#include "base/fields/visitors.h"
#include "tread/curve.h"
#include "tread/describe.h"

namespace tread {

struct Implausible {
    std::string path;                 // "front.suspension.spring"
    std::vector<std::string> places;  // where a file may say it: with indices in place of x and y, with old names
    double value = 0;                 // SI
    std::string unit;
    Usual usual;
    std::string why = {};  // the reason for the plausible values, where it is not the field alone
};

// "found 550 m, expected 0.02 to 3 m for any car; did you mean "550 mm"?" `written` is how a file or an option says it;
// empty when that is not known.
std::string implausibleText(const Implausible& number, std::string_view written);

// "0.02 to 3", "0 to 1"; empty when nothing is said or every value is plausible.
std::string usualText(const Usual& usual);

namespace detail {

// Ways to a field: as described, and as files of the time before a field was renamed spell it.
struct Way {
    std::string path;
    std::vector<std::string> places;

    Way to(std::string_view name, std::string_view old_name = {}) const;
    Way at(std::size_t index) const { return to(std::to_string(index)); }
};

struct Judge {
    std::vector<Implausible> found;

    void number(double value, const Way& way, std::string_view unit, const Usual& usual);
    void curve(const Curve& curve, const Way& way, const About& about);

    template <class T>
    void value(const T& value, const Way& way, const About& about) {
        if constexpr (std::is_same_v<T, double> || std::is_same_v<T, int>) {
            number(static_cast<double>(value), way, about.unit, about.usual);
        } else if constexpr (std::is_same_v<T, Curve>) {
            curve(value, way, about);
        } else if constexpr (Described<T>) {
            FieldsOf<T>::judge(*this, value, way);
        } else if constexpr (IsOptional<T>::value) {
            if (value) this->value(*value, way, about);
        } else if constexpr (IsVector<T>::value) {
            for (std::size_t i = 0; i < value.size(); ++i) this->value(value[i], way.at(i), about);
        } else if constexpr (IsVariant<T>::value) {
            std::visit(
                [&](const auto& alternative) {
                    using Alternative = std::remove_cvref_t<decltype(alternative)>;
                    FieldsOf<Alternative>::judge(*this, alternative, way.to(Alternative::kName));
                },
                value);
        }
    }
};

template <class T>
void FieldsOf<T>::judge(Judge& judge, const T& object, const Way& way) {
    T::describe(object, [&](std::string_view name, const auto& field, const About& about) {
        judge.value(field, way.to(name, about.old_name), about);
    });
}

}  // namespace detail

// All of them, in the order of the description; of a curve the first point that is one.
template <Described T>
std::vector<Implausible> implausible(const T& object) {
    detail::Judge judge;
    detail::FieldsOf<T>::judge(judge, object, {"", {""}});
    return std::move(judge.found);
}

}  // namespace tread
