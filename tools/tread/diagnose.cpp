#include <fmt/format.h>

#include <algorithm>

#include "commands.h"
#include "diagnose/diagnosis_json.h"
#include "diagnose/diagnosis_text.h"
#include "diagnose/vehicle_with_effect.h"
#include "diagnose_check.h"
#include "log/csv.h"
#include "output.h"
#include "progress.h"
#include "report/diagnosis_report.h"

namespace tread::program {
namespace {

// The three simulations of a drive, for whoever wants to look closer.
void writeLogs(const Diagnosis& diagnosis, const Path& folder) {
    for (const Overlay& overlay : diagnosis.overlays) {
        const Path here = folder / "logs" / overlay.recording;
        std::filesystem::create_directories(here);
        writeLog(here / "nominal.csv", overlay.nominal);
        writeLog(here / "calibrated.csv", overlay.calibrated);
        writeLog(here / "extended.csv", overlay.extended);
    }
}

int statusOf(const Diagnosis& diagnosis) {
    return diagnosis.verdict == Verdict::unknown || diagnosis.verdict == Verdict::not_testable ? kNo : kYes;
}

}  // namespace

int diagnose(const DiagnoseRequest& request) {
    if (!request.init.empty()) return initDiagnosis(request.init, request.vehicle);
    if (request.file.empty())
        throw LoadError({{"tread diagnose", 0, 0, "", "found no file, expected diagnosis.yaml, or --init FOLDER"}});
    const DiagnosisInputs inputs = readDiagnosisInputs(request.file, request.data);
    if (request.check) return checkData(inputs, request.json);
    for (const std::string& warning : inputs.warnings) fmt::print(stderr, "tread diagnose: {}\n", warning);

    Diagnosis diagnosis;
    {
        Progress bar(100, "%");
        DiagnoseOptions options;
        options.threads = request.threads;
        options.progress = [&](double done, const std::string&) { bar.at(100 * done); };
        diagnosis = tread::diagnose(inputs.nominal, inputs.file, inputs.logs, inputs.effects, options);
    }
    diagnosis.data_warnings = inputs.warnings;

    const Path out = request.output.empty() ? Path("out") : Path(request.output);
    std::filesystem::create_directories(out);
    writeLogs(diagnosis, out);
    const nlohmann::json json = diagnosisJson(diagnosis);
    writeFile(out / "diagnosis.json", jsonText(json));
    writeFile(out / "vehicle_with_effect.yaml", vehicleWithEffectYaml(inputs.nominal, diagnosis));
    const std::string& car = inputs.nominal.vehicle.name;
    writeFile(out / "report.html",
              diagnosisReport(
                  {.title = "Diagnosis of " + car, .vehicle = car, .version = TREAD_VERSION, .diagnosis = diagnosis}));
    if (request.json) printJson(json);
    else print(diagnosisText(diagnosis));
    return statusOf(diagnosis);
}

}  // namespace tread::program
