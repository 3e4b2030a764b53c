#include "compare/compare.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/read_yaml.h"
#include "commands.h"
#include "judge.h"
#include "log/csv.h"
#include "output.h"
#include "overlay.h"

namespace tread::program {
namespace {

constexpr std::size_t kRows = 10;  // in the table, unless more channels differ

void writeReport(const CompareOptions& options, const Log& reference, const Log& candidate,
                 const Comparison& comparison, const std::string& answer) {
    const std::string reference_name = Path(options.reference).filename(),
                      new_name = Path(options.candidate).filename();
    const bool alike = reference_name == new_name;  // then only the folders tell them apart
    const OverlayReport report{.title = "Comparison of " + new_name + " with " + reference_name,
                               .answer = answer,
                               .reference_name = alike ? options.reference : reference_name,
                               .candidate_name = alike ? options.candidate : new_name,
                               .version = std::string("tread ") + TREAD_VERSION,
                               .ok = comparison.same,
                               .channels = overlays(reference, candidate, comparison),
                               .warnings = remarks(comparison)};
    writeFile(options.report, overlayReport(report));
    std::fprintf(stderr, "overlay report: %s\n", options.report.c_str());
}

}  // namespace

int compare(const CompareOptions& options) {
    if (!options.envelope.empty() || !options.score.empty()) return judge(options);
    const Tolerances tolerances = options.tolerances.empty() ? Tolerances{} : readYaml<Tolerances>(options.tolerances);
    const Log reference = readLog(options.reference);
    const Log candidate = readLog(options.candidate);
    const Comparison comparison = tread::compare(reference, candidate, tolerances);
    const std::string words = text(comparison, std::max(kRows, comparison.differing()));
    if (!options.report.empty()) {
        writeReport(options, reference, candidate, comparison, words.substr(0, words.find('\n')));
    }
    if (options.json) {
        printJson(tread::json(comparison));
    } else {
        print(words);
    }
    return comparison.same ? kYes : kNo;
}

}  // namespace tread::program
