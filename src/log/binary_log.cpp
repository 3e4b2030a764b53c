#include "log/binary_log.h"

#include <zstd.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <new>

#include "tread/problem.h"

namespace tread {
namespace {

constexpr std::string_view kHead = "tread log 1\nrows ";
constexpr std::string_view kMagic = "\x28\xB5\x2F\xFD";
constexpr unsigned long long kLargest = 1ull << 30;  // bytes; a hostile frame could claim any size

// No block of Zstandard gives more than 128 KB or takes less than 4 bytes (RFC 8878, 3.1.1.2): a frame that claims more
// than that for each of its bytes is refused before there is memory for it.
constexpr unsigned long long kMostPerByte = (128 << 10) / 4;

std::uint64_t littleEndian(std::uint64_t bits) {
    if constexpr (std::endian::native == std::endian::little) return bits;
    else return __builtin_bswap64(bits);
}

[[noreturn]] void refuse(const std::string& file, const std::string& text) {
    throw LoadError({{file, 0, 0, "", "found " + text + ", expected a log as `tread campaign` keeps it"}});
}

std::string unpacked(std::string_view bytes, const std::string& file) {
    const unsigned long long size = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
    if (size == ZSTD_CONTENTSIZE_UNKNOWN || size == ZSTD_CONTENTSIZE_ERROR || size > kLargest)
        refuse(file, "no Zstandard frame that states its size");
    if (size > kMostPerByte * bytes.size()) refuse(file, "a damaged Zstandard frame");
    std::string text(static_cast<std::size_t>(size), '\0');
    const std::size_t got = ZSTD_decompress(text.data(), text.size(), bytes.data(), bytes.size());
    if (ZSTD_isError(got) || got != text.size()) refuse(file, "a damaged Zstandard frame");
    return text;
}

// What every log promises, and the reader of CSV demands.
void expectTime(const Log& log, const std::string& file) {
    const Channel& time = log.channels.front();
    if (time.name != "time" || time.unit != "s") refuse(file, "no time in seconds in the first column");
    if (time.values.empty()) refuse(file, "no rows");
    for (std::size_t i = 0; i < time.values.size(); ++i) {
        if (!std::isfinite(time.values[i]) || (i > 0 && time.values[i] <= time.values[i - 1]))
            refuse(file, "a time that does not increase");
    }
    for (const Channel& channel : log.channels)
        if (channel.name.empty() || channel.unit.empty()) refuse(file, "a column without a name or a unit");
}

}  // namespace

std::string binaryLog(const Log& log) {
    std::string text = std::string(kHead) + std::to_string(log.samples()) + "\n";
    for (const Channel& channel : log.channels) text += channel.name + " [" + channel.unit + "]\n";
    text += "\n";
    for (const Channel& channel : log.channels) {
        for (const double value : channel.values) {
            const std::uint64_t bits = littleEndian(std::bit_cast<std::uint64_t>(value));
            char raw[sizeof bits];
            std::memcpy(raw, &bits, sizeof bits);
            text.append(raw, sizeof raw);
        }
    }
    std::string packed(ZSTD_compressBound(text.size()), '\0');
    const std::size_t size = ZSTD_compress(packed.data(), packed.size(), text.data(), text.size(), ZSTD_CLEVEL_DEFAULT);
    if (ZSTD_isError(size)) throw std::bad_alloc();  // its only cause here
    packed.resize(size);
    return packed;
}

bool isBinaryLog(std::string_view bytes) {
    return bytes.starts_with(kMagic);
}

Log parseBinaryLog(std::string_view bytes, const std::string& file) {
    const std::string text = unpacked(bytes, file);
    std::string_view rest = text;
    if (!rest.starts_with(kHead)) refuse(file, "another kind of Zstandard file");
    rest.remove_prefix(kHead.size());
    std::size_t rows = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), rows);
    if (error != std::errc{} || end == rest.data() + rest.size() || *end != '\n') refuse(file, "no number of rows");
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()) + 1);
    Log log;
    for (;;) {
        const std::size_t line_end = rest.find('\n');
        if (line_end == std::string_view::npos) refuse(file, "columns without an end");
        const std::string_view line = rest.substr(0, line_end);
        rest.remove_prefix(line_end + 1);
        if (line.empty()) break;
        const std::size_t unit = line.rfind(" [");
        if (unit == std::string_view::npos || !line.ends_with(']')) refuse(file, "a column without a unit");
        log.channels.push_back(
            {std::string(line.substr(0, unit)), std::string(line.substr(unit + 2, line.size() - unit - 3)), {}});
    }
    if (log.channels.empty() || rows > rest.size() / sizeof(double) ||
        rest.size() != log.channels.size() * rows * sizeof(double))
        refuse(file, "another number of values than rows and columns make");
    for (Channel& channel : log.channels) {
        channel.values.reserve(rows);
        for (std::size_t i = 0; i < rows; ++i, rest.remove_prefix(sizeof(double))) {
            std::uint64_t bits = 0;
            std::memcpy(&bits, rest.data(), sizeof bits);
            channel.values.push_back(std::bit_cast<double>(littleEndian(bits)));
        }
    }
    expectTime(log, file);
    return log;
}

}  // namespace tread
