// Verdicts on a page, in words and colour.
#pragma once

#include <string_view>
#include <vector>

#include "metrics/verdict.h"
#include "report/html.h"

namespace tread {

// The answer, behind a badge that says whether the run is accepted, and of each condition how much is to spare, large;
// without conditions the answer alone.
void answerWithVerdict(HtmlPage& page, std::string_view answer, const std::vector<Verdict>& verdicts);

// A table of all verdicts; nothing without conditions.
void addVerdicts(HtmlPage& page, const std::vector<Verdict>& verdicts);

// All verdicts of a run in one cell.
Cell verdictCell(const std::vector<Verdict>& verdicts);

}  // namespace tread
