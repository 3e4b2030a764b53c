// Diagnosis and identification.
#include <pybind11/stl.h>

#include <filesystem>
#include <memory>

#include "bind.h"
#include "calibrate/identification_text.h"
#include "diagnose/answer/diagnosis_json.h"
#include "diagnose/answer/diagnosis_text.h"
#include "diagnose/answer/vehicle_with_effect.h"
#include "diagnose/answer/words.h"
#include "diagnose_check.h"
#include "interruptible.h"
#include "output.h"
#include "output_folder.h"
#include "report/diagnosis_report.h"
#include "report/identification_report.h"

namespace tread::python {
namespace {

using program::DiagnosisInputs;
using program::IdentifyRequest;
using program::OutputFolder;
using program::Path;

// What both answer: whether there is an answer, in words, as JSON, the car that was found, the page, warnings.
struct Answered {
    bool positive;
    std::string text, json, vehicle, report;
    std::vector<std::string> warnings;
};

// Stops at the beginning of a simulation; each takes a fraction of a second.
diagnose::Options optionsOf(int threads, const std::string& output, const Watch& watch) {
    diagnose::Options options;
    options.threads = threads;
    if (!output.empty()) options.cache = Path(output) / "cache";
    options.progress = [&watch](double done, const std::string&) { watch.tell(done); };
    options.before_each = [&watch] {
        if (watch.stop()) throw Stopped();
    };
    return options;
}

std::unique_ptr<OutputFolder> folderOf(const std::string& output) {
    return output.empty() ? nullptr : std::make_unique<OutputFolder>(output);
}

// Of reading; those of the data are among the answer's.
std::vector<std::string> warningsOf(const DiagnosisInputs& inputs, const std::vector<std::string>& of_data) {
    std::vector<std::string> all;
    for (const Problem& warning : inputs.implausible) all.push_back(toText(warning));
    all.insert(all.end(), of_data.begin(), of_data.end());
    return all;
}

Answered diagnosed(const std::string& file, const std::string& data, const std::string& vehicle, int threads,
                   const std::string& output, const Watch& watch) {
    using namespace diagnose::answer;
    const DiagnosisInputs inputs = program::readDiagnosisInputs(file, data, vehicle);
    const std::unique_ptr<OutputFolder> folder = folderOf(output);
    const Diagnosis found = program::diagnosisOf(inputs, optionsOf(threads, output, watch));
    if (folder) {
        program::writeDiagnosis(inputs, found, output);
        folder->complete();
    }
    const std::string& car = inputs.nominal.vehicle.name;
    return {isAnswered(found),
            diagnosisText(found),
            program::jsonText(diagnosisJson(found)),
            vehicleWithEffectYaml(inputs.nominal, found),
            diagnosisReport({"Diagnosis of " + car, car, TREAD_VERSION, found}),
            warningsOf(inputs, found.data_warnings)};
}

Answered identified(const IdentifyRequest& request, const Watch& watch) {
    using namespace calibrate;
    const DiagnosisInputs inputs = program::readIdentificationInputs(request, "fit");
    const std::unique_ptr<OutputFolder> folder = folderOf(request.output);
    const Identification found = program::identificationOf(inputs, optionsOf(request.threads, request.output, watch));
    if (folder) {
        program::writeIdentification(inputs, found, request.output);
        folder->complete();
    }
    return {hasSucceeded(found),
            identificationText(found),
            program::jsonText(identificationJson(found)),
            calibratedVehicleYaml(inputs.nominal, found),
            identificationReport(inputs.nominal.vehicle.name, TREAD_VERSION, found),
            warningsOf(inputs, found.gap.data_warnings)};
}

py::tuple tupleOf(const Answered& found) {
    return py::make_tuple(found.positive, found.text, found.json, found.vehicle, found.report, found.warnings);
}

}  // namespace

void bindDiagnosis(py::module_& module) {
    module.def(
        "diagnose",
        [](const std::string& file, const std::string& data, const std::string& vehicle, int threads,
           const std::string& output, const py::object& progress) {
            return tupleOf(interruptible(
                [&](const Watch& watch) { return diagnosed(file, data, vehicle, threads, output, watch); }, progress));
        },
        py::arg("file"), py::arg("data"), py::arg("vehicle"), py::arg("threads"), py::arg("output"),
        py::arg("progress"));
    module.def(
        "identify",
        [](const std::string& file, const std::vector<std::string>& fit, const std::vector<std::string>& without,
           const std::string& data, const std::string& vehicle, int threads, const std::string& output,
           const py::object& progress) {
            IdentifyRequest request;
            request.file = file, request.fit = fit, request.without = without, request.data = data;
            request.vehicle = vehicle, request.output = output, request.threads = threads;
            return tupleOf(interruptible([&](const Watch& watch) { return identified(request, watch); }, progress));
        },
        py::arg("file"), py::arg("fit"), py::arg("without"), py::arg("data"), py::arg("vehicle"), py::arg("threads"),
        py::arg("output"), py::arg("progress"));
}

}  // namespace tread::python
