// Conditions on the metrics of a scenario: its own, and those of a file that the command line names.
#pragma once

#include <string>
#include <vector>

#include "commands.h"
#include "metrics/verdict.h"
#include "report/junit.h"
#include "scenario/scenario.h"
#include "terminal.h"
#include "tread/problem.h"

namespace tread::program {

// The metrics on which a scenario can have conditions: of its manoeuvre, its own; of a search for the highest value,
// that value.
std::vector<MetricDefinition> acceptable(const Scenario& scenario);

// What has these metrics, for messages: the manoeuvre, or the search.
std::string ownerOf(const Scenario& scenario);

// The conditions that the file `options.accept` has for a scenario; none without a file. Of several scenarios, each
// takes the conditions whose metrics it has. Throws LoadError.
Acceptance acceptanceOf(const RunOptions& options, const Scenario& scenario);

struct NamedScenario {
    std::string name;
    const Scenario* scenario;  // nullptr: it could not be read
};
// Throws LoadError for conditions and scenarios of the file that fit none of these. A condition may be on a scenario
// that could not be read.
void expectAllUsed(const std::string& file, const std::vector<NamedScenario>& scenarios);

// A file of conditions on the metrics of any manoeuvre. Returns notes on the names that no manoeuvre has: metrics of
// the user's own, if a scenario or a file of metrics defines them. Throws LoadError, also for a name that is nearly one
// of a manoeuvre.
std::vector<std::string> checkAcceptFile(const std::string& file);

// Of an answer with these verdicts.
Tone toneOf(const std::vector<Verdict>& verdicts);

// Of one run, for JUnit: the run itself, and each of its verdicts.
std::vector<JUnitCase> junitCases(const std::string& name, const std::vector<Verdict>& verdicts);

}  // namespace tread::program
