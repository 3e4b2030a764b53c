// Many cars that are stepped together: what tread.VectorEnv stands on.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bind.h"
#include "car_inputs.h"
#include "host/channels.h"
#include "tread/car_fleet.h"

namespace tread::python {
namespace {

using Numbers = py::array_t<double, py::array::c_style>;
using Flags = py::array_t<bool, py::array::c_style>;

std::vector<const host::Channel*> channelsNamed(const std::vector<host::Channel>& all,
                                                const std::vector<std::string>& names) {
    std::vector<const host::Channel*> found;
    for (const std::string& name : names) {
        const auto index = host::indexOf(all, name);
        if (!index) throw std::invalid_argument(host::unknownChannelText(all, name));
        found.push_back(&all[*index]);
    }
    return found;
}

std::vector<VehicleParams> carsOf(std::size_t count, const std::string& vehicle,
                                  const std::vector<std::vector<std::string>>& settings) {
    std::vector<VehicleParams> cars;
    for (const std::vector<std::string>& own : settings) cars.push_back(readCar(vehicle, own));
    if (cars.size() == 1) cars.resize(count, cars.front());
    return cars;
}

class Fleet {
public:
    Fleet(std::size_t count, const std::string& vehicle, const std::vector<std::vector<std::string>>& settings,
          const std::vector<std::string>& road, double step, int threads, const std::vector<std::string>& observed,
          const std::vector<std::string>& acted)
        : fleet_(carsOf(count, vehicle, settings), {.step = step, .threads = threads}),
          outputs_(count),
          observed_(channelsNamed(host::outputChannels(), observed)),
          acted_(channelsNamed(host::inputChannels(), acted)) {
        if (!road.empty()) fleet_.setRoad(roadOf(road));
    }

    // starts: speed, x, y, heading of each car.
    void reset(const Flags& which, const Numbers& starts) {
        std::vector<Start> from(fleet_.size());
        for (std::size_t i = 0; i < from.size(); ++i) {
            const double* const row = starts.data() + 4 * i;
            from[i] = {.x = row[1], .y = row[2], .heading = row[3], .speed = row[0]};
        }
        const std::vector<bool> mask(which.data(), which.data() + which.size());
        const py::gil_scoped_release release;
        fleet_.reset(from, mask);
        fleet_.output(outputs_);
    }

    void step(const Numbers& actions, int steps) {
        const double* const all = actions.data();
        const py::gil_scoped_release release;
        const std::span<VehicleInput> inputs = fleet_.inputs();
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            for (std::size_t k = 0; k < acted_.size(); ++k)
                host::valueOf(inputs[i], *acted_[k]) = all[i * acted_.size() + k];
        }
        fleet_.advance(steps);
        fleet_.output(outputs_);
    }

    // (cars, observed channels)
    Numbers observations() const {
        Numbers result({outputs_.size(), observed_.size()});
        double* out = result.mutable_data();
        for (const VehicleOutput& output : outputs_) {
            for (const host::Channel* channel : observed_) *out++ = host::valueOf(output, *channel);
        }
        return result;
    }

    Numbers output(const std::string& name) const {
        const host::Channel& channel = *channelsNamed(host::outputChannels(), {name}).front();
        Numbers result(static_cast<py::ssize_t>(outputs_.size()));
        std::transform(outputs_.begin(), outputs_.end(), result.mutable_data(),
                       [&](const VehicleOutput& output) { return host::valueOf(output, channel); });
        return result;
    }

    // Of each car: its motion is not finite; it lies on its side or roof.
    std::pair<Flags, Flags> lost() const {
        Flags broken(static_cast<py::ssize_t>(fleet_.size())), rolled(static_cast<py::ssize_t>(fleet_.size()));
        for (std::size_t i = 0; i < fleet_.size(); ++i) {
            const ChassisMotion motion = fleet_.motion(i);
            const bool finite = motion.position_W.allFinite() && motion.velocity_W.allFinite() &&
                                motion.angular_velocity_W.allFinite() && motion.orientation.coeffs().allFinite();
            broken.mutable_at(i) = !finite;
            rolled.mutable_at(i) = finite && (motion.orientation * Vector3::UnitZ()).z() <= 0;
        }
        return {broken, rolled};
    }

private:
    CarFleet fleet_;
    std::vector<VehicleOutput> outputs_;
    std::vector<const host::Channel*> observed_, acted_;
};

// Unit, lowest and highest value of inputs by name.
py::list limitsOf(const std::vector<std::string>& names) {
    py::list list;
    for (const host::Channel* channel : channelsNamed(host::inputChannels(), names))
        list.append(py::make_tuple(channel->unit, channel->limits.lowest, channel->limits.highest));
    return list;
}

}  // namespace

void bindFleet(py::module_& module) {
    py::class_<Fleet>(module, "Fleet")
        .def(py::init<std::size_t, const std::string&, const std::vector<std::vector<std::string>>&,
                      const std::vector<std::string>&, double, int, const std::vector<std::string>&,
                      const std::vector<std::string>&>(),
             py::arg("count"), py::arg("vehicle"), py::arg("settings"), py::arg("road"), py::arg("step"),
             py::arg("threads"), py::arg("observed"), py::arg("acted"), py::call_guard<py::gil_scoped_release>())
        .def("reset", &Fleet::reset, py::arg("which"), py::arg("starts"))
        .def("step", &Fleet::step, py::arg("actions"), py::arg("steps"))
        .def("observations", &Fleet::observations)
        .def("output", &Fleet::output, py::arg("name"))
        .def("lost", &Fleet::lost);
    module.def("input_limits", &limitsOf, py::arg("names"));
}

}  // namespace tread::python
