// MCAP recordings (mcap.dev): the numbers of the messages in JSON, of ROS 2 (CDR with ros2msg) and of ROS 1. Each topic
// has rows of its own, one for each message, and a column with their time.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>

#include "base/text/number_text.h"
#include "import/formats/foreign_table.h"
#include "import/formats/mcap/json_message.h"
#include "import/formats/mcap/mcap_scan.h"
#include "import/formats/mcap/ros_message.h"
#include "import/formats/mcap/topic_table.h"
#include "import/formats/unit_spelling.h"
#include "log/mcap_write.h"

namespace tread {
namespace {

// s. [guess] A stamp that differs by more from the time of logging is of another clock: a played-back or simulated one.
constexpr double kSameClock = 60;

// What is told to a car, not what it does: taken only for what no other topic has.
constexpr std::string_view kCommandWords[] = {"cmd", "command", "setpoint", "goal", "target", "desired", "reference"};

struct RecordedTopic {
    std::string name;
    TopicTable table;
    std::map<std::string, std::string> titles;  // of the paths, in the files of tread
    std::size_t damaged = 0;
    std::vector<std::string> passed_over;
    std::string fault;  // why its messages are not read
    std::vector<std::int64_t> times{};
};

enum class McapEncoding { json, ros2, ros1, unread };

struct McapSource {
    RecordedTopic* topic;
    McapEncoding encoding;
    std::shared_ptr<const RosDefinition> definition;
};

class McapReader {
public:
    McapReader(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

    ForeignTable read() {
        const McapTaker taker{[&](McapSchema schema) { schemas_.try_emplace(schema.id, std::move(schema)); },
                              [&](McapChannel channel) { channels_.try_emplace(channel.id, std::move(channel)); },
                              [&](const McapMessage& message) { take(message); }};
        McapScan scan = scanMcap(bytes_, file_, taker);
        const bool own = scan.program.starts_with(kMcapOfTread);
        ForeignTable table{file_, std::string(own ? kOwnMcap : "MCAP file"), {}, {}, std::move(scan.notes)};
        if (orphans_ > 0) table.notes.push_back(counted(orphans_, "message") + " of unknown topics left out");
        finishTopics(table);
        const std::int64_t zero = chooseTimes(table);
        for (const auto& topic : topics_) addColumns(*topic, own, zero, table);
        return table;
    }

private:
    [[noreturn]] void fail(const std::string& text) const { throw LoadError({{file_, 0, 0, "", text}}); }

    void take(const McapMessage& message) {
        const McapSource* const source = sourceOf(message.channel);
        if (!source) return void(++orphans_);
        RecordedTopic& topic = *source->topic;
        if (source->encoding == McapEncoding::unread) return;
        TopicTable& table = topic.table;
        const std::size_t had_columns = table.columns.size(), had_values = had_columns * table.rows();
        const bool in_time = message.time <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
        if (in_time && readMessage(*source, message.bytes)) {
            table.endRow(static_cast<std::int64_t>(message.time));
        } else {
            table.dropRow();
            ++topic.damaged;
        }
        columns_ += table.columns.size() - had_columns;
        values_ += table.columns.size() * table.rows() - had_values;
        if (columns_ > kMostMcapColumns || values_ > kMostMcapValues)
            fail(
                fmt::format("has more than {} columns or {} numbers in its messages, expected the recording of a drive",
                            kMostMcapColumns, kMostMcapValues));
    }

    static bool readMessage(const McapSource& source, std::string_view bytes) {
        if (source.encoding == McapEncoding::json) return readJsonMessage(bytes, source.topic->table);
        const RosWire wire = source.encoding == McapEncoding::ros1 ? RosWire::ros1 : RosWire::cdr;
        return readRosMessage(*source.definition, wire, bytes, source.topic->table, source.topic->passed_over);
    }

    const McapSource* sourceOf(std::uint16_t id) {
        if (const auto known = sources_.find(id); known != sources_.end()) return &known->second;
        const auto channel = channels_.find(id);
        if (channel == channels_.end()) return nullptr;
        return &sources_.emplace(id, open(channel->second)).first->second;
    }

    McapSource open(const McapChannel& channel) {
        McapSource source{&topicNamed(channel.topic), McapEncoding::unread, nullptr};
        const auto schema = schemas_.find(channel.schema);
        const std::string described = schema == schemas_.end() ? "" : schema->second.encoding;
        if (channel.encoding == "json") {
            source.encoding = McapEncoding::json;
            if (described == "jsonschema") declare(schema->second.text, *source.topic);
        } else if ((channel.encoding == "cdr" && described == "ros2msg") ||
                   (channel.encoding == "ros1" && described == "ros1msg")) {
            source.definition = std::make_shared<RosDefinition>(schema->second.name, schema->second.text);
            source.topic->fault = source.definition->fault();
            if (source.topic->fault.empty())
                source.encoding = channel.encoding == "cdr" ? McapEncoding::ros2 : McapEncoding::ros1;
        } else {
            source.topic->fault = "its messages are " + quote(channel.encoding) +
                                  (described.empty() ? std::string() : ", described by " + quote(described));
        }
        return source;
    }

    RecordedTopic& topicNamed(const std::string& name) {
        for (const auto& topic : topics_) {
            if (topic->name == name) return *topic;
        }
        topics_.push_back(std::make_unique<RecordedTopic>());
        topics_.back()->name = name;
        return *topics_.back();
    }

    static void declare(const std::string& schema, RecordedTopic& topic) {
        for (const JsonProperty& property : jsonProperties(schema)) {
            const bool unit = property.description == "-" || !spelledUnit(property.description).empty();
            topic.table.declare(property.name, unit ? property.description : "");
            topic.titles.emplace(property.name, property.title);
        }
    }

    // Topics without numbers go; those of commands come last.
    void finishTopics(ForeignTable& table) {
        std::string unread;
        for (const auto& topic : topics_) {
            topic->table.finish();
            if (!topic->fault.empty()) {
                unread = "topic " + topic->name + ": " + topic->fault + ", which tread does not read";
                table.notes.push_back(unread);
            }
            if (topic->damaged > 0)
                table.notes.push_back(fmt::format("topic {}: {} that cannot be read left out", topic->name,
                                                  counted(topic->damaged, "message")));
            if (!topic->passed_over.empty())
                table.notes.push_back(fmt::format("topic {}: covariances and long arrays left out ({})", topic->name,
                                                  listedPaths(topic->passed_over)));
        }
        std::erase_if(topics_,
                      [](const auto& topic) { return topic->table.rows() == 0 || topic->table.columns.empty(); });
        if (topics_.empty()) {
            fail(
                "holds no numbers that tread reads, expected messages in JSON or of ROS (cdr with ros2msg, ros1 with "
                "ros1msg)" +
                (table.notes.empty() ? std::string() : "; " + table.notes.front()));
        }
        std::stable_partition(topics_.begin(), topics_.end(),
                              [](const auto& topic) { return !isCommand(topic->name); });
    }

    static std::string listedPaths(const std::vector<std::string>& paths) {
        std::string text;
        for (const std::string& path : paths) text += (text.empty() ? "" : ", ") + path;
        return text;
    }

    static bool isCommand(const std::string& name) {
        return std::any_of(std::begin(kCommandWords), std::end(kCommandWords),
                           [&](std::string_view word) { return name.find(word) != std::string::npos; });
    }

    // The stamps of the messages where they are of one clock, else the times of logging; in order. Returns the
    // earliest.
    std::int64_t chooseTimes(ForeignTable& table) {
        const bool all =
            std::all_of(topics_.begin(), topics_.end(), [](const auto& topic) { return !topic->table.stamps.empty(); });
        const double clock = all ? lead(topics_.front()->table) : 0;
        std::string stamped;
        std::int64_t earliest = std::numeric_limits<std::int64_t>::max();
        for (const auto& topic : topics_) {
            TopicTable& rows = topic->table;
            const bool has = !rows.stamps.empty(), same = has && std::abs(lead(rows) - clock) <= kSameClock;
            topic->times = same ? rows.stamps : rows.logged;
            if (same) stamped += (stamped.empty() ? "" : ", ") + topic->name;
            if (has && !same)
                table.notes.push_back(fmt::format(
                    "topic {}: its stamps are of another clock than those of logging ({:+.6g} s); the times of logging "
                    "were taken",
                    topic->name, lead(rows)));
            sortRows(*topic, table);
            earliest = std::min(earliest, topic->times.front());
        }
        if (!stamped.empty()) table.notes.push_back("the time of " + stamped + " is that of their stamps");
        if (earliest != 0)
            table.notes.push_back(fmt::format("time counts from {}.{:09} s, the first message",
                                              earliest / 1'000'000'000, earliest % 1'000'000'000));
        return earliest;
    }

    // Of the stamps before the times of logging, s.
    static double lead(const TopicTable& table) {
        return 1e-9 * (static_cast<double>(table.stamps.front()) - static_cast<double>(table.logged.front()));
    }

    static void sortRows(RecordedTopic& topic, ForeignTable& table) {
        std::vector<std::size_t> order(topic.times.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        const auto at = [&](std::size_t i) { return topic.times[i]; };
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return at(a) < at(b); });
        const auto repeated =
            std::unique(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return at(a) == at(b); });
        const auto dropped = static_cast<std::size_t>(order.end() - repeated);
        order.erase(repeated, order.end());
        if (dropped > 0)
            table.notes.push_back(
                fmt::format("topic {}: {} with a repeated time dropped", topic.name, counted(dropped, "message")));
        const auto reorder = [&](auto& list) {
            auto sorted = list;
            sorted.clear();
            for (const std::size_t i : order) sorted.push_back(list[i]);
            list = std::move(sorted);
        };
        for (TopicTable::Column& column : topic.table.columns) reorder(column.values);
        reorder(topic.times);
    }

