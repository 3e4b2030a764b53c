#include <algorithm>

#include "commands.h"
#include "diagnose/answer/diagnosis.h"
#include "diagnose/answer/diagnosis_json.h"
#include "diagnose/answer/diagnosis_text.h"
#include "diagnose/answer/vehicle_with_effect.h"
#include "diagnose/answer/words.h"
#include "diagnose/diagnose.h"
#include "diagnose/options.h"
#include "diagnose_all.h"
#include "diagnose_check.h"
#include "output.h"
#include "output_folder.h"
#include "plausibility.h"
#include "report/diagnosis_report.h"
#include "shipped_drives.h"
#include "stages.h"
#include "terminal.h"

namespace tread::program {
namespace {

using diagnose::answer::Diagnosis;
using diagnose::answer::diagnosisJson;
using diagnose::answer::diagnosisText;
using diagnose::answer::isAnswered;
using diagnose::answer::vehicleWithEffectYaml;

}  // namespace

Diagnosis diagnosisOf(const DiagnosisInputs& inputs, const tread::diagnose::Options& asked) {
    tread::diagnose::Options options = asked;
    options.possible_next = shippedDrives();
    try {
        Diagnosis found =
            tread::diagnose::diagnosisOf(inputs.nominal, inputs.file, inputs.recorded, inputs.effects, options);
        found.data_warnings.insert(found.data_warnings.begin(), inputs.warnings.begin(), inputs.warnings.end());
        return found;
    } catch (const SimulationError& error) {
        throw SimulationError(withSuspects(error, inputs.implausible), error.time, error.suspect);
    }
}

void writeDiagnosis(const DiagnosisInputs& inputs, const Diagnosis& diagnosis, const Path& folder) {
    const nlohmann::json json = diagnosisJson(diagnosis);
    writeFile(folder / "diagnosis.json", jsonText(json));
    writeStages(diagnosis.overlays, folder / "logs");
    writeFile(folder / "vehicle_with_effect.yaml", vehicleWithEffectYaml(inputs.nominal, diagnosis));
    const std::string& car = inputs.nominal.vehicle.name;
    writeFile(folder / "report.html",
              diagnosisReport(
                  {.title = "Diagnosis of " + car, .vehicle = car, .version = TREAD_VERSION, .diagnosis = diagnosis}));
}

Diagnosis diagnoseInto(const DiagnosisInputs& inputs, const Path& out, tread::diagnose::Options options) {
    const OutputFolder output(out);
    options.cache = out / "cache";
    const Diagnosis diagnosis = diagnosisOf(inputs, options);
    try {
        writeDiagnosis(inputs, diagnosis, out);
    } catch (const FileError&) {  // perhaps the disk is full: what is kept for a next diagnosis gives way
        std::error_code ignored;
        if (std::filesystem::remove_all(options.cache, ignored) == 0) throw;
        writeDiagnosis(inputs, diagnosis, out);
    }
    output.complete();
    return diagnosis;
}

int diagnose(const DiagnoseRequest& request) {
    if (!request.init.empty()) return initDiagnosis(request.init, request.vehicle);
    if (!request.all.empty()) return diagnoseAll(request);
    if (request.file.empty()) {
        throw LoadError(
            {{"tread diagnose", 0, 0, "", "found no file, expected a diagnosis.yaml, --all FOLDER or --init FOLDER"}});
    }
    const DiagnosisInputs inputs = readDiagnosisInputs(request.file, request.data, request.vehicle);
    warnOfImplausible(inputs.implausible, request.strict);
    tread::diagnose::Options options;
    options.threads = request.threads;
    const Path out = request.output.empty() ? Path("out") : Path(request.output);
    if (request.check) {
        options.cache = out / "cache";
        return checkData(inputs, options, request.json);
    }
    warnOf(inputs.warnings);
    Diagnosis diagnosis;
    {
        Progress bar(100, "%");
        options.progress = [&](double done, const std::string&) { bar.at(100 * done); };
        diagnosis = diagnoseInto(inputs, out, options);
    }
    warnOf(diagnosis.data_warnings);
    const bool answered = isAnswered(diagnosis);
    if (request.json) printJson(diagnosisJson(diagnosis));
    else say(diagnosisText(diagnosis), answered ? Tone::good : Tone::bad);
    return answered ? kYes : kNo;
}

}  // namespace tread::program
