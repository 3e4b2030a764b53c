#include "report/verdict_table.h"

#include <cmath>

#include "report/text.h"

namespace tread {
namespace {

// In the unit of the metric, as the condition is read; the table of the metrics may show another.
std::string valueOf(const Verdict& verdict) {
    if (std::isnan(verdict.value)) return "could not be computed";
    const std::string number = formatNumber(verdict.value, 5);
    return verdict.unit.empty() || verdict.unit == "-" ? number : number + " " + prettyUnit(verdict.unit);
}

}  // namespace

void answerWithVerdict(HtmlPage& page, std::string_view answer, const std::vector<Verdict>& verdicts) {
    if (verdicts.empty()) return page.answer(answer);
    const bool met = allMet(verdicts);
    page.answer(answer, met ? "accepted" : "not accepted", met);
}

void addVerdicts(HtmlPage& page, const std::vector<Verdict>& verdicts) {
    if (verdicts.empty()) return;
    bool several = false;
    for (const Verdict& verdict : verdicts) several = several || !verdict.run.empty();
    page.section("Verdict");
    std::vector<std::vector<Cell>> rows;
    for (const Verdict& verdict : verdicts) {
        std::vector<Cell> row;
        if (several) row.push_back({.text = verdict.run});
        row.push_back({.text = verdict.metric});
        row.push_back({.text = valueOf(verdict), .number = true, .alarm = !verdict.met});
        row.push_back({.text = verdict.condition});
        row.push_back(verdictCell({verdict}));
        rows.push_back(std::move(row));
    }
    std::vector<std::string> header{"Metric", "Value", "Condition", "Verdict"};
    if (several) header.insert(header.begin(), "Run");
    page.table(header, rows);
}

Cell verdictCell(const std::vector<Verdict>& verdicts) {
    if (verdicts.empty()) return {.text = ""};
    std::string missed;
    for (const Verdict& verdict : verdicts) {
        if (!verdict.met) missed += (missed.empty() ? "missed: " : ", ") + verdict.metric;
    }
    if (missed.empty()) return {.text = "met", .good_news = true};
    return {.text = verdicts.size() == 1 ? "missed" : missed, .alarm = true};
}

}  // namespace tread
