#include "import/formats/mcap/mcap_scan.h"

#include <algorithm>

#include "base/text/number_text.h"
#include "base/text/text_file.h"
#include "import/formats/byte_reader.h"
#include "import/formats/mcap/lz4_frame.h"
#include "log/mcap_format.h"
#include "tread/problem.h"

namespace tread {
namespace {

using mcap::Opcode;

constexpr std::size_t kRecordHead = 1 + sizeof(std::uint64_t);  // opcode and length
// [guess] Writers make chunks of about 1 MB and at most some camera images; a hostile one could claim any size.
constexpr std::uint64_t kLargestChunk = std::uint64_t{1} << 28;  // bytes unpacked
constexpr std::uint64_t kMostUnpacked = std::uint64_t{16}
                                        << 30;  // bytes of all chunks of a file, more than a day's drive

class McapScanner {
public:
    McapScanner(std::string_view bytes, const std::string& file, const McapTaker& taker)
        : bytes_(bytes), file_(file), taker_(taker) {}

    McapScan scan() {
        if (!bytes_.starts_with(mcap::kMagic))
            throw LoadError({{file_, 0, 0, "",
                              "is not an MCAP file: it does not begin with the signature of the format; is it cut off, "
                              "or a file of another kind with this name?"}});
        records(bytes_.substr(mcap::kMagic.size()), false);
        if (!ended_ && !cut_) {
            result_.notes.emplace_back(
                "the file has no end, as when a recording is cut off; all its messages were read");
        } else if (ended_ && !bytes_.substr(mcap::kMagic.size()).ends_with(mcap::kMagic)) {
            result_.notes.emplace_back("the index at the end of the file is cut off; all messages were read");
        }
        count(damaged_, "chunk", "damaged and left out");
        count(too_large_, "chunk", "left out, with a claim of more than 256 MB");
        count(unknown_packing_, "chunk",
              "left out, packed with " + quote(packing_) +
                  "; `mcap compress drive.mcap -o repacked.mcap --compression zstd` (mcap.dev) makes a file that tread "
                  "reads");
        count(faulty_, "record", "damaged and left out");
        return std::move(result_);
    }

private:
    void count(std::size_t times, std::string_view what, const std::string& text) {
        if (times == 0) return;
        result_.notes.push_back(counted(times, what) + (times == 1 ? " was " : " were ") + text);
    }

    void records(std::string_view rest, bool in_chunk) {
        while (!rest.empty() && !ended_) {
            ByteReader head(rest);
            const auto opcode = static_cast<Opcode>(head.number<std::uint8_t>());
            const auto length = head.number<std::uint64_t>();
            const bool whole = head.ok() && length <= head.left();
            const std::string_view content =
                rest.substr(std::min(kRecordHead, rest.size()), whole ? static_cast<std::size_t>(length) : rest.size());
            if (!whole) return cutOff(opcode, content, head.ok(), in_chunk);
            rest.remove_prefix(kRecordHead + static_cast<std::size_t>(length));
            in_chunk ? recordOfChunk(opcode, content) : record(opcode, content);
        }
    }

    void cutOff(Opcode opcode, std::string_view content, bool has_head, bool in_chunk) {
        if (in_chunk) return;  // the record around it is cut off, too, or counted as damaged
        cut_ = true;
        result_.notes.emplace_back(
            "the file ends within a record, as when a recording is cut off; what is in front of it was read");
        if (has_head && opcode == Opcode::chunk) chunk(content, true);
    }

    void record(Opcode opcode, std::string_view content) {
        if (opcode == Opcode::header) {
            ByteReader reader(content);
            reader.text();  // profile
            result_.program = reader.text();
        } else if (opcode == Opcode::chunk) {
            chunk(content, false);
        } else if (opcode == Opcode::data_end || opcode == Opcode::footer) {
            ended_ = true;
        } else {
            recordOfChunk(opcode, content);
        }
    }

    void recordOfChunk(Opcode opcode, std::string_view content) {
        ByteReader reader(content);
        if (opcode == Opcode::schema) {
            McapSchema schema;
            schema.id = reader.number<std::uint16_t>();
            schema.name = reader.text();
            schema.encoding = reader.text();
            schema.text = reader.text();
            // Those of protobuf are no text.
            const bool good = reader.ok() && isUtf8(schema.name) && isUtf8(schema.encoding);
            good ? taker_.schema(std::move(schema)) : void(++faulty_);
        } else if (opcode == Opcode::channel) {
            McapChannel channel;
            channel.id = reader.number<std::uint16_t>();
            channel.schema = reader.number<std::uint16_t>();
            channel.topic = reader.text();
            channel.encoding = reader.text();
            const bool good = reader.ok() && isUtf8(channel.topic) && isUtf8(channel.encoding);
            good ? taker_.channel(std::move(channel)) : void(++faulty_);
        } else if (opcode == Opcode::message) {
            McapMessage message;
            message.channel = reader.number<std::uint16_t>();
            reader.number<std::uint32_t>();  // sequence
            message.time = reader.number<std::uint64_t>();
            reader.number<std::uint64_t>();  // published
            message.bytes = reader.rest();
            reader.ok() ? taker_.message(message) : void(++faulty_);
        }
    }

    // What a chunk holds that is cut off is what could be unpacked of it; of a damaged one nothing can be trusted.
    void chunk(std::string_view content, bool cut) {
        ByteReader reader(content);
        reader.take(2 * sizeof(std::uint64_t));  // times of the first and the last message
        const auto size = reader.number<std::uint64_t>();
        const auto sum = reader.number<std::uint32_t>();
        const std::string_view packing = reader.text();
        const auto packed_size = reader.number<std::uint64_t>();
        if (!reader.ok()) return void(cut || ++damaged_);
        if (size > kLargestChunk) return void(++too_large_);
        unpacked_ += size;
        if (unpacked_ > kMostUnpacked)
            throw LoadError({{file_, 0, 0, "", "unpacks to more than 16 GB, expected the recording of a drive"}});
        const std::string_view packed = cut ? reader.rest() : reader.take(packed_size);
        if (!reader.ok()) return void(++damaged_);
        if (packing.empty()) {
            if (cut || isWhole(packed, size, sum)) return records(packed, true);
            ++damaged_;
        } else if (packing == "zstd" || packing == "lz4") {
            const auto most = static_cast<std::size_t>(size);
            const mcap::Unpacked got = packing == "zstd" ? mcap::unpacked(packed, most) : unpackedLz4(packed, most);
            if (cut || (got.whole && isWhole(got.bytes, size, sum))) return records(got.bytes, true);
            ++damaged_;
        } else {
            ++unknown_packing_;
            packing_ = std::string(packing.substr(0, 20));
        }
    }

    static bool isWhole(std::string_view bytes, std::uint64_t size, std::uint32_t sum) {
        return bytes.size() == size && (sum == 0 || mcap::crc32(bytes) == sum);  // 0: the writer made none
    }

    std::string_view bytes_;
    const std::string& file_;
    const McapTaker& taker_;
    McapScan result_;
    bool ended_ = false, cut_ = false;
    std::uint64_t unpacked_ = 0;
    std::size_t damaged_ = 0, too_large_ = 0, unknown_packing_ = 0, faulty_ = 0;
    std::string packing_;
};

}  // namespace

McapScan scanMcap(std::string_view bytes, const std::string& file, const McapTaker& taker) {
    return McapScanner(bytes, file, taker).scan();
}

}  // namespace tread
