// The descriptions that `tread describe` shows.
#include <pybind11/stl.h>

#include "bind.h"
#include "describable.h"

namespace tread::python {
namespace {

py::list rowsOf(const std::string& what) {
    py::list rows;
    for (const ReferenceRow& row : program::describable(what, false).rows()) {
        py::dict one;
        one["path"] = row.path;
        one["unit"] = row.unit;
        one["meaning"] = row.meaning;
        one["limits"] = row.limits;
        one["default"] = row.default_text;
        rows.append(one);
    }
    return rows;
}

}  // namespace

void bindDescriptions(py::module_& module) {
    module.def("describables", [] { return program::describableNames(false); });
    module.def("describe", &rowsOf, py::arg("what"));
}

}  // namespace tread::python
