// A car that Python steps.
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <exception>
#include <optional>
#include <string>

#include "base/fields/reference_table.h"
#include "bind.h"
#include "car_inputs.h"
#include "host/car.h"
#include "host/channels.h"
#include "host/failure.h"
#include "run/simulate.h"
#include "vehicle/fields.h"

namespace tread::python {
namespace {

using host::Car;

std::string docOf(const host::Channel& channel) {
    const std::string limits = detail::limitsOf(About{channel.unit, "", channel.limits});
    return "[" + channel.unit + "] " + channel.meaning + (limits.empty() ? "" : ", " + limits);
}

// Name, unit and meaning of each channel.
py::list listOf(const std::vector<host::Channel>& channels) {
    py::list list;
    for (const host::Channel& channel : channels)
        list.append(py::make_tuple(channel.name, channel.unit, docOf(channel).substr(channel.unit.size() + 3)));
    return list;
}

const host::Channel& channelNamed(const std::vector<host::Channel>& channels, const std::string& name) {
    const auto index = host::indexOf(channels, name);
    if (!index) throw py::key_error(host::unknownChannelText(channels, name));
    return channels[*index];
}

VehicleInput inputOf(const py::kwargs& fields) {
    VehicleInput input;
    for (const auto& [key, value] : fields) {
        const auto name = key.cast<std::string>();
        const auto index = host::indexOf(host::inputChannels(), name);
        if (!index) throw py::type_error(host::unknownChannelText(host::inputChannels(), name));
        host::valueOf(input, host::inputChannels()[*index]) = value.cast<double>();
    }
    return input;
}

std::string textOf(const VehicleInput& input) {
    std::string text;
    for (const host::Channel& channel : host::inputChannels()) {
        const double value = host::valueOf(input, channel);
        if (value == 0) continue;
        text += (text.empty() ? "" : ", ") + channel.name + "=" + py::repr(py::float_(value)).cast<std::string>();
    }
    return "VehicleInput(" + text + ")";
}

Vector3 vectorOf(const std::array<double, 3>& v) {
    return {v[0], v[1], v[2]};
}

py::array_t<double> arrayOf(const Vector3& v) {
    return py::array_t<double>(3, v.data());
}

// Of Python's answer to where the ground is: None, a height, or (height, normal, friction).
RoadContact contactOf(const py::object& answer, const Vector3& centre_W) {
    RoadContact contact;
    contact.exists = !answer.is_none();
    if (!contact.exists) return contact;
    contact.point_W = centre_W;
    if (!py::isinstance<py::tuple>(answer)) {
        contact.point_W.z() = answer.cast<double>();
        return contact;
    }
    const auto parts = answer.cast<py::tuple>();
    if (parts.size() < 2 || parts.size() > 3)
        throw py::type_error("ground: found a tuple of " + std::to_string(parts.size()) +
                             ", expected None, a height or (height, normal, friction)");
    contact.point_W.z() = parts[0].cast<double>();
    contact.normal_W = vectorOf(parts[1].cast<std::array<double, 3>>());
    if (parts.size() == 3) contact.friction = parts[2].cast<double>();
    return contact;
}

// A car with what Python adds to it: a ground that is a function may raise.
class SteppedCar {
public:
    SteppedCar(const std::string& vehicle, const std::vector<std::string>& settings,
               const std::vector<std::string>& road, double step)
        : car_(readCar(vehicle, settings), step) {
        if (!road.empty()) car_.ground().use(roadOf(road));
    }

    Car& car() { return car_; }
    const Car& car() const { return car_; }

    void setGround(const py::function& ask) {
        car_.ground().use([this, ask](const Vector3& centre_W, std::size_t wheel) {
            const py::gil_scoped_acquire acquire;
            if (raised_ || fault_) return RoadContact{.exists = false};
            try {
                return contactOf(ask(centre_W.x(), centre_W.y(), centre_W.z(), wheel), centre_W);
            } catch (py::error_already_set& error) {
                raised_.emplace(error);
            } catch (const py::cast_error&) {
                fault_ = std::make_exception_ptr(
                    py::type_error("ground: expected None, a height or (height, normal, friction)"));
            } catch (const py::builtin_exception&) {
                fault_ = std::current_exception();
            }
            return RoadContact{.exists = false};
        });
    }

    void start(const Start& at) {
        guarded([&] { car_.start(at); });
    }

    // Signals are looked at between stretches of whole steps, which do not change the result.
    void advance(double duration, host::Course course) {
        const double stretch = 1000 * car_.step();  // some milliseconds
        double left = duration;
        while (course == host::Course::held && left > stretch) {
            guarded([&] { car_.advance(stretch); });
            left -= stretch;
            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        }
        guarded([&] { car_.advance(left); });
    }

private:
    template <class Work>
    void guarded(const Work& work) {
        raised_.reset();
        fault_ = nullptr;
        std::exception_ptr failure;
        {
            const py::gil_scoped_release release;
            try {
                work();
            } catch (const host::Failure& error) {
                failure = error.kind == host::Failure::Kind::broken
                              ? std::make_exception_ptr(SimulationError(error.what(), car_.time()))
                              : std::make_exception_ptr(std::invalid_argument(error.what()));
            }
        }
        if (raised_) throw py::error_already_set(*raised_);
        if (fault_) std::rethrow_exception(fault_);
        if (failure) std::rethrow_exception(failure);
    }

