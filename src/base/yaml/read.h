// Reading described structs from YAML: strict, every fault of a file and of what it includes in one exception.
//
//     const auto tyre = readYaml<TyreParams>("vehicles/tyres/car_205_60R15.yaml");
//
// A bare number is SI; "1480 mm" or 4.5 deg are converted to the described unit. A key that is absent leaves the
// default; a number without default must be given. A struct may have
//   static void check(const auto& self, auto&& complain);
//       rules across fields: complain("bump", "found ..., expected ..."); a complaint that names a field which is
//       faulty itself does not count, so a rule names the fields that it compares
//   static constexpr bool kIncludable = true;
//       the name of a file, relative to the including one, may stand for the struct
// and, declared beside its definition so that every reader of the type sees it,
//   bool readForeign(T&, const std::filesystem::path&, std::vector<Problem>&);
//       is asked first for every file; true when it took the file (".tir")
#pragma once

#include <array>
#include <concepts>
#include <filesystem>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "base/fields/visitors.h"
#include "base/yaml/fields.h"
#include "base/yaml/reader.h"

namespace tread {
namespace detail {

struct IgnoreComplaint {
    void operator()(std::string_view, const std::string&) const {}
};

template <class T>
concept Checked = requires(const T& object) {
    T::check(object, IgnoreComplaint{});
};

template <class T>
constexpr bool isIncludable() {
    if constexpr (requires { T::kIncludable; }) return T::kIncludable;
    return false;
}

template <class T>
concept HasForeignFiles = requires(T& object, const std::filesystem::path& file, std::vector<Problem>& problems) {
    { readForeign(object, file, problems) } -> std::convertible_to<bool>;
};

template <class T>
void FieldsOf<T>::read(const YamlReader& reader, const YamlPlace& place, T& object) {
    const std::size_t faults_before = reader.faults();
    YamlFields fields(reader, place);
    if (!fields.readable()) return;
    T::describe(object,
                [&](std::string_view name, const auto&, const About& about) { fields.know(name, about.old_name); });
    fields.rejectUnknown();
    T::describe(object, [&](std::string_view name, auto& value, const About& about) {
        readValue(reader, fields.find(name), value, about);
    });
    if constexpr (Checked<T>) {
        const std::vector<std::string> faulty = reader.faultyNames(faults_before, place.path);
        T::check(std::as_const(object), [&](std::string_view field, std::string text) {
            if (!namesAny(faulty, field, text)) fields.complain(field, std::move(text));
        });
    }
}

// The same for a struct that the file may not give at all: then what it requires is one fault.
template <Described T>
void readPart(const YamlReader& reader, const YamlPlace& place, T& object) {
    const std::size_t faults_before = reader.faults();
    FieldsOf<T>::read(reader, place, object);
    if (!place.node) reader.gatherMissing(place, faults_before);
}

// Whether an included file is of another kind altogether: most of its keys are none of the fields.
template <Described T>
bool isAnotherKind(const YamlReader& reader, const YamlPlace& place, const YamlDocument& document, const T& object) {
    if (!place.node) return false;
    std::vector<std::string_view> names;
    T::describe(object, [&](std::string_view name, const auto&, const About&) { names.push_back(name); });
    return reader.rejectsKind(place, document, names);
}

// Looks once more at an object that was filled by other means than YAML: what is missing or beyond its limits?
template <Described T>
void readNothing(YamlSession& session, const std::string& source, const std::string& path, T& object) {
    const YamlDocument nothing{source, {}};
    const YamlReader reader(session, nothing);
    const bool before = std::exchange(session.check_absent, true);
    FieldsOf<T>::read(reader, reader.root(path), object);
    session.check_absent = before;
}

// Reads a file, YAML or foreign, into an object with its defaults; `place` is where the file was named.
template <Described T>
void readFile(const YamlReader& reader, const YamlPlace& place, const std::filesystem::path& file, T& object) {
    YamlSession& session = reader.session();
    const OpenFile open(session, file);
    if constexpr (HasForeignFiles<T>) {
        const std::size_t faults_before = reader.faults();
        if (readForeign(object, file, session.problems)) {
            if (reader.faults() == faults_before) readNothing(session, file.string(), place.path, object);
            return;
        }
    }
    const auto document = openYaml(reader, place, file);
    if (!document || isAnotherKind(reader, place, *document, object)) return;
    const YamlReader inner(session, *document);
    FieldsOf<T>::read(inner, inner.root(place.path), object);
}

template <class T>
void readList(const YamlReader& reader, const YamlPlace& place, std::vector<T>& list, const About& about) {
    if (const auto places = reader.elements(place)) {
        list = std::vector<T>(places->size());
        for (std::size_t i = 0; i < list.size(); ++i) readValue(reader, (*places)[i], list[i], about);
    } else if (!place.node) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            readValue(reader, {nullptr, place.line, place.column, joinPath(place.path, std::to_string(i))}, list[i],
                      about);
        }
    }
}

