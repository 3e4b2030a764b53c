// Long work in a thread of its own. Meanwhile other threads of Python run, Ctrl-C ends the work, and a Python function
// is told how far it is.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <optional>
#include <thread>
#include <utility>

namespace tread::python {

namespace py = pybind11;

// What work ends with after it was asked to stop, where it has no other way. No std::exception: nobody takes it for a
// failure of a simulation.
struct Stopped {};

// Of work that runs: asks whether to stop, and tells which share is done, from 0 to 1. From any thread.
struct Watch {
    std::function<bool()> stop;
    std::function<void(double)> tell;
};

// Calls work(watch) and returns its result. A signal handler or a `progress` function that raises stops the work, and
// the exception goes on to the caller.
template <class Work>
auto interruptible(const Work& work, const py::object& progress = py::none()) {
    constexpr std::chrono::milliseconds kPeriod{50};  // of a look at signals: a person does not notice it
    std::atomic<bool> stop{false};
    std::atomic<double> share{0};
    const Watch watch{[&] { return stop.load(std::memory_order_relaxed); }, [&](double done) { share = done; }};
    std::packaged_task<decltype(work(watch))()> task([&] { return work(watch); });
    auto result = task.get_future();
    std::optional<py::error_already_set> raised;
    {
        const py::gil_scoped_release release;
        std::thread thread(std::move(task));
        double told = 0;
        while (result.wait_for(kPeriod) != std::future_status::ready) {
            if (stop) continue;
            const py::gil_scoped_acquire acquire;
            try {
                if (PyErr_CheckSignals() != 0) throw py::error_already_set();
                const double done = share;
                if (!progress.is_none() && done != std::exchange(told, done)) progress(done);
            } catch (py::error_already_set& error) {
                raised.emplace(error);
                stop = true;
            }
        }
        thread.join();
    }
    if (raised) throw py::error_already_set(*raised);
    return result.get();
}

}  // namespace tread::python
