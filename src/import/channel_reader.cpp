#include "import/channel_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/text/number_text.h"
#include "import/columns.h"
#include "import/formats/unit_spelling.h"
#include "import/time_base.h"
#include "log/direction.h"
#include "log/log_columns.h"
#include "log/resample.h"

namespace tread {
namespace {

[[noreturn]] void refuse(const std::string& path, std::string text) {
    throw LoadError({{"", 0, 0, path, std::move(text)}});
}

class ChannelReader {
public:
    ChannelReader(const ForeignTable& table, const ImportMap& map, const std::vector<double>& time,
                  std::vector<Change>& changes)
        : table_(table), map_(map), time_(time), changes_(changes) {}

    WholeChannel read(std::size_t index) {
        const ImportChannel& how = map_.map[index];
        path_ = "map." + std::to_string(index);
        WholeChannel channel{&how, "", std::vector<double>(time_.size(), 0)};
        const std::size_t columns = 1 + how.mean_with.size();
        addColumn(channel, how.from, path_ + ".from", columns);
        for (std::size_t i = 0; i < how.mean_with.size(); ++i) {
            addColumn(channel, how.mean_with[i], path_ + ".mean_with." + std::to_string(i), columns);
        }
        reportFactors(how, columns);
        return channel;
    }

private:
    void addColumn(WholeChannel& channel, const std::string& name, const std::string& path, std::size_t columns) {
        const ForeignColumn& column = foreignColumn(table_, name, path);
        expectNumbers(column);
        const Scaling scaling = scalingOf(channel, column);
        const ImportChannel& how = *channel.how;
        const double factor = how.sign * how.scale / how.rolling_radius.value_or(1) / static_cast<double>(columns);
        std::vector<double> own;
        for (const double value : column.values) own.push_back(scaling(value));
        if (isDirection(how.channel)) own = withoutWraps(how, std::move(own));
        const std::vector<double> values = onRows(channel, column, std::move(own), path);
        for (std::size_t i = 0; i < values.size(); ++i)
            channel.values[i] += factor * (how.curve.empty() ? values[i] : how.curve(values[i]));
    }

    // A wrapped direction cannot be interpolated: between the two samples of a wrap it would point backwards.
    std::vector<double> withoutWraps(const ImportChannel& how, std::vector<double> angles) {
        std::vector<double> direction = continuous(angles);
        if (direction != angles) note("turns", how.channel, "unwrapped: jumps by a whole turn removed");
        return direction;
    }

    // From the unit of the column to that of the channel, which is fixed for the channels that tread has.
    Scaling scalingOf(WholeChannel& channel, const ForeignColumn& column) {
        const ImportChannel& how = *channel.how;
        const auto known = logUnit(how.channel);
        const std::string path = path_ + (how.unit.empty() ? ".from" : ".unit");
        const auto foreign = foreignUnit(column, how.unit, path);
        if (how.rolling_radius) {
            channel.unit = "rad/s";
            if (known && *known != channel.unit) {
                refuse(path_ + ".rolling_radius", "found a radius, which makes a speed a spin (rad/s), expected " +
                                                      std::string(*known) + " for " + how.channel);
            }
            return scalingTo(foreign.value_or("m/s"), "m/s", path, column);
        }
        if (!known && !foreign) {
            channel.unit = column.unit.empty() ? "-" : column.unit;
            note("unit", how.channel,
                 column.unit.empty() ? "no unit given, treated as a pure number"
                                     : "unknown unit " + quote(column.unit) + ", kept as it is");
            return {};
        }
        if (!foreign && *known != "-") {
            refuse(path_ + ".from", "column " + quote(column.name) + " of " + table_.file + " has " +
                                        (column.unit.empty() ? "no unit" : "the unknown unit " + quote(column.unit)) +
                                        ", expected one like " + std::string(*known) + "; add a line unit");
        }
        const std::string from = foreign.value_or("-");
        channel.unit = known ? std::string(*known) : siUnitOf(from);
        const Scaling scaling = scalingTo(from, channel.unit, path, column);
        const bool same = scaling.numerator == scaling.denominator && scaling.offset == 0;
        if (!same) note("unit", how.channel, from + " to " + (channel.unit == "-" ? "a fraction" : channel.unit));
        return scaling;
    }

    // The values on the rows of the file's time base. The mapping or else the file says when a column has its own time.
    std::vector<double> onRows(WholeChannel& channel, const ForeignColumn& column, std::vector<double> values,
                               const std::string& path) {
        const ImportChannel& how = *channel.how;
        const bool mapped = !how.time.empty();
        const std::string own_name = mapped ? how.time : map_.time.from.empty() ? "" : column.time;
        if (own_name.empty() || (!mapped && own_name == map_.time.from)) {
            if (values.size() == time_.size()) return values;
            refuse(path, fmt::format("found {} values in column {}, but {} in time: another sampling rate; name the "
                                     "column with its own time (time)",
                                     values.size(), quote(column.name), time_.size()));
        }
        ImportTime own;
        own.from = own_name;
        if (mapped) {
            own.unit = map_.time.unit;
            own.format = map_.time.format;
        }
        std::vector<Change> ignored;
        const std::vector<double> own_time = timeOfRows(table_, own, ignored);
        if (own_time.size() != values.size()) {
            refuse(path_ + ".time", fmt::format("found {} values in column {}, but {} in column {}, its time",
                                                values.size(), quote(column.name), own_time.size(), quote(own_name)));
        }
        for (std::size_t i = 1; i < own_time.size(); ++i) {
            if (own_time[i] > own_time[i - 1]) continue;
            refuse(path_ + ".time",
                   fmt::format("column {} does not increase at value {}, expected a time", quote(own_name), i + 1));
        }
        std::vector<double> on_rows;
        for (const double t : time_) on_rows.push_back(valueAt(own_time, values, t));
        if (!own_time.empty()) {
            channel.first = std::max(channel.first, own_time.front());
            channel.last = std::min(channel.last, own_time.back());
        }
        note("rate", how.channel, "interpolated from its own time " + quote(own_name));
        return on_rows;
    }

    void reportFactors(const ImportChannel& how, std::size_t columns) {
        if (columns > 1) note("mean", how.channel, fmt::format("mean of {} columns", columns));
        if (how.sign < 0) note("sign", how.channel, "sign reversed");
        if (!how.curve.empty())
            note("curve", how.channel, fmt::format("by a curve of {} points", how.curve.points.size()));
        if (how.scale != 1) note("scale", how.channel, "multiplied by " + numberText(how.scale));
        if (how.rolling_radius) {
            note("scale", how.channel, "speed over a rolling radius of " + numberText(*how.rolling_radius) + " m");
        }
    }

    void note(std::string kind, const std::string& channel, std::string text) {
        if (!changes_.empty() && changes_.back().channel == channel && changes_.back().text == text) return;
        changes_.push_back({std::move(kind), channel, time_.size(), std::move(text)});
    }

    const ForeignTable& table_;
    const ImportMap& map_;
    const std::vector<double>& time_;
    std::vector<Change>& changes_;
    std::string path_;
};

}  // namespace

WholeChannel readChannel(const ForeignTable& table, const ImportMap& map, std::size_t index,
                         const std::vector<double>& time, std::vector<Change>& changes) {
    return ChannelReader(table, map, time, changes).read(index);
}

}  // namespace tread
