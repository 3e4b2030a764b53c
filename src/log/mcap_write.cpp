#include "log/mcap_write.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/text/json_string.h"
#include "base/text/number_text.h"
#include "log/log_columns.h"
#include "log/mcap_format.h"
#include "tread/problem.h"

namespace tread {
namespace {

constexpr std::size_t kChunkBytes = std::size_t{1} << 20;  // [guess] small enough to seek, large enough to pack well
constexpr double kLatest = 9.2e9;                          // s: less than 2^63 ns, which every reader can hold
constexpr std::string_view kLooseTopic = "/log";           // of channels without a dot in their names

struct McapField {
    const Channel* channel;
    std::string key;  // in JSON, with quotes and colon
};

struct McapTopic {
    std::string name;
    std::vector<McapField> fields;
};

std::string topicNameOf(std::string_view channel) {
    const std::string_view quantity = quantityOf(channel), source = sourceOf(channel);
    const std::size_t dot = quantity.rfind('.');
    std::string name = source.empty() ? std::string() : "/" + std::string(source);
    if (dot == std::string_view::npos) return name + std::string(kLooseTopic);
    name += "/" + std::string(quantity.substr(0, dot));
    std::replace(name.begin(), name.end(), '.', '/');
    return name;
}

std::string fieldNameOf(std::string_view channel) {
    const std::string_view quantity = quantityOf(channel);
    return std::string(quantity.substr(quantity.rfind('.') + 1));  // npos + 1 is 0
}

// In the order in which the log has them.
std::vector<McapTopic> topicsOf(const Log& log) {
    std::vector<McapTopic> topics;
    std::map<std::string, std::size_t> by_name;
    for (std::size_t i = 1; i < log.channels.size(); ++i) {
        const Channel& channel = log.channels[i];
        const std::string name = topicNameOf(channel.name);
        const auto [place, is_new] = by_name.emplace(name, topics.size());
        if (is_new) topics.push_back({name, {}});
        std::vector<McapField>& fields = topics[place->second].fields;
        std::string field = fieldNameOf(channel.name);
        const auto taken = [&] {
            const std::string key = jsonString(field) + ":";
            return std::any_of(fields.begin(), fields.end(), [&](const McapField& one) { return one.key == key; });
        };
        while (taken()) field += '_';
        fields.push_back({&channel, jsonString(field) + ":"});
    }
    return topics;
}

std::string schemaOf(const McapTopic& topic) {
    std::string text = R"({"type":"object","properties":{)";
    for (const McapField& field : topic.fields) {
        if (&field != &topic.fields.front()) text += ',';
        text += field.key + R"({"type":"number","title":)" + jsonString(field.channel->name) + R"(,"description":)" +
                jsonString(field.channel->unit) + "}";
    }
    return text + "}}";
}

void putJsonNumber(std::string& out, double value) {
    if (value == 0 && std::signbit(value)) {
        out += "-0.0";  // -0 is a whole number to many readers
        return;
    }
    char digits[32];  // the shortest that is read back as the same number has at most 24 characters
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    out.append(digits, static_cast<std::size_t>(end - digits));
}

std::string messageOf(const McapTopic& topic, std::size_t row) {
    std::string text = "{";
    for (const McapField& field : topic.fields) {
        const double value = field.channel->values[row];
        if (!std::isfinite(value)) continue;
        if (text.size() > 1) text += ',';
        text += field.key;
        putJsonNumber(text, value);
    }
    return text + "}";
}

std::vector<std::uint64_t> nanoseconds(const Log& log, std::string_view file) {
    const std::vector<double>& time = log.channels.front().values;
    const double zero = time.empty() ? 0 : std::min(time.front(), 0.0);
    std::vector<std::uint64_t> out;
    out.reserve(time.size());
    for (const double t : time) {
        if (!(t - zero <= kLatest))
            throw LoadError({{std::string(file), 0, 0, "time",
                              "found " + numberText(t) + " s, expected at most " + numberText(kLatest) +
                                  " s: MCAP counts nanoseconds in 64 bits"}});
        out.push_back(static_cast<std::uint64_t>(std::llround((t - zero) * 1e9)));
    }
    return out;
}

class McapWriter {
public:
    McapWriter(const Log& log, std::string_view file, const std::function<void(std::string_view)>& take)
        : topics_(topicsOf(log)), times_(nanoseconds(log, file)), take_(take), indexes_(topics_.size()) {}

