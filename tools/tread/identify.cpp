#include "base/yaml/session.h"
#include "calibrate/identification.h"
#include "calibrate/identification_text.h"
#include "commands.h"
#include "diagnose/options.h"
#include "diagnose_check.h"
#include "output.h"
#include "output_folder.h"
#include "plausibility.h"
#include "recording/subject_paths.h"
#include "report/identification_report.h"
#include "stages.h"
#include "terminal.h"

namespace tread::program {
namespace {

using calibrate::calibratedVehicleYaml;
using calibrate::hasSucceeded;
using calibrate::Identification;
using calibrate::identificationJson;
using calibrate::identificationText;
using recording::pathFault;

void judgePaths(const std::vector<std::string>& paths, const std::string& source) {
    std::vector<Problem> problems;
    for (const std::string& path : paths) {
        const std::string fault = pathFault(path);
        if (!fault.empty()) problems.push_back({source, 0, 0, "", fault});
    }
    throwIfAny(std::move(problems));
}

}  // namespace

DiagnosisInputs readIdentificationInputs(const IdentifyRequest& request, const std::string& source) {
    judgePaths(request.fit, source);
    DiagnosisInputs inputs = readDiagnosisInputs(request.file, request.data, request.vehicle, request.without);
    if (!request.fit.empty()) inputs.file.fit = request.fit;
    return inputs;
}

Identification identificationOf(const DiagnosisInputs& inputs, const tread::diagnose::Options& options) {
    Identification found = tread::calibrate::identificationOf(inputs.nominal, inputs.file, inputs.recorded, options);
    std::vector<std::string>& warnings = found.gap.data_warnings;
    warnings.insert(warnings.begin(), inputs.warnings.begin(), inputs.warnings.end());
    return found;
}

void writeIdentification(const DiagnosisInputs& inputs, const Identification& found, const Path& folder) {
    const nlohmann::json json = identificationJson(found);
    writeFile(folder / "identify.json", jsonText(json));
    writeStages(found.gap.overlays, folder / "logs");
    writeFile(folder / "calibrated.yaml", calibratedVehicleYaml(inputs.nominal, found));
    writeFile(folder / "report.html", identificationReport(inputs.nominal.vehicle.name, TREAD_VERSION, found));
}

int identify(const IdentifyRequest& request) {
    const DiagnosisInputs inputs = readIdentificationInputs(request, "--fit");
    warnOfImplausible(inputs.implausible);
    warnOf(inputs.warnings);

    const Path out = request.output.empty() ? Path("out") : Path(request.output);
    const OutputFolder output(out);
    Identification found;
    {
        Progress bar(100, "%");
        tread::diagnose::Options options;
        options.threads = request.threads;
        options.cache = out / "cache";
        options.progress = [&](double done, const std::string&) { bar.at(100 * done); };
        found = identificationOf(inputs, options);
    }
    warnOf(found.gap.data_warnings);
    writeIdentification(inputs, found, out);
    output.complete();
    if (request.json) printJson(identificationJson(found));
    else say(identificationText(found), hasSucceeded(found) ? Tone::good : Tone::bad);
    return hasSucceeded(found) ? kYes : kNo;
}

}  // namespace tread::program
