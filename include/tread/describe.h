// One description per struct.
//
// A struct that a user can see names its fields once, in `describe`; the YAML reader and writer, parameter paths, log
// columns, the JSON Schema and the reference tables are all visitors of that one list:
//
//     struct DamperParams {
//         double bump = kRequired;   // no default: the file must say
//         double friction = 0;       // default = neutral = effect absent
//
//         static constexpr void describe(auto& self, auto&& field) {
//             field(TREAD_FIELD(bump), About{"N s/m", "damping in compression", kNonNegative});
//             field(TREAD_FIELD(friction), About{"N", "dry friction", kNonNegative});
//         }
//     };
//     static_assert(describesEveryMember<DamperParams>());   // a forgotten member does not compile
//
// A field is a double, int, bool, std::string, enum (with `enumNames`), Curve, another described struct, or a
// std::vector, std::optional or std::variant of these. The alternatives of a variant carry their name as `kName`.
#pragma once

#include "tread/cpp20.h"

#include <array>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#define TREAD_FIELD(name) #name, self.name

namespace tread {

// Marks a number without a default: the reader rejects a file that does not give it.
inline constexpr double kRequired = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The values a number may take; the ends belong to the range unless they are open.
struct Limits {
    double lowest = -kInfinity;
    double highest = kInfinity;
    bool lowest_open = false;
    bool highest_open = false;

    constexpr bool allow(double value) const {
        const bool above = lowest_open ? value > lowest : value >= lowest;
        const bool below = highest_open ? value < highest : value <= highest;
        return above && below;
    }
};
inline constexpr Limits kAny{};
inline constexpr Limits kPositive{0, kInfinity, true, true};
inline constexpr Limits kNonNegative{0, kInfinity, false, true};
inline constexpr Limits kFraction{0, 1};

// The values that a number has in cars of all kinds, from 1:10 models (3 kg) to trucks of 40 t: what lies outside is
// allowed and yet hardly meant, most often a slip of the unit. The ends are [guess] where no comment names a source:
// the numbers of the shipped cars and of the sources that their files quote, with room for what is larger, smaller,
// stiffer and softer. 0 is no slip of a unit: as a default it is the absence of an effect; infinity is the absence of a
// limit.
struct Usual {
    double lowest = -kInfinity;
    double highest = kInfinity;
    bool said = false;  // whether the description says it, be it that every value is usual

    constexpr bool has(double value) const {
        const bool infinite = value == kInfinity || value == -kInfinity;
        return value == 0 || infinite || !(value < lowest || value > highest);
    }
};

// What a user has to know about a field. The unit is the SI unit in which the program holds the value ("" for fields
// that are not numbers, "-" for pure numbers).
struct About {
    std::string_view unit;
    std::string_view meaning;
    Limits limits = kAny;
    double tolerance = 0;            // how well a real car's value is usually known, as a fraction of it (0: not said)
    std::string_view argument = {};  // for a Curve: SI unit of its argument
    std::string_view old_name = {};  // of a renamed field: files and settings that use it are still read
    Usual usual = {};                // plausible values
    Usual usual_argument = {};       // the same for the argument of a Curve

    // The description with plausible values; those of the argument; and with the statement that any value is as good
    // as another: a place on a map, a seed, a coefficient of a fit.
    constexpr About usually(const Usual& range) const {
        About copy = *this;
        copy.usual = range;
        return copy;
    }
    constexpr About usually(double from, double to) const { return usually(Usual{from, to, true}); }
    constexpr About over(double from, double to) const {
        About copy = *this;
        copy.usual_argument = {from, to, true};
        return copy;
    }
    constexpr About unjudged() const { return usually(Usual{.said = true}); }
};

template <class T>
concept Described = requires(T& object) {
    T::describe(object, [](auto&&...) {});
};

template <class T>
concept DescribedEnum = std::is_enum_v<T> && requires(T value) {
    enumNames(value);
};

// ---- Proof that a description is complete ----

namespace detail {

struct ConvertsToAnything {
    template <class T>
    operator T() const {
        std::abort();  // never called: only whether brace initialisers take it is asked
    }
};

// Whether the aggregate T has at least as many members as there are indices.
template <class T, std::size_t... I>
constexpr bool bracesTake(std::index_sequence<I...>) {
    return requires {
        T{((void)I, ConvertsToAnything{})...};
    };
}

// Room for a T that is never made: only compilers look at the places of its members.
template <class T>
union Unmade {
    char nothing;
    T value;
    constexpr ~Unmade() {}
};
#ifdef __clang__
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wundefined-var-template"
#pragma clang diagnostic ignored "-Wundefined-internal"
#endif
template <class T>
extern Unmade<T> unmade;  // not defined anywhere

template <class T>
constexpr std::size_t describedCount() {
    std::size_t count = 0;
    T::describe(unmade<T>.value, [&count](auto&&...) { ++count; });
    return count;
}
#ifdef __clang__
#pragma clang diagnostic pop
#endif

template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};
template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};
template <class T>
struct IsVariant : std::false_type {};
template <class... T>
struct IsVariant<std::variant<T...>> : std::true_type {};

}  // namespace detail

// True when `T::describe` visits as many fields as `T` has members.
template <class T>
constexpr bool describesEveryMember() {
    constexpr std::size_t described = detail::describedCount<T>();
    return detail::bracesTake<T>(std::make_index_sequence<described>{}) &&
           !detail::bracesTake<T>(std::make_index_sequence<described + 1>{});
}

}  // namespace tread
