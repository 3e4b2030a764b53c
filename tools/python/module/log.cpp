// Logs: channels as NumPy arrays without a copy, metrics, files, the report.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>

#include "base/yaml/session.h"
#include "base/yaml/write.h"
#include "bind.h"
#include "log/binary_log.h"
#include "log/csv.h"
#include "log/log_columns.h"
#include "logged_run.h"
#include "metrics/metrics.h"
#include "output.h"
#include "report/run_report.h"

namespace tread::python {
namespace {

using program::Path;

// A read-only view that keeps the log alive.
py::array viewOf(const py::object& owner, const std::string& name) {
    const Channel* const channel = owner.cast<const LoggedRun&>().log.find(name);
    if (!channel) throw py::key_error(name);
    py::array_t<double> view(static_cast<py::ssize_t>(channel->values.size()), channel->values.data(), owner);
    view.attr("setflags")(py::arg("write") = false);
    return view;
}

py::dict unitsOf(const LoggedRun& run) {
    py::dict units;
    for (const Channel& channel : run.log.channels) units[py::str(channel.name)] = channel.unit;
    return units;
}

py::list listOf(const std::vector<Metric>& metrics) {
    py::list list;
    for (const Metric& metric : metrics)
        list.append(py::make_tuple(metric.name, metric.value, metric.unit, titleOf(metric), metric.definition));
    return list;
}

// Of the run that made the log; of another log those of the manoeuvre that is named, or that it contains.
std::vector<Metric> metricsOf(const LoggedRun& run, const std::string& manoeuvre) {
    if (!manoeuvre.empty()) return tread::metrics(run.log, manoeuvre);
    return run.record ? run.driven().metrics : tread::metrics(run.log, detectManoeuvre(run.log));
}

std::vector<Metric> metricsIfAny(const LoggedRun& run) {
    try {
        return metricsOf(run, {});
    } catch (const MetricError&) {
        return {};
    }
}

std::string reportOf(const LoggedRun& run) {
    if (run.record) return program::reportOf(*run.record, run.log, run.driven(), {});
    return runReport({.title = run.name,
                      .answer = run.name,
                      .vehicle = "",
                      .scenario = "",
                      .version = TREAD_VERSION,
                      .log = run.log,
                      .metrics = metricsIfAny(run)});
}

void save(const LoggedRun& run, const Path& file) {
    if (file.extension() == ".tlog") return writeFile(file, binaryLog(run.log));
    if (file.extension() == ".csv") return writeLog(file, run.log);
    throw LoadError({{file.string(), 0, 0, "", "found another kind of file, expected .csv or .tlog"}});
}

void saveRun(const LoggedRun& run, const Path& folder) {
    if (!run.record) {
        throw LoadError(
            {{run.name, 0, 0, "",
              "found a log that was read from a file, expected one of tread.run: only that knows its inputs; "
              "use save() and report()"}});
    }
    program::saveRun(*run.record, run.log, run.driven(), folder);
}

LoggedRunPointer read(const Path& file) {
    auto run = std::make_shared<LoggedRun>();
    run->name = file.filename().string();
    run->log = readLog(file);
    throwIfAny(unitFaults(run->log, file.string()));
    return run;
}

// A log of the user's own: one array for each channel, all as long as the first, "time". Without a unit: the one that
// tread has for that name.
LoggedRunPointer made(const std::vector<std::tuple<std::string, std::string, std::vector<double>>>& channels) {
    auto run = std::make_shared<LoggedRun>();
    run->name = "log";
    for (const auto& [name, unit, values] : channels) {
        const std::string usual(logUnit(name).value_or("-"));
        run->log.channels.push_back({name, unit.empty() ? usual : unit, values});
    }
    throwIfAny(unitFaults(run->log, "log"));
    return run;
}

}  // namespace

void bindLog(py::module_& module) {
    const auto unguarded = py::call_guard<py::gil_scoped_release>();
    py::class_<LoggedRun, LoggedRunPointer>(module, "Log")
        .def(
            "view", [](const py::object& self, const std::string& name) { return viewOf(self, name); }, py::arg("name"))
        .def("units", &unitsOf)
        .def("samples", [](const LoggedRun& run) { return run.log.samples(); })
        .def("name", [](const LoggedRun& run) { return run.name; })
        .def(
            "answer", [](const LoggedRun& run) { return run.driven().answer; }, unguarded)
        .def("warnings", [](const LoggedRun& run) { return run.warnings; })
        .def(
            "further_warnings", [](const LoggedRun& run) { return run.driven().warnings; }, unguarded)
        .def("inputs", [](const LoggedRun& run) { return run.record ? writeYaml(*run.record) : std::string(); })
        .def("accepted",
             [](const LoggedRun& run) -> py::object {
                 if (run.driven().verdicts.empty()) return py::none();
                 return py::bool_(allMet(run.driven().verdicts));
             })
        .def(
            "metrics",
            [](const LoggedRun& run, const std::string& manoeuvre) { return listOf(metricsOf(run, manoeuvre)); },
            py::arg("manoeuvre"))
        .def("report", &reportOf, unguarded)
        .def("save", &save, py::arg("file"), unguarded)
        .def("save_run", &saveRun, py::arg("folder"), unguarded);
    module.def("read_log", &read, py::arg("file"), unguarded);
    module.def("make_log", &made, py::arg("channels"));
    module.def(
        "write_text", [](const Path& file, const std::string& text) { writeFile(file, text); }, py::arg("file"),
        py::arg("text"), unguarded);
}

}  // namespace tread::python
