#include "calibrate/identification_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnose/answer/diagnosis_json.h"
#include "diagnose/answer/parts.h"
#include "recording/subject_paths.h"
#include "tread/load.h"

namespace tread::calibrate {
namespace {

using diagnose::answer::GapLevels;
using diagnose::answer::HowFar;
using diagnose::answer::NuisanceEstimate;
using recording::isOfTheCar;
using recording::numberAt;
using recording::Subject;
using recording::subjectNumber;

using Json = nlohmann::ordered_json;

constexpr double kNotJustNoise = 1.2;  // ratio to the noise floor above which the model lacks something
constexpr double kMost = 0.5;          // share of the closed part of the squared gap that counts as most of it
constexpr double kMoved = 1;           // prior standard deviations from which a number counts as moved
constexpr std::size_t kNamed = 3;      // other numbers that are named
constexpr double kAlike = 0.9;         // correlation from which two numbers are reported as determined only together
constexpr double kFarMoved = 2;        // prior standard deviations from which a fitted number is flagged
constexpr double kBadly = 1e4;         // condition number from which the least determined mixture is reported
constexpr double kPartOf = 0.3;        // share in that mixture from which a number is named

std::string names(const std::vector<FittedNumber>& numbers, bool FittedNumber::*which, bool value) {
    std::string list;
    for (const FittedNumber& one : numbers)
        if (one.*which == value) list += (list.empty() ? "" : ", ") + one.path;
    return list;
}

const GapLevels& judged(const HowFar& how_far) {
    return how_far.in_sample ? how_far.training : how_far.held_out;
}

std::string pairsOf(const Identification& found) {
    std::string text;
    for (std::size_t i = 0; i < found.numbers.size(); ++i) {
        for (std::size_t j = i + 1; j < found.numbers.size(); ++j) {
            if (std::abs(found.correlation[i][j]) < kAlike) continue;
            text += fmt::format("TOGETHER  {} and {}: correlation {:.2f}\n", found.numbers[i].path,
                                found.numbers[j].path, found.correlation[i][j]);
        }
    }
    if (!(found.condition > kBadly)) return text;
    std::string mixture;
    for (const auto& [path, share] : found.weakest)
        if (std::abs(share) > kPartOf) mixture += fmt::format("{}{} {:+.2f}", mixture.empty() ? "" : ", ", path, share);
    return text + fmt::format("WEAKEST   condition number {:.1e}; least determined combination: {}\n", found.condition,
                              mixture);
}

}  // namespace

std::string identificationInWords(const Identification& found) {
    const std::size_t n = found.numbers.size();
    const auto determined = std::count_if(found.numbers.begin(), found.numbers.end(),
                                          [](const FittedNumber& one) { return one.determined; });
    const GapLevels& level = judged(found.gap.how_far);
    std::string text =
        fmt::format("{} of {} number{} determined by these drives; gap {} {:.2f} -> {:.2f}", determined, n,
                    n == 1 ? " is" : "s are", found.gap.how_far.in_sample ? "in the same drives" : "in held-out drives",
                    level.nominal, level.calibrated);
    text += fmt::format(" (with all other tolerances fitted: {:.2f}, noise floor {:.2f})", level.extended, level.floor);
    if (!found.better) text += "; not better than the nominal car, so do not use it";
    if (!found.converged) text += "; the fit has not converged, so values and errors are unreliable";
    return text;
}

bool hasSucceeded(const Identification& found) {
    return found.converged && found.better && names(found.numbers, &FittedNumber::determined, false).empty();
}

std::string outcomeInWords(const Identification& found) {
    if (!found.converged) return "not converged";
    if (!found.better) return "not better";
    return hasSucceeded(found) ? "determined" : "not all determined";
}

std::string otherNumbersInWords(const Identification& found) {
    const GapLevels& level = judged(found.gap.how_far);
    const auto closed = [&](double by) { return level.nominal * level.nominal - by * by; };
    if (level.nominal < kNotJustNoise * level.floor || closed(level.calibrated) > kMost * closed(level.extended))
        return {};
    std::vector<std::pair<std::string, NuisanceEstimate>> moved;
    for (const auto& one : found.gap.nuisance)
        if (std::abs(one.second.z) > kMoved) moved.push_back(one);
    if (moved.empty()) return {};
    std::stable_sort(moved.begin(), moved.end(),
                     [](const auto& a, const auto& b) { return std::abs(a.second.z) > std::abs(b.second.z); });
    std::string list;
    for (std::size_t i = 0; i < std::min(moved.size(), kNamed); ++i)
        list += fmt::format("{}{} ({:+.1f})", i > 0 ? ", " : "", moved[i].first, moved[i].second.z);
    return "most of the gap is closed by numbers that are not fitted here (change in standard deviations): " + list;
}

std::string identificationText(const Identification& found) {
    std::size_t width = 6;
    for (const FittedNumber& one : found.numbers) width = std::max(width, one.path.size());
    std::string text = found.answer + "\n";
    if (found.of_references)
        text += "BEFORE    fitted to the references: the car before the change, in the drives that have a reference\n";
    text += fmt::format("{:<{}}  {:>10}  {:>8}  {:>10}  {:>8}\n", "number", width, "value", "+-", "nominal", "+-");
    for (const FittedNumber& one : found.numbers) {
        const ReferenceRow* row = subjectNumber(one.path);
        text += fmt::format("{:<{}}  {:>10.5g}  {:>8.2g}  {:>10.5g}  {:>8.2g}  {}{}{}{}\n", one.path, width, one.value,
                            one.sd, one.nominal, one.prior_sd, row && row->unit != "-" ? row->unit : "",
                            one.at_bound ? "  at the end of its plausible range" : "",
                            one.determined ? "" : "  not determined: no more certain than before",
                            !one.at_bound && std::abs(one.z) > kFarMoved
                                ? fmt::format("  {:.1f} standard deviations from nominal", one.z)
                                : "");
    }
    text += pairsOf(found);
    if (const std::string others = otherNumbersInWords(found); !others.empty()) text += "OTHERS    " + others + "\n";
    if (found.birge_ratio > kNotJustNoise)
        text += fmt::format(
            "LEFT      {:.1f} times the noise in the fitted drives: the model is incomplete; the errors are scaled "
            "accordingly\n",
            found.birge_ratio);
    if (found.gap.how_far.in_sample)
        text += "no recording is held out: the gap is judged in the fitted drives, which is too optimistic\n";
    return text;
}

Json identificationJson(const Identification& found) {
    Json numbers = Json::object();
    for (const FittedNumber& one : found.numbers) {
        numbers[one.path] = {{"value", one.value},
                             {"sd", one.sd},
                             {"nominal", one.nominal},
                             {"prior_sd", one.prior_sd},
                             {"lowest", one.lowest},
                             {"highest", one.highest},
                             {"z", one.z},
                             {"at_bound", one.at_bound},
                             {"determined", one.determined}};
    }
    Json paths = Json::array();  // a reader may sort the keys of `numbers`
    for (const FittedNumber& one : found.numbers) paths.push_back(one.path);
    const Json gap = diagnosisJson(found.gap);
    const GapLevels& levels = judged(found.gap.how_far);
    const auto closed = [&](double after) {
        const double share = diagnose::answer::closedShare(levels, after);
        return std::isfinite(share) ? Json(share) : Json(nullptr);
    };
    return {{"answer", found.answer},
            {"paths", paths},
            {"numbers", numbers},
            {"correlation", found.correlation},
            {"condition", found.condition},
            {"weakest", found.weakest},
            {"fitted_to", found.of_references ? "references" : "recordings"},
            {"not_determined", names(found.numbers, &FittedNumber::determined, false)},
            {"birge_ratio", found.birge_ratio},
            {"converged", found.converged},
            {"better", found.better},
            {"how_far", gap["how_far"]},
            {"closed", {{"calibrated", closed(levels.calibrated)}, {"extended", closed(levels.extended)}}},
            {"where", gap["where"]},
            {"nuisance", gap["nuisance"]},
            {"data_warnings", gap["data_warnings"]},
            {"seconds", gap["seconds"]},
            {"simulations", gap["simulations"]}};
}

std::string calibratedVehicleYaml(const recording::Subject& nominal, const Identification& found) {
    Subject calibrated = nominal;
    std::string head = "# " + found.answer + ".\n", beside, tolerances;
    if (found.of_references) head += "# Fitted to the references: the car before the change.\n";
    for (const FittedNumber& one : found.numbers) {
        const ReferenceRow* row = subjectNumber(one.path);
        const bool car = isOfTheCar(one.path);
        (car ? head : beside) += fmt::format("#   {} = {:.5g}{} (+- {:.2g}), nominal {:.5g}{}\n", one.path, one.value,
                                             row && row->unit != "-" ? " " + row->unit : "", one.sd, one.nominal,
                                             one.determined ? "" : ", not determined by the drives");
        if (double* number = numberAt(calibrated, one.path); number && car) *number = one.value;
        tolerances += fmt::format("#   - {{path: {}, absolute: {:.3g}}}\n", one.path, one.sd * std::sqrt(3.0));
    }
    if (!beside.empty()) head += "# Not numbers of the car, and therefore not in this file:\n" + beside;
    return head + "# Remaining uncertainties, to copy into the tolerances of a diagnosis:\n" + tolerances +
           vehicleYaml(calibrated.vehicle);
}

}  // namespace tread::calibrate
