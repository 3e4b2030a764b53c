// MathWorks, MAT-File Format (R2023b): version 5 elements "Tag Field", version 4 "Matrix Header".
#include "import/formats/mat_whole.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "import/formats/byte_reader.h"
#include "import/formats/mat_elements.h"

namespace tread {
namespace {

constexpr std::size_t kHeader = 128;     // of a version 5 file
constexpr std::size_t kVersionAt = 124;  // in it: version, then the letters that tell the order of bytes
constexpr std::uint32_t kVersion5 = 0x0100, kVersion73 = 0x0200;
constexpr std::size_t kTag = 8, kHeader4 = 20;
constexpr std::uint32_t kMatrix = 14, kCompressed = 15;
constexpr std::uint32_t kLargest4 = 1u << 30;  // rows, columns, name: a version 4 file with more is none

std::uint32_t word(std::string_view bytes, std::size_t at, bool big) {
    return ByteReader(bytes.substr(at)).number<std::uint32_t>(big);
}

MatContents cutOff(std::size_t variable, std::size_t missing) {
    return {"is cut off within its variable number " + std::to_string(variable) + ": " + std::to_string(missing) +
            " bytes are missing"};
}

MatContents version5(std::string_view bytes, bool big) {
    std::size_t at = kHeader, variable = 1;
    for (; at < bytes.size(); ++variable) {
        if (bytes.size() - at < kTag) return cutOff(variable, kTag - (bytes.size() - at));
        const std::uint32_t type = word(bytes, at, big), size = word(bytes, at + 4, big);
        if (type != kMatrix && type != kCompressed) {
            return {"is damaged: at byte " + std::to_string(at) + " there is no variable where one should begin"};
        }
        at += kTag;
        if (bytes.size() - at < size) return cutOff(variable, size - (bytes.size() - at));
        const std::string_view content = bytes.substr(at, size);
        const std::string fault = type == kMatrix ? matrixFault(content, big) : compressedFault(content, big);
        if (!fault.empty()) return {"is damaged: its variable number " + std::to_string(variable) + " " + fault};
        at += size;
    }
    return {{}, variable - 1};
}

MatContents version4(std::string_view bytes) {
    static constexpr std::array<std::size_t, 6> kBytes{8, 4, 4, 2, 2, 1};  // of a number, by the tens digit of the type
    if (bytes.empty()) return {"is empty"};
    std::size_t at = 0, variable = 1;
    for (; at < bytes.size(); ++variable) {
        if (bytes.size() - at < kHeader4) return cutOff(variable, kHeader4 - (bytes.size() - at));
        const bool big = word(bytes, 0, false) > 9999;  // one order for all variables
        const std::uint32_t type = word(bytes, at, big), rows = word(bytes, at + 4, big),
                            columns = word(bytes, at + 8, big), imaginary = word(bytes, at + 12, big),
                            name = word(bytes, at + 16, big), number = type / 10 % 10;
        // The thousands tell the order of bytes. matio goes by them, also where the file is in the other order.
        if (type / 1000 != (big ? 1 : 0) || number >= kBytes.size() || imaginary > 1 ||
            std::max({rows, columns, name}) > kLargest4) {
            return {"is not a MATLAB file that tread can read (neither version 4, 5 nor 7.3)"};
        }
        at += kHeader4;
        const std::size_t left = bytes.size() - at, parts = 1 + imaginary;
        // Not multiplied out: rows times columns may exceed what a number holds.
        const std::size_t numbers = left / (kBytes[number] * parts);
        const bool fits = name <= left && (rows == 0 || columns <= numbers / rows);
        const std::size_t size = fits ? std::size_t{rows} * columns * kBytes[number] * parts + name : 0;
        if (!fits || size > left) return {"is cut off within its variable number " + std::to_string(variable)};
        at += size;
    }
    return {{}, variable - 1};
}

}  // namespace

MatContents matContents(std::string_view bytes) {
    if (bytes.size() >= kHeader) {
        const std::string_view order = bytes.substr(kVersionAt + 2, 2);
        if (order == "IM" || order == "MI") {
            const bool big = order == "MI";
            const std::uint32_t version = ByteReader(bytes.substr(kVersionAt)).number<std::uint16_t>(big);
            if (version == kVersion73) return {};
            if (version == kVersion5) return version5(bytes, big);
        }
    }
    if (bytes.size() < kHeader && bytes.starts_with("MATLAB")) return {"is cut off within its header"};
    return version4(bytes);
}

}  // namespace tread
