// What a gap consists of, what remains of it, and what was left out.

#include <fmt/format.h>

#include <algorithm>

#include "diagnose/answer/parts.h"
#include "diagnose/answer/words.h"
#include "report/diagnosis_tables.h"
#include "report/text.h"

namespace tread {
namespace {

using diagnose::answer::capitalised;
using diagnose::answer::CausePart;
using diagnose::answer::Cut;
using diagnose::answer::Decomposition;
using diagnose::answer::Diagnosis;
using diagnose::answer::Part;
using diagnose::answer::PartKind;
using diagnose::answer::roundedPercent;
using diagnose::answer::Shares;
using diagnose::answer::ToldPart;
using diagnose::answer::Unexplained;
using DiagnosisVerdict = diagnose::answer::Verdict;

// Empty where there is none: a single drive does not tell how much drives differ.
std::string intervalOf(const Part& part) {
    if (part.low == part.high) return {};
    return fmt::format("{} to {}", roundedPercent(part.low), roundedPercent(part.high));
}

// The causes differ in colour; no more than three are named.
Fill fillOf(const ToldPart& part, std::size_t place) {
    constexpr Fill kCauses[] = {Fill::blue, Fill::sky, Fill::purple};
    switch (part.kind) {
        case PartKind::tolerances:
            return Fill::pale;
        case PartKind::cause:
            return kCauses[(place - 1) % std::size(kCauses)];
        case PartKind::shared:
        case PartKind::together:
            return Fill::striped;
        case PartKind::remainder:
            return Fill::warm;
        case PartKind::noise:
            return Fill::dotted;
    }
    return Fill::none;
}

void addTable(HtmlPage& page, const Decomposition& gap) {
    const bool several = gap.each.size() > 1;
    std::vector<std::string> header{"Part", "Share of the gap", "90 % interval"};
    if (several) header.insert(header.end(), {"First in", "Last in"});
    std::vector<std::vector<Cell>> rows;
    const std::vector<ToldPart> parts = toldParts(gap);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const ToldPart& part = parts[i];
        Cell name{capitalised(partInWords(part))};
        name.fill = fillOf(part, i);
        std::vector<Cell> row{name,
                              {roundedPercent(part.share), true, part.share < 0},
                              {part.interval ? intervalOf(*part.interval) : "", true}};
        if (several) {
            const auto cause = std::find_if(gap.each.begin(), gap.each.end(), [&](const CausePart& one) {
                return part.kind == PartKind::cause && one.name == part.causes.front();
            });
            const bool known = cause != gap.each.end();
            row.push_back({known ? roundedPercent(cause->first.share) : "", true});
            row.push_back({known ? roundedPercent(cause->last.share) : "", true});
        }
        rows.push_back(std::move(row));
    }
    page.table(header, rows);
}

void addGap(HtmlPage& page, const char* drives, const Decomposition& gap) {
    PartedBar bar{
        .title = fmt::format("{}: the gap is {} times that of a perfect model", drives, formatNumber(gap.gap, 3)),
        .pieces = {}};
    const std::vector<ToldPart> parts = toldParts(gap);
    for (std::size_t i = 0; i < parts.size(); ++i)
        bar.pieces.push_back(
            {partInWords(parts[i]), roundedPercent(parts[i].share), parts[i].drawn, fillOf(parts[i], i)});
    page.bar(bar);
    page.bullets(enlargingInWords(gap));
    addTable(page, gap);
    if (const std::string closed = diagnose::answer::closedInWords(gap); !closed.empty())
        page.text("Closed, as a share of what a model can close: " + closed + ".");
}

void addSharesTable(HtmlPage& page, const char* of, const Shares& shares) {
    constexpr double kLeast = 0.01;
    std::vector<std::pair<double, std::string>> order;
    for (const auto& [name, share] : shares)
        if (share >= kLeast) order.push_back({share, name});
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<std::vector<Cell>> rows;
    for (const auto& [share, name] : order) {
        Cell cell{roundedPercent(share), true};
        cell.bar = share;
        rows.push_back({{diagnose::answer::channelInWords(name)}, cell});
    }
    if (!rows.empty()) page.table({of, "Share of what remains"}, rows);
}

void addForces(HtmlPage& page, const Unexplained& rest) {
    std::vector<std::pair<double, std::string>> order;
    for (const auto& [kind, size] : rest.sizes) order.push_back({size, kind});
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    constexpr double kUsual = 1.5;  // up to it, a size is not shown
    std::vector<std::vector<Cell>> rows;
    for (const auto& [size, kind] : order) {
        if (size <= kUsual) break;
        Cell cell{formatNumber(size, 2), true};
        cell.bar = size / order.front().first;
        rows.push_back({{capitalised(diagnose::answer::kindOfForceInWords(kind))}, cell});
    }
    if (!rows.empty()) page.table({"What the model lacks", "Size relative to the usual size"}, rows);
    page.text(fmt::format("{} of {} kinds of disturbances and errors have at most {} times their usual size.",
                          order.size() - rows.size(), order.size(), kUsual));
}

}  // namespace

