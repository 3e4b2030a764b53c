#include "diagnose/answer/changed_numbers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>

#include "diagnose/answer/parts.h"
#include "diagnose/answer/words.h"
#include "log/log_columns.h"
#include "recording/subject_paths.h"

namespace tread::diagnose::answer {
namespace {

constexpr double kNoteworthy = 1;  // change of a number, in standard deviations of its tolerance

// Without " in " and the name of a recording.
std::string pathOf(const std::string& name) {
    return name.substr(0, name.find(' '));
}

// The description of a number, without its unit and the equation of the tyre model in brackets at its end.
std::string meaningOf(const std::string& path) {
    const ReferenceRow* row = recording::subjectNumber(path);
    if (!row) return path;
    std::string meaning = row->meaning;
    if (const std::size_t unit = meaning.find(", in the SI unit of the channel"); unit != std::string::npos)
        return meaning.substr(0, unit);
    const std::size_t open = meaning.rfind(" (");
    if (open == std::string::npos || meaning.back() != ')') return meaning;
    const bool number = std::isdigit(static_cast<unsigned char>(meaning[open + 2])) != 0;
    return number ? meaning.substr(0, open) : meaning;
}

// "yaw_rate", "chassis.yaw_rate@can"; empty for a number that concerns all instruments.
std::string instrumentIn(const std::string& path) {
    constexpr std::string_view kInstruments = "instruments.";
    const std::size_t first = kInstruments.size(), last = path.rfind('.');
    if (!path.starts_with(kInstruments) || last <= first) return {};
    std::string instrument = path.substr(first, last - first);
    for (const std::string_view list : {"further.", "mountings."})
        if (instrument.starts_with(list)) instrument.erase(0, list.size());
    return instrument;
}

// "yaw rate", "inertial unit"; empty for a number that concerns all instruments.
std::string instrumentOf(const std::string& path) {
    const std::string instrument = instrumentIn(path);
    if (instrument.empty()) return {};
    for (const std::string& channel : {instrument, "chassis." + instrument})
        if (const std::string words = channelInWords(channel); words != channel) return words;
    return effectInWords(instrument);
}

// The unit of the channel that an instrument reads; empty for what reads none.
std::string unitOfReading(const std::string& path) {
    std::string instrument(quantityOf(instrumentIn(path)));
    if (instrument == "speed") instrument = "vx";
    if (instrument == "wheel_speed") instrument = "wheel.front_left.spin";
    for (const std::string& channel : {instrument, "chassis." + instrument, "driver." + instrument})
        if (const auto unit = logUnit(channel)) return std::string(*unit);
    return {};
}

// "front", "rear left", or the name of an instrument; empty for a number that the car has once.
std::string placeOf(const std::string& path) {
    if (path.starts_with("instruments.")) return instrumentOf(path);
    const std::size_t dot = path.find('.');
    const std::string axle = path.substr(0, dot);
    if (dot == std::string::npos || (axle != "front" && axle != "rear")) return {};
    for (const std::string side : {"left", "right"})
        if (path.starts_with(axle + "." + side + ".")) return axle + " " + side;
    return axle;
}

bool alike(const Estimate& a, const Estimate& b) {
    return a.value == b.value && a.sd == b.sd && a.neutral == b.neutral;
}

}  // namespace

std::string unitOf(const std::string& path) {
    const ReferenceRow* row = recording::subjectNumber(pathOf(path));
    if (row && pathOf(path).ends_with(".bias") && row->unit == "-") return unitOfReading(pathOf(path));
    return row ? row->unit : "-";
}

bool atItsEnd(const Estimate& estimate) {
    return estimate.at_bound && estimate.value != estimate.neutral;
}

std::vector<ChangedNumber> changedNumbers(const RankedEffect& effect) {
    std::vector<ChangedNumber> numbers;
    for (const auto& [path, estimate] : effect.parameters) {
        const auto isSame = [&where = path, &found = estimate](const ChangedNumber& one) {
            return alike(one.estimate, found) && meaningOf(one.paths.front()) == meaningOf(where);
        };
        const auto same = std::find_if(numbers.begin(), numbers.end(), isSame);
        if (same != numbers.end()) same->paths.push_back(path);
        else numbers.push_back({{path}, estimate});
    }
    return numbers;
}

std::vector<const RankedEffect*> namedEffects(const Diagnosis& diagnosis) {
    std::vector<const RankedEffect*> named;
    for (const std::string& cause : causesInOrder(diagnosis)) {
        for (const RankedEffect& effect : diagnosis.effects)
            if (effect.name == cause) named.push_back(&effect);
    }
    return named;
}

std::string numberInWords(const std::vector<std::string>& paths) {
    std::vector<std::string> places;
    for (const std::string& path : paths)
        if (const std::string place = placeOf(pathOf(path)); !place.empty()) places.push_back(place);
    const std::string& first = paths.front();
    const std::string of = first.substr(pathOf(first).size());
    return (places.empty() ? "" : fmt::format("{}: ", fmt::join(places, ", "))) + meaningOf(pathOf(first)) + of;
}

std::string changeInPercent(const Estimate& estimate, std::string_view plus_minus) {
    constexpr double kLargest = 10;  // times nominal
    const double nominal = std::abs(estimate.neutral), change = estimate.value - estimate.neutral;
    const bool next_to_zero = std::abs(change) > kLargest * nominal || estimate.sd > nominal;
    if (nominal == 0 || next_to_zero) return {};
    const double sd = 100 * estimate.sd / nominal;
    int decimals = 0;  // that show the first digit of the standard deviation
    while (sd > 0 && decimals < 3 && sd * std::pow(10, decimals) < 0.95) ++decimals;
    return fmt::format("{:+.{}f} {} {:.{}f} %", 100 * change / nominal, decimals, plus_minus, sd, decimals);
}

std::vector<MovedNumber> movedNumbers(const std::map<std::string, NuisanceEstimate>& numbers) {
    std::vector<MovedNumber> moved;
    for (const auto& [name, number] : numbers)
        if (std::abs(number.z) >= kNoteworthy || (number.at_bound && number.z != 0)) moved.push_back({name, number});
    std::stable_sort(moved.begin(), moved.end(), [](const MovedNumber& a, const MovedNumber& b) {
        return std::abs(a.estimate.z) > std::abs(b.estimate.z);
    });
    return moved;
}

}  // namespace tread::diagnose::answer
