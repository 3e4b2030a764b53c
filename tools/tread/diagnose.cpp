#include <algorithm>

#include "commands.h"
#include "diagnose/answer/diagnosis.h"
#include "diagnose/answer/diagnosis_json.h"
#include "diagnose/answer/diagnosis_text.h"
#include "diagnose/answer/vehicle_with_effect.h"
#include "diagnose/answer/words.h"
#include "diagnose/diagnose.h"
#include "diagnose/options.h"
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

int diagnose(const DiagnoseRequest& request) {
    if (!request.init.empty()) return initDiagnosis(request.init, request.vehicle);
    if (request.file.empty())
        throw LoadError({{"tread diagnose", 0, 0, "", "found no file, expected a diagnosis.yaml or --init FOLDER"}});
    const DiagnosisInputs inputs = readDiagnosisInputs(request.file, request.data, request.vehicle);
    warnOfImplausible(inputs.implausible, request.strict);
    const Path out = request.output.empty() ? Path("out") : Path(request.output);
    tread::diagnose::Options options;
    options.threads = request.threads;
    options.cache = out / "cache";
    if (request.check) return checkData(inputs, options, request.json);
    warnOf(inputs.warnings);
    const OutputFolder output(out);

    Diagnosis diagnosis;
    {
        Progress bar(100, "%");
        options.possible_next = shippedDrives();
        options.progress = [&](double done, const std::string&) { bar.at(100 * done); };
        try {
            diagnosis =
                tread::diagnose::diagnosisOf(inputs.nominal, inputs.file, inputs.recorded, inputs.effects, options);
        } catch (const SimulationError& error) {
            throw SimulationError(withSuspects(error, inputs.implausible), error.time, error.suspect);
        }
    }
    warnOf(diagnosis.data_warnings);
    diagnosis.data_warnings.insert(diagnosis.data_warnings.begin(), inputs.warnings.begin(), inputs.warnings.end());

    const nlohmann::json json = diagnosisJson(diagnosis);
    writeFile(out / "diagnosis.json", jsonText(json));
    writeStages(diagnosis.overlays, out / "logs");
    writeFile(out / "vehicle_with_effect.yaml", vehicleWithEffectYaml(inputs.nominal, diagnosis));
    const std::string& car = inputs.nominal.vehicle.name;
    writeFile(out / "report.html",
              diagnosisReport(
                  {.title = "Diagnosis of " + car, .vehicle = car, .version = TREAD_VERSION, .diagnosis = diagnosis}));
    output.complete();
    const bool answered = isAnswered(diagnosis);
    if (request.json) printJson(json);
    else say(diagnosisText(diagnosis), answered ? Tone::good : Tone::bad);
    return answered ? kYes : kNo;
}

}  // namespace tread::program