    void write(std::string_view program) {
        emit(mcap::kMagic);
        std::string header;
        mcap::putText(header, "");  // no profile: nothing but what the schemas say
        mcap::putText(header, program);
        record(mcap::Opcode::header, header);
        for (std::size_t i = 0; i < topics_.size(); ++i) record(mcap::Opcode::schema, schemaRecord(i));
        for (std::size_t i = 0; i < topics_.size(); ++i) record(mcap::Opcode::channel, channelRecord(i));
        for (std::size_t row = 0; row < times_.size(); ++row) addRow(row);
        endChunk();
        std::string end;
        mcap::put(end, sum_);  // of all bytes so far
        record(mcap::Opcode::data_end, end);
        writeSummary();
        emit(mcap::kMagic);
    }

private:
    void emit(std::string_view bytes) {
        sum_ = mcap::crc32(bytes, sum_);
        written_ += bytes.size();
        take_(bytes);
    }

    void record(mcap::Opcode opcode, std::string_view content) {
        std::string bytes;
        mcap::putRecord(bytes, opcode, content);
        emit(bytes);
    }

    // Schemas are numbered from 1, since 0 is none; channels bear the number of their schema.
    static std::uint16_t number(std::size_t topic) { return static_cast<std::uint16_t>(topic + 1); }

    std::string schemaRecord(std::size_t topic) const {
        std::string content;
        mcap::put(content, number(topic));
        mcap::putText(content, topics_[topic].name.substr(1));
        mcap::putText(content, "jsonschema");
        mcap::putText(content, schemaOf(topics_[topic]));
        return content;
    }

    std::string channelRecord(std::size_t topic) const {
        std::string content;
        mcap::put(content, number(topic));
        mcap::put(content, number(topic));
        mcap::putText(content, topics_[topic].name);
        mcap::putText(content, "json");
        mcap::putText(content, "");  // no metadata
        return content;
    }

    void addRow(std::size_t row) {
        if (chunk_.empty()) chunk_begin_ = row;
        chunk_end_ = row;
        for (std::size_t i = 0; i < topics_.size(); ++i) {
            mcap::put(indexes_[i], times_[row]);
            mcap::put(indexes_[i], static_cast<std::uint64_t>(chunk_.size()));
            std::string content;
            mcap::put(content, number(i));
            mcap::put(content, static_cast<std::uint32_t>(row));
            mcap::put(content, times_[row]);  // logged
            mcap::put(content, times_[row]);  // published
            content += messageOf(topics_[i], row);
            mcap::putRecord(chunk_, mcap::Opcode::message, content);
        }
        if (chunk_.size() >= kChunkBytes) endChunk();
    }

    void endChunk() {
        if (chunk_.empty()) return;
        const std::string frame = mcap::packed(chunk_);
        std::string content;
        putSpan(content);
        mcap::put(content, static_cast<std::uint64_t>(chunk_.size()));
        mcap::put(content, mcap::crc32(chunk_));
        mcap::putText(content, kPacking);
        mcap::put(content, static_cast<std::uint64_t>(frame.size()));
        content += frame;
        const std::uint64_t begin = written_;
        record(mcap::Opcode::chunk, content);
        const std::uint64_t length = written_ - begin;

        const std::uint64_t index_begin = written_;
        std::string places;
        for (std::size_t i = 0; i < topics_.size(); ++i) {
            mcap::put(places, number(i));
            mcap::put(places, written_);
            std::string index;
            mcap::put(index, number(i));
            mcap::putText(index, indexes_[i]);
            record(mcap::Opcode::message_index, index);
            indexes_[i].clear();
        }
        std::string chunk_index;
        putSpan(chunk_index);
        mcap::put(chunk_index, begin);
        mcap::put(chunk_index, length);
        mcap::putText(chunk_index, places);
        mcap::put(chunk_index, written_ - index_begin);
        mcap::putText(chunk_index, kPacking);
        mcap::put(chunk_index, static_cast<std::uint64_t>(frame.size()));
        mcap::put(chunk_index, static_cast<std::uint64_t>(chunk_.size()));
        chunk_indexes_.push_back(std::move(chunk_index));
        chunk_.clear();
    }

