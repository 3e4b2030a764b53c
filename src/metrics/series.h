// One channel over time, and what metrics ask of it: at any sampling rate, straight lines between the samples.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace tread {

struct TimeSeries {
    std::vector<double> time;   // s, increasing, at least one sample
    std::vector<double> value;  // one per time

    std::size_t size() const { return time.size(); }
    double begin() const { return time.front(); }
    double end() const { return time.back(); }
};

struct Instant {
    double time;
    double value;
};

struct Range {
    double least;
    double most;

    double width() const { return most - least; }
};

struct Line {
    double offset;  // value at x = 0
    double slope;
};

double at(const TimeSeries& series, double t);                      // held beyond the ends
double integral(const TimeSeries& series, double from, double to);  // within the series
double mean(const TimeSeries& series, double from, double to);  // time-weighted; at(from) when the interval is empty
TimeSeries part(const TimeSeries& series, double from, double to);  // the samples within, and the values at both ends
TimeSeries increments(const TimeSeries& series, double level, double factor = 1);  // factor (value - level)

// First time from `from` on at which the series reaches the level, from either side.
std::optional<double> firstCrossing(const TimeSeries& series, double level, double from,
                                    double to = std::numeric_limits<double>::infinity());
std::optional<double> lastCrossing(const TimeSeries& series, double level, double from, double to);

// Largest value within the interval; the parabola through its neighbours gives it between the samples.
Instant highest(const TimeSeries& series, double from, double to);
Instant lowest(const TimeSeries& series, double from, double to);

// Of the samples themselves, without a parabola.
double largestSample(const TimeSeries& series);  // magnitude
Range range(const TimeSeries& series);

// Where the series turns back by at least `swing`, alternately up and down; not its first and last sample.
std::vector<Instant> turningPoints(const TimeSeries& series, double swing);

// Least-squares line.
Line fitLine(std::span<const double> x, std::span<const double> y);

}  // namespace tread