void addParts(HtmlPage& page, const Diagnosis& diagnosis) {
    page.text(
        "Squared difference between the recordings and the nominal car, each reading in units of the deviation that "
        "noise and usual disturbances cause. A part is the amount by which it reduces this squared difference.");
    if (diagnosis.training.each.size() > 1)
        page.text(
            "A cause counts with what it explains after all others (last in). Alone it may explain more (first in): "
            "what several causes explain equally well is shown as a separate part.");
    addGap(page, "Drives used for fitting", diagnosis.training);
    if (diagnosis.held_out.gap > 0) addGap(page, "Held-out drives", diagnosis.held_out);
    else page.text("No drive is held out: the parts are judged in the fitted drives, which is too optimistic.");
}

void addRemainder(HtmlPage& page, const Diagnosis& diagnosis) {
    const Unexplained& rest = diagnosis.unexplained;
    const bool told =
        diagnosis.verdict == DiagnosisVerdict::unknown || diagnosis.verdict == DiagnosisVerdict::partly_explained;
    std::string compared = "no more than in an ordinary drive";
    if (rest.beyond_ordinary > 0.5)
        compared = told ? fmt::format("it is larger than that of an ordinary drive by {:.0f} nats of evidence",
                                      rest.beyond_ordinary)
                        : fmt::format(
                              "{:.0f} nats of evidence support a larger remainder than in an ordinary drive, "
                              "too few to report an unknown cause",
                              rest.beyond_ordinary);
    page.text(fmt::format("{} of the gap remains unexplained; {}.",
                          diagnose::answer::percentInWords(diagnosis.training.remainder.share), compared));
    const std::string law = lawInWords(rest.law);
    if (!law.empty() && rest.law.generalised_force.empty()) page.text("In addition to the best answer, " + law + ".");
    else if (!law.empty()) page.text(capitalised(law) + ".");
    if (const std::string vibration = vibrationInWords(rest.vibration); !vibration.empty())
        page.text("There is " + vibration + ".");
    addForces(page, rest);
    addSharesTable(page, "Channel", remainderOfChannels(diagnosis));
    addSharesTable(page, "Recording", remainderOfRecordings(diagnosis));
}

void addLeftOut(HtmlPage& page, const Diagnosis& diagnosis) {
    std::vector<std::vector<Cell>> rows;
    for (const Cut& cut : diagnosis.cuts)
        rows.push_back(
            {{cut.recording}, {fmt::format("{:.1f} s", cut.until), true}, {roundedPercent(cut.share), true}});
    if (!rows.empty()) page.table({"Recording", "Not compared after", "Share of its readings"}, rows);
    page.bullets(diagnosis.data_warnings);
    if (rows.empty() && diagnosis.data_warnings.empty())
        page.text("Nothing: all recordings are compared to their end.");
}

}  // namespace tread
