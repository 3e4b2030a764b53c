// Figures and tables of a campaign's page: distributions of metrics, and what the factors do to them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "campaign/database.h"
#include "campaign/plan.h"
#include "report/html.h"
#include "report/text.h"
#include "scenario/condition.h"

namespace tread::program {

// A metric of one scenario, with its conditions there.
struct MetricHere {
    const MetricDefinition* about;
    std::string column;
    std::optional<Interval> wanted;
    std::string condition;
    DisplayUnit shown;  // the unit of the condition, if the page can show it; else that of the metric
};

// The title of a metric; of one without, its name.
std::string titleOf(const MetricHere& metric);

// Rows of a scenario, and of one vehicle unless its name is empty, as SQL.
std::string where(const std::string& vehicle, const std::string& scenario);

// Those with conditions first, then what says most.
std::vector<MetricHere> metricsOf(const campaign::Plan& plan, std::size_t scenario);

// Without what does not vary; beyond the conditions and what says most, that first which varies most.
std::vector<MetricHere> worthShowing(const campaign::DatabaseReader& data, const std::string& scenario,
                                     std::vector<MetricHere> metrics);

// Distribution of a metric, a curve for each vehicle, and the limits of its condition.
Chart histogram(const campaign::Plan& plan, const campaign::DatabaseReader& data, std::size_t scenario,
                const MetricHere& metric);

// Main effects of the factors on these metrics, and the metrics over the factors that matter most. The rows of a design
// for Sobol indices share values: their main effects order the charts, but are not shown.
void addEffects(HtmlPage& page, const campaign::Plan& plan, const campaign::DatabaseReader& data, std::size_t scenario,
                const std::vector<MetricHere>& metrics);

// Sobol indices of a car in a scenario.
void addSobol(HtmlPage& page, const campaign::Plan& plan, const campaign::DatabaseReader& data,
              const campaign::Cell& cell, const std::vector<MetricHere>& metrics);

}  // namespace tread::program
