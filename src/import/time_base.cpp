#include "import/time_base.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/math/median.h"
#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "import/columns.h"
#include "import/formats/foreign_text.h"

namespace tread {
namespace {

constexpr double kHour = 3600, kDay = 86400;  // s
constexpr double kGap = 1.5;                  // steps of this many medians lack a sample
constexpr double kMostMissing = 1e9;          // samples in a gap: if there are more, their number tells nothing
constexpr double kJitter = 0.2;               // steps that differ by more than this share are uneven

double secondsOfClock(double hhmmss) {
    const double hours = std::floor(hhmmss / 10000), minutes = std::floor(hhmmss / 100) - 100 * hours;
    return hours * kHour + minutes * 60 + (hhmmss - 10000 * hours - 100 * minutes);
}

std::string placeOf(const ForeignTable& table, std::size_t row) {
    return table.lines.empty() ? fmt::format("sample {}", row + 1) : fmt::format("line {}", table.lines[row]);
}

// One recording after the other, as the rows come.
class Sorter {
public:
    Sorter(const ForeignTable& table, double max_jump) : table_(table), max_jump_(max_jump) {}

    void take(std::size_t row, double t) {
        if (!std::isfinite(t)) {
            ++without_time;
        } else if (recordings.empty() || t > last_ + max_jump_ || t < last_ - max_jump_) {
            if (!recordings.empty()) {
                jumps.push_back(fmt::format("time jumps by {:+.4g} s at {}", t - last_, placeOf(table_, row)));
            }
            recordings.push_back({{row}, {0}, t});
            last_ = t;
        } else if (t < last_) {
            note(backwards, first_backwards, row);
        } else {
            append(recordings.back(), row, t);
            last_ = t;
        }
    }

    // One or two rows with a wild time amid a recording are no recording of their own.
    void rejoin() {
        constexpr std::size_t kWild = 2;
        for (std::size_t i = 1; i + 1 < recordings.size();) {
            Stretch &before = recordings[i - 1], &behind = recordings[i + 1];
            const double step = behind.begin - (before.begin + before.duration());
            if (recordings[i].rows.size() > kWild || !(step > 0) || step > max_jump_) {
                ++i;
                continue;
            }
            wild += recordings[i].rows.size();
            for (std::size_t k = 0; k < behind.rows.size(); ++k)
                append(before, behind.rows[k], behind.begin + behind.time[k]);
            const auto at = static_cast<std::ptrdiff_t>(i);
            recordings.erase(recordings.begin() + at, recordings.begin() + at + 2);
            jumps.erase(jumps.begin() + at - 1, jumps.begin() + at + 1);
        }
    }

    std::vector<Stretch> recordings;
    std::vector<std::string> jumps;
    std::size_t wild = 0;
    std::size_t without_time = 0, duplicates = 0, backwards = 0;
    std::string first_duplicate, first_backwards;

private:
    // `t` on the clock of the file. Times that differ there may be the same from the first one on.
    void append(Stretch& recording, std::size_t row, double t) {
        const double since = t - recording.begin;
        if (since > recording.time.back()) recording.rows.push_back(row), recording.time.push_back(since);
        else note(duplicates, first_duplicate, row);
    }

    void note(std::size_t& count, std::string& first, std::size_t row) {
        if (count++ == 0) first = placeOf(table_, row);
    }

