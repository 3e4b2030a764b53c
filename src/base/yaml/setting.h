// Single fields set by path, as with `--set front.damper.bump=1800`. The value is what could stand in a file: a number
// with or without unit, a word, [[x, y], [x, y]], {key: value}.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/fields/field_path.h"
#include "base/fields/reference_table.h"
#include "base/yaml/read.h"

namespace tread {

// Says in a clause where the fields around a path are listed, for whoever gave a path that does not exist.
using PathListing = std::string (*)(std::string_view path);

namespace detail {

struct Setting {
    std::string path;
    YamlDocument value;
};

// "path=value", its value as a document; complains as `what` when it cannot be taken apart.
std::optional<Setting> parseSetting(std::string_view assignment, std::string_view what, PathListing listing,
                                    std::vector<Problem>& problems);

// Index of an element; `size` when the name is not one.
std::size_t elementIndex(std::string_view name, std::size_t size);

// The last names of the paths of faults.
std::vector<std::string> lastNames(const std::vector<Problem>& problems);

std::string unknownPathText(const std::string& path, const std::vector<ReferenceRow>& known, PathListing listing);

// Calls `visit(field, about, its path)` for the field at the path; false when there is none. The path may have old
// names, the one that is visited has not; `walked` is what lies before `value`.
template <class T, class Visit>
bool visitField(T& value, std::string_view path, const About& about, const Visit& visit,
                const std::string& walked = {}) {
    if (path.empty()) {
        visit(value, about, walked);
        return true;
    }
    bool found = false;
    if constexpr (Described<T>) {
        const std::string_view name = takeName(path);
        T::describe(value, [&](std::string_view field, auto& inner, const About& inner_about) {
            if (field != name && (inner_about.old_name.empty() || inner_about.old_name != name)) return;
            found = visitField(inner, path, inner_about, visit, joinPath(walked, field));
        });
    } else if constexpr (IsVector<T>::value) {
        const std::string_view name = takeName(path);
        const std::size_t index = elementIndex(name, value.size());
        if (index < value.size()) found = visitField(value[index], path, about, visit, joinPath(walked, name));
    } else if constexpr (IsVariant<T>::value) {
        const std::string_view name = takeName(path);
        std::visit(
            [&](auto& inner) {
                if (inner.kName == name) found = visitField(inner, path, about, visit, joinPath(walked, name));
            },
            value);
    } else if constexpr (IsOptional<T>::value) {
        auto inner = value ? *value : typename T::value_type{};
        found = visitField(inner, path, about, visit, walked);
        if (found) value = std::move(inner);
    }
    return found;
}

}  // namespace detail

// Sets fields one after the other, then looks at the whole object again: rules across fields see all new values. A rule
// that is broken does not count when a setting of a field that it names is faulty.
// Throws LoadError, naming `what` ("--set") in place of a file, and then leaves the object as it was.
template <Described T>
void applySettings(T& object, std::span<const std::string> assignments, std::string_view what, PathListing listing) {
    YamlSession session;
    T changed = object;
    std::map<std::string, std::string> given;  // path of a field: as it was spelt
    for (const std::string& assignment : assignments) {
        const auto setting = detail::parseSetting(assignment, what, listing, session.problems);
        if (!setting) continue;
        const YamlReader reader(session, setting->value);
        const YamlPlace place = reader.root(setting->path);
        const auto read = [&](auto& field, const About& about, const std::string& path) {
            const auto& [present, spelt] = *given.emplace(path, setting->path).first;
            if (spelt != setting->path)
                return reader.complain(place, sameFieldTwice(spelt == present ? setting->path : spelt, present));
            detail::readValue(reader, place, field, about);
        };
        const bool found = detail::visitField(changed, setting->path, About{}, read);
        if (!found) reader.complain(place, detail::unknownPathText(setting->path, referenceTable<T>(), listing));
    }
    // An object that was incomplete before may remain so.
    const auto gapsOf = [&](T copy) {
        YamlSession check;
        detail::readNothing(check, std::string(what), "", copy);
        return std::move(check.problems);
    };
    std::vector<Problem> gaps = gapsOf(changed);
    const std::vector<Problem> before = gapsOf(object);
    const std::vector<std::string> faulty = detail::lastNames(session.problems);
    std::erase_if(gaps, [&](const Problem& gap) {
        return std::find(before.begin(), before.end(), gap) != before.end() ||
               namesAny(faulty, lastName(gap.path), gap.text);
    });
    session.problems.insert(session.problems.end(), gaps.begin(), gaps.end());
    throwIfAny(std::move(session.problems));
    object = std::move(changed);
}

}  // namespace tread
