// Campaigns.
#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "bind.h"
#include "campaign/result.h"
#include "campaign/work.h"
#include "campaign_begin.h"
#include "campaign_inputs.h"
#include "campaign_page.h"
#include "interruptible.h"
#include "output.h"

namespace tread::python {
namespace {

using campaign::Plan;
using campaign::Tally;
using program::Path;

struct Ran {
    Path folder;
    std::string answer;
};

// Runs what the folder lacks, and joins the results. Stopped: the runs that are done are kept.
Ran ran(const Plan& plan, const Path& folder, int threads, const Watch& watch) {
    program::beginCampaign(plan, folder, true, watch.stop);
    WorkOptions work;
    work.threads = threads;
    work.stop = watch.stop;
    work.progress = [&](std::uint64_t done, std::uint64_t of) {
        watch.tell(static_cast<double>(done) / static_cast<double>(of));
    };
    const campaign::Worked worked = campaign::work(plan, folder, program::measureOf(watch.stop), work);
    if (worked.stopped || !worked.complete) throw Stopped();
    const Tally found = merge(plan, {folder}, folder, false);
    writeFile(folder / "report.html", program::campaignPage(plan, folder, found));
    return {folder, program::campaignAnswer(plan, found)};
}

}  // namespace

void bindCampaign(py::module_& module) {
    py::class_<Plan>(module, "Plan")
        .def(py::init([](const std::string& file, const std::vector<std::string>& settings) {
                 return program::readCampaign(file, settings);
             }),
             py::arg("file"), py::arg("settings"), py::call_guard<py::gil_scoped_release>())
        .def("runs", [](const Plan& plan) { return plan.runs; })
        .def("title", [](const Plan& plan) { return plan.inputs.campaign.title; })
        .def(
            "run",
            [](const Plan& plan, const std::string& file, const std::string& output, int threads,
               const py::object& progress) {
                const Path folder = program::resultFolder(file, output);
                const Ran found =
                    interruptible([&](const Watch& watch) { return ran(plan, folder, threads, watch); }, progress);
                return py::make_tuple(found.folder.string(), found.answer);
            },
            py::arg("file"), py::arg("output"), py::arg("threads"), py::arg("progress"));
}

}  // namespace tread::python
