// Two logs compared, or a simulation judged against measurements.
#include "compare/compare.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bind.h"
#include "interruptible.h"
#include "judge.h"
#include "logged_run.h"
#include "output.h"
#include "overlay.h"

namespace tread::python {
namespace {

// What each kind of comparison answers: whether it is positive, in words, as JSON, and as a page.
struct Compared {
    bool positive;
    std::string text, json;
    std::string report = {};
};

std::string nameOf(const LoggedRun& run) {
    return run.record ? run.record->vehicle.name : run.name;
}

Compared compared(const LoggedRun& reference, const LoggedRun& candidate, const std::string& tolerances, bool report) {
    const Comparison found =
        tread::compare(reference.log, candidate.log, program::readTolerances(tolerances, reference.log));
    if (!found.nothing.empty()) throw LoadError({{"", 0, 0, "", "nothing was compared: " + found.nothing}});
    Compared out{found.same, tread::text(found), program::jsonText(tread::json(found))};
    if (!report) return out;
    std::vector<program::ComparedLog> logs;
    for (const LoggedRun* run : {&reference, &candidate})
        logs.push_back({nameOf(*run), "", run->log, run->record ? &*run->record : nullptr});
    if (logs[0].name == logs[1].name) logs[0].name += " (reference)", logs[1].name += " (candidate)";
    out.report = program::comparisonReport(logs, found, out.text.substr(0, out.text.find('\n')));
    return out;
}

std::vector<NamedLog> named(const std::vector<LoggedRunPointer>& measured) {
    std::vector<NamedLog> logs;
    for (const LoggedRunPointer& run : measured) logs.push_back({run->name, run->log});
    return logs;
}

Compared scored(const std::vector<LoggedRunPointer>& measured, const LoggedRun& simulated, const std::string& given) {
    const Scores found = scoreLogs(named(measured), simulated.log, program::scoreParamsOf(given, "score"));
    return {found.passed, tread::text(found), program::jsonText(tread::json(found))};
}

Compared enveloped(const std::vector<LoggedRunPointer>& measured, const LoggedRun& simulated,
                   const std::string& given) {
    const CrossPlotResult found =
        judgeCrossPlots(simulated.log, named(measured), program::crossPlotsOf(given, "envelope"));
    return {found.inside, tread::text(found), program::jsonText(tread::json(found))};
}

py::tuple tupleOf(const Compared& found) {
    return py::make_tuple(found.positive, found.text, found.json, found.report);
}

}  // namespace

void bindCompare(py::module_& module) {
    using Runs = std::vector<LoggedRunPointer>;
    module.def(
        "compare",
        [](const LoggedRunPointer& reference, const LoggedRunPointer& candidate, const std::string& tolerances,
           bool report) {
            return tupleOf(
                interruptible([&](const Watch&) { return compared(*reference, *candidate, tolerances, report); }));
        },
        py::arg("reference"), py::arg("candidate"), py::arg("tolerances"), py::arg("report"));
    module.def(
        "score",
        [](const Runs& measured, const LoggedRunPointer& simulated, const std::string& given) {
            return tupleOf(interruptible([&](const Watch&) { return scored(measured, *simulated, given); }));
        },
        py::arg("measured"), py::arg("simulated"), py::arg("given"));
    module.def(
        "envelope",
        [](const Runs& measured, const LoggedRunPointer& simulated, const std::string& given) {
            return tupleOf(interruptible([&](const Watch&) { return enveloped(measured, *simulated, given); }));
        },
        py::arg("measured"), py::arg("simulated"), py::arg("given"));
}

}  // namespace tread::python
