// Steady-state forces of a tyre at many points.
#include "tread/tyre.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "base/fields/numbers.h"
#include "base/yaml/setting.h"
#include "bind.h"
#include "interruptible.h"
#include "kind_of_file.h"
#include "shipped_file.h"
#include "tread/load.h"
#include "tyre_axes.h"
#include "vehicle/fields.h"

namespace tread::python {
namespace {

using Numbers = py::array_t<double, py::array::c_style>;

TyreParams readTyre(const std::string& file, const std::vector<std::string>& settings) {
    const std::string path = program::shippedFile(file, "vehicles/tyres");
    program::expectKind(path, {"tyre", "tir"});
    TyreParams tyre = loadTyre(path);
    applySettings(tyre, settings, "settings",
                  [](std::string_view) -> std::string { return "`tread describe tyre` lists all paths"; });
    return tyre;
}

// Numbers of all points, or one for all of them.
struct Operand {
    const double* first;
    std::size_t step;  // 0: one for all

    double at(std::size_t point) const { return first[step * point]; }
};

// What each point is given by, in ISO 8855 axes.
constexpr std::array<const char*, 5> kOperands{"Fz", "alpha", "kappa", "gamma", "V"};

[[noreturn]] void refuse(const char* name, std::size_t point, double value) {
    throw LoadError({{name, 0, 0, "",
                      "found " + std::string(std::isnan(value) ? "nan" : "inf") + " at point " + std::to_string(point) +
                          ", expected finite numbers"}});
}

// Slip velocities in the paper's axes, in which Vy and with it Vsy have the other sign; alpha counts the same in both.
TyreSlip slipOf(double Fz, double alpha, double kappa, double gamma, double V) {
    const double speed = std::abs(V);
    return {.Fz = Fz, .gamma = gamma, .Vx = V, .Vsx = -kappa * speed, .Vsy = -std::tan(alpha) * speed};
}

// Field by field: result[field * points + point].
void compute(const TyreParams& tyre, const std::array<Operand, 5>& given, std::size_t points, double* result,
             const Watch& watch) {
    constexpr std::size_t kBetweenLooks = 4096;  // about a millisecond
    TyreSteadyState forces;
    std::array<double, 32> signs{};
    std::vector<const double*> fields;
    for (const Number& number : numbers(forces)) {
        signs[fields.size()] = program::axisSign(number.path, program::Axes::iso);
        fields.push_back(number.value);
    }
    for (std::size_t i = 0; i < points; ++i) {
        if (i % kBetweenLooks == 0) {
            if (watch.stop()) throw Stopped();
            watch.tell(static_cast<double>(i) / static_cast<double>(points));
        }
        std::array<double, 5> here{};
        for (std::size_t k = 0; k < here.size(); ++k) {
            here[k] = given[k].at(i);
            if (!std::isfinite(here[k])) refuse(kOperands[k], i, here[k]);
        }
        forces = steadyState(tyre, slipOf(here[0], here[1], here[2], here[3], here[4]));
        for (std::size_t f = 0; f < fields.size(); ++f) result[f * points + i] = signs[f] * *fields[f];
    }
}

std::size_t fieldCount() {
    TyreSteadyState any;
    return numbers(any).size();
}

// The operands are flat: each with one number for each point, or a single one.
py::array_t<double> forcesOf(const TyreParams& tyre, const std::array<Numbers, 5>& given, std::size_t points) {
    std::array<Operand, 5> operands{};
    for (std::size_t k = 0; k < given.size(); ++k) {
        const auto size = static_cast<std::size_t>(given[k].size());
        if (size != 1 && size != points) throw std::invalid_argument("arrays of different shapes");
        operands[k] = {given[k].data(), size == 1 ? 0u : 1u};
    }
    py::array_t<double> result({fieldCount(), points});
    double* const out = result.mutable_data();
    constexpr std::size_t kFew = 4096;  // done before anybody could interrupt them
    if (points <= kFew) {
        const py::gil_scoped_release release;
        compute(tyre, operands, points, out, {[] { return false; }, [](double) {}});
        return result;
    }
    interruptible([&](const Watch& watch) {
        compute(tyre, operands, points, out, watch);
        return true;
    });
    return result;
}

// Name, unit and meaning of each field, as forcesOf() has them.
template <Described T>
py::list fieldsOf() {
    py::list list;
    T object{};
    for (const Number& number : numbers(object))
        list.append(py::make_tuple(number.path, std::string(number.about.unit), std::string(number.about.meaning)));
    return list;
}

}  // namespace

void bindTyre(py::module_& module) {
    py::class_<TyreParams>(module, "Tyre")
        .def(py::init(&readTyre), py::arg("file"), py::arg("settings"), py::call_guard<py::gil_scoped_release>())
        .def_readonly("name", &TyreParams::name)
        .def_readonly("notes", &TyreParams::notes)
        .def("forces", &forcesOf, py::arg("operands"), py::arg("points"));
    module.def("tyre_force_fields", &fieldsOf<TyreSteadyState>);
}

}  // namespace tread::python
