// MCAP files as far as the writer and the reader share them: a magic, records of <opcode u8, length u64, content>, the
// magic again. Numbers are little-endian; texts, lists and maps bear their length in bytes (u32) in front of them.
// (mcap.dev, "MCAP Format Specification", version 0.)
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace tread::mcap {

inline constexpr std::string_view kMagic = "\x89MCAP0\r\n";  // 8 bytes

enum class Opcode : std::uint8_t {
    header = 0x01,
    footer = 0x02,
    schema = 0x03,
    channel = 0x04,
    message = 0x05,
    chunk = 0x06,
    message_index = 0x07,
    chunk_index = 0x08,
    statistics = 0x0B,
    summary_offset = 0x0E,
    data_end = 0x0F,
};

// Of ISO 3309, as zlib has it. `before`: the sum of the bytes in front of these.
std::uint32_t crc32(std::string_view bytes, std::uint32_t before = 0);

template <class T>
void put(std::string& out, T value) {
    for (std::size_t i = 0; i < sizeof(T); ++i)
        out += static_cast<char>(static_cast<unsigned char>(static_cast<std::uint64_t>(value) >> (8 * i)));
}
void putText(std::string& out, std::string_view text);
void putRecord(std::string& out, Opcode opcode, std::string_view content);

// One Zstandard frame.
std::string packed(std::string_view bytes);

// What a frame holds, at most `most` bytes; a frame that is cut off or damaged gives what is in front of that place.
struct Unpacked {
    std::string bytes;
    bool whole = false;
};
Unpacked unpacked(std::string_view frame, std::size_t most);

}  // namespace tread::mcap
