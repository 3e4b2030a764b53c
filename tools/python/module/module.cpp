// The module tread._tread, which the package tread (tools/python/tread) builds on.
#include "bind.h"
#include "terminal.h"

PYBIND11_MODULE(_tread, module) {
    module.doc() = "The part of tread that is written in C++; use the package tread.";
    module.attr("__version__") = TREAD_VERSION;
    tread::program::beQuiet();  // warnings become those of Python
    tread::python::bindErrors(module);
    tread::python::bindDescriptions(module);
    tread::python::bindLog(module);
    tread::python::bindRun(module);
    tread::python::bindCompare(module);
    tread::python::bindTyre(module);
    tread::python::bindDiagnosis(module);
    tread::python::bindCampaign(module);
    tread::python::bindVehicle(module);
    tread::python::bindFleet(module);
}
