#include "campaign/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text/number_text.h"
#include "metrics/channels.h"

namespace tread::campaign {
namespace {

// Row of the design for a dimension: with Sobol indices, rows come in blocks of A, B, and A with one column of B.
double drawn(const Plan& plan, const Cell& cell, std::uint64_t sample, std::size_t dimension) {
    const Draws& draws = plan.draws.front();
    if (plan.inputs.campaign.sampling != Sampling::sobol_indices)
        return draws.at(static_cast<std::size_t>(sample), dimension);
    const std::uint64_t block = cell.drawn.size() + 2;
    const std::uint64_t row = sample % block;
    const bool of_b = row == 1 || (row >= 2 && plan.variables[cell.drawn[row - 2]].dimension == dimension);
    return draws.at(static_cast<std::size_t>(sample / block), dimension + (of_b ? plan.dimensions : 0));
}

double meanOf(const Cell& cell, const Group& group, const Variable& variable) {
    if (!group.mean.empty()) return group.mean[variable.row];
    Subject copy = cell.nominal;
    return fieldAt(copy, variable.path).value;
}

double drawnValue(const Plan& plan, const Cell& cell, const Variable& variable, std::uint64_t sample) {
    if (variable.group == Variable::kNoGroup)
        return valueOfShare(plan, cell, variable, drawn(plan, cell, sample, variable.dimension));
    const Group& group = plan.groups[variable.group];
    double value = meanOf(cell, group, variable);
    for (std::size_t j = 0; j < group.dimensions.size(); ++j)
        value += group.root[variable.row][j] * normalQuantile(drawn(plan, cell, sample, group.dimensions[j]));
    return value;
}

}  // namespace

std::uint64_t Plan::countOf(std::uint64_t piece) const {
    return std::min(runs_per_piece, runs - firstOf(piece));
}

PlannedRun plannedRun(const Plan& plan, RunNumber number) {
    const auto after = std::upper_bound(plan.cells.begin(), plan.cells.end(), number,
                                        [](RunNumber n, const Cell& cell) { return n < cell.first; });
    PlannedRun run;
    run.number = number;
    run.cell = static_cast<std::size_t>(after - plan.cells.begin()) - 1;
    const Cell& cell = plan.cells[run.cell];
    std::uint64_t rest = number - cell.first;
    const auto take = [&](std::uint64_t radix) {
        const std::uint64_t digit = rest % radix;
        rest /= radix;
        return digit;
    };
    run.repetition = take(static_cast<std::uint64_t>(plan.inputs.campaign.repetitions));
    run.sample = take(cell.samples);
    run.point = rest;
    run.values.assign(plan.variables.size(), kUndefined);
    for (std::size_t i = cell.listed.size(); i-- > 0;) {
        const Variable& variable = plan.variables[cell.listed[i]];
        run.values[cell.listed[i]] = variable.numbers[take(variable.numbers.size())];
    }
    for (const std::size_t i : cell.drawn) run.values[i] = drawnValue(plan, cell, plan.variables[i], run.sample);
    return run;
}

Subject subjectOf(const Plan& plan, const PlannedRun& run) {
    const Cell& cell = plan.cells[run.cell];
    Subject subject = cell.nominal;
    const std::string where = fmt::format("run {}", run.number);
    std::vector<std::string> words;
    for (std::size_t i = 0; i < plan.variables.size(); ++i) {
        const Variable& variable = plan.variables[i];
        if (std::isnan(run.values[i])) continue;
        for (const std::string& path : variable.paths) {
            if (variable.words) {
                words.push_back(path + "=" + variable.texts[static_cast<std::size_t>(run.values[i])]);
                continue;
            }
            const double value = variable.relative ? fieldAt(subject, path).value * run.values[i] : run.values[i];
            fieldAt(subject, path, &value);
        }
    }
    if (!words.empty()) setFields(subject, words, where);
    expectSound(subject, where);
    if (run.repetition > 0)
        reseed(subject.scenario, static_cast<std::uint64_t>(plan.inputs.campaign.seed), run.repetition);
    return subject;
}

double valueOfShare(const Plan& plan, const Cell& cell, const Variable& variable, double share) {
    if (variable.group != Variable::kNoGroup) {
        const Group& group = plan.groups[variable.group];
        double variance = 0;
        for (const double part : group.root[variable.row]) variance += part * part;
        return meanOf(cell, group, variable) + std::sqrt(variance) * normalQuantile(share);
    }
    if (!variable.normal) return variable.from + (variable.to - variable.from) * share;
    const double left = variable.lowest_share + (variable.highest_share - variable.lowest_share) * share;
    return variable.mean + variable.sd * normalQuantile(left);
}

std::string valueText(const Variable& variable, double value) {
    if (std::isnan(value)) return {};
    return variable.words ? variable.texts[static_cast<std::size_t>(value)] : numberText(value);
}

}  // namespace tread::campaign
