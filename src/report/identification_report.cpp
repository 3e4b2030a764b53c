#include "report/identification_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "calibrate/identification.h"
#include "calibrate/identification_text.h"
#include "diagnose/answer/diagnosis.h"
#include "diagnose/answer/parts.h"
#include "diagnose/answer/words.h"
#include "recording/subject_paths.h"
#include "report/diagnosis_charts.h"
#include "report/diagnosis_tables.h"
#include "report/html.h"
#include "report/text.h"

namespace tread {
namespace {

using calibrate::FittedNumber;
using calibrate::Identification;
using calibrate::otherNumbersInWords;
using diagnose::answer::closedShare;
using diagnose::answer::GapLevels;
using diagnose::answer::HowFar;
using diagnose::answer::roundedPercent;
using recording::subjectNumber;

constexpr double kFarMoved = 2;  // prior standard deviations

void addHead(HtmlPage& page, const std::string& vehicle, const std::string& version, const Identification& found) {
    const auto determined = std::count_if(found.numbers.begin(), found.numbers.end(),
                                          [](const FittedNumber& one) { return one.determined; });
    page.answer(found.answer + ".", outcomeInWords(found), hasSucceeded(found));
    const HowFar& how_far = found.gap.how_far;
    const GapLevels& judged = how_far.in_sample ? how_far.training : how_far.held_out;
    const std::string where = how_far.in_sample ? "in the same drives" : "in held-out drives";
    page.cards({{"numbers determined", fmt::format("{} of {}", determined, found.numbers.size()), ""},
                {"gap " + where + ", in noise units: nominal", formatNumber(judged.nominal, 3), ""},
                {"with the fitted numbers", formatNumber(judged.calibrated, 3), ""},
                {"noise floor", formatNumber(judged.floor, 3), ""},
                {"condition number of the fit", formatNumber(found.condition, 2), ""}});
    page.keyValues({{"Car", vehicle},
                    {"Fitted to", found.of_references ? "the references: the car before the change" : ""},
                    {"Made by", fmt::format("tread {}, {} simulations in {:.0f} s", version, found.gap.simulations,
                                            found.gap.seconds)}});
    page.warnings(found.gap.data_warnings);
}

std::string remark(const FittedNumber& one) {
    if (!one.determined) return "not determined by these drives: no more certain than before";
    if (one.at_bound) return "at the end of its plausible range";
    return std::abs(one.z) > kFarMoved ? "far from nominal" : "";
}

void addNumbers(HtmlPage& page, const Identification& found) {
    std::vector<std::vector<Cell>> rows;
    for (const FittedNumber& one : found.numbers) {
        const ReferenceRow* row = subjectNumber(one.path);
        const DisplayUnit shown = displayUnit(row ? row->unit : "");
        const auto cell = [&](double value, int digits) {
            return Cell{formatNumber(value * shown.scale, digits), true};
        };
        rows.push_back({{one.path},
                        cell(one.value, 4),
                        cell(one.sd, 2),
                        cell(one.nominal, 4),
                        cell(one.prior_sd, 2),
                        {prettyUnit(shown.unit)},
                        {formatNumber(one.z, 2), true, std::abs(one.z) > kFarMoved},
                        {remark(one), false, !one.determined || one.at_bound}});
    }
    page.table({"Number", "Value", "±", "Nominal", "± before", "Unit", "Change, in ± before", ""}, rows);
}

void addCorrelation(HtmlPage& page, const Identification& found) {
    std::vector<std::string> header{""};
    for (const FittedNumber& one : found.numbers) header.push_back(one.path);
    std::vector<std::vector<Cell>> rows;
    for (std::size_t i = 0; i < found.numbers.size(); ++i) {
        std::vector<Cell> row{{found.numbers[i].path}};
        for (std::size_t j = 0; j < found.numbers.size(); ++j) {
            Cell cell{fmt::format("{:.2f}", found.correlation[i][j]), true};
            cell.heat = i == j ? 0 : std::abs(found.correlation[i][j]);
            row.push_back(std::move(cell));
        }
        rows.push_back(std::move(row));
    }
    page.table(header, rows);
}

void addLevels(HtmlPage& page, const HowFar& how_far) {
    std::vector<std::vector<Cell>> rows;
    const auto add = [&](const char* drives, const GapLevels& levels) {
        const double most = std::max({levels.nominal, levels.calibrated, levels.extended, levels.floor, 1e-9});
        const std::pair<const char*, double> stages[] = {{"nominal", levels.nominal},
                                                         {"calibrated", levels.calibrated},
                                                         {"within tolerance", levels.extended},
                                                         {"noise floor", levels.floor}};
        for (const auto& [stage, value] : stages) {
            Cell bar{stage};
            bar.bar = value / most;
            const double closed = closedShare(levels, value);
            rows.push_back({{stage == stages[0].first ? drives : ""},
                            bar,
                            {formatNumber(value, 4), true},
                            {std::isfinite(closed) ? roundedPercent(closed) : "–", true}});
        }
    };
    add("Drives used for fitting", how_far.training);
    if (!how_far.in_sample) add("Held-out drives", how_far.held_out);
    page.table({"Drives", "Model", "Gap", "Closed"}, rows);
    page.text("Closed, as a share of what a model can close: (nominal² - gap²) / (nominal² - noise floor²).");
    if (how_far.in_sample)
        page.text("No drive is held out: the gap is judged in the fitted drives, which is too optimistic.");
}

}  // namespace

std::string identificationReport(const std::string& vehicle, const std::string& version, const Identification& found) {
    HtmlPage page("Identification of " + vehicle);
    addHead(page, vehicle, version, found);

    page.section("The numbers");
    addNumbers(page, found);
    page.text(
        "Correlation of the remaining uncertainties. Near 1 or -1, only a combination of the two numbers is "
        "determined.");
    addCorrelation(page, found);

    page.section("How far the gap shrinks");
    page.text(
        "Root mean square of measured minus simulated, in units of the noise; a perfect model leaves 1. "
        "Nominal: the car as described by its file. Calibrated: with the fitted numbers only, as in calibrated.yaml. "
        "Within tolerance: all other uncertain numbers fitted as well.");
    addLevels(page, found.gap.how_far);
    if (const std::string others = otherNumbersInWords(found); !others.empty())
        page.text(fmt::format("Note: {}.", others));

    page.section("Where the nominal car deviates");
    addWhere(page, found.gap.where);

    if (!found.gap.overlays.empty()) {
        page.section("Measured and simulated");
        addOverlays(page, found.gap, {.calibrated = "calibrated", .extended = "within tolerance"});
    }

    page.section("Other numbers of the car within their tolerances");
    addMoved(page, found.gap.nuisance);
    return page.finish();
}

}  // namespace tread
