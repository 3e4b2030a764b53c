#include "report/diagnosis_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "diagnose/subject_paths.h"
#include "diagnose/thresholds.h"
#include "report/text.h"

namespace tread {
namespace {

constexpr std::size_t kShown = 8;  // effects in the table; the others are only named
constexpr double kNoteworthy = 1;  // standard deviations of its tolerance that a number was moved

std::string percent(double share) {
    return fmt::format("{:.0f} %", 100 * share);
}
std::string probability(double p) {
    return p > 0.9995 ? "> 0.999" : p < 0.0005 ? "< 0.001" : fmt::format("{:.3f}", p);
}

std::string questionOf(const std::string& effect) {
    for (const Effect& known : effectCatalogue()) {
        if (known.name == effect) return known.question;
    }
    return {};
}

// "front.tyre.lambda.Ky 0.88 ± 0.02 (0.85 to 0.91), nominal 1".
std::string parameterText(const std::string& path, const Estimate& e) {
    const ReferenceRow* row = subjectNumber(path);
    const DisplayUnit shown = displayUnit(row ? row->unit : "");
    const auto number = [&](double value) { return formatNumber(value * shown.scale); };
    const std::string unit = prettyUnit(shown.unit);
    return fmt::format("{} = {} ± {}{}{} (90 %: {} to {}; nominal {}){}", path, number(e.value),
                       formatNumber(e.sd * shown.scale, 2), unit.empty() ? "" : " ", unit, number(e.low),
                       number(e.high), number(e.neutral), e.at_bound ? ", at its limit" : "");
}

template <class Value>
Value valueOf(const std::map<std::string, Value>& map, const std::string& key, Value otherwise) {
    const auto found = map.find(key);
    return found == map.end() ? otherwise : found->second;
}

// Numbers that move together by one change are told once, the others counted.
std::string parametersText(const RankedEffect& effect) {
    std::vector<std::string> lines;
    for (const auto& [path, estimate] : effect.parameters) lines.push_back(parameterText(path, estimate));
    return fmt::format("{}", fmt::join(lines, "; "));
}

std::vector<std::pair<std::string, double>> sorted(const Shares& shares) {
    std::vector<std::pair<std::string, double>> order(shares.begin(), shares.end());
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    return order;
}

// Groups of shares beside each other, each its own column: "1-3 Hz  45 %".
void addShares(HtmlPage& page, const std::vector<std::pair<const char*, const Shares*>>& groups) {
    std::vector<std::string> header;
    std::vector<std::vector<std::pair<std::string, double>>> columns;
    std::size_t rows = 0;
    for (const auto& [name, shares] : groups) {
        if (shares->empty()) continue;
        header.push_back(name);
        columns.push_back(sorted(*shares));
        rows = std::max(rows, columns.back().size());
    }
    std::vector<std::vector<Cell>> cells;
    for (std::size_t r = 0; r < std::min<std::size_t>(rows, 8); ++r) {
        std::vector<Cell> row;
        for (const auto& column : columns) {
            if (r >= column.size()) {
                row.push_back({""});
                continue;
            }
            Cell cell{shownName(column[r].first) + "  " + percent(column[r].second)};
            cell.bar = column[r].second;
            row.push_back(std::move(cell));
        }
        cells.push_back(std::move(row));
    }
    page.table(header, cells);
}

void addHeatMap(HtmlPage& page, const WhereItLies& where) {
    std::vector<std::string> channels, header{"Recording"};
    for (const auto& [channel, share] : sorted(where.channels)) {
        channels.push_back(channel);
        header.push_back(shownName(channel));
    }
    double most = 0;
    for (const auto& [recording, shares] : where.channels_of_recording) {
        for (const auto& [channel, share] : shares) most = std::max(most, share);
    }
    std::vector<std::vector<Cell>> rows;
    for (const auto& [recording, total] : sorted(where.recordings)) {
        const auto found = where.channels_of_recording.find(recording);
        if (found == where.channels_of_recording.end()) continue;
        std::vector<Cell> row{{recording}};
        for (const std::string& channel : channels) {
            const double share = valueOf(found->second, channel, 0.0);
            Cell cell{share > 0 ? fmt::format("{:.1f} %", 100 * share) : "", true};
            cell.heat = most > 0 ? share / most : 0;
            row.push_back(std::move(cell));
        }
        rows.push_back(std::move(row));
    }
    page.table(header, rows);
}

}  // namespace

std::string shownName(std::string_view name) {
    if (name.starts_with("chassis.")) name.remove_prefix(8);
    std::string out(name);
    if (out == "vx") return "speed";
    if (out == "vy") return "lateral velocity";
    if (out.starts_with("wheel.")) out = "wheel speed " + out.substr(6, out.rfind('.') - 6);
    std::replace(out.begin(), out.end(), '_', ' ');
    return out;
}

std::vector<std::string> shownNames(const std::vector<std::string>& names) {
    std::vector<std::string> out;
    for (const std::string& name : names) out.push_back(shownName(name));
    return out;
}

void addEffects(HtmlPage& page, const Diagnosis& diagnosis) {
    std::vector<std::vector<Cell>> rows;
    const auto add = [&](const std::string& name, double p, std::string evidence, std::string constancy, bool varies,
                         std::string text) {
        Cell chance{probability(p), true};
        chance.bar = p;
        const auto& causes = diagnosis.causes;
        const bool blamed = std::find(causes.begin(), causes.end(), name) != causes.end();
        rows.push_back({{(blamed ? "▶ " : "") + shownName(name)},
                        chance,
                        {std::move(evidence), true},
                        {std::move(constancy), true, varies},
                        {std::move(text)}});
    };
    for (std::size_t i = 0; i < std::min(diagnosis.effects.size(), kShown); ++i) {
        const RankedEffect& effect = diagnosis.effects[i];
        const double same = valueOf(diagnosis.constancy, effect.name, std::nan(""));
        const std::string question = questionOf(effect.name), parameters = parametersText(effect);
        add(effect.name, effect.probability, formatNumber(effect.log_evidence, 3),
            std::isfinite(same) ? formatNumber(same, 2) : "", same < 0.01,
            question + (question.empty() || parameters.empty() ? "" : " ") + parameters);
    }
    add("nothing that these drives could show", diagnosis.probability_of_nothing, "0", "", false,
        "The numbers of the car within their tolerances explain the drives.");
    add("an unknown cause", diagnosis.probability_of_unknown, "", "", false,
        "A force acts that nothing in the catalogue explains.");
    page.table({"Effect", "Probability", "Evidence, nats", "Same in all drives, p", "What it asks, and what was found"},
               rows, true);
    if (diagnosis.effects.size() > kShown)
        page.text(fmt::format("{} further effects were considered and are less likely than these.",
                              diagnosis.effects.size() - kShown));
}

void addLevels(HtmlPage& page, const HowFar& how_far, const char* extended) {
    std::vector<std::vector<Cell>> rows;
    const auto add = [&](const char* drives, const GapLevels& levels) {
        const double most = std::max({levels.nominal, levels.calibrated, levels.extended, levels.floor, 1e-9});
        const std::pair<const char*, double> stages[] = {{"nominal", levels.nominal},
                                                         {"calibrated", levels.calibrated},
                                                         {extended, levels.extended},
                                                         {"noise floor", levels.floor}};
        for (const auto& [stage, value] : stages) {
            Cell bar{stage};
            bar.bar = value / most;
            rows.push_back({{stage == stages[0].first ? drives : ""}, bar, {formatNumber(value, 3), true}});
        }
    };
    add("Drives it was learnt from", how_far.training);
    if (!how_far.in_sample) add("Held-out drives", how_far.held_out);
    page.table({"Drives", "Model", "Gap"}, rows);
    page.text(fmt::format("{} of what can be closed is closed (90 %: {} to {}){}.", percent(how_far.closure),
                          percent(how_far.closure_low), percent(how_far.closure_high),
                          how_far.in_sample
                              ? "; judged on the drives that it was fitted to, because none was held out: "
                                "too favourable"
                              : ", on drives that were not used to find it"));
}

void addWhere(HtmlPage& page, const WhereItLies& where) {
    page.text(
        "Shares of the squared gap of the nominal car, in noise units: by recording and channel, then by what the "
        "driver does, frequency, operating regime and the force that is missing.");
    addHeatMap(page, where);
    addShares(page, {{"Phase", &where.phases},
                     {"Frequency", &where.bands},
                     {"Regime", &where.regimes},
                     {"Missing force", &where.generalised_force},
                     {"Side force at the axle", &where.axle_force}});
    page.text(
        "Missing force: what would have to push the nominal car, its numbers within their tolerances, for it to go as "
        "was measured. Side force at the axle: where it would push to do what is missing of lateral force and yaw "
        "moment.");
}

void addLimits(HtmlPage& page, const Diagnosis& diagnosis) {
    std::vector<std::vector<Cell>> next;
    for (const NextDrive& drive : diagnosis.next)
        next.push_back({{drive.scenario}, {formatNumber(drive.nats, 3), true}, {drive.separates}});
    if (!next.empty()) page.table({"Drive next", "Nats to expect", "What it would tell"}, next, true);

    std::vector<std::vector<Cell>> pairs;
    for (const ConfusablePair& pair : diagnosis.confusable)
        pairs.push_back({{shownName(pair.a)},
                         {shownName(pair.b)},
                         {formatNumber(pair.cosine, 2), true},
                         {formatNumber(pair.separation, 2), true, pair.separation < kThresholds.separable},
                         {pair.manoeuvre}});
    if (!pairs.empty()) {
        page.text("Pairs that look alike in these drives; separation in nats at typical size.");
        page.table({"Effect", "looks like", "Likeness", "Separation, nats", "Best told apart by"}, pairs);
    }
    std::vector<std::string> hidden;
    for (const auto& [effect, nats] : diagnosis.testable) {
        if (nats < kThresholds.testable) hidden.push_back(shownName(effect));
    }
    page.text(hidden.empty()
                  ? std::string("Every effect that was considered would show in these drives at its typical size.")
                  : fmt::format("These drives would not show {} of {} effects at their typical size: {}.",
                                hidden.size(), diagnosis.testable.size(), fmt::join(hidden, ", ")));
}

void addNuisances(HtmlPage& page, const Diagnosis& diagnosis) {
    std::vector<std::pair<std::string, NuisanceEstimate>> order;
    for (const auto& [path, estimate] : diagnosis.nuisance) {
        if (std::abs(estimate.z) > kNoteworthy) order.push_back({path, estimate});
    }
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return std::abs(a.second.z) > std::abs(b.second.z); });
    if (order.empty()) {
        page.text(
            fmt::format("None of its {} uncertain numbers had to be moved by more than {:.0f} standard deviation of "
                        "its tolerance.",
                        diagnosis.nuisance.size(), kNoteworthy));
        return;
    }
    std::vector<std::vector<Cell>> rows;
    for (const auto& [path, estimate] : order) {
        const ReferenceRow* row = subjectNumber(path);
        const DisplayUnit shown = displayUnit(row ? row->unit : "");
        rows.push_back({{path},
                        {formatNumber(estimate.value * shown.scale), true},
                        {formatNumber(estimate.sd * shown.scale, 2), true},
                        {prettyUnit(shown.unit)},
                        {formatNumber(estimate.z, 2), true, std::abs(estimate.z) > 2}});
    }
    page.text(
        fmt::format("{} of {} uncertain numbers were moved by more than {:.0f} standard deviation of their tolerance; "
                    "beyond 2 the tolerance is doubtful.",
                    order.size(), diagnosis.nuisance.size(), kNoteworthy));
    page.table({"Number", "Value", "±", "Unit", "Standard deviations moved"}, rows);
}

}  // namespace tread
