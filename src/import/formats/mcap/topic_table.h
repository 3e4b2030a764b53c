// The numbers of the messages of one topic, as columns with one row for each message.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace tread {

// Columns of a file, and values of all its columns (doubles: 2 GB): a drive has fewer, a hostile file could make any.
inline constexpr std::size_t kMostMcapColumns = 20000, kMostMcapValues = std::size_t{1} << 28;

// Elements of an array that become columns each; longer ones are images, scans and maps.
inline constexpr std::size_t kMostArrayColumns = 64;

class TopicTable {
public:
    struct Column {
        std::string path;  // within the message: "twist.linear.x", "ranges[3]"
        std::string unit;  // empty: nobody says
        std::vector<double> values;
        bool declared = false;
    };

    // A column that is there even if no message has it.
    void declare(std::string_view path, std::string_view unit);

    // The values of a message, then one of the two ends: a message that turns out to be damaged leaves no row.
    void value(std::string_view path, double value, std::string_view unit = {});
    void endRow(std::int64_t logged);
    void dropRow() { row_.clear(); }

    std::size_t rows() const { return logged.size(); }

    // All columns as long as there are rows. Two of seconds and nanoseconds (start.sec, start.nanosec) become one of
    // seconds (start), those of the message's own time (header.stamp, stamp or timestamp) the stamps.
    void finish();

    std::vector<Column> columns;
    std::vector<std::int64_t> logged;  // ns
    std::vector<std::int64_t> stamps;  // ns; empty unless every message has one

private:
    void joinTimes();
    std::size_t indexOf(std::string_view path, std::string_view unit);

    struct Hash : std::hash<std::string_view> {
        using is_transparent = void;
    };
    std::unordered_map<std::string, std::size_t, Hash, std::equal_to<>> index_;
    std::vector<std::pair<std::size_t, double>> row_;
    std::size_t next_ = 0;  // the column that is probably next
};

}  // namespace tread
