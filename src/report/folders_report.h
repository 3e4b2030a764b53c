// One page over the comparison of two folders of runs.
#pragma once

#include <string>
#include <vector>

#include "compare/compare.h"
#include "compare/compare_metrics.h"

namespace tread {

struct ComparedRun {
    std::string name;     // of its folder
    std::string problem;  // why it was not compared, in a sentence; empty: it was
    bool failed = false;  // a problem that is a difference
    Comparison channels = {};
    bool has_channels = false;  // any were compared
    std::vector<MetricComparison> metrics = {};

    bool compared() const { return problem.empty(); }
    bool same() const;
};

struct FoldersReport {
    std::string answer;
    std::string reference;  // folder
    std::string candidate;
    std::string version;
    bool ok = false;
    std::vector<ComparedRun> runs;
};

// What differs in a run, one sentence each.
std::vector<std::string> differences(const ComparedRun& run);

std::string foldersReport(const FoldersReport& content);

}  // namespace tread