    Car car_;
    std::optional<py::error_already_set> raised_;
    std::exception_ptr fault_;
};

py::array_t<double> outputsOf(const SteppedCar& self) {
    const VehicleOutput& output = self.car().output();
    py::array_t<double> values(static_cast<py::ssize_t>(host::outputChannels().size()));
    std::size_t i = 0;
    for (const host::Channel& channel : host::outputChannels()) values.mutable_at(i++) = host::valueOf(output, channel);
    return values;
}

// Refusals outside of steps.
template <class Work>
auto refusing(const Work& work) {
    try {
        return work();
    } catch (const host::Failure& error) {
        throw std::invalid_argument(error.what());
    }
}

void bindInput(py::module_& module) {
    py::class_<VehicleInput> input(module, "VehicleInput",
                                   "What the driver does: VehicleInput(steering_wheel_angle=0.5, throttle=0.2).");
    input.def(py::init(&inputOf)).def("__repr__", &textOf);
    for (const host::Channel& channel : host::inputChannels()) {
        input.def_property(
            channel.name.c_str(), [&channel](const VehicleInput& self) { return host::valueOf(self, channel); },
            [&channel](VehicleInput& self, double value) { host::valueOf(self, channel) = value; },
            docOf(channel).c_str());
    }
    module.def("input_channels", [] { return listOf(host::inputChannels()); });
    module.def("output_channels", [] { return listOf(host::outputChannels()); });
}

}  // namespace

void bindVehicle(py::module_& module) {
    bindInput(module);
    py::class_<SteppedCar>(module, "Vehicle")
        .def(py::init([](const std::string& vehicle, const std::vector<std::string>& settings,
                         const std::vector<std::string>& road, double step) {
                 return refusing([&] { return std::make_unique<SteppedCar>(vehicle, settings, road, step); });
             }),
             py::arg("vehicle"), py::arg("settings"), py::arg("road"), py::arg("step"))
        .def("set_ground", &SteppedCar::setGround, py::arg("ask"))
        .def("set_wind",
             [](SteppedCar& self, const std::array<double, 3>& wind) {
                 refusing([&] { self.car().setWind(vectorOf(wind)); });
             })
        .def(
            "start",
            [](SteppedCar& self, double speed, double x, double y, double heading, const VehicleInput& input) {
                self.start({.x = x, .y = y, .heading = heading, .speed = speed, .input = input});
            },
            py::arg("speed"), py::arg("x"), py::arg("y"), py::arg("heading"), py::arg("input"))
        .def(
            "set_input",
            [](SteppedCar& self, const VehicleInput& input, bool ramp) {
                refusing([&] { self.car().setInput(input, ramp ? host::Course::ramp : host::Course::held); });
            },
            py::arg("input"), py::arg("ramp"))
        .def("input", [](const SteppedCar& self) { return self.car().input(); })
        .def(
            "advance",
            [](SteppedCar& self, double duration, bool ramp) {
                self.advance(duration, ramp ? host::Course::ramp : host::Course::held);
            },
            py::arg("duration"), py::arg("ramp"))
        .def("time", [](const SteppedCar& self) { return self.car().time(); })
        .def(
            "output",
            [](const SteppedCar& self, const std::string& name) {
                const host::Channel& channel = channelNamed(host::outputChannels(), name);
                return host::valueOf(self.car().output(), channel);
            },
            py::arg("name"))
        .def("outputs", &outputsOf)
        .def("position", [](const SteppedCar& self) { return arrayOf(self.car().motion().position_W); })
        .def("velocity", [](const SteppedCar& self) { return arrayOf(self.car().motion().velocity_W); })
        .def("angular_velocity", [](const SteppedCar& self) { return arrayOf(self.car().motion().angular_velocity_W); })
        .def("orientation",
             [](const SteppedCar& self) {
                 const Quaternion& q = self.car().motion().orientation;
                 const std::array<double, 4> parts{q.w(), q.x(), q.y(), q.z()};
                 return py::array_t<double>(4, parts.data());
             })
        .def("snapshot",
             [](const SteppedCar& self) {
                 const std::vector<std::byte> bytes = self.car().bytes();
                 return py::bytes(reinterpret_cast<const char*>(bytes.data()), bytes.size());
             })
        .def(
            "restore",
            [](SteppedCar& self, const std::string& bytes) {
                refusing([&] { self.car().restore(std::as_bytes(std::span(bytes))); });
            },
            py::arg("bytes"));
}

}  // namespace tread::python
