// MathWorks, MAT-File Format (R2023b): "Data MatElement Format", "Array Data MatElement Formats".
#include "import/formats/mat_elements.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include "import/formats/byte_reader.h"

namespace tread {
namespace {

constexpr std::uint32_t kInt8Element = 1, kInt32Element = 5, kUint32Element = 6, kMatrixElement = 14;
constexpr std::size_t kAlignment = 8, kElementTag = 8, kFlags = 8;
constexpr std::size_t kSmall = 4;                            // bytes of data within a tag, at most
constexpr int kDeepestArray = 64;                            // arrays in arrays
constexpr std::size_t kMostUnpacked = std::size_t{1} << 30;  // of one variable
enum Class : std::uint32_t { kCell = 1, kStruct, kObject, kChar, kSparse, kFunction = 16, kOpaque };
constexpr std::uint32_t kComplex = 0x800;

// Bytes of a number of a type; 0: it has none.
std::size_t bytesOfNumber(std::uint32_t type) {
    static constexpr std::array<std::size_t, 19> kBytes{0, 1, 1, 2, 2, 4, 4, 4, 0, 8, 0, 0, 8, 8, 0, 0, 1, 2, 4};
    return type < kBytes.size() ? kBytes[type] : 0;
}

struct MatElement {
    std::uint32_t type = 0;
    std::string_view data;
    bool within_tag = false;
};

// matio takes these for granted: where they do not hold, it reads tags where there are none.
bool isFlags(const std::optional<MatElement>& flags) {
    return flags && flags->type == kUint32Element && !flags->within_tag && flags->data.size() == kFlags;
}
bool isSizes(const std::optional<MatElement>& sizes) {
    return sizes && sizes->type == kInt32Element && !sizes->within_tag &&
           sizes->data.size() >= 2 * sizeof(std::int32_t) && sizes->data.size() % sizeof(std::int32_t) == 0;
}
bool isName(const std::optional<MatElement>& name) {
    return name && name->type == kInt8Element;
}
// A field takes its name from its struct; matio looks for data where a further name would be. So it does in a cell, if
// the array is sparse.
bool isNameOfField(const std::optional<MatElement>& name) {
    return isName(name) && (name->within_tag || name->data.empty());
}
// matio looks for a tag within the name of an object.
bool isNameOfObject(const std::optional<MatElement>& name) {
    const auto is_letter = [](unsigned char c) { return c > ' '; };
    return isName(name) && std::all_of(name->data.begin(), name->data.end(), is_letter);
}

std::uint32_t wordOf(std::string_view bytes, bool big) {
    return ByteReader(bytes).number<std::uint32_t>(big);
}

class MatWalk {
public:
    explicit MatWalk(bool big) : big_(big) {}

    // Each returns false where the bytes end before what they claim.
    bool matrix(std::string_view content, int depth, bool is_field = false) {
        if (content.empty()) return true;  // an array that is empty
        if (depth > kDeepestArray) return false;
        ByteReader reader(content);
        const auto flags = next(reader);
        if (!isFlags(flags)) return false;
        const std::uint32_t word = wordOf(flags->data, big_), kind = word & 0xff;
        if (kind == kOpaque) return isNameOfObject(next(reader)) && elements(reader);  // no sizes; not read
        const auto sizes = next(reader), name = next(reader);
        const bool nameless = is_field || (depth > 0 && kind == kSparse);
        if (!isSizes(sizes) || !(nameless ? isNameOfField(name) : isName(name))) return false;
        const std::optional<std::size_t> count = product(sizes->data);
        if (!count) return false;
        if (kind == kCell || kind == kFunction) return matrices(reader, *count, depth);
        if (kind == kStruct || kind == kObject) return fields(reader, kind, *count, depth);
        if (kind == kSparse || kind == 0 || kind > kOpaque) return elements(reader);  // not read
        return numbers(reader, *count) && ((word & kComplex) == 0 || numbers(reader, *count));
    }

private:
    // Padded to whole words of 8 bytes; the last may not be.
    std::optional<MatElement> next(ByteReader& reader) {
        const auto type = reader.number<std::uint32_t>(big_);
        if (!reader.ok()) return {};
        if (type >> 16 != 0) {  // four bytes at most, within the tag
            const std::string_view data = reader.take(kSmall);
            if (!reader.ok() || type >> 16 > kSmall) return {};
            return MatElement{type & 0xffff, data.substr(0, type >> 16), true};
        }
        const auto size = reader.number<std::uint32_t>(big_);
        const std::string_view data = reader.take(size);
        if (!reader.ok()) return {};
        reader.take(std::min(reader.left(), (kAlignment - size % kAlignment) % kAlignment));
        return MatElement{type, data};
    }

