#include "fmu/variables.h"

#include <cmath>
#include <span>

#include "base/fields/field_path.h"
#include "base/fields/numbers.h"
#include "base/text/concat.h"
#include "host/channels.h"
#include "host/snapshot.h"
#include "host/version.h"
#include "vehicle/fields.h"

namespace tread::fmu {
namespace {

// Structured names have an index in brackets where a path has it behind a dot.
std::string structuredName(std::string_view path) {
    std::string name;
    while (!path.empty()) {
        const std::string_view part = takeName(path);
        const bool index = part.find_first_not_of("0123456789") == std::string_view::npos;
        if (index) name += concat({"[", part, "]"});
        else name += concat({name.empty() ? "" : ".", part});
    }
    return name;
}

// "front left wheel: " of "ground.front_left.height"
std::string wheelOf(std::string_view path) {
    PerWheel<double> wheels;
    std::string found;
    PerWheel<double>::describe(wheels, [&](std::string_view name, const double&, const About& about) {
        if (path.find(concat({".", name, "."})) != std::string_view::npos) found = concat({about.meaning, ": "});
    });
    return found;
}

class List {
public:
    template <Described T>
    void add(T& object, const std::string& prefix, Role role) {
        for (const Number& n : numbers(object, prefix)) {
            if (!std::isfinite(*n.value)) continue;
            all.push_back({structuredName(n.path), role, std::string(n.about.unit),
                           concat({wheelOf(n.path), n.about.meaning}), n.about.limits, n.value, nullptr});
        }
    }
    void addFlags(Settings& object, const std::string& prefix) {
        Settings::describe(object, [&](std::string_view name, auto& value, const About& about) {
            if constexpr (std::is_same_v<decltype(value), bool&>)
                all.push_back(
                    {joinPath(prefix, name), Role::parameter, "", std::string(about.meaning), kAny, nullptr, &value});
        });
    }

    std::vector<Variable> all;
};

std::string hexadecimal(std::uint64_t number) {
    std::string digits(16, '0');
    for (std::size_t i = 0; i < digits.size(); ++i) digits[i] = "0123456789abcdef"[(number >> (60 - 4 * i)) & 15];
    return digits;
}

}  // namespace

std::vector<Variable> variablesOf(Values& values) {
    List list;
    list.all.push_back({"time", Role::independent, "s", "time", kAny, &values.time, nullptr});
    list.add(values.inputs, "", Role::input);
    list.add(values.parameters.start, "start", Role::parameter);
    list.add(values.parameters.settings, "settings", Role::parameter);
    list.addFlags(values.parameters.settings, "settings");
    list.add(values.parameters.car, "car", Role::parameter);
    list.add(values.found, "found", Role::calculated);
    list.add(values.outputs, "", Role::output);
    list.add(values.wheel_centre, "wheel_centre", Role::output);
    return std::move(list.all);
}

std::string tokenOf(std::string_view car_text, std::string_view fmi_version) {
    constexpr std::string_view kMeaning = "1";  // counts up when the variables change and the version does not
    const std::string all = concat({fmi_version, "\n", host::version(), "\n", kMeaning, "\n", car_text});
    const auto bytes = std::as_bytes(std::span(all));
    const std::string digits =
        hexadecimal(host::hashOf(bytes)) + hexadecimal(host::hashOf(bytes, host::hashOf(bytes) | 1));
    return concat({"{", digits.substr(0, 8), "-", digits.substr(8, 4), "-", digits.substr(12, 4), "-",
                   digits.substr(16, 4), "-", digits.substr(20), "}"});
}

}  // namespace tread::fmu
