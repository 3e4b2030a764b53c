#include "describable.h"

#include "base/concat.h"
#include "base/did_you_mean.h"
#include "base/field_path.h"
#include "base/number_text.h"
#include "base/read_yaml.h"
#include "base/schema.h"
#include "compare/cross_plots.h"
#include "compare/score.h"
#include "compare/tolerances.h"
#include "import/import_map.h"
#include "log/log_columns.h"
#include "metrics/metrics.h"
#include "run_inputs.h"
#include "tread/load.h"
#include "tyres_of.h"

namespace tread::program {
namespace {

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
    for (ReferenceRow& row : rows) row.default_text.clear();  // a column is there or not
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
        {"log", "the columns of a log", topOf<LogColumns>, logRows},
        {"import", "how a foreign log becomes a log", topOf<ImportMap>, referenceTable<ImportMap>,
         [] { return jsonSchema<ImportMap>("Import", "import.schema.json"); }, readDescribed<ImportMap>},
        {"tolerances", "how far two logs may differ", topOf<Tolerances>, referenceTable<Tolerances>,
         [] { return jsonSchema<Tolerances>("Tolerances", "tolerances.schema.json"); }, readDescribed<Tolerances>},
        {"envelope", "how far measurements may lie off a simulation", topOf<CrossPlots>, referenceTable<CrossPlots>,
         [] { return jsonSchema<CrossPlots>("Envelope", "envelope.schema.json"); }, readDescribed<CrossPlots>},
        {"score", "how the likeness of curves is rated", topOf<ScoreParams>, referenceTable<ScoreParams>,
         [] { return jsonSchema<ScoreParams>("Score", "score.schema.json"); }, readDescribed<ScoreParams>},
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
