#include <fmt/format.h>

#include <algorithm>

#include "commands.h"
#include "diagnose/data_checks.h"
#include "diagnose/diagnosis_json.h"
#include "diagnose/diagnosis_text.h"
#include "log/csv.h"
#include "output.h"
#include "progress.h"

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
    const DiagnosisFile file = loadDiagnosis(request.file, request.data);
    const Subject nominal = nominalSubject(file);
    const Recorded recorded = readRecordings(file);
    std::vector<std::string> warnings = recorded.notes;
    for (const DataWarning& warning : dataWarnings(file, recorded.logs, nominal)) warnings.push_back(toText(warning));
    for (const std::string& warning : warnings) fmt::print(stderr, "tread diagnose: {}\n", warning);

    Diagnosis diagnosis;
    {
        Progress bar(100, "%");
        DiagnoseOptions options;
        options.threads = request.threads;
        options.progress = [&](double done, const std::string&) { bar.at(100 * done); };
        diagnosis = tread::diagnose(nominal, file, recorded.logs, effectsToConsider(file), options);
    }
    diagnosis.data_warnings = std::move(warnings);

    const Path out = request.output.empty() ? Path("out") : Path(request.output);
    std::filesystem::create_directories(out);
    writeLogs(diagnosis, out);
    const nlohmann::json json = diagnosisJson(diagnosis);
    writeFile(out / "diagnosis.json", jsonText(json));
    if (request.json) printJson(json);
    else print(diagnosisText(diagnosis));
    return statusOf(diagnosis);
}

}  // namespace tread::program
