#include "describable.h"

#include "accepting.h"
#include "base/fields/field_path.h"
#include "base/text/concat.h"
#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "base/yaml/read.h"
#include "base/yaml/schema.h"
#include "campaign_inputs.h"
#include "compare/cross_plots.h"
#include "compare/score.h"
#include "compare/tolerances.h"
#include "diagnose/catalogue/effect.h"
#include "diagnose/catalogue/effects_to_consider.h"
#include "diagnose/catalogue/plausible.h"
#include "import/import_map.h"
#include "log/log_columns.h"
#include "metrics/metrics.h"
#include "own_metrics.h"
#include "plausibility.h"
#include "recording/diagnosis_file.h"
#include "recording/subject_paths.h"
#include "run_inputs.h"
#include "scenario/expression/functions.h"
#include "shipped_file.h"
#include "tread/load.h"
#include "tyres_of.h"
#include "vehicle/fields.h"

namespace tread::program {
namespace {

using diagnose::catalogue::Direction;
using diagnose::catalogue::Effect;
using diagnose::catalogue::effectCatalogue;
using diagnose::catalogue::effectsToConsider;
using diagnose::catalogue::Knob;
using diagnose::catalogue::loadOwnEffects;
using diagnose::catalogue::OwnEffects;
using diagnose::catalogue::plausibleText;
using recording::checkedDiagnosis;
using recording::DiagnosisFile;
using recording::subjectNumber;

template <class T>
std::vector<TopField> topOf() {
    std::vector<TopField> fields;
    const T object{};
    T::describe(object, [&](std::string_view name, const auto&, const About& about) {
        fields.push_back({std::string(name), std::string(about.meaning)});
    });
    return fields;
}

std::vector<ReferenceRow> logRows() {
    std::vector<ReferenceRow> rows = referenceTable<LogColumns>();
    for (ReferenceRow& row : rows) row.default_text.clear();  // columns have no default
    return rows;
}

std::vector<TopField> manoeuvreFields() {
    std::vector<TopField> fields;
    for (const Manoeuvre& known : manoeuvres()) {
        fields.push_back({std::string(known.name), std::string(known.description)});
    }
    return fields;
}

std::vector<ReferenceRow> metricRows() {
    std::vector<ReferenceRow> rows;
    for (const Manoeuvre& known : manoeuvres()) {
        for (const MetricDefinition& metric : known.definitions()) {
            rows.push_back({joinPath(known.name, metric.name), metric.unit,
                            concat({metric.title, ": ", metric.definition}), "", ""});
        }
    }
    return rows;
}

// "; can be taken for: mass, fuel".
std::string alikeText(const Effect& effect) {
    std::string text;
    for (const std::string& other : effect.alike) text += (text.empty() ? "; can be mistaken for: " : ", ") + other;
    return text;
}

std::vector<TopField> effectFields() {
    std::vector<TopField> fields;
    for (const Effect& effect : effectCatalogue())
        fields.push_back({effect.name, concat({effect.question, " (sizes: ", effect.source, ")", alikeText(effect)})});
    return fields;
}

// Change of a number by a knob at its typical size, in words.
std::string movement(const Knob& knob, std::size_t path, const ReferenceRow& number) {
    const double share = knob.shares.empty() ? 1 : knob.shares[path];
    const std::string_view sign = knob.direction == Direction::either                ? (share < 0 ? "-/+" : "+/-")
                                  : (knob.direction == Direction::up) == (share > 0) ? "+"
                                                                                     : "-";
    const double size = std::abs(share) * knob.typical;
    const std::string amount = knob.relative ? numberText(100 * size) + " %"
                               : number.unit.empty() || number.unit == "-"
                                   ? numberText(size)
                                   : concat({numberText(size), " ", number.unit});
    return concat({sign, " ", amount});
}

std::vector<ReferenceRow> effectRows() {
    std::vector<ReferenceRow> rows;
    for (const Effect& effect : effectCatalogue()) {
        for (const Knob& knob : effect.knobs) {
            for (std::size_t i = 0; i < knob.paths.size(); ++i) {
                const ReferenceRow* known = subjectNumber(knob.paths[i]);
                const ReferenceRow number = known ? *known : ReferenceRow{};
                rows.push_back({joinPath(effect.name, knob.paths[i]), number.unit,
                                concat({"typically ", movement(knob, i, number), ": ", number.meaning}),
                                plausibleText(knob.paths[i]), ""});
            }
        }
    }
    return rows;
}

FileReading readOwnEffectsFile(const Path& file) {
    loadOwnEffects(file);
    return {};
}

// The logs may be in a folder that is given only to the diagnosis, so their existence is not checked.
FileReading readDiagnosisFile(const Path& file) {
    effectsToConsider(checkedDiagnosis(file, shippedFileNamed));
    return {};
}

FileReading readVehicleFile(const Path& file) {
    FileReading found;
    const VehicleParams car = readVehicle(file.string(), found.faults);
    found.warnings = implausibleIn(car, file.string());
    for (const auto& [path, tyre] : tyresOf(car)) {
        for (const std::string& note : tyre->notes) found.notes.push_back(path + ": " + note);
    }
    return found;
}

FileReading readScenarioFile(const Path& file) {
    FileReading found;
    const Scenario scenario = readScenario(file.string(), found.faults);
    found.warnings = implausibleIn(scenario, file.string());
    return found;
}

FileReading readOwnMetricsFile(const Path& file) {
    checkOwnMetricsFile(file.string());
    return {};
}

// An example and the rules, then the functions.
std::vector<TopField> expressionFields() {
    std::vector<TopField> fields = {
        {"example", "max(abs(chassis.roll), start(\"countersteer\"), end()) with the unit deg"},
        {"condition",
         "abs(rate(chassis.roll)) < 1.5 deg/s and chassis.vx > 5 m/s: in until.when of a phase, or in duration(...), "
         "longest(...), time_of(...), count(...)"},
        {"names",
         "channels as the log calls them; vehicle.<path> and scenario.<path> are numbers of the run (metrics only)"},
        {"numbers", "with their unit: 0.3 g, 40 km/h, 2 s; 0 fits everything; the radian counts as 1"},
        {"signs", "+ - * / ^ < <= > >= == != and or not ( )"}};
    for (const FunctionAbout& about : functions()) fields.push_back({callOf(about), std::string(about.meaning)});
    return fields;
}

std::vector<ReferenceRow> expressionRows() {
    std::vector<ReferenceRow> rows;
    for (const TopField& field : expressionFields()) rows.push_back({field.name, "", field.meaning, "", ""});
    return rows;
}

FileReading readAcceptFile(const Path& file) {
    return {.notes = checkAcceptFile(file.string())};
}

template <class T>
FileReading readDescribed(const Path& file) {
    readYaml<T>(file);
    return {};
}

}  // namespace

const std::vector<Describable>& describables() {
    static const std::vector<Describable> list = {
        {"vehicle", "a car", topOf<VehicleParams>, referenceTable<VehicleParams>,
         [] { return jsonSchema<VehicleParams>("Car", "vehicle.schema.json"); }, readVehicleFile},
        {"tyre", "a tyre", topOf<TyreParams>, referenceTable<TyreParams>,
         [] { return jsonSchema<TyreParams>("Tyre", "tyre.schema.json"); }, readTyreFile},
        {"scenario", "a manoeuvre", topOf<Scenario>, referenceTable<Scenario>,
         [] { return jsonSchema<Scenario>("Manoeuvre", "scenario.schema.json"); }, readScenarioFile},
        {"accept", "conditions on the metrics of a run", topOf<AcceptFile>, referenceTable<AcceptFile>,
         [] { return jsonSchema<AcceptFile>("Accept", "accept.schema.json"); }, readAcceptFile},
        {"own_metrics", "metrics of your own", topOf<OwnMetricsFile>, referenceTable<OwnMetricsFile>,
         [] { return jsonSchema<OwnMetricsFile>("OwnMetrics", "own_metrics.schema.json"); }, readOwnMetricsFile},
        {"expressions", "what until.when of a phase and own metrics are written in", expressionFields, expressionRows},
        {"log", "the columns of a log", topOf<LogColumns>, logRows},
        {"import", "how a foreign log becomes a log", topOf<ImportMap>, referenceTable<ImportMap>,
         [] { return jsonSchema<ImportMap>("Import", "import.schema.json"); }, readDescribed<ImportMap>},
        {"tolerances", "how far two logs may differ", topOf<Tolerances>, referenceTable<Tolerances>,
         [] { return jsonSchema<Tolerances>("Tolerances", "tolerances.schema.json"); }, readDescribed<Tolerances>},
        {"envelope", "how far measurements may deviate from a simulation", topOf<CrossPlots>,
         referenceTable<CrossPlots>, [] { return jsonSchema<CrossPlots>("Envelope", "envelope.schema.json"); },
         readDescribed<CrossPlots>},
        {"score", "how the agreement of curves is rated", topOf<ScoreParams>, referenceTable<ScoreParams>,
         [] { return jsonSchema<ScoreParams>("Score", "score.schema.json"); }, readDescribed<ScoreParams>},
        {"diagnosis", "input of a diagnosis: car, recordings, tolerances", topOf<DiagnosisFile>,
         referenceTable<DiagnosisFile>, [] { return jsonSchema<DiagnosisFile>("Diagnosis", "diagnosis.schema.json"); },
         readDiagnosisFile},
        {"campaign", "many runs: cars, scenarios, what differs between them", topOf<campaign::CampaignFile>,
         referenceTable<campaign::CampaignFile>,
         [] { return jsonSchema<campaign::CampaignFile>("Campaign", "campaign.schema.json"); }, readCampaignFile},
        {"own_effects", "additional effects for a diagnosis", topOf<OwnEffects>, referenceTable<OwnEffects>,
         [] { return jsonSchema<OwnEffects>("Effects", "own_effects.schema.json"); }, readOwnEffectsFile},
        {"effects", "possible causes of a gap between model and car", effectFields, effectRows},
        {"metrics", "the metrics of each manoeuvre, undefined when a log lacks what they need", manoeuvreFields,
         metricRows},
    };
    return list;
}

std::vector<std::string_view> describableNames(bool only_files) {
    std::vector<std::string_view> names;
    for (const Describable& entry : describables()) {
        if (entry.isFile() || !only_files) names.push_back(entry.name);
    }
    return names;
}

const Describable& describable(std::string_view name, bool only_files) {
    for (const Describable& entry : describables()) {
        if (entry.name == name && (entry.isFile() || !only_files)) return entry;
    }
    rejectName(only_files ? "kind of file" : "description", name, describableNames(only_files));
}

FileReading readTyreFile(const Path& file) {
    const TyreParams tyre = loadTyre(file);
    return {tyre.notes, implausibleIn(tyre, file.string()), {}};
}

void rejectName(std::string_view what, std::string_view name, const std::vector<std::string_view>& known) {
    throw LoadError(
        {{"", 0, 0, "",
          concat({"tread: there is no ", what, " ", quote(name), ", only ", listed(known), didYouMean(name, known)})}});
}

}  // namespace tread::program
