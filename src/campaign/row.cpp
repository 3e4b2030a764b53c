#include "campaign/row.h"

#include <algorithm>
#include <cmath>

#include "base/text/number_text.h"

namespace tread::campaign {
namespace {

void appendCell(std::string& out, std::string_view cell) {
    if (cell.find_first_of(",\"\n\r") == std::string_view::npos) {
        out += cell;
        return;
    }
    out += '"';
    for (const char c : cell) {
        if (c == '"') out += "\"\"";
        else out += c == '\n' || c == '\r' ? ' ' : c;  // one line, one run
    }
    out += '"';
}

void appendValue(std::string& out, double value) {
    if (!std::isnan(value)) appendNumber(out, value);
}

}  // namespace

std::vector<std::string> columnNames(const Plan& plan) {
    std::vector<std::string> names{"run", "vehicle", "scenario", "repetition", "status", "message", "missed"};
    for (const Variable& variable : plan.variables) {
        std::string name = variable.column();
        // A path may vary differently in different cells.
        for (int i = 2; std::find(names.begin(), names.end(), name) != names.end(); ++i)
            name = variable.column() + " (" + std::to_string(i) + ")";
        names.push_back(name);
    }
    for (const MetricDefinition& metric : plan.metrics) names.push_back(metric.name + " [" + metric.unit + "]");
    return names;
}

std::string csvLine(const std::vector<std::string>& cells) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (i > 0) line += ',';
        appendCell(line, cells[i]);
    }
    return line + "\n";
}

std::string rowText(const Plan& plan, const PlannedRun& run, const Outcome& outcome) {
    const Cell& cell = plan.cells[run.cell];
    std::string line = std::to_string(run.number) + ",";
    appendCell(line, plan.vehicleOf(cell));
    line += ',';
    appendCell(line, plan.scenarioOf(cell));
    line += ',' + std::to_string(run.repetition) + ',';
    line += enumNames(outcome.status)[static_cast<std::size_t>(outcome.status)];
    line += ',';
    appendCell(line, outcome.message);
    line += ',';
    std::string missed;
    for (const Verdict& verdict : outcome.verdicts) {
        if (!verdict.met) missed += (missed.empty() ? "" : "; ") + verdict.metric;
    }
    appendCell(line, missed);
    for (std::size_t i = 0; i < plan.variables.size(); ++i) {
        line += ',';
        if (plan.variables[i].words) appendCell(line, valueText(plan.variables[i], run.values[i]));
        else appendValue(line, run.values[i]);
    }
    std::vector<double> values(plan.metrics.size(), std::nan(""));
    for (const Metric& metric : outcome.metrics) {
        for (const std::size_t i : plan.metrics_of_scenario[cell.scenario]) {
            if (plan.metrics[i].name == metric.name) values[i] = metric.value;
        }
    }
    for (const double value : values) {
        line += ',';
        appendValue(line, value);
    }
    return line + "\n";
}

std::vector<std::string> cellsOf(std::string_view line) {
    std::vector<std::string> cells(1);
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == ',') {
            cells.emplace_back();
        } else if (line[i] == '"') {
            for (++i; i < line.size(); ++i) {
                if (line[i] != '"') cells.back() += line[i];
                else if (i + 1 < line.size() && line[i + 1] == '"') cells.back() += line[i++];
                else break;
            }
        } else {
            cells.back() += line[i];
        }
    }
    return cells;
}

}  // namespace tread::campaign
