// Messages of ROS by the text of their definition (ros2msg or ros1msg: the type, then each type in it behind a line of
// "=" and a line "MSG: package/Type"), in CDR (XCDR1 of OMG DDS-XTypes, as ROS 2 has it) or as ROS 1 writes them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "import/formats/mcap/topic_table.h"

namespace tread {

enum class RosPrimitive { boolean, int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64, text };

struct RosField {
    std::string name;
    std::string unit;  // of the numbers in it where the definition of a common message says so; else empty
    bool nested = false;
    RosPrimitive primitive{};  // when it is not nested
    std::size_t type = 0;      // when it is nested: index of its type
    enum class Array { none, fixed, sequence } array = Array::none;
    std::size_t length = 0;  // of a fixed array
};

struct RosType {
    std::string name;  // "geometry_msgs/Twist"
    std::vector<RosField> fields;
};

class RosDefinition {
public:
    // `name` is that of the outermost type, "sensor_msgs/msg/Imu".
    RosDefinition(std::string_view name, std::string_view text);

    // Why messages of the type cannot be read, as one clause; empty when they can.
    const std::string& fault() const { return fault_; }
    const std::vector<RosType>& types() const { return types_; }  // the first is the outermost

private:
    void parseType(std::string_view name, std::string_view text);
    void resolve();
    void expectNoCircle();

    std::vector<RosType> types_;
    std::vector<std::vector<std::string>> wanted_;  // of each type and field, the type by its name
    std::string fault_;
};

enum class RosWire { cdr, ros1 };

// Adds the numbers of a message to the open row of `table`, false when the message is not as its definition says.
// Covariances and long arrays are passed over; their names go to `passed_over`, once.
bool readRosMessage(const RosDefinition& definition, RosWire wire, std::string_view bytes, TopicTable& table,
                    std::vector<std::string>& passed_over);

}  // namespace tread
