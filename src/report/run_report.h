// The report of one run: the answer, the metrics, what the driver did and what car and tyres made of it.
#pragma once

#include <string>
#include <vector>

#include "log/log.h"
#include "metrics/metric.h"
#include "metrics/verdict.h"
#include "report/car_shape.h"
#include "report/html.h"
#include "report/svg.h"
#include "run/run_record.h"

namespace tread {

struct RunReport {
    std::string title;
    std::string answer;  // the result in one sentence
    std::string vehicle;
    std::string scenario;
    std::string scenario_description = {};
    std::string version;
    const Log& log;                    // channels that are missing are left out of the report
    std::vector<Metric> metrics = {};  // most important first: the first six become cards
    std::vector<Verdict> verdicts = {};
    std::string resolved_yaml = {};
    std::vector<std::string> warnings = {};
    std::vector<Link> files = {};  // beside the page: log, metrics, inputs
    const RunRecord* record =
        nullptr;  // car and road of the replay and the top view; without it a medium car, level ground
};

// What the figures and the replay draw as the car.
CarShape shapeOf(const RunReport& content);

std::string runReport(const RunReport& content);

}  // namespace tread
