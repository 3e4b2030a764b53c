// Failures as Python exceptions, those of tread/_errors.py, with the sentence of the command line.
#include <stdexcept>

#include "bind.h"
#include "log/csv.h"
#include "metrics/metrics.h"
#include "run/simulate.h"
#include "series/series.h"
#include "tread/problem.h"

namespace tread::python {
namespace {

py::object errorNamed(const char* name) {
    return py::module_::import("tread._errors").attr(name);
}

void raise(const char* name, const py::object& error) {
    PyErr_SetObject(errorNamed(name).ptr(), error.ptr());
}

void raiseInput(const LoadError& error) {
    py::list problems;
    const py::object problem = errorNamed("Problem");
    for (const Problem& one : error.problems())
        problems.append(problem(one.file, one.line, one.column, one.path, one.text));
    raise("InputError", errorNamed("InputError")(error.what(), problems));
}

void raiseSimulation(const SimulationError& error) {
    raise("SimulationError", errorNamed("SimulationError")(error.what(), error.time));
}

}  // namespace

void bindErrors(py::module_&) {
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const LoadError& error) {
            raiseInput(error);
        } catch (const SimulationError& error) {
            raiseSimulation(error);
        } catch (const FileError& error) {
            raise("FileError", errorNamed("FileError")(error.what()));
        } catch (const MetricError& error) {
            raise("InputError", errorNamed("InputError")(error.what()));
        } catch (const std::invalid_argument& error) {
            raise("InputError", errorNamed("InputError")(error.what()));
        } catch (const SeriesError& error) {
            raise("SimulationError", errorNamed("SimulationError")(error.what()));
        }
    });
}

}  // namespace tread::python
