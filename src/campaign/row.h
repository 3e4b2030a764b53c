// A run as a row of the table of results, and back.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "campaign/plan.h"
#include "metrics/verdict.h"

namespace tread::campaign {

// "ok": metrics, and all conditions met; "rejected": metrics, and a condition missed; "no_metrics": driven, but the log
// has no such manoeuvre; "failed": the simulation could not go on; "invalid": the numbers contradict each other or are
// beyond their limits.
enum class Status { ok, rejected, no_metrics, failed, invalid };
constexpr auto enumNames(Status) {
    return std::array<std::string_view, 5>{"ok", "rejected", "no_metrics", "failed", "invalid"};
}

struct Outcome {
    Status status = Status::ok;
    std::string message = {};  // of one that failed
    std::vector<Verdict> verdicts = {};
    std::vector<Metric> metrics = {};  // none of one that failed
};

// Columns before those of factors and metrics.
inline constexpr std::size_t kFixedColumns = 7;

// Names of all columns: run, vehicle, scenario, repetition, status, message, missed; factors; metrics.
std::vector<std::string> columnNames(const Plan& plan);

// One line of a CSV table (RFC 4180), with its end. Cells are empty where there is no value.
std::string rowText(const Plan& plan, const PlannedRun& run, const Outcome& outcome);
std::string csvLine(const std::vector<std::string>& cells);

// The cells of such a line, without its end; none when it is no such line.
std::vector<std::string> cellsOf(std::string_view line);

}  // namespace tread::campaign
