#include "host/parameters.h"

#include "base/fields/numbers.h"
#include "base/text/concat.h"
#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "base/yaml/setting.h"
#include "vehicle/fields.h"

namespace tread::host {
namespace {

std::string listing(std::string_view) {
    return "`tread describe vehicle` lists all paths";
}

}  // namespace

VehicleParams vehicleOfText(std::string_view text, const std::string& file) {
    return readYamlText<VehicleParams>(text, file);
}

void checkParameters(const VehicleParams& car) {
    YamlSession session;
    VehicleParams copy = car;
    detail::readNothing(session, "parameters", "", copy);
    throwIfAny(std::move(session.problems));
}

void setParameters(VehicleParams& car, std::span<const std::string> assignments, std::string_view what) {
    applySettings(car, assignments, what, listing);
}

void setParameter(VehicleParams& car, std::string_view path, std::string_view value) {
    const std::string assignment = concat({path, "=", value});
    setParameters(car, std::span(&assignment, 1), "parameter");
}

double parameter(VehicleParams& car, std::string_view path) {
    std::vector<std::string_view> names;
    const std::vector<Number> all = numbers(car);
    for (const Number& number : all) {
        if (number.path == path) return *number.value;
        names.push_back(number.path);
    }
    const auto near = closest(path, names);
    const std::string text = concat({"found the unknown path ", quote(path), ", expected that of a number"});
    throw LoadError(
        {{"", 0, 0, std::string(path), near ? concat({text, "; did you mean ", quote(*near), "?"}) : text}});
}

}  // namespace tread::host
