#include "judge.h"

#include <nlohmann/json.hpp>

#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "base/yaml/position.h"
#include "base/yaml/read.h"
#include "compare/cross_plots.h"
#include "compare/score.h"
#include "log/csv.h"
#include "log/log_columns.h"
#include "output.h"
#include "vehicle/fields.h"

namespace tread::program {
namespace {

Log readChecked(const std::string& file) {
    Log log = readLog(file);
    throwIfAny(unitFaults(log, file));
    return log;
}

// The default parameters when `given` is the name of the standard; otherwise those of the file `given`.
template <class T>
T parameters(const std::string& given, std::string_view standard, const char* option) {
    if (given == standard) return {};
    if (!std::filesystem::exists(given)) {
        throw LoadError({{"", 0, 0, "",
                          std::string("tread compare: found ") + quote(given) + " after " + option + ", expected " +
                              std::string(standard) + " or the name of a file"}});
    }
    return readYaml<T>(given);
}

void refuseOthers(const CompareOptions& options) {
    const char* const other = !options.report.empty()       ? "--report"
                              : !options.tolerances.empty() ? "--tolerances"
                                                            : nullptr;
    if (!other) return;
    throw LoadError({{"", 0, 0, "",
                      std::string("tread compare: ") + other +
                          " belongs to the plain comparison, not to --envelope and --score; leave out one of them"}});
}

}  // namespace

CrossPlots crossPlotsOf(const std::string& given, const char* option) {
    return parameters<CrossPlots>(given, "iso19364", option);
}

ScoreParams scoreParamsOf(const std::string& given, const char* option) {
    return parameters<ScoreParams>(given, "iso18571", option);
}

Tolerances readTolerances(const std::string& file, const Log& reference) {
    if (file.empty()) return {};
    Tolerances tolerances = readYaml<Tolerances>(file);
    std::vector<Problem> problems;
    for (const ToleranceFault& fault : unitFaults(tolerances, reference)) {
        const TextPosition position = positionOfValue(file, fault.path);
        problems.push_back({file, position.line, position.column, fault.path, fault.text});
    }
    throwIfAny(std::move(problems));
    return tolerances;
}

int judge(const CompareOptions& options) {
    refuseOthers(options);
    CrossPlots plots;
    ScoreParams params;
    if (!options.envelope.empty()) plots = crossPlotsOf(options.envelope);
    if (!options.score.empty()) params = scoreParamsOf(options.score);

    std::vector<NamedLog> measured{{options.reference, readChecked(options.reference)}};
    for (const std::string& file : options.repeats) measured.push_back({file, readChecked(file)});
    const Log simulated = readChecked(options.candidate);

    bool passed = true, judged = true;
    std::string words;
    nlohmann::json found;
    if (!options.envelope.empty()) {
        const CrossPlotResult result = judgeCrossPlots(simulated, measured, plots);
        passed = passed && result.inside;
        judged = judged && !result.plots.empty();
        words += text(result);
        found["envelope"] = tread::json(result);
    }
    if (!options.score.empty()) {
        const Scores result = scoreLogs(measured, simulated, params);
        passed = passed && result.passed;
        judged = judged && !result.channels.empty();
        words += (words.empty() ? "" : "\n") + text(result);
        found["score"] = tread::json(result);
    }
    if (options.json) {
        printJson(found);
    } else {
        say(words, passed && judged ? Tone::good : Tone::bad);
    }
    return !judged ? kBadInput : passed ? kYes : kNo;
}

}  // namespace tread::program
