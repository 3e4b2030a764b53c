#include "log/mcap_format.h"

#include <zstd.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>

namespace tread::mcap {
namespace {

constexpr std::uint32_t kPolynomial = 0xEDB88320;  // of ISO 3309, lowest bit first

constexpr std::array<std::uint32_t, 256> remainders() {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t rest = byte;
        for (int bit = 0; bit < 8; ++bit) rest = (rest & 1) ? (rest >> 1) ^ kPolynomial : rest >> 1;
        table[byte] = rest;
    }
    return table;
}

struct FreeStream {
    void operator()(ZSTD_DStream* stream) const { ZSTD_freeDStream(stream); }
};

}  // namespace

std::uint32_t crc32(std::string_view bytes, std::uint32_t before) {
    static constexpr std::array<std::uint32_t, 256> kRemainders = remainders();
    std::uint32_t sum = ~before;
    for (const char c : bytes) sum = kRemainders[(sum ^ static_cast<unsigned char>(c)) & 0xFF] ^ (sum >> 8);
    return ~sum;
}

void putText(std::string& out, std::string_view text) {
    put(out, static_cast<std::uint32_t>(text.size()));
    out += text;
}

void putRecord(std::string& out, Opcode opcode, std::string_view content) {
    put(out, static_cast<std::uint8_t>(opcode));
    put(out, static_cast<std::uint64_t>(content.size()));
    out += content;
}

std::string packed(std::string_view bytes) {
    std::string frame(ZSTD_compressBound(bytes.size()), '\0');
    const std::size_t size = ZSTD_compress(frame.data(), frame.size(), bytes.data(), bytes.size(), ZSTD_CLEVEL_DEFAULT);
    if (ZSTD_isError(size)) throw std::bad_alloc();  // its only cause here
    frame.resize(size);
    return frame;
}

// By and by: memory is only taken for what is really there.
Unpacked unpacked(std::string_view frame, std::size_t most) {
    const std::unique_ptr<ZSTD_DStream, FreeStream> stream(ZSTD_createDStream());
    if (!stream) throw std::bad_alloc();
    Unpacked result;
    ZSTD_inBuffer in{frame.data(), frame.size(), 0};
    const std::size_t step = ZSTD_DStreamOutSize();
    for (;;) {
        const std::size_t had = result.bytes.size();
        if (had > most) break;
        result.bytes.resize(had + std::min(step, most + 1 - had));
        ZSTD_outBuffer out{result.bytes.data() + had, result.bytes.size() - had, 0};
        const std::size_t left = ZSTD_decompressStream(stream.get(), &out, &in);
        result.bytes.resize(had + out.pos);
        result.whole = left == 0 && in.pos == in.size;
        if (left == 0 || ZSTD_isError(left) || (out.pos < out.size && in.pos == in.size)) break;
    }
    if (result.bytes.size() > most) result = {std::move(result.bytes), false};
    return result;
}

}  // namespace tread::mcap
