#include "describable.h"

#include "accepting.h"
#include "base/concat.h"
#include "base/did_you_mean.h"
#include "base/field_path.h"
#include "base/number_text.h"
#include "base/read_yaml.h"
#include "base/schema.h"
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
#include "recording/diagnosis_file.h"
#include "recording/subject_paths.h"
#include "run_inputs.h"
#include "tread/load.h"
#include "tyres_of.h"

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
            rows.push_back({joinPath(known.name, metric.name), metric.unit, metric.definition, "", ""});
        }
    }
    return rows;
}

// "; can be taken for: mass, fuel".
std::string alikeText(const Effect& effect) {
    std::string text;
    for (const std::string& other : effect.alike) text += (text.empty() ? "; can be taken for: " : ", ") + other;
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

std::vector<std::string> readOwnEffectsFile(const Path& file) {
    loadOwnEffects(file);
    return {};
}

// The logs may be in a folder that is given only to the diagnosis, so their existence is not checked.
std::vector<std::string> readDiagnosisFile(const Path& file) {
    effectsToConsider(checkedDiagnosis(file));
    return {};
}

std::vector<std::string> readVehicleFile(const Path& file) {
    const VehicleParams car = loadVehicle(file);
    std::vector<std::string> notes;
    for (const auto& [path, tyre] : tyresOf(car)) {
        for (const std::string& note : tyre->notes) notes.push_back(path + ": " + note);
    }
    return notes;
}

std::vector<std::string> readScenarioFile(const Path& file) {
    readScenario(file.string());
    return {};
}

std::vector<std::string> readAcceptFile(const Path& file) {
    checkAcceptFile(file.string());
    return {};
}

template <class T>
std::vector<std::string> readDescribed(const Path& file) {
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
        {"accept", "what the metrics of a run must be", topOf<AcceptFile>, referenceTable<AcceptFile>,
         [] { return jsonSchema<AcceptFile>("Accept", "accept.schema.json"); }, readAcceptFile},
        {"log", "the columns of a log", topOf<LogColumns>, logRows},
        {"import", "how a foreign log becomes a log", topOf<ImportMap>, referenceTable<ImportMap>,
         [] { return jsonSchema<ImportMap>("Import", "import.schema.json"); }, readDescribed<ImportMap>},
        {"tolerances", "how far two logs may differ", topOf<Tolerances>, referenceTable<Tolerances>,
         [] { return jsonSchema<Tolerances>("Tolerances", "tolerances.schema.json"); }, readDescribed<Tolerances>},
        {"envelope", "how far measurements may lie off a simulation", topOf<CrossPlots>, referenceTable<CrossPlots>,
         [] { return jsonSchema<CrossPlots>("Envelope", "envelope.schema.json"); }, readDescribed<CrossPlots>},
        {"score", "how the likeness of curves is rated", topOf<ScoreParams>, referenceTable<ScoreParams>,
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

std::vector<std::string> readTyreFile(const Path& file) {
    return loadTyre(file).notes;
}

void rejectName(std::string_view what, std::string_view name, const std::vector<std::string_view>& known) {
    throw LoadError(
        {{"", 0, 0, "",
          concat({"tread: there is no ", what, " ", quote(name), ", only ", listed(known), didYouMean(name, known)})}});
}

}  // namespace tread::program
