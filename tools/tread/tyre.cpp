// The command `tread tyre`: forces of a tyre at given points, its transients, its curves, and an overview.

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/text/number_text.h"
#include "base/yaml/setting.h"
#include "commands.h"
#include "kind_of_file.h"
#include "output.h"
#include "plausibility.h"
#include "tread/load.h"
#include "tyre_figures.h"
#include "tyre_overview.h"
#include "tyre_steady.h"
#include "tyre_transient.h"
#include "vehicle/fields.h"

namespace tread::program {
namespace {

void rejectOptionsThatDoNotFit(const TyreOptions& options) {
    std::vector<Problem> problems;
    const auto complain = [&](std::string option, std::string text) {
        problems.push_back({std::move(option), 0, 0, "", std::move(text)});
    };
    const bool transient = !options.transient.empty();
    if (!options.table.empty() && transient) {
        complain("--transient", "given together with --table, expected one of them; run the program twice");
    }
    if (options.table.empty() && !transient && !options.output.empty()) {
        complain("--output", "nothing to write to it, expected --table or --transient as well");
    }
    const TyreOptions usual;
    if (!transient && options.substeps != usual.substeps) complain("--substeps", "expected only with --transient");
    if (!transient && options.interpolate != usual.interpolate) {
        complain("--interpolate", "expected only with --transient");
    }
    if (!transient && options.standstill) complain("--standstill", "expected only with --transient");
    if (!problems.empty()) throw LoadError(std::move(problems));
}

// Answer of the command as text and as JSON.
struct TyreAnswer {
    std::string text;
    nlohmann::json json;
};

void addAnswer(TyreAnswer& outcome, const std::string& answer) {
    outcome.text += answer + "\n";
    if (!outcome.json.contains("answer")) outcome.json["answer"] = answer;
}

void writeTable(TyreAnswer& outcome, const TyreParams& tyre, const TyreOptions& options, Axes axes) {
    const bool transient = !options.transient.empty();
    const TransientOptions how{.axes = axes,
                               .linear = options.interpolate == "linear",
                               .substeps = options.substeps,
                               .standstill = options.standstill ? Standstill::hold : Standstill::paper};
    const std::size_t rows = transient ? writeTransientTable(tyre, options.transient, how, options.output)
                                       : writeSteadyTable(tyre, options.table, axes, options.output);
    addAnswer(outcome, fmt::format("Wrote {} to {}", counted(rows, transient ? "row" : "point"),
                                   options.output.empty() ? "standard output" : options.output));
    outcome.json[transient ? "transient" : "table"] = {
        {"rows", rows}, {"axes", options.axes}, {"file", options.output}};
}

void writePage(TyreAnswer& outcome, const TyreParams& tyre, const TyreOptions& options, Axes axes) {
    std::size_t charts = 0;
    writeFile(options.plot, tyrePage({tyre, axes}, charts));
    addAnswer(outcome, fmt::format("Wrote {} of {} to {}", counted(charts, "chart"), tyreName(tyre), options.plot));
    outcome.json["plot"] = {{"charts", charts}, {"axes", options.axes}, {"file", options.plot}};
}

void describeTyre(TyreAnswer& outcome, const TyreParams& tyre) {
    const std::vector<TyreFact> facts = tyreFacts(tyre);
    outcome.text = overviewText(tyre, facts);
    outcome.json["answer"] = outcome.text.substr(0, outcome.text.find('\n'));
    for (const TyreFact& fact : facts) {
        outcome.json["facts"][fmt::format("{} [{}]", fact.key, fact.unit)] = fact.value;
    }
}

}  // namespace

int tyre(const TyreOptions& given) {
    TyreOptions options = given;
    if (options.output == "-" || options.output == "/dev/stdout") options.output.clear();
    rejectOptionsThatDoNotFit(given);
    expectKind(options.tyre, {"tyre", "tir"});
    for (const std::string& table : {options.table, options.transient}) expectKind(table, {"table", "log"});
    TyreParams params = loadTyre(options.tyre);
    for (const std::string& note : params.notes) warn(note);
    applySettings(params, options.settings, "--set",
                  [](std::string_view) -> std::string { return "`tread describe tyre` lists all paths"; });
    warnOfImplausible(implausibleIn(params, options.tyre, {{options.settings, "--set"}}));
    const Axes axes = options.axes == "iso" ? Axes::iso : Axes::paper;

    const bool table = !options.table.empty() || !options.transient.empty();
    TyreAnswer outcome;
    if (table) writeTable(outcome, params, options, axes);
    if (!options.plot.empty()) writePage(outcome, params, options, axes);
    if (!table && options.plot.empty()) describeTyre(outcome, params);

    // Standard output is reserved for the table if that was written there.
    outcome.json["tyre"] = params.name;
    outcome.json["notes"] = params.notes;
    const std::string answer = options.json ? jsonText(outcome.json) : outcome.text;
    if (table && options.output.empty()) {
        fmt::print(stderr, "{}", answer);
    } else if (options.json) {
        print(answer);
    } else {
        say(answer);
    }
    return kYes;
}

}  // namespace tread::program
