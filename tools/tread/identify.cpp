#include "base/yaml_session.h"
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

void judgePaths(const std::vector<std::string>& paths) {
    std::vector<Problem> problems;
    for (const std::string& path : paths) {
        const std::string fault = pathFault(path);
        if (!fault.empty()) problems.push_back({"--fit", 0, 0, "", fault});
    }
    throwIfAny(std::move(problems));
}

}  // namespace

int identify(const IdentifyRequest& request) {
    judgePaths(request.fit);
    DiagnosisInputs inputs = readDiagnosisInputs(request.file, request.data, request.vehicle, request.without);
    warnOfImplausible(inputs.implausible);
    if (!request.fit.empty()) inputs.file.fit = request.fit;
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
        found = tread::calibrate::identificationOf(inputs.nominal, inputs.file, inputs.recorded, options);
    }
    std::vector<std::string>& warnings = found.gap.data_warnings;
    warnOf(warnings);
    warnings.insert(warnings.begin(), inputs.warnings.begin(), inputs.warnings.end());

    const nlohmann::json json = identificationJson(found);
    writeFile(out / "identify.json", jsonText(json));
    writeStages(found.gap.overlays, out / "logs");
    writeFile(out / "calibrated.yaml", calibratedVehicleYaml(inputs.nominal, found));
    writeFile(out / "report.html", identificationReport(inputs.nominal.vehicle.name, TREAD_VERSION, found));
    output.complete();
    if (request.json) printJson(json);
    else say(identificationText(found), hasSucceeded(found) ? Tone::good : Tone::bad);
    return hasSucceeded(found) ? kYes : kNo;
}

}  // namespace tread::program