    void addColumns(RecordedTopic& topic, bool own, std::int64_t zero, ForeignTable& table) {
        const std::string time = timeColumn(topic, own, zero, table);
        for (TopicTable::Column& column : topic.table.columns) {
            const auto title = topic.titles.find(column.path);
            const bool titled = own && title != topic.titles.end() && !title->second.empty();
            std::string name = titled ? title->second : topic.name + "." + column.path;
            table.columns.push_back({std::move(name), column.unit, std::move(column.values), 0, 0, {}, time});
        }
    }

    // Topics with equal times share a column.
    std::string timeColumn(const RecordedTopic& topic, bool own, std::int64_t zero, ForeignTable& table) {
        for (const auto& other : topics_) {
            if (other.get() == &topic) break;
            if (other->times == topic.times) return time_columns_.at(other.get());
        }
        const bool first = table.columns.empty();
        const bool taken = std::any_of(topic.table.columns.begin(), topic.table.columns.end(),
                                       [](const TopicTable::Column& column) { return column.path == "time"; });
        std::string name = own && first ? "time" : topic.name + (taken ? ".log_time" : ".time");
        std::vector<double> seconds;
        // One rounding: a decimal number of seconds comes back as it was written.
        for (const std::int64_t t : topic.times) seconds.push_back(static_cast<double>(t - zero) / 1e9);
        table.columns.push_back({name, "s", std::move(seconds), 0, 0, {}, name});
        return time_columns_[&topic] = name;
    }

    std::string_view bytes_;
    const std::string& file_;
    std::map<std::uint16_t, McapSchema> schemas_;
    std::map<std::uint16_t, McapChannel> channels_;
    std::map<std::uint16_t, McapSource> sources_;
    std::vector<std::unique_ptr<RecordedTopic>> topics_;
    std::map<const RecordedTopic*, std::string> time_columns_;
    std::size_t orphans_ = 0, columns_ = 0, values_ = 0;
};

}  // namespace

ForeignTable parseMcap(std::string_view bytes, const std::string& file) {
    return McapReader(bytes, file).read();
}

}  // namespace tread
