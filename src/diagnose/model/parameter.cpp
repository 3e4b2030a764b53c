#include "diagnose/model/parameter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "base/fields/numbers.h"
#include "base/text/concat.h"
#include "base/text/pattern.h"
#include "diagnose/catalogue/plausible.h"
#include "diagnose/model/similarity.h"
#include "recording/further_instruments.h"

namespace tread::diagnose::model {
namespace {

constexpr double kOpenLimit = 1e-3;    // distance to an open limit, as a share of the nominal value or unit
constexpr double kKneeDistance = 0.3;  // units; a number whose limits leave it less room than this is not a parameter

// Tolerances of numbers whose description cannot state one as a fraction, because the nominal value is 0 or because a
// fraction would be meaningless. Chassis angles: accuracy of alignment benches. Instruments: data sheets of common
// ones.
const std::vector<KnownWithin>& usualTolerances() {
    static const std::vector<KnownWithin> known{
        {"*.suspension.toe", 0, 0.0009},
        {"*.suspension.camber", 0, 0.006},
        {"inertia.roll_yaw", 0, 20},
        {"lateral_offset", 0, 0.01},
        {"road.grade", 0, 0.001},
        {"road.bank", 0, 0.001},
        {"instruments.ax.bias", 0, 0.03},
        {"instruments.ay.bias", 0, 0.03},
        {"instruments.*_rate.bias", 0, 1e-3},
        {"instruments.roll.bias", 0, 2e-3},
        {"instruments.sideslip.bias", 0, 2e-3},
        {"instruments.*.gain", 0.003, 0},
        {"instruments.latency", 0, 0.005},
        {"instruments.speed.delay", 0, 0.005},
        {"instruments.inertial_unit.x", 0, 0.02},
        {"instruments.inertial_unit.y", 0, 0.02},
        {"instruments.inertial_unit.z", 0, 0.02},
        {"instruments.inertial_unit.roll", 0, 0.003},
        {"instruments.inertial_unit.pitch", 0, 0.003},
        {"instruments.inertial_unit.yaw", 0, 0.003},
        {"instruments.steering_wheel_angle.bias", 0, 0.005},
        {"instruments.command.bias", 0, 100},  // N: a slope of 0.5 % under a car
    };
    return known;
}

// Stiffness and friction of rubber change by 0.2 to 0.5 % per K. Weather and warming up change the temperature of all
// tyres by 15 K, and that of an axle by another 5 K (guesses).
constexpr double kPerKelvin = 0.0035;
constexpr double kTyresWarmer = 15;  // K
// What a factor differs by besides: 5 K of its axle, and 0.15 % per K between it and the others.
constexpr double kOfAFactor = 0.022;

// What differs between two days although the car is the same, where that is more than a share of its tolerance.
const std::vector<KnownWithin>& usualBetweenDays() {
    static const std::vector<KnownWithin> known{
        {"*.tyre_surroundings.pressure.inflation", 0.05, 0},  // ideal gas, 10 K
        {"aero.air_density", 0.04, 0},                        // 10 K and 10 hPa
        {"mass", 0.02, 0},                                    // tank, driver and companions: 30 kg of 1500 kg
        {"front_axle_distance", 0.015, 0},                    // 20 kg of them at the rear axle
    };
    return known;
}

// Measured drives avoid more than 3 m/s; the standard deviation of each component is 1.5 m/s.
const std::vector<KnownWithin>& usualWind() {
    static const std::vector<KnownWithin> known{{"wind.x", 0, 2.6}, {"wind.y", 0, 2.6}};
    return known;
}

bool isWind(const std::string& path) {
    return std::any_of(usualWind().begin(), usualWind().end(),
                       [&](const KnownWithin& known) { return matches(known.path, path); });
}

bool feelsTemperature(const std::string& path) {
    constexpr std::array<std::string_view, 4> kFactors{"Kx", "Ky", "mux", "muy"};
    return std::any_of(kFactors.begin(), kFactors.end(), [&](std::string_view factor) {
        return path.ends_with(concat({".tyre.lambda.", factor}));
    });
}

double toleranceOf(const Number& number, const VehicleParams& car, const std::vector<KnownWithin>& told) {
    const double value = std::abs(*number.value);
    double tolerance = number.about.tolerance * value;
    // A further instrument is usually known as well as the first one of its quantity.
    const std::string in_first = recording::pathInFirst(number.path);
    for (const auto* usual : {&usualTolerances(), &usualWind()}) {
        for (const KnownWithin& known : *usual) {
            if (matches(known.path, in_first.empty() ? number.path : in_first))
                tolerance = known.relative * value + atScaleOf(car, known.absolute, number.about.unit);
        }
    }
    for (const KnownWithin& known : told) {
        if (matches(known.path, number.path)) tolerance = known.relative * value + known.absolute;
    }
    return tolerance;
}

// Of a number of the same car on another day: the given one, but no more than the file says.
double asTold(double tolerance, const Number& number, const VehicleParams& car, const std::vector<KnownWithin>& told) {
    const auto states = [&](const KnownWithin& known) { return matches(known.path, number.path); };
    if (std::none_of(told.begin(), told.end(), states)) return tolerance;
    return std::min(tolerance, toleranceOf(number, car, told));
}

double toleranceBetweenDays(const Number& number, const VehicleParams& car, const std::vector<KnownWithin>& told,
                            double same) {
    const double value = std::abs(*number.value);
    double tolerance = same * toleranceOf(number, car, told);
    if (feelsTemperature(number.path)) tolerance = std::max(tolerance, kOfAFactor * value);
    for (const KnownWithin& known : usualBetweenDays())
        if (matches(known.path, number.path)) tolerance = std::max(tolerance, known.relative * value);
    return asTold(tolerance, number, car, told);
}

// Narrows the range of the parameter, in units, so that the number stays within its limits.
void limit(Parameter& parameter, const Limits& limits, double nominal, double by) {
    const auto until = [&](double end, bool open) {
        const double margin = open ? kOpenLimit * std::max(std::abs(nominal), std::abs(by)) : 0;
        return (end + (end < nominal ? margin : -margin) - nominal) / by;
    };
    double low = std::isfinite(limits.lowest) ? until(limits.lowest, limits.lowest_open) : -by * kInfinity;
    double high = std::isfinite(limits.highest) ? until(limits.highest, limits.highest_open) : by * kInfinity;
    if (by < 0) std::swap(low, high);
    parameter.lowest = std::max(parameter.lowest, std::min(low, 0.0));
    parameter.highest = std::min(parameter.highest, std::max(high, 0.0));
}

// Adds a number that the parameter moves by so much per unit.
void addMove(Parameter& parameter, const Number& number, double by, const VehicleParams& car) {
    parameter.moves.push_back({number.path, *number.value, by});
    Parameter physical;
    limit(physical, number.about.limits, *number.value, by);
    parameter.physical_lowest = std::max(parameter.physical_lowest, physical.lowest);
    parameter.physical_highest = std::min(parameter.physical_highest, physical.highest);
    limit(parameter, number.about.limits, *number.value, by);
    limit(parameter, catalogue::plausibleLimits(number.path, *number.value, car), *number.value, by);
}

void boundWhereNothingElseDoes(Parameter& parameter) {
    if (std::isinf(parameter.lowest)) parameter.lowest = -kWidest;
    if (std::isinf(parameter.highest)) parameter.highest = kWidest;
}

// Instruments that record the driver's inputs are excluded, because the replay is driven with these inputs.
bool readingOnly(const std::string& path) {
    const auto of = [&](const char* input) { return path.starts_with(std::string("instruments.") + input); };
    return path.starts_with("instruments.") && !of("steering_wheel_angle") && !of("throttle") && !of("brake") &&
           !of("command");
}

// Road and the zeros of instruments change from day to day.
bool staysTheSame(const std::string& path) {
    return !path.starts_with("road.") && !path.ends_with(".bias");
}

// Adds a number that is known within a tolerance, if it is uncertain at all and has room to move.
void addNuisance(std::vector<Parameter>& found, const Number& number, double tolerance, const VehicleParams& car) {
    if (!(tolerance > 0) || !std::isfinite(tolerance)) return;
    Parameter parameter;
    addMove(parameter, number, tolerance / std::sqrt(3.0), car);
    boundWhereNothingElseDoes(parameter);
    parameter.instruments_only = readingOnly(number.path);
    if (parameter.highest - parameter.lowest > kKneeDistance) found.push_back(std::move(parameter));
}

}  // namespace

bool Parameter::implausibleAt(double units) const {
    constexpr double kNear = 1e-6;  // units
    return (units < lowest + kNear && lowest > physical_lowest + kNear) ||
           (units > highest - kNear && highest < physical_highest - kNear);
}

void move(Subject& subject, const Parameter& parameter, double units) {
    if (units == 0) return;
    std::size_t found = 0;
    for (const Number& number : numbers(subject)) {
        for (const Parameter::Move& one : parameter.moves) {
            if (number.path != one.path) continue;
            *number.value += units * one.by;
            if (++found == parameter.moves.size()) return;
        }
    }
}

Subject movedIn(const RecordedDrive& drive, Subject subject, const std::vector<Parameter>& parameters,
                const Eigen::VectorXd& units) {
    std::unordered_map<std::string, double*> values;
    for (const Number& number : numbers(subject)) values.emplace(number.path, number.value);
    for (Eigen::Index i = 0; i < units.size(); ++i) {
        if (units(i) == 0 || !parameters[i].concerns(drive)) continue;
        for (const Parameter::Move& one : parameters[i].moves)
            if (const auto value = values.find(one.path); value != values.end()) *value->second += units(i) * one.by;
    }
    return subject;
}

std::vector<Parameter> nuisances(const Subject& nominal, const std::vector<KnownWithin>& tolerances, double same) {
    Subject subject = nominal;
    std::vector<Parameter> found;
    for (const Number& number : numbers(subject)) {
        if (isWind(number.path)) continue;
        const double tolerance = same < 1 && staysTheSame(number.path)
                                     ? toleranceBetweenDays(number, nominal.vehicle, tolerances, same)
                                     : toleranceOf(number, nominal.vehicle, tolerances);
        addNuisance(found, number, tolerance, nominal.vehicle);
    }
    return found;
}

std::optional<Parameter> temperatureOfTheTyres(const Subject& nominal, const std::vector<KnownWithin>& tolerances) {
    Subject subject = nominal;
    Parameter parameter;
    parameter.quantity = "temperature of the tyres against the other day, K";
    parameter.quantity_by = kTyresWarmer / std::sqrt(3.0);
    for (const Number& number : numbers(subject)) {
        if (!feelsTemperature(number.path) || *number.value == 0) continue;
        // Less in proportion where the file says less of the factor than it differs by besides.
        const double value = std::abs(*number.value), own = kOfAFactor * value;
        const double share = asTold(own, number, nominal.vehicle, tolerances) / own;
        const double by = -share * kPerKelvin * parameter.quantity_by * value;
        if (by != 0) addMove(parameter, number, by, nominal.vehicle);
    }
    if (parameter.moves.empty() || parameter.highest - parameter.lowest < kKneeDistance) return std::nullopt;
    boundWhereNothingElseDoes(parameter);
    return parameter;
}

std::vector<Parameter> nuisancesOfTheWind(const Subject& nominal, const std::vector<KnownWithin>& tolerances,
                                          Drives drives) {
    constexpr double kOfADay = 0.5;  // share of the variance that all drives have in common
    Subject subject = nominal;
    std::vector<Parameter> found;
    for (const Number& number : numbers(subject)) {
        if (!isWind(number.path) || drives.empty()) continue;
        const double tolerance = toleranceOf(number, nominal.vehicle, tolerances);
        const std::size_t first = found.size();
        addNuisance(found, number, tolerance * std::sqrt(kOfADay * drives[0].runs), nominal.vehicle);
        if (found.size() == first) continue;
        found.back().of_the_day = true;
        for (const RecordedDrive& drive : drives) {
            addNuisance(found, number, tolerance * std::sqrt((1 - kOfADay) * drive.runs), nominal.vehicle);
            found.back().only = drive.recording, found.back().only_name = drive.name;
        }
    }
    return found;
}

std::vector<Parameter> nuisancesOfBoth(const Subject& before, const std::vector<KnownWithin>& left_open) {
    Subject subject = before;
    std::vector<Parameter> found;
    for (const Number& number : numbers(subject)) {
        for (const KnownWithin& known : left_open) {
            if (known.path != number.path) continue;
            const std::size_t already = found.size();
            addNuisance(found, number, known.absolute, before.vehicle);
            if (found.size() > already) found.back().of_both = true;
        }
    }
    return found;
}

inference::Bounds boundsOf(const std::vector<Parameter>& all, const std::vector<Eigen::Index>& some) {
    return boundsAbout(Eigen::VectorXd::Zero(std::ssize(all)), all, some);
}

inference::Bounds boundsAbout(const Eigen::VectorXd& point, const std::vector<Parameter>& all,
                              const std::vector<Eigen::Index>& some) {
    inference::Bounds bounds{Eigen::VectorXd(std::ssize(some)), Eigen::VectorXd(std::ssize(some))};
    for (Eigen::Index i = 0; i < std::ssize(some); ++i) {
        bounds.lowest(i) = all[some[i]].lowest - point(some[i]);
        bounds.highest(i) = all[some[i]].highest - point(some[i]);
    }
    return bounds;
}

std::vector<Eigen::Index> joined(const std::vector<Eigen::Index>& some, const std::vector<Eigen::Index>& more) {
    std::vector<Eigen::Index> all;
    all.reserve(some.size() + more.size());
    for (const auto* list : {&some, &more})
        for (const Eigen::Index one : *list) all.push_back(one);
    return all;
}

std::vector<Share> mixture(const Parameter& parameter, const std::vector<Parameter>& all,
                           const std::vector<Eigen::Index>& others) {
    std::vector<Share> shares;
    for (const Parameter::Move& move : parameter.moves) {
        const auto alone = [&](const Parameter& one) {
            return one.moves.size() == 1 && one.path() == move.path && !one.of_both;
        };
        const auto inAll = [&](Eigen::Index other) { return alone(all[other]) && !all[other].only; };
        const auto inEach = [&](const Parameter& one) { return alone(one) && one.only; };
        const auto add = [&](Eigen::Index of) { shares.push_back({of, move.by / all[of].moves.front().by}); };

        // Either one parameter moves the number in all drives, or each drive has its own.
        const auto common = std::find_if(others.begin(), others.end(), inAll);
        if (common != others.end()) {
            add(*common);
            continue;
        }
        const auto before = std::ssize(shares), drives = std::count_if(all.begin(), all.end(), inEach);
        for (const Eigen::Index other : others)
            if (inEach(all[other])) add(other);
        if (drives == 0 || std::ssize(shares) - before != drives) return {};
    }
    return shares;
}

std::vector<Parameter> knobsOf(const Effect& effect, const Subject& nominal) {
    Subject subject = nominal;
    const std::vector<Number> all = numbers(subject);
    std::vector<Parameter> knobs;
    for (const catalogue::Knob& knob : effect.knobs) {
        Parameter parameter;
        parameter.instruments_only = true;
        for (std::size_t i = 0; i < knob.paths.size(); ++i) {
            const std::string& path = knob.paths[i];
            const auto number = std::find_if(all.begin(), all.end(), [&](const Number& n) { return n.path == path; });
            if (number == all.end()) continue;
            const double change = knob.typicalChange(i, *number->value);
            const double by = knob.relative ? change : atScaleOf(nominal.vehicle, change, number->about.unit);
            if (by == 0) continue;
            addMove(parameter, *number, by, nominal.vehicle);
            parameter.instruments_only = parameter.instruments_only && readingOnly(path);
        }
        const double largest = knob.largest / knob.typical;
        parameter.lowest = std::max(parameter.lowest, -largest);
        parameter.highest = std::min(parameter.highest, largest);
        boundWhereNothingElseDoes(parameter);
        if (knob.direction == catalogue::Direction::up) parameter.lowest = 0;
        if (knob.direction == catalogue::Direction::down) parameter.highest = 0;
        if (!parameter.moves.empty()) knobs.push_back(std::move(parameter));
    }
    return knobs;
}

}  // namespace tread::diagnose::model