    std::optional<std::size_t> product(std::string_view sizes) const {
        std::size_t count = 1;
        for (; sizes.size() >= sizeof(std::int32_t); sizes.remove_prefix(sizeof(std::int32_t))) {
            const std::size_t size = wordOf(sizes, big_);
            if (size > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) return {};
            if (size != 0 && count > std::numeric_limits<std::int32_t>::max() / size) return {};
            count *= size;
        }
        return count;
    }

    bool matrices(ByteReader& reader, std::size_t count, int depth, bool are_fields = false) {
        if (count > reader.left() / kElementTag) return false;
        for (; count > 0; --count) {
            const auto element = next(reader);
            if (!element || element->type != kMatrixElement || !matrix(element->data, depth + 1, are_fields))
                return false;
        }
        return true;
    }

    bool fields(ByteReader& reader, std::uint32_t kind, std::size_t count, int depth) {
        if (kind == kObject && !next(reader)) return false;  // name of its class
        const auto room = next(reader), names = next(reader);
        if (!room || !names || room->data.size() < sizeof(std::int32_t)) return false;
        const std::size_t each = wordOf(room->data, big_);
        if (each == 0) return false;
        const std::size_t fields = names->data.size() / each;
        if (fields != 0 && count > reader.left() / fields) return false;
        return (fields != 0 || count <= reader.size()) && matrices(reader, count * fields, depth, true);
    }

    bool elements(ByteReader& reader) {
        while (reader.left() >= kElementTag)
            if (!next(reader)) return false;
        return true;
    }

    bool numbers(ByteReader& reader, std::size_t count) {
        if (count == 0) return true;
        const auto element = next(reader);
        const std::size_t each = element ? bytesOfNumber(element->type) : 0;
        return each != 0 && count <= element->data.size() / each;
    }

    bool big_;
};

struct EndInflate {
    void operator()(z_stream* stream) const { inflateEnd(stream); }
};

// What the bytes unpack to, as far as they can be; nothing beyond the most bytes.
std::optional<std::string> inflated(std::string_view bytes) {
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK) return {};
    const std::unique_ptr<z_stream, EndInflate> guard(&stream);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    constexpr std::size_t kFirst = 1 << 14;
    std::string text;
    for (int status = Z_OK; status == Z_OK;) {
        const std::size_t had = text.size();
        if (had > kMostUnpacked) return {};
        text.resize(had + std::max(had, kFirst));
        stream.next_out = reinterpret_cast<Bytef*>(text.data() + had);
        stream.avail_out = static_cast<uInt>(text.size() - had);
        status = inflate(&stream, Z_NO_FLUSH);
        text.resize(text.size() - stream.avail_out);
    }
    return text;
}

}  // namespace

std::string matrixFault(std::string_view content, bool big_endian) {
    return MatWalk(big_endian).matrix(content, 0) ? "" : "has a part that is out of place or claims more than it holds";
}

std::string compressedFault(std::string_view content, bool big_endian) {
    const auto text = inflated(content);
    if (!text) return "unpacks to more than 1 GB";
    ByteReader reader(*text);
    const auto type = reader.number<std::uint32_t>(big_endian), size = reader.number<std::uint32_t>(big_endian);
    if (!reader.ok() || type != kMatrixElement || size > reader.left()) return "cannot be unpacked";
    return matrixFault(reader.take(size), big_endian);
}

}  // namespace tread
