#include "report/verdict_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/text.h"

namespace tread {
namespace {

std::string titleOf(const Verdict& verdict) {
    return verdict.title.empty() ? verdict.metric : verdict.title;
}

// Of the verdicts on one condition the one that is nearest to its limit, or farthest beyond it.
std::vector<Verdict> tightest(const std::vector<Verdict>& verdicts) {
    std::vector<Verdict> out;
    const auto rank = [](const Verdict& verdict) {
        if (std::isnan(verdict.value)) return -std::numeric_limits<double>::infinity();
        return verdict.margin.value_or(verdict.met ? 0 : -1);
    };
    for (const Verdict& verdict : verdicts) {
        const auto same = std::find_if(out.begin(), out.end(), [&](const Verdict& other) {
            return other.metric == verdict.metric && other.condition == verdict.condition;
        });
        if (same == out.end()) out.push_back(verdict);
        else if (rank(verdict) < rank(*same)) *same = verdict;
    }
    return out;
}

Card cardOf(const Verdict& verdict) {
    const std::string margin = marginInWords(verdict), word = verdict.met ? " to spare" : " beyond";
    const std::string number = margin.substr(0, margin.rfind(word));
    return {.label = titleOf(verdict) + (verdict.run.empty() ? "" : ", run " + verdict.run),
            .value = margin.empty() ? (verdict.met ? "met" : "missed") : number,
            .unit = margin.empty() ? "" : word.substr(1),
            .note = fmt::format("{}, required {}", valueInWords(verdict, 4), verdict.condition),
            .tone = verdict.met ? Tone::good : Tone::bad};
}

}  // namespace

void answerWithVerdict(HtmlPage& page, std::string_view answer, const std::vector<Verdict>& verdicts) {
    if (verdicts.empty()) return page.answer(answer);
    const bool met = allMet(verdicts);
    page.answer(answer, met ? "accepted" : "not accepted", met);
    std::vector<Card> cards;
    for (const Verdict& verdict : tightest(verdicts)) cards.push_back(cardOf(verdict));
    page.cards(cards);
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
        row.push_back({.text = titleOf(verdict), .note = verdict.title.empty() ? "" : verdict.metric});
        row.push_back({.text = valueInWords(verdict), .number = true, .alarm = !verdict.met});
        row.push_back({.text = verdict.condition});
        row.push_back({.text = marginInWords(verdict), .number = true});
        row.push_back(verdictCell({verdict}));
        rows.push_back(std::move(row));
    }
    std::vector<std::string> header{"Metric", "Value", "Condition", "Margin", "Verdict"};
    if (several) header.insert(header.begin(), "Run");
    constexpr std::size_t kMostVerdictsOpen = 12;  // rows: more are folded away, the tightest stand above
    const bool fold = rows.size() > kMostVerdictsOpen;
    if (fold) page.fold(fmt::format("All {} verdicts", rows.size()));
    page.table(header, rows);
    if (fold) page.unfold();
}

Cell verdictCell(const std::vector<Verdict>& verdicts) {
    if (verdicts.empty()) return {.text = ""};
    std::string missed;
    for (const Verdict& verdict : verdicts) {
        if (!verdict.met) missed += (missed.empty() ? "missed: " : ", ") + titleOf(verdict);
    }
    if (missed.empty()) return {.text = "met", .good_news = true};
    return {.text = verdicts.size() == 1 ? "missed" : missed, .alarm = true};
}

}  // namespace tread
