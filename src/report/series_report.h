// Pages over several runs: a series, with its metrics over what is varied, and the overview of a catalogue.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "metrics/metric.h"
#include "metrics/verdict.h"
#include "report/html.h"

namespace tread {

struct SeriesReport {
    struct Run {
        double value;  // of the number, SI
        bool passed;
        std::string failure;  // empty: none
        std::vector<Metric> metrics;
        std::string link;  // to its report, relative to the page; empty: it has none
    };
    std::string title;
    std::string answer;
    std::string vehicle;
    std::string scenario_description;
    std::string version;
    std::string number;  // path of what changes from run to run
    std::string unit;    // SI
    std::vector<Run> runs;
    std::string resolved_yaml;
    std::vector<Verdict> verdicts = {};
    double highest = std::numeric_limits<double>::quiet_NaN();  // value that passes, SI; NaN: not looked for, or none
    std::vector<Link> files = {};                               // beside the page
};
std::string seriesReport(const SeriesReport& content);

struct Overview {
    struct Entry {
        std::string scenario;  // name of its file
        std::string title;
        std::string answer;           // or why there is none
        std::vector<Metric> metrics;  // most important first
        std::vector<std::string> warnings;
        std::string link;
        bool driven;
        std::vector<Verdict> verdicts = {};
    };
    std::string title;
    std::string answer;
    std::string vehicle;
    std::string version;
    std::vector<Entry> entries;
};
std::string overviewReport(const Overview& content);

}  // namespace tread
