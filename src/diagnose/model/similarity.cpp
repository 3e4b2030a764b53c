#include "diagnose/model/similarity.h"

#include <cctype>
#include <cmath>

namespace tread::diagnose::model {
namespace {

// Wheelbases for which the sizes are taken as stated.
constexpr double kShortestRoadCar = 1.5, kLongestRoadCar = 6;  // m
// A medium road car, to which the sizes belong.
constexpr double kMediumMass = 1400;      // kg
constexpr double kMediumWheelbase = 2.6;  // m

struct Exponents {
    double mass = 0, length = 0, time = 0;
};

// Weights grow with the mass, so N counts as kg: acceleration does not depend on the scale.
void add(Exponents& sum, std::string_view symbol, double power) {
    if (symbol == "N" || symbol == "kg") sum.mass += power;
    if (symbol == "m") sum.length += power;
    if (symbol == "s") sum.time += power;
}

// Of a unit such as "N s/m" or "rad/(N m)": what stands behind the stroke divides.
Exponents exponentsOf(std::string_view unit) {
    Exponents sum;
    double sign = 1;
    for (std::size_t i = 0; i < unit.size();) {
        if (unit[i] == '/') sign = -1;
        const std::size_t begin = i;
        while (i < unit.size() && std::isalpha(static_cast<unsigned char>(unit[i]))) ++i;
        const std::string_view symbol = unit.substr(begin, i - begin);
        if (symbol.empty()) {
            ++i;
            continue;
        }
        const bool raised = i < unit.size() && std::isdigit(static_cast<unsigned char>(unit[i]));
        add(sum, symbol, sign * (raised ? unit[i] - '0' : 1));
    }
    return sum;
}

}  // namespace

double atScaleOf(const VehicleParams& car, double size, std::string_view unit) {
    if (car.wheelbase >= kShortestRoadCar && car.wheelbase <= kLongestRoadCar) return size;
    const Exponents of = exponentsOf(unit);
    if (of.mass == 0 && of.time != 0) return size;  // of the driver, the instruments or the weather
    const double length = car.wheelbase / kMediumWheelbase;
    // Times of a similar motion go with the root of the length.
    return size * std::pow(car.mass / kMediumMass, of.mass) * std::pow(length, of.length + 0.5 * of.time);
}

}  // namespace tread::diagnose::model
