#include "import/formats/mcap/lz4_frame.h"

#include <cstdint>
#include <string>

#include "import/formats/byte_reader.h"

namespace tread {
namespace {

constexpr std::uint32_t kLz4Magic = 0x184D2204;
constexpr std::uint32_t kStored = 0x80000000;  // of a block's size: as it is
constexpr unsigned kBlockSum = 1 << 4, kSizeGiven = 1 << 3, kFrameSum = 1 << 2, kDictionary = 1 << 0;  // flags
constexpr unsigned kLongLength = 15;  // more bytes of it follow
constexpr std::size_t kShortestMatch = 4;

class Lz4Reader {
public:
    Lz4Reader(std::string_view frame, std::size_t most) : in_(frame), most_(most) {}

    mcap::Unpacked read() {
        const bool whole = readFrame() && in_.ok() && in_.left() == 0;
        return {std::move(out_), whole};
    }

private:
    bool readFrame() {
        if (in_.number<std::uint32_t>() != kLz4Magic) return false;
        const unsigned flags = in_.number<std::uint8_t>();
        in_.take(1);                                                      // largest block
        if (flags >> 6 != 1 || (flags & kDictionary) != 0) return false;  // another version
        if ((flags & kSizeGiven) != 0) in_.take(sizeof(std::uint64_t));
        in_.take(1);  // sum of the head
        while (in_.ok()) {
            const auto size = in_.number<std::uint32_t>();
            if (in_.ok() && size == 0) {
                if ((flags & kFrameSum) != 0) in_.take(sizeof(std::uint32_t));
                return true;
            }
            const bool stored = (size & kStored) != 0;
            const std::uint32_t length = size & ~kStored;
            // Of a block that is cut off, what is there.
            const std::string_view block = in_.left() < length ? in_.rest() : in_.take(length);
            if (!(stored ? append(block) : readBlock(block)) || block.size() < length) return false;
            if ((flags & kBlockSum) != 0) in_.take(sizeof(std::uint32_t));
        }
        return false;
    }

    bool append(std::string_view bytes) {
        if (bytes.size() > most_ - out_.size()) return false;
        out_ += bytes;
        return true;
    }

    static std::size_t lengthOf(ByteReader& block, unsigned begin) {
        std::size_t length = begin;
        for (unsigned more = begin == kLongLength ? 255 : 0; more == 255; length += more)
            more = block.number<std::uint8_t>();
        return length;
    }

    // Literals and matches, bytes that are there already, by turns; the last literals have no match behind them.
    bool readBlock(std::string_view bytes) {
        ByteReader block(bytes);
        while (block.left() > 0) {
            const unsigned token = block.number<std::uint8_t>();
            const std::string_view literals = block.take(lengthOf(block, token >> 4));
            if (!block.ok() || !append(literals)) return false;
            if (block.left() == 0) return true;
            const std::size_t distance = block.number<std::uint16_t>();
            const std::size_t length = lengthOf(block, token & kLongLength) + kShortestMatch;
            if (!block.ok() || distance == 0 || distance > out_.size() || length > most_ - out_.size()) return false;
            for (std::size_t i = 0; i < length; ++i) out_ += out_[out_.size() - distance];  // may overlap itself
        }
        return block.ok();
    }

    ByteReader in_;
    std::size_t most_;
    std::string out_;
};

}  // namespace

mcap::Unpacked unpackedLz4(std::string_view frame, std::size_t most) {
    return Lz4Reader(frame, most).read();
}

}  // namespace tread
