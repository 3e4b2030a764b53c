#include "campaign/subject.h"

#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include "base/yaml/setting.h"
#include "campaign/draws.h"

namespace tread::campaign {
namespace {

template <class Field>
constexpr bool holdsNumber() {
    return std::is_same_v<Field, double> || std::is_same_v<Field, std::optional<double>>;
}

template <class T, class Visit>
void visitSeeds(T& value, const Visit& visit) {
    if constexpr (Described<T>) {
        T::describe(value, [&](std::string_view name, auto& field, const About&) {
            using Field = std::remove_reference_t<decltype(field)>;
            if constexpr (std::is_same_v<Field, int> || std::is_same_v<Field, double>) {
                if (name == "seed") visit(field);
            } else {
                visitSeeds(field, visit);
            }
        });
    } else if constexpr (detail::IsVector<T>::value) {
        for (auto& element : value) visitSeeds(element, visit);
    } else if constexpr (detail::IsVariant<T>::value) {
        std::visit([&](auto& alternative) { visitSeeds(alternative, visit); }, value);
    } else if constexpr (detail::IsOptional<T>::value) {
        if (value) visitSeeds(*value, visit);
    }
}

}  // namespace

FieldFound fieldAt(Subject& subject, const std::string& path, const double* set) {
    FieldFound found;
    const auto visit = [&](auto& field, const About& about, const std::string&) {
        found.exists = true;
        found.about = about;
        if constexpr (holdsNumber<std::remove_reference_t<decltype(field)>>()) {
            found.is_number = true;
            if (set) field = *set;
            if constexpr (requires { *field; }) found.value = field ? *field : found.value;
            else found.value = field;
        }
    };
    detail::visitField(subject, path, About{"", ""}, visit);
    return found;
}

void setFields(Subject& subject, std::span<const std::string> assignments, const std::string& where) {
    applySettings(subject, assignments, where, listingOf);
}

void setFields(VehicleParams& vehicle, std::span<const std::string> assignments, const std::string& where) {
    applySettings(vehicle, assignments, where, listingOf);
}

void expectSound(Subject& subject, const std::string& where) {
    YamlSession session;
    detail::readNothing(session, where, "", subject);
    throwIfAny(std::move(session.problems));
}

std::string listingOf(std::string_view path) {
    if (path.starts_with("scenario")) return "`tread describe scenario` lists all paths after \"scenario.\"";
    return "`tread describe vehicle` lists all paths";
}

std::string unknownPath(const std::string& path) {
    return detail::unknownPathText(path, referenceTable<Subject>(), listingOf);
}

int seedsIn(const Scenario& scenario) {
    Scenario copy = scenario;
    int seeds = 0;
    visitSeeds(copy, [&](auto&) { ++seeds; });
    return seeds;
}

void reseed(Scenario& scenario, std::uint64_t seed, std::uint64_t repetition) {
    constexpr std::uint64_t kBelow = 1'000'000'007;  // a whole number that int and double hold
    std::uint64_t which = 0;
    visitSeeds(scenario, [&](auto& one) {
        const std::uint64_t hash = hashOf(seed + ++which, repetition, static_cast<std::uint64_t>(one));
        one = static_cast<std::remove_reference_t<decltype(one)>>(hash % kBelow);
    });
}

}  // namespace tread::campaign
