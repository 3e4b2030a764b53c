// The units that have a name of their own, and the names of what they measure.
//
// Sources: BIPM, The International System of Units, 9th edition, 2019 (minute, hour, tonne, bar, standard gravity);
// NIST Special Publication 811, 2008, appendix B.8 (inch, foot, mile, pound, pound-force, both horsepowers).
#include <numbers>

#include "base/units/units.h"

namespace tread {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kGravity = 9.80665;             // m/s2
constexpr double kInch = 0.0254;                 // m
constexpr double kFoot = 0.3048;                 // m
constexpr double kMile = 1609.344;               // m
constexpr double kPound = 0.45359237;            // kg
constexpr double kMetricHorsepower = 735.49875;  // W, 75 kgf m/s
constexpr double kIceInKelvin = 273.15;

//                              m  kg  s  K  A rad
constexpr Dimension kPure{0, 0, 0, 0, 0, 0};
constexpr Dimension kLength{1, 0, 0, 0, 0, 0};
constexpr Dimension kArea{2, 0, 0, 0, 0, 0};
constexpr Dimension kVolume{3, 0, 0, 0, 0, 0};
constexpr Dimension kMass{0, 1, 0, 0, 0, 0};
constexpr Dimension kTime{0, 0, 1, 0, 0, 0};
constexpr Dimension kTemperature{0, 0, 0, 1, 0, 0};
constexpr Dimension kCurrent{0, 0, 0, 0, 1, 0};
constexpr Dimension kAngle{0, 0, 0, 0, 0, 1};
constexpr Dimension kFrequency{0, 0, -1, 0, 0, 0};
constexpr Dimension kSpeed{1, 0, -1, 0, 0, 0};
constexpr Dimension kAcceleration{1, 0, -2, 0, 0, 0};
constexpr Dimension kAngularSpeed{0, 0, -1, 0, 0, 1};
constexpr Dimension kAngularAcceleration{0, 0, -2, 0, 0, 1};
constexpr Dimension kForce{1, 1, -2, 0, 0, 0};
constexpr Dimension kTorque{2, 1, -2, 0, 0, 0};
constexpr Dimension kPower{2, 1, -3, 0, 0, 0};
constexpr Dimension kPressure{-1, 1, -2, 0, 0, 0};
constexpr Dimension kStiffness{0, 1, -2, 0, 0, 0};
constexpr Dimension kDamping{0, 1, -1, 0, 0, 0};
constexpr Dimension kTorsionalStiffness{2, 1, -2, 0, 0, -1};
constexpr Dimension kTorsionalDamping{2, 1, -1, 0, 0, -1};
constexpr Dimension kInertia{2, 1, 0, 0, 0, 0};
constexpr Dimension kDensity{-3, 1, 0, 0, 0, 0};
constexpr Dimension kVoltage{2, 1, -3, 0, -1, 0};

constexpr NamedUnit kNamedUnits[] = {
    {"m", {1, 1, 0, kLength}, true},
    {"in", {kInch, 1, 0, kLength}},
    {"ft", {kFoot, 1, 0, kLength}},
    {"mi", {kMile, 1, 0, kLength}},
    {"l", {1, 1000, 0, kVolume}},
    {"L", {1, 1000, 0, kVolume}},
    {"kg", {1, 1, 0, kMass}},
    {"t", {1000, 1, 0, kMass}},
    {"lb", {kPound, 1, 0, kMass}},
    {"s", {1, 1, 0, kTime}, true},
    {"min", {60, 1, 0, kTime}},
    {"h", {3600, 1, 0, kTime}},
    {"A", {1, 1, 0, kCurrent}, true},
    {"V", {1, 1, 0, kVoltage}, true},
    {"rad", {1, 1, 0, kAngle}, true},
    {"deg", {kPi, 180, 0, kAngle}},
    {"°", {kPi, 180, 0, kAngle}},
    {"K", {1, 1, 0, kTemperature}},
    {"degC", {1, 1, kIceInKelvin, kTemperature}},
    {"°C", {1, 1, kIceInKelvin, kTemperature}},
    {"rev", {2 * kPi, 1, 0, kAngle}},
    {"rpm", {2 * kPi, 60, 0, kAngularSpeed}},
    {"Hz", {1, 1, 0, kFrequency}, true},
    {"kph", {1000, 3600, 0, kSpeed}},
    {"mph", {kMile, 3600, 0, kSpeed}},
    {"g", {kGravity, 1, 0, kAcceleration}},
    {"N", {1, 1, 0, kForce}, true},
    {"lbf", {kPound * kGravity, 1, 0, kForce}},
    {"kgf", {kGravity, 1, 0, kForce}},
    {"Nm", {1, 1, 0, kTorque}, true},
    {"J", {1, 1, 0, kTorque}, true},
    {"W", {1, 1, 0, kPower}, true},
    {"hp", {550 * kFoot * kPound * kGravity, 1, 0, kPower}},
    {"PS", {kMetricHorsepower, 1, 0, kPower}},
    {"Pa", {1, 1, 0, kPressure}, true},
    {"bar", {100000, 1, 0, kPressure}, true},
    {"psi", {kPound * kGravity, kInch* kInch, 0, kPressure}},
    {"%", {1, 100, 0, kPure}},
};

struct NamedDimension {
    Dimension dimension;
    std::string_view name;
};

constexpr NamedDimension kNamedDimensions[] = {
    {kPure, "a pure number"},
    {kLength, "a length"},
    {kArea, "an area"},
    {kVolume, "a volume"},
    {kMass, "a mass"},
    {kTime, "a time"},
    {kTemperature, "a temperature"},
    {kCurrent, "an electric current"},
    {kVoltage, "a voltage"},
    {kAngle, "an angle"},
    {kFrequency, "a frequency"},
    {kSpeed, "a speed"},
    {kAcceleration, "an acceleration"},
    {kAngularSpeed, "an angular speed"},
    {kAngularAcceleration, "an angular acceleration"},
    {kForce, "a force"},
    {kTorque, "a torque or energy"},
    {kPower, "a power"},
    {kPressure, "a pressure"},
    {kStiffness, "a stiffness"},
    {kDamping, "a damping coefficient"},
    {kTorsionalStiffness, "a torsional stiffness"},
    {kTorsionalDamping, "a torsional damping coefficient"},
    {kInertia, "a moment of inertia"},
    {kDensity, "a density"},
};

}  // namespace

std::span<const NamedUnit> namedUnits() {
    return kNamedUnits;
}

std::string dimensionName(const Dimension& dimension) {
    for (const NamedDimension& named : kNamedDimensions) {
        if (named.dimension == dimension) return std::string(named.name);
    }
    constexpr std::string_view kBase[] = {"m", "kg", "s", "K", "A", "rad"};
    std::string text = "a quantity in";
    for (std::size_t i = 0; i < dimension.size(); ++i) {
        if (dimension[i] == 0) continue;
        text += ' ';
        text += kBase[i];
        if (dimension[i] != 1) text += std::to_string(dimension[i]);
    }
    return text;
}

}  // namespace tread
