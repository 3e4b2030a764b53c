// The variables of an FMU: one list for its model description and its shared object. The index in it is the value
// reference.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fmu/values.h"

namespace tread::fmu {

enum class Role { independent, input, parameter, calculated, output };

struct Variable {
    std::string name;  // "chassis.yaw_rate", "car.driveline.ratios[0]"
    Role role;
    std::string unit;  // "-": a pure number
    std::string meaning;
    Limits limits;
    double* number;  // within the values; or
    bool* flag;

    double get() const { return flag ? (*flag ? 1 : 0) : *number; }
    void set(double value) const { flag ? void(*flag = value != 0) : void(*number = value); }
};

// Of these values, which must stay where they are. Numbers of the car that it does not have, or that are without limit,
// are no variables.
std::vector<Variable> variablesOf(Values& values);

// Name of the shared object, and of its functions' owner in a model description.
inline constexpr std::string_view kModelIdentifier = "tread";

// The car's file in the resources.
inline constexpr std::string_view kCarFile = "car.yaml";

// Identifies the variables and the meaning of an FMU: the same car, version of tread and version of FMI ("2.0", "3.0")
// give the same.
std::string tokenOf(std::string_view car_text, std::string_view fmi_version);

}  // namespace tread::fmu
