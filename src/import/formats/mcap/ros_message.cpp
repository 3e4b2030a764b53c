#include "import/formats/mcap/ros_message.h"

#include <algorithm>
#include <bit>

#include "import/formats/byte_reader.h"

namespace tread {
namespace {

constexpr std::size_t kEncapsulation = 4;  // bytes in front of a message in CDR: its representation and options
constexpr std::size_t kMostVisits = 32;    // types read for each byte: arrays in arrays of nothing would have no end

std::size_t sizeOf(RosPrimitive primitive) {
    switch (primitive) {
        case RosPrimitive::boolean:
        case RosPrimitive::int8:
        case RosPrimitive::uint8:
            return 1;
        case RosPrimitive::int16:
        case RosPrimitive::uint16:
            return 2;
        case RosPrimitive::int64:
        case RosPrimitive::uint64:
        case RosPrimitive::float64:
            return 8;
        default:
            return 4;  // with the length of a text
    }
}

bool isPassedOver(const RosField& field, std::size_t elements) {
    return elements > kMostArrayColumns || field.name.ends_with("covariance");
}

class RosReader {
public:
    RosReader(const RosDefinition& definition, RosWire wire, std::string_view bytes, TopicTable& table,
              std::vector<std::string>& passed_over)
        : types_(definition.types()), wire_(wire), bytes_(bytes), table_(table), passed_over_(passed_over) {}

    bool read() {
        if (wire_ == RosWire::cdr) {
            const auto representation = bytes_.number<std::uint16_t>(true);  // CDR_BE or CDR_LE
            bytes_.number<std::uint16_t>();                                  // options
            if (representation > 1) return false;
            big_endian_ = representation == 0;
        }
        readType(types_.front(), {}, false);
        return bytes_.ok();
    }

private:
    // Primitives lie at multiples of their size from the end of the encapsulation; ROS 1 knows no padding.
    void align(std::size_t size) {
        if (wire_ == RosWire::ros1) return;
        const std::size_t beyond = (bytes_.place() - kEncapsulation) % size;
        if (beyond != 0) bytes_.take(size - beyond);
    }

    template <class T>
    T aligned() {
        align(sizeof(T));
        return bytes_.number<T>(big_endian_);
    }

    void readType(const RosType& type, std::string_view unit, bool skip) {
        if (++visits_ > kMostVisits * bytes_.size()) return bytes_.fail();
        // A type without fields has a byte in ROS 2, since IDL knows no empty structures.
        if (type.fields.empty() && wire_ == RosWire::cdr) bytes_.number<std::uint8_t>();
        for (const RosField& field : type.fields) {
            if (!bytes_.ok()) return;
            const std::size_t had = path_.size();
            if (!skip) path_ += (path_.empty() ? "" : ".") + field.name;
            readField(field, field.unit.empty() ? unit : std::string_view(field.unit), skip);
            path_.resize(had);
        }
    }

    void readField(const RosField& field, std::string_view unit, bool skip) {
        if (field.array == RosField::Array::none) return readElement(field, unit, skip);
        const bool fixed = field.array == RosField::Array::fixed;
        const std::size_t length = fixed ? field.length : aligned<std::uint32_t>();
        // Each element has at least a byte, but for ROS 1's types without fields.
        if (!bytes_.ok() || length > bytes_.left()) return bytes_.fail();
        const bool number = !field.nested && field.primitive != RosPrimitive::text;
        if (!skip && isPassedOver(field, length)) {
            skip = true;
            if (number || field.nested) notePassedOver();
        }
        if (skip && number) {
            if (length > 0) align(sizeOf(field.primitive));
            bytes_.take(length * sizeOf(field.primitive));
            return;
        }
        for (std::size_t i = 0; i < length && bytes_.ok(); ++i) {
            const std::size_t had = path_.size();
            if (!skip) path_ += "[" + std::to_string(i) + "]";
            readElement(field, unit, skip);
            path_.resize(had);
        }
    }

    void notePassedOver() {
        if (std::find(passed_over_.begin(), passed_over_.end(), path_) == passed_over_.end() &&
            passed_over_.size() < kMostArrayColumns)
            passed_over_.push_back(path_);
    }

    void readElement(const RosField& field, std::string_view unit, bool skip) {
        if (field.nested) return readType(types_[field.type], unit, skip);
        if (field.primitive == RosPrimitive::text) {
            align(sizeof(std::uint32_t));
            bytes_.text(big_endian_);
            return;
        }
        const double value = number(field.primitive);
        if (bytes_.ok() && !skip) table_.value(path_, value, unit);
    }

    double number(RosPrimitive primitive) {
        switch (primitive) {
            case RosPrimitive::boolean:
                return aligned<std::uint8_t>() != 0;
            case RosPrimitive::int8:
                return aligned<std::int8_t>();
            case RosPrimitive::uint8:
                return aligned<std::uint8_t>();
            case RosPrimitive::int16:
                return aligned<std::int16_t>();
            case RosPrimitive::uint16:
                return aligned<std::uint16_t>();
            case RosPrimitive::int32:
                return aligned<std::int32_t>();
            case RosPrimitive::uint32:
                return aligned<std::uint32_t>();
            case RosPrimitive::int64:
                return static_cast<double>(aligned<std::int64_t>());
            case RosPrimitive::uint64:
                return static_cast<double>(aligned<std::uint64_t>());
            case RosPrimitive::float32:
                return std::bit_cast<float>(aligned<std::uint32_t>());
            case RosPrimitive::float64:
                return std::bit_cast<double>(aligned<std::uint64_t>());
            case RosPrimitive::text:
                break;
        }
        return 0;
    }

    const std::vector<RosType>& types_;
    RosWire wire_;
    ByteReader bytes_;
    TopicTable& table_;
    std::vector<std::string>& passed_over_;
    bool big_endian_ = false;
    std::size_t visits_ = 0;
    std::string path_;
};

}  // namespace

bool readRosMessage(const RosDefinition& definition, RosWire wire, std::string_view bytes, TopicTable& table,
                    std::vector<std::string>& passed_over) {
    return RosReader(definition, wire, bytes, table, passed_over).read();
}

}  // namespace tread
