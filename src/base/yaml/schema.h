// JSON Schema (draft 7) of a described type, so that editors complete and check its YAML files.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <typeindex>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "base/fields/field_path.h"
#include "base/fields/numbers.h"
#include "base/yaml/read.h"
#include "tread/curve.h"
#include "tread/describe.h"

namespace tread {
namespace detail {

// One property of an object in the schema.
struct SchemaProperty {
    std::string name;
    std::string schema;  // JSON
    bool required;
};

// Collects the definitions; every function returns JSON text.
class SchemaBuilder {
public:
    std::string number(const About& about);
    std::string wholeNumber(const About& about) const;
    std::string curve(const About& about);
    std::string simple(std::string_view type, const About& about) const;
    std::string choice(std::span<const std::string_view> names, const About& about) const;
    std::string list(const std::string& element, const About& about) const;
    std::string oneOf(const std::vector<std::string>& schemas, const About& about) const;
    std::string object(const std::vector<SchemaProperty>& properties) const;
    std::string reference(const std::string& name, const About& about, bool includable) const;
    std::string alternative(std::string_view name, const std::string& schema) const;

    // The definition of a type: its name, and whether it has yet to be defined.
    std::pair<std::string, bool> definition(std::type_index type, const std::string& path);
    void define(const std::string& name, std::string schema) { definitions_.emplace_back(name, std::move(schema)); }

    std::string document(std::string_view title, std::string_view id, const std::string& root) const;

private:
    std::string numberOrQuantity(std::string_view unit, const Limits& limits);

    std::vector<std::pair<std::string, std::string>> quantities_;  // name and schema
    std::unordered_map<std::type_index, std::string> names_;
    std::vector<std::pair<std::string, std::string>> definitions_;
};

// Whether a file must give this value: a number without default, or something that holds one.
template <class T>
bool needsValue(const T& value) {
    if constexpr (std::is_same_v<T, double>) {
        return value != value;
    } else if constexpr (Described<T>) {
        bool needs = false;
        T::describe(value,
                    [&](std::string_view, const auto& field, const About&) { needs = needs || needsValue(field); });
        return needs;
    } else if constexpr (IsVariant<T>::value) {
        return std::visit([](const auto& alternative) { return needsValue(alternative); }, value);
    } else {
        return false;
    }
}

template <class T>
std::string schemaOf(SchemaBuilder& builder, const std::string& path, const T& value, const About& about);

template <Described T>
std::string objectSchema(SchemaBuilder& builder, const std::string& path, const T& object) {
    std::vector<SchemaProperty> properties;
    T::describe(object, [&](std::string_view name, const auto& value, const About& about) {
        properties.push_back(
            {std::string(name), schemaOf(builder, joinPath(path, name), value, about), needsValue(value)});
    });
    return builder.object(properties);
}

template <Described T>
std::string referenceSchema(SchemaBuilder& builder, const std::string& path, const About& about) {
    const auto [name, is_new] = builder.definition(typeid(T), path);
    if (is_new) builder.define(name, objectSchema(builder, path, T{}));
    return builder.reference(name, about, isIncludable<T>());
}

// {name: {...}}, or the bare name of an alternative without required fields.
template <class... T>
std::string variantSchema(SchemaBuilder& builder, const std::string& path, const std::variant<T...>&,
                          const About& about) {
    std::vector<std::string_view> bare;
    ((needsValue(T{}) || (bare.push_back(T::kName), true)), ...);
    std::vector<std::string> schemas;
    if (!bare.empty()) schemas.push_back(builder.choice(bare, About{}));
    (schemas.push_back(builder.alternative(T::kName, referenceSchema<T>(builder, joinPath(path, T::kName), About{}))),
     ...);
    return builder.oneOf(schemas, about);
}

template <class T>
std::string schemaOf(SchemaBuilder& builder, const std::string& path, const T& value, const About& about) {
    if constexpr (std::is_same_v<T, double>) {
        return builder.number(about);
    } else if constexpr (std::is_same_v<T, int>) {
        return builder.wholeNumber(about);
    } else if constexpr (std::is_same_v<T, bool>) {
        return builder.simple("boolean", about);
    } else if constexpr (std::is_same_v<T, std::string>) {
        return builder.simple("string", about);
    } else if constexpr (std::is_same_v<T, Curve>) {
        return builder.curve(about);
    } else if constexpr (DescribedEnum<T>) {
        constexpr auto kNames = enumNames(T{});
        return builder.choice(kNames, about);
    } else if constexpr (IsVector<T>::value) {
        const About element{about.unit, "", about.limits, 0, about.argument};
        return builder.list(schemaOf(builder, path, typename T::value_type{}, element), about);
    } else if constexpr (IsVariant<T>::value) {
        return variantSchema(builder, path, value, about);
    } else if constexpr (IsOptional<T>::value) {
        return schemaOf(builder, path, typename T::value_type{}, about);
    } else {
        return referenceSchema<T>(builder, path, about);
    }
}

}  // namespace detail

// `id` is the address under which the schema can be found.
template <Described T>
std::string jsonSchema(std::string_view title, std::string_view id) {
    detail::SchemaBuilder builder;
    const std::string root = detail::objectSchema(builder, "", T{});
    return builder.document(title, id, root);
}

}  // namespace tread
