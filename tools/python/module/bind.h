// The parts of the module tread._tread.
#pragma once

#include <pybind11/pybind11.h>

namespace tread::python {

namespace py = pybind11;

void bindErrors(py::module_& module);
void bindDescriptions(py::module_& module);
void bindLog(py::module_& module);
void bindRun(py::module_& module);
void bindCompare(py::module_& module);
void bindTyre(py::module_& module);
void bindDiagnosis(py::module_& module);
void bindCampaign(py::module_& module);
void bindVehicle(py::module_& module);
void bindFleet(py::module_& module);

}  // namespace tread::python