    void putSpan(std::string& out) const {
        mcap::put(out, times_[chunk_begin_]);
        mcap::put(out, times_[chunk_end_]);
    }

    std::string statistics() const {
        std::string content, counts;
        mcap::put(content, static_cast<std::uint64_t>(times_.size() * topics_.size()));
        mcap::put(content, static_cast<std::uint16_t>(topics_.size()));  // schemas
        mcap::put(content, static_cast<std::uint32_t>(topics_.size()));  // channels
        mcap::put(content, std::uint32_t{0});                            // attachments
        mcap::put(content, std::uint32_t{0});                            // metadata
        mcap::put(content, static_cast<std::uint32_t>(chunk_indexes_.size()));
        mcap::put(content, times_.empty() ? 0 : times_.front());
        mcap::put(content, times_.empty() ? 0 : times_.back());
        for (std::size_t i = 0; i < topics_.size(); ++i) {
            mcap::put(counts, number(i));
            mcap::put(counts, static_cast<std::uint64_t>(times_.size()));
        }
        mcap::putText(content, counts);
        return content;
    }

    // One group of equal records of the summary, and the record that says where it lies.
    void group(mcap::Opcode opcode, const std::vector<std::string>& contents) {
        if (contents.empty()) return;
        const std::uint64_t begin = written_;
        for (const std::string& content : contents) record(opcode, content);
        std::string offset;
        mcap::put(offset, static_cast<std::uint8_t>(opcode));
        mcap::put(offset, begin);
        mcap::put(offset, written_ - begin);
        offsets_.push_back(std::move(offset));
    }

    void writeSummary() {
        const std::uint64_t begin = written_;
        sum_ = 0;
        std::vector<std::string> schemas, channels;
        for (std::size_t i = 0; i < topics_.size(); ++i) {
            schemas.push_back(schemaRecord(i));
            channels.push_back(channelRecord(i));
        }
        group(mcap::Opcode::schema, schemas);
        group(mcap::Opcode::channel, channels);
        group(mcap::Opcode::statistics, {statistics()});
        group(mcap::Opcode::chunk_index, chunk_indexes_);
        const std::uint64_t offsets = written_;
        for (const std::string& offset : offsets_) record(mcap::Opcode::summary_offset, offset);
        std::string footer;
        mcap::put(footer, begin);
        mcap::put(footer, offsets);
        std::string bytes;
        mcap::putRecord(bytes, mcap::Opcode::footer, footer + std::string(sizeof(std::uint32_t), '\0'));
        bytes.resize(bytes.size() - sizeof(std::uint32_t));
        emit(bytes);
        std::string sum;
        mcap::put(sum, sum_);  // of the summary up to here
        emit(sum);
    }

    static constexpr std::string_view kPacking = "zstd";

    std::vector<McapTopic> topics_;
    std::vector<std::uint64_t> times_;  // ns
    const std::function<void(std::string_view)>& take_;
    std::uint32_t sum_ = 0;  // of what was emitted, since the beginning of the file or of its summary
    std::uint64_t written_ = 0;
    std::string chunk_;                            // records that are not yet emitted
    std::size_t chunk_begin_ = 0, chunk_end_ = 0;  // its rows
    std::vector<std::string> indexes_;             // of the chunk: time and place of each message of a topic
    std::vector<std::string> chunk_indexes_, offsets_;
};

}  // namespace

void writeMcap(const Log& log, std::string_view file, std::string_view program,
               const std::function<void(std::string_view)>& take) {
    McapWriter(log, file, take).write(program);
}

}  // namespace tread
