// Single fields set by path, as with `--set front.damper.bump=1800`. The value is what could stand in a file: a number
// with or without unit, a word, [[x, y], [x, y]], {key: value}.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
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

// Gives the field of a setting its value, and complains about a field that an earlier setting has given.
class ReadSetting {
public:
    // `given`: paths of the fields that have a value by now, each as its setting spells it.
    ReadSetting(const YamlReader& reader, const YamlPlace& place, std::map<std::string, std::string>& given)
        : reader_(reader), place_(place), given_(given) {}

    template <class T>
    void operator()(T& field, const About& about, const std::string& path) const {
        if (isFirstOf(path)) readValue(reader_, place_, field, about);
    }

private:
    bool isFirstOf(const std::string& path) const;

    const YamlReader& reader_;
    const YamlPlace& place_;
    std::map<std::string, std::string>& given_;
};

template <class T, class Visit>
bool visitFieldOf(T& object, std::string_view path, const Visit& visit, const std::string& walked);

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
        if constexpr (std::is_same_v<Visit, ReadSetting>) found = FieldsOf<T>::set(value, path, visit, walked);
        else found = visitFieldOf(value, path, visit, walked);
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

// The same for a described struct and a path that is not empty.
template <class T, class Visit>
bool visitFieldOf(T& object, std::string_view path, const Visit& visit, const std::string& walked) {
    bool found = false;
    const std::string_view name = takeName(path);
    T::describe(object, [&](std::string_view field, auto& inner, const About& about) {
        if (field != name && (about.old_name.empty() || about.old_name != name)) return;
        found = visitField(inner, path, about, visit, joinPath(walked, field));
    });
    return found;
}

template <class T>
bool FieldsOf<T>::set(T& object, std::string_view path, const ReadSetting& read, const std::string& walked) {
    return visitFieldOf(object, path, read, walked);
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
        const detail::ReadSetting read(reader, place, given);
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
