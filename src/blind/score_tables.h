// The score of a blind check as tables, for text and page alike.
#pragma once

#include <string>
#include <vector>

#include "blind/score.h"

namespace tread {

struct ScoreTable {
    struct Row {
        std::vector<std::string> cells;
        double share = 0;     // of a figure: 0 to 1
        bool missed = false;  // what was asked for
    };
    std::string title;
    std::vector<std::string> header;
    std::vector<Row> rows;
    std::size_t words = 1;  // leading columns of words; numbers behind them
    std::string note = {};
};

// All tables that have rows, in the order in which one reads them: figures of all cases; the same by what the drives
// show, and by kind; what became of the cases; stated probabilities; what was answered to what.
std::vector<ScoreTable> scoreTables(const BlindScore& score);

ScoreTable overallTable(const BlindScore& score);

}  // namespace tread
