// The score of a blind check as tables, common to text and HTML report.
#pragma once

#include <string>
#include <vector>

#include "blind/score/score.h"

namespace tread::blind::score {

struct ScoreTable {
    struct Row {
        std::vector<std::string> cells;
        double share = 0;     // of hits, 0 to 1
        bool missed = false;  // the target
    };
    std::string title;
    std::vector<std::string> header;
    std::vector<Row> rows;
    std::size_t words = 1;  // number of leading text columns; the others are numbers
    std::string note = {};
};

// All tables that have rows, in reading order: figures of all cases, by detectability, by kind; outcomes; calibration;
// confusion.
std::vector<ScoreTable> scoreTables(const BlindScore& score);

ScoreTable overallTable(const BlindScore& score);

}  // namespace tread::blind::score
