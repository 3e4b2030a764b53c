#include "import/formats/mcap/topic_table.h"

#include <algorithm>
#include <set>

#include "import/formats/foreign_text.h"

namespace tread {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;  // ns
constexpr double kLatestStamp = 9e9;             // s, within 64 bits of nanoseconds

// The stamps of ROS and of the schemas of Foxglove.
constexpr std::string_view kStamps[] = {"header.stamp", "stamp", "timestamp"};

// "stamp" of "stamp.nanosec", as ROS 2 and 1 and JSON call it; empty for other columns.
std::string_view timeWithNanoseconds(std::string_view path) {
    for (const std::string_view end : {".nanosec", ".nsec", ".nsecs"}) {
        if (path.ends_with(end)) return path.substr(0, path.size() - end.size());
    }
    return {};
}

// Up to the first that is no time after 1970 or cannot be held.
std::vector<std::int64_t> nanosecondsOf(const std::vector<double>& seconds, const std::vector<double>& fine) {
    std::vector<std::int64_t> out;
    for (std::size_t i = 0; i < seconds.size(); ++i) {
        const bool good =
            seconds[i] >= 0 && seconds[i] < kLatestStamp && fine[i] >= 0 && fine[i] < 1e9 && seconds[i] + fine[i] > 0;
        if (!good) break;
        out.push_back(static_cast<std::int64_t>(seconds[i]) * kSecond + static_cast<std::int64_t>(fine[i]));
    }
    return out;
}

}  // namespace

std::size_t TopicTable::indexOf(std::string_view path, std::string_view unit) {
    if (next_ < columns.size() && columns[next_].path == path) return next_;
    if (const auto found = index_.find(path); found != index_.end()) return found->second;
    index_.emplace(path, columns.size());
    columns.push_back({std::string(path), std::string(unit), {}, false});
    return columns.size() - 1;
}

void TopicTable::declare(std::string_view path, std::string_view unit) {
    columns[indexOf(path, unit)].declared = true;
}

void TopicTable::value(std::string_view path, double value, std::string_view unit) {
    const std::size_t index = indexOf(path, unit);
    row_.emplace_back(index, value);
    next_ = index + 1;
}

void TopicTable::endRow(std::int64_t time) {
    for (const auto& [index, value] : row_) {
        std::vector<double>& values = columns[index].values;
        values.resize(rows() + 1, kNoNumber);
        values.back() = value;
    }
    row_.clear();
    next_ = 0;
    logged.push_back(time);
}

void TopicTable::finish() {
    joinTimes();
    std::erase_if(columns, [](const Column& column) { return column.values.empty() && !column.declared; });
    for (Column& column : columns) column.values.resize(rows(), kNoNumber);
}

void TopicTable::joinTimes() {
    for (Column& column : columns) {
        if (!column.values.empty()) column.values.resize(rows(), kNoNumber);
    }
    std::vector<Column> kept;
    std::set<std::size_t> parts;
    for (std::size_t fine = 0; fine < columns.size(); ++fine) {
        const std::string name(timeWithNanoseconds(columns[fine].path));
        const auto coarse = name.empty() ? index_.end() : index_.find(name + ".sec");
        const auto other = name.empty() ? index_.end() : index_.find(name + ".secs");
        if (coarse == index_.end() && other == index_.end()) continue;
        const std::size_t seconds = coarse != index_.end() ? coarse->second : other->second;
        if (columns[fine].values.size() != columns[seconds].values.size()) continue;  // one has none
        parts.insert({fine, seconds});
        std::vector<std::int64_t> ns = nanosecondsOf(columns[seconds].values, columns[fine].values);
        if (std::find(std::begin(kStamps), std::end(kStamps), name) != std::end(kStamps)) {
            if (stamps.empty() && ns.size() == rows()) stamps = std::move(ns);
            continue;
        }
        Column joined{name, "s", {}, false};
        for (std::size_t i = 0; i < columns[fine].values.size(); ++i)
            joined.values.push_back(columns[seconds].values[i] + 1e-9 * columns[fine].values[i]);
        kept.push_back(std::move(joined));
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (!parts.contains(i)) kept.push_back(std::move(columns[i]));
    }
    columns = std::move(kept);
    index_.clear();
}

}  // namespace tread
