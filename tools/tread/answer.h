// The answer of a run in words: the first line that the program prints, and the head of the report.
#pragma once

#include <string>
#include <vector>

#include "log/log.h"
#include "metrics/metric.h"
#include "metrics/verdict.h"
#include "run/run_record.h"

namespace tread::program {

// "Straight braking from 100 km/h, compact hatchback: stops within 43.7 m, ...": the most telling metrics of the
// manoeuvre, or how long the car drove when there are none.
std::string runAnswer(const RunRecord& record, const Log& log, const std::vector<Metric>& metrics);

// The answer, and behind it whether the run is accepted; as it is without conditions.
std::string withVerdict(const std::string& answer, const std::vector<Verdict>& verdicts);

}  // namespace tread::program