    const ForeignTable& table_;
    double max_jump_;
    double last_ = 0;
};

void reportSteps(const Stretch& recording, std::vector<Change>& changes) {
    const double usual = medianStep(recording.time);
    std::size_t gaps = 0, uneven = 0, missing = 0;
    double longest = 0;
    for (std::size_t i = 1; i < recording.time.size(); ++i) {
        const double step = recording.time[i] - recording.time[i - 1];
        if (step > kGap * usual) {
            ++gaps;
            missing += static_cast<std::size_t>(std::min(std::round(step / usual), kMostMissing)) - 1;
            longest = std::max(longest, step);
        } else if (std::abs(step - usual) > kJitter * usual) {
            ++uneven;
        }
    }
    if (gaps > 0) {
        changes.push_back(
            {"gaps", "", gaps,
             fmt::format(
                 "{} in time, about {} missing, the longest step {:.4g} s instead of {:.4g} s; nothing was inserted",
                 counted(gaps, "gap"), counted(missing, "sample"), longest, usual)});
    }
    if (uneven > 0) {
        changes.push_back({"uneven", "", uneven,
                           fmt::format("{} of time differ by more than 20 % from the usual {:.4g} s; kept",
                                       counted(uneven, "step"), usual)});
    }
}

}  // namespace

std::vector<double> timeOfRows(const ForeignTable& table, const ImportTime& how, std::vector<Change>& changes) {
    std::vector<double> time;
    if (how.from.empty()) {
        if (!how.rate) {
            throw LoadError({{"", 0, 0, "time",
                              "found neither a time column (from) nor a sampling rate (rate); give one of them"}});
        }
        std::size_t rows = 0;
        for (const ForeignColumn& column : table.columns) rows = std::max(rows, column.values.size());
        for (std::size_t i = 0; i < rows; ++i) time.push_back(static_cast<double>(i) / *how.rate);
        changes.push_back({"time", "", rows, fmt::format("time was generated at {:.6g} Hz", *how.rate)});
        return time;
    }
    const ForeignColumn& column = foreignColumn(table, how.from, "time.from");
    expectNumbers(column);
    if (how.format == TimeFormat::hhmmss) {
        double days = 0, last = 0;
        for (const double value : column.values) {
            const double seconds = secondsOfClock(value);
            if (seconds < last - kDay / 2) days += kDay;  // past midnight
            last = seconds;
            time.push_back(seconds + days);
        }
        return time;
    }
    const std::string unit = foreignUnit(column, how.unit, "time.unit", "s").value_or("s");
    const Scaling scaling = scalingTo(unit, "s", "time.unit", column);
    for (const double value : column.values) time.push_back(scaling(value));
    if (unit != "s") changes.push_back({"unit", "time", time.size(), "time: " + unit + " to s"});
    return time;
}

std::vector<Stretch> recordingsOf(const std::vector<double>& time, const ForeignTable& table,
                                  const ImportRepairs& repairs, std::vector<Change>& changes) {
    Sorter sorter(table, repairs.max_jump);
    for (std::size_t row = 0; row < time.size(); ++row) sorter.take(row, time[row]);
    sorter.rejoin();
    std::vector<Stretch> recordings = std::move(sorter.recordings);
    if (recordings.empty()) {
        throw LoadError({{table.file, 0, 0, "", "the time column holds no numbers, expected increasing seconds"}});
    }
    if (sorter.without_time > 0) {
        changes.push_back(
            {"without_time", "", sorter.without_time, counted(sorter.without_time, "row") + " without a time dropped"});
    }
    if (sorter.duplicates > 0) {
        changes.push_back({"duplicates", "", sorter.duplicates,
                           fmt::format("{} with a repeated time stamp dropped (the first at {})",
                                       counted(sorter.duplicates, "row"), sorter.first_duplicate)});
    }
    if (sorter.backwards > 0) {
        changes.push_back({"backwards", "", sorter.backwards,
                           fmt::format("{} with an earlier time than the one before dropped (the first at {})",
                                       counted(sorter.backwards, "row"), sorter.first_backwards)});
    }
    if (sorter.wild > 0) {
        changes.push_back({"wild_time", "", sorter.wild,
                           counted(sorter.wild, "row") + " with a time that does not fit its neighbours dropped"});
    }
    if (recordings.size() > 1) {
        if (repairs.at_jump == AtJump::refuse) {
            throw LoadError({{table.file, 0, 0, "",
                              sorter.jumps.front() + ", expected one recording (repairs.at_jump: "
                                                     "longest keeps the longest, split all)"}});
        }
        const std::string where =
            sorter.jumps.front() +
            (sorter.jumps.size() > 1 ? fmt::format(" and {} more times", sorter.jumps.size() - 1) : std::string());
        if (repairs.at_jump == AtJump::split) {
            changes.push_back({"jump", "", sorter.jumps.size(),
                               fmt::format("{}; split into {} recordings", where, recordings.size())});
        } else {
            const auto shorter = [](const Stretch& a, const Stretch& b) { return a.rows.size() < b.rows.size(); };
            const Stretch longest = *std::max_element(recordings.begin(), recordings.end(), shorter);
            std::size_t rows = 0;
            for (const Stretch& recording : recordings) rows += recording.rows.size();
            changes.push_back(
                {"jump", "", rows - longest.rows.size(),
                 fmt::format("{}; {} cut off, the longest recording kept ({:.4g} s from {:.6g} s)", where,
                             counted(rows - longest.rows.size(), "row"), longest.duration(), longest.begin)});
            recordings = {longest};
        }
    }
    for (const Stretch& recording : recordings) {
        if (recording.begin != 0) {
            changes.push_back(
                {"time", "", 1, fmt::format("time begins at 0 (in the file at {:.9g} s)", recording.begin)});
        }
        reportSteps(recording, changes);
    }
    return recordings;
}

}  // namespace tread
