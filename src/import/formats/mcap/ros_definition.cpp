#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

#include "base/text/number_text.h"
#include "base/text/text_file.h"
#include "import/formats/foreign_text.h"
#include "import/formats/mcap/ros_message.h"

namespace tread {
namespace {

constexpr std::size_t kMostTypes = 1000, kMostFields = 10000;  // [guess] far more than any message has
constexpr std::size_t kDeepestType = 16;                       // types in types

// ROS has SI units (REP 103); the definitions of the messages say which.
struct KnownUnit {
    std::string_view type, field, unit;
};
constexpr KnownUnit kKnownUnits[] = {
    {"geometry_msgs/Twist", "linear", "m/s"},
    {"geometry_msgs/Twist", "angular", "rad/s"},
    {"geometry_msgs/Accel", "linear", "m/s2"},
    {"geometry_msgs/Pose", "position", "m"},
    {"sensor_msgs/Imu", "angular_velocity", "rad/s"},
    {"sensor_msgs/Imu", "linear_acceleration", "m/s2"},
    {"sensor_msgs/NavSatFix", "latitude", "deg"},
    {"sensor_msgs/NavSatFix", "longitude", "deg"},
    {"ackermann_msgs/AckermannDrive", "steering_angle", "rad"},
    {"ackermann_msgs/AckermannDrive", "steering_angle_velocity", "rad/s"},
    {"ackermann_msgs/AckermannDrive", "speed", "m/s"},
    {"ackermann_msgs/AckermannDrive", "acceleration", "m/s2"},
};

std::string_view knownUnit(std::string_view type, std::string_view field) {
    for (const KnownUnit& known : kKnownUnits) {
        if (known.type == type && known.field == field) return known.unit;
    }
    return {};
}

const std::map<std::string_view, RosPrimitive>& primitives() {
    static const std::map<std::string_view, RosPrimitive> list = {
        {"bool", RosPrimitive::boolean},    {"byte", RosPrimitive::uint8},    {"char", RosPrimitive::uint8},
        {"int8", RosPrimitive::int8},       {"uint8", RosPrimitive::uint8},   {"int16", RosPrimitive::int16},
        {"uint16", RosPrimitive::uint16},   {"int32", RosPrimitive::int32},   {"uint32", RosPrimitive::uint32},
        {"int64", RosPrimitive::int64},     {"uint64", RosPrimitive::uint64}, {"float32", RosPrimitive::float32},
        {"float64", RosPrimitive::float64}, {"string", RosPrimitive::text},
    };
    return list;
}

// Types that every definition may use without giving them.
constexpr std::pair<std::string_view, std::string_view> kBuiltin[] = {
    {"builtin_interfaces/Time", "int32 sec\nuint32 nanosec"},
    {"builtin_interfaces/Duration", "int32 sec\nuint32 nanosec"},
    {"time", "uint32 sec\nuint32 nsec"},  // of ROS 1
    {"duration", "int32 sec\nint32 nsec"},
};

// "sensor_msgs/msg/Imu" and "sensor_msgs/Imu" are the same.
std::string shortTypeName(std::string_view name) {
    std::string out(name);
    if (const std::size_t middle = out.find("/msg/"); middle != std::string::npos) out.erase(middle, 4);
    return out;
}

std::string_view wordOf(std::string_view& line) {
    line = trimmedText(line);
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    const std::string_view word = line.substr(0, end);
    line.remove_prefix(end);
    return word;
}

// "float64[9]" is float64 and a fixed array of 9; bounds of strings and sequences ("<=10") do not matter.
struct TypeWord {
    std::string_view base;
    RosField::Array array = RosField::Array::none;
    std::size_t length = 0;
};
std::optional<TypeWord> typeWordOf(std::string_view word) {
    TypeWord type{word};
    if (word.ends_with(']')) {
        const std::size_t open = word.rfind('[');
        if (open == std::string_view::npos) return {};
        const std::string_view length = word.substr(open + 1, word.size() - open - 2);
        type.base = word.substr(0, open);
        type.array = RosField::Array::sequence;
        if (!length.empty() && !length.starts_with("<=")) {
            type.array = RosField::Array::fixed;
            const auto result = std::from_chars(length.data(), length.data() + length.size(), type.length);
            if (result.ec != std::errc{} || result.ptr != length.data() + length.size()) return {};
        }
    }
    type.base = type.base.substr(0, type.base.find("<="));
    if (type.base.empty()) return {};
    return type;
}

}  // namespace

RosDefinition::RosDefinition(std::string_view name, std::string_view text) {
    if (!isUtf8(text)) fault_ = "its definition is no text";
    std::string_view type_name = name;
    std::size_t begin = 0;
    bool behind_rule = false;
    for (const TextLine& line : linesOf(text)) {
        const std::string_view words = trimmedText(line.text);
        const auto at = static_cast<std::size_t>(line.text.data() - text.data());
        if (words.starts_with("====")) {
            parseType(type_name, text.substr(begin, at - begin));
            begin = at + line.text.size();
            behind_rule = true;
        } else if (behind_rule && words.starts_with("MSG:")) {
            type_name = trimmedText(words.substr(4));
            begin = at + line.text.size();
            behind_rule = false;
        }
    }
    parseType(type_name, text.substr(begin));
    if (fault_.empty()) resolve();
    if (fault_.empty()) expectNoCircle();
}

void RosDefinition::parseType(std::string_view name, std::string_view text) {
    if (!fault_.empty()) return;
    RosType type{shortTypeName(name), {}};
    std::vector<std::string> wanted;
    for (const TextLine& line : linesOf(text)) {
        std::string_view rest = line.text.substr(0, line.text.find('#'));
        const std::string_view first = wordOf(rest), second = wordOf(rest);
        if (first.empty()) continue;
        const bool constant = second.find('=') != std::string_view::npos || trimmedText(rest).starts_with('=');
        if (constant) continue;
        const auto word = typeWordOf(first);
        if (!word || second.empty()) {
            fault_ = "its definition has the line " + quote(line.text) + ", expected a type and a name";
            return;
        }
        RosField field;
        field.name = second;
        field.unit = knownUnit(type.name, second);
        field.array = word->array;
        field.length = word->length;
        const auto primitive = primitives().find(word->base);
        field.nested = primitive == primitives().end();
        if (!field.nested) field.primitive = primitive->second;
        wanted.emplace_back(word->base);
        type.fields.push_back(std::move(field));
    }
    if (types_.size() >= kMostTypes || type.fields.size() > kMostFields) {
        fault_ = "its definition is larger than that of any message";
        return;
    }
    types_.push_back(std::move(type));
    wanted_.push_back(std::move(wanted));
}

// A type within the same package may be named without it; Header alone is that of std_msgs.
void RosDefinition::resolve() {
    std::map<std::string, std::size_t> known;
    for (std::size_t i = 0; i < types_.size(); ++i) known.emplace(types_[i].name, i);
    const std::size_t given = types_.size();
    for (const auto& [name, text] : kBuiltin) {
        if (known.emplace(name, types_.size()).second) parseType(name, text);
    }
    for (std::size_t i = 0; i < given; ++i) {
        const std::string package = types_[i].name.substr(0, types_[i].name.find('/'));
        for (std::size_t f = 0; f < types_[i].fields.size(); ++f) {
            RosField& field = types_[i].fields[f];
            if (!field.nested) continue;
            const std::string name = shortTypeName(wanted_[i][f]);
            auto found = known.find(name);
            if (found == known.end()) found = known.find(package + "/" + name);
            if (found == known.end() && name == "Header") found = known.find("std_msgs/Header");
            if (found == known.end()) {
                fault_ = "its definition does not say what " + quote(wanted_[i][f]) + " is";
                return;
            }
            field.type = found->second;
        }
    }
}

void RosDefinition::expectNoCircle() {
    std::vector<std::size_t> depth(types_.size(), 1);
    for (std::size_t round = 0; round <= kDeepestType; ++round) {
        bool changed = false;
        for (std::size_t i = 0; i < types_.size(); ++i) {
            for (const RosField& field : types_[i].fields) {
                if (!field.nested || depth[i] > depth[field.type]) continue;
                depth[i] = depth[field.type] + 1;
                changed = true;
            }
        }
        if (!changed) return;
    }
    fault_ = "its definition has types in types without an end";
}

}  // namespace tread
