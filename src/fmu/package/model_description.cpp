#include "fmu/package/model_description.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "base/text/concat.h"
#include "base/text/markup.h"
#include "base/text/number_text.h"
#include "base/units/units.h"
#include "fmu/variables.h"
#include "host/version.h"

namespace tread::fmu {
namespace {

std::string attribute(std::string_view name, std::string_view value) {
    return concat({" ", name, "=\"", escapeMarkup(value), "\""});
}

bool hasUnit(const Variable& variable) {
    return !variable.unit.empty() && variable.unit != "-";
}

// ---- Units ----

std::string baseUnit(std::string_view unit) {
    static constexpr std::array<std::string_view, 6> kNames{"m", "kg", "s", "K", "A", "rad"};
    std::string fault, text = "<BaseUnit";
    const auto parsed = parseUnit(unit, fault);
    for (std::size_t i = 0; parsed && i < kNames.size(); ++i) {
        if (const int exponent = parsed->dimension[i]) text += attribute(kNames[i], std::to_string(exponent));
    }
    return text + "/>";
}

std::string unitDefinitions(const std::vector<Variable>& variables) {
    std::set<std::string> units;
    for (const Variable& one : variables) {
        if (hasUnit(one)) units.insert(one.unit);
    }
    std::string text = "  <UnitDefinitions>\n";
    for (const std::string& unit : units)
        text += concat({"    <Unit", attribute("name", unit), ">", baseUnit(unit), "</Unit>\n"});
    return text + "  </UnitDefinitions>\n";
}

// ---- Variables ----

struct Nature {
    std::string_view causality, variability, initial;
};

// Booleans and parameters do not move during a simulation.
Nature natureOf(const Variable& variable) {
    switch (variable.role) {
        case Role::independent:
            return {"independent", "continuous", ""};
        case Role::input:
            return {"input", "continuous", ""};
        case Role::parameter:
            return {"parameter", "fixed", "exact"};
        case Role::calculated:
            return {"calculatedParameter", "fixed", "calculated"};
        default:
            return {"output", "continuous", "calculated"};
    }
}

bool hasStart(const Variable& variable) {
    return variable.role == Role::input || variable.role == Role::parameter;
}

// What both versions have of a variable, in the element that each of them has for it.
std::string head(const Variable& variable, std::size_t reference) {
    const Nature nature = natureOf(variable);
    std::string text = attribute("name", variable.name) + attribute("valueReference", std::to_string(reference)) +
                       attribute("description", variable.meaning) + attribute("causality", nature.causality) +
                       attribute("variability", nature.variability);
    if (!nature.initial.empty()) text += attribute("initial", nature.initial);
    return text;
}

std::string kind(const Variable& variable) {
    std::string text;
    if (hasUnit(variable)) text += attribute("unit", variable.unit);
    if (std::isfinite(variable.limits.lowest)) text += attribute("min", numberText(variable.limits.lowest));
    if (std::isfinite(variable.limits.highest)) text += attribute("max", numberText(variable.limits.highest));
    if (hasStart(variable))
        text += attribute("start", variable.flag ? (*variable.flag ? "true" : "false") : numberText(*variable.number));
    return text;
}

std::string element(const Variable& variable, std::size_t reference, FmiVersion version) {
    if (version == FmiVersion::fmi3) {
        return concat(
            {"    <", variable.flag ? "Boolean" : "Float64", head(variable, reference), kind(variable), "/>\n"});
    }
    return concat({"    <ScalarVariable", head(variable, reference), "><", variable.flag ? "Boolean" : "Real",
                   kind(variable), "/></ScalarVariable>\n"});
}

// ---- Structure: nothing is said of dependencies, so that every output may depend on every input ----

// `index`: of FMI 2, from 1; the value reference of FMI 3.
std::string unknown(std::string_view element, std::size_t reference, FmiVersion version) {
    const bool fmi3 = version == FmiVersion::fmi3;
    return concat({fmi3 ? "    <" : "      <", fmi3 ? element : "Unknown",
                   attribute(fmi3 ? "valueReference" : "index", std::to_string(fmi3 ? reference : reference + 1)),
                   "/>\n"});
}

std::string unknowns(const std::vector<Variable>& variables, std::string_view list, std::string_view element,
                     bool initial, FmiVersion version) {
    std::string text;
    for (std::size_t i = 0; i < variables.size(); ++i) {
        const Role role = variables[i].role;
        if (role == Role::output || (initial && role == Role::calculated)) text += unknown(element, i, version);
    }
    if (version == FmiVersion::fmi3) return text;
    return concat({"    <", list, ">\n", text, "    </", list, ">\n"});
}

std::string structure(const std::vector<Variable>& variables, FmiVersion version) {
    return concat({"  <ModelStructure>\n", unknowns(variables, "Outputs", "Output", false, version),
                   unknowns(variables, "InitialUnknowns", "InitialUnknown", true, version), "  </ModelStructure>\n"});
}

// ---- What the FMU is and can ----

std::string opening(const VehicleParams& car, std::string_view car_text, FmiVersion version) {
    const bool fmi3 = version == FmiVersion::fmi3;
    const std::string name = car.name.empty() ? "car" : car.name;
    return concat({"<fmiModelDescription", attribute("fmiVersion", nameOf(version)), attribute("modelName", name),
                   attribute(fmi3 ? "instantiationToken" : "guid", tokenOf(car_text, nameOf(version))),
                   attribute("description", "full-vehicle model with Delft Tyre 97"),
                   attribute("generationTool", concat({"tread ", host::version()})),
                   attribute("variableNamingConvention", "structured"),
                   fmi3 ? "" : attribute("numberOfEventIndicators", "0"), ">\n"});
}

std::string abilities(FmiVersion version) {
    const bool fmi3 = version == FmiVersion::fmi3;
    return concat({"  <CoSimulation", attribute("modelIdentifier", kModelIdentifier),
                   attribute("canHandleVariableCommunicationStepSize", "true"),
                   attribute(fmi3 ? "canGetAndSetFMUState" : "canGetAndSetFMUstate", "true"),
                   attribute(fmi3 ? "canSerializeFMUState" : "canSerializeFMUstate", "true"),
                   fmi3 ? "" : attribute("canNotUseMemoryManagementFunctions", "true"), "/>\n"});
}

}  // namespace

std::string_view nameOf(FmiVersion version) {
    return version == FmiVersion::fmi2 ? "2.0" : "3.0";
}

std::string modelDescription(const VehicleParams& car, std::string_view car_text, FmiVersion version) {
    Values values;
    values.parameters.car = car;
    const std::vector<Variable> variables = variablesOf(values);
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    text += opening(car, car_text, version) + abilities(version) + unitDefinitions(variables);
    text +=
        "  <LogCategories>\n    <Category name=\"logStatusError\" description=\"why a call has failed\"/>\n"
        "  </LogCategories>\n  <DefaultExperiment startTime=\"0\" stepSize=\"0.001\"/>\n  <ModelVariables>\n";
    for (std::size_t i = 0; i < variables.size(); ++i) text += element(variables[i], i, version);
    text += concat({"  </ModelVariables>\n", structure(variables, version), "</fmiModelDescription>\n"});
    return text;
}

}  // namespace tread::fmu
