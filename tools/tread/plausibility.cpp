#include "plausibility.h"

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>

#include "base/fields/field_path.h"
#include "base/fields/implausible.h"
#include "base/text/trimmed.h"
#include "base/yaml/position.h"
#include "terminal.h"
#include "vehicle/fields.h"
#include "vehicle/relations.h"

namespace tread::program {
namespace {

// Whether a setting gives the number at a path, alone or as part of a list or map.
bool gives(std::string_view setting, std::string_view path) {
    return path == setting || (path.starts_with(setting) && path[setting.size()] == '.');
}

// The place and the text of a value in settings; nothing when none of them gives it.
std::optional<WrittenValue> inSettings(const Implausible& number, const AppliedSettings& settings) {
    for (std::size_t i = settings.assignments.size(); i-- > 0;) {
        const std::string_view assignment = settings.assignments[i];
        const std::size_t equals = assignment.find('=');
        if (equals == std::string_view::npos) continue;
        const std::string_view path = trimmed(assignment.substr(0, equals));
        for (const std::string& place : number.places) {
            if (!gives(path, settings.prefix + place)) continue;
            WrittenValue found{settings.source, {0, 0}, ""};
            if (path == settings.prefix + place) found.text = trimmed(assignment.substr(equals + 1));
            if (!settings.list.empty())
                found.at = positionOfValue(settings.source, joinPath(settings.list, std::to_string(i)));
            return found;
        }
    }
    return {};
}

std::optional<WrittenValue> inFile(const Implausible& number, const std::string& file) {
    for (const std::string& place : number.places) {
        if (auto found = writtenValue(file, place)) return found;
    }
    return {};
}

std::vector<Problem> located(const std::vector<Implausible>& numbers, const std::string& file,
                             const std::vector<AppliedSettings>& settings) {
    std::vector<Problem> problems;
    std::set<std::tuple<std::string, int, int, std::string>> seen;
    for (const Implausible& number : numbers) {
        std::optional<WrittenValue> at;
        std::string path = number.path;
        for (std::size_t i = settings.size(); i-- > 0 && !at;) {
            at = inSettings(number, settings[i]);
            if (at) path = settings[i].prefix + number.path;
        }
        if (!at) at = inFile(number, file);
        if (!at) at = WrittenValue{file, {0, 0}, ""};
        Problem problem{at->file, at->at.line, at->at.column, path, implausibleText(number, at->text)};
        const bool in_file = problem.line > 0;
        if (in_file && !seen.emplace(problem.file, problem.line, problem.column, problem.text).second) continue;
        problems.push_back(std::move(problem));
    }
    return problems;
}

}  // namespace

std::vector<Problem> implausibleIn(const VehicleParams& car, const std::string& file,
                                   const std::vector<AppliedSettings>& settings) {
    std::vector<Implausible> numbers = implausible(car);
    for (Implausible& relation : implausibleRelations(car)) numbers.push_back(std::move(relation));
    return located(numbers, file, settings);
}

std::vector<Problem> implausibleIn(const TyreParams& tyre, const std::string& file,
                                   const std::vector<AppliedSettings>& settings) {
    return located(implausible(tyre), file, settings);
}

std::vector<Problem> implausibleIn(const Scenario& scenario, const std::string& file,
                                   const std::vector<AppliedSettings>& settings) {
    return located(implausible(scenario), file, settings);
}

void warnOfImplausible(const std::vector<Problem>& warnings, bool strict) {
    if (strict && !warnings.empty()) throw LoadError(warnings);
    for (const Problem& warning : warnings) warn(toText(warning));
}

std::string withSuspects(const SimulationError& error, const std::vector<Problem>& implausible) {
    constexpr std::size_t kMost = 3;
    std::string text = error.what();
    if (implausible.empty()) {
        if (error.suspect == SimulationError::Suspect::numbers)
            text += "; none of the numbers of car and scenario is implausible, so no field is suspected";
        return text;
    }
    text += implausible.size() == 1 ? "; suspect: " : "; suspects: ";
    for (std::size_t i = 0; i < std::min(kMost, implausible.size()); ++i)
        text += (i > 0 ? "; " : "") + toText(implausible[i]);
    if (implausible.size() > kMost) text += "; and " + std::to_string(implausible.size() - kMost) + " more";
    return text;
}

}  // namespace tread::program