template <class... T>
void readVariant(const YamlReader& reader, const YamlPlace& place, std::variant<T...>& variant) {
    constexpr std::array<std::string_view, sizeof...(T)> kNames{T::kName...};
    if (const auto given = reader.alternative(place, kNames)) {
        const auto tryOne = [&]<class Alternative>(std::size_t index, std::type_identity<Alternative>) {
            if (index == given->index) readPart(reader, given->place, variant.template emplace<Alternative>());
        };
        std::size_t index = 0;
        (tryOne(index++, std::type_identity<T>{}), ...);
    } else if (!place.node) {
        const YamlPlace inner{nullptr, place.line, place.column, joinPath(place.path, kNames[variant.index()])};
        std::visit([&]<class Alternative>(
                       Alternative& alternative) { FieldsOf<Alternative>::read(reader, inner, alternative); },
                   variant);
    }
}

template <class T>
void readValue(const YamlReader& reader, const YamlPlace& place, T& value, const About& about) {
    if constexpr (std::is_same_v<T, double>) {
        reader.number(place, about, value);
    } else if constexpr (std::is_same_v<T, int>) {
        reader.wholeNumber(place, about, value);
    } else if constexpr (std::is_same_v<T, bool>) {
        reader.yesNo(place, value);
    } else if constexpr (std::is_same_v<T, std::string>) {
        reader.text(place, value);
    } else if constexpr (std::is_same_v<T, Curve>) {
        reader.curve(place, about, value);
    } else if constexpr (DescribedEnum<T>) {
        constexpr auto kNames = enumNames(T{});
        if (const auto index = reader.choice(place, kNames)) value = static_cast<T>(*index);
    } else if constexpr (IsVector<T>::value) {
        readList(reader, place, value, about);
    } else if constexpr (IsVariant<T>::value) {
        readVariant(reader, place, value);
    } else if constexpr (IsOptional<T>::value) {
        if (place.node) value.emplace();
        if (value) readValue(reader, place, *value, about);
    } else {
        static_assert(Described<T>, "a field of this type cannot be read");
        if constexpr (isIncludable<T>()) {
            if (place.node && place.node->kind == YamlNode::Kind::scalar) {
                const auto file = reader.include(place);
                value = T{};
                if (file) readFile(reader, place, *file, value);
                return;
            }
        }
        readPart(reader, place, value);
    }
}

}  // namespace detail

// The object that a file describes, as far as the file is sound; its faults and those of the files that it includes are
// added to `problems`. For readers that look for further faults: they throw (throwIfAny) when they have them all.
template <Described T>
T readYaml(const std::filesystem::path& file, std::vector<Problem>& problems) {
    YamlSession session;
    const YamlDocument nothing{file.string(), {}};
    T object{};
    detail::readFile(YamlReader(session, nothing), {}, file, object);
    problems.insert(problems.end(), session.problems.begin(), session.problems.end());
    return object;
}

// The object that a file describes. Throws LoadError with every fault of the file and of the files that it includes.
template <Described T>
T readYaml(const std::filesystem::path& file) {
    std::vector<Problem> problems;
    T object = readYaml<T>(file, problems);
    throwIfAny(std::move(problems));
    return object;
}

// The same for a text, as if it stood in a file of that name.
template <Described T>
T readYamlText(std::string_view text, const std::string& file) {
    YamlSession session;
    const OpenFile open(session, file);
    T object{};
    if (const auto document = parseYaml(text, file, session.problems)) {
        const YamlReader reader(session, *document);
        detail::FieldsOf<T>::read(reader, reader.root(""), object);
    }
    throwIfAny(std::move(session.problems));
    return object;
}

}  // namespace tread
