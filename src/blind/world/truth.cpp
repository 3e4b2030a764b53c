#include "blind/world/truth.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "base/text/enum_named.h"
#include "blind/world/draws.h"
#include "blind/world/instruments.h"
#include "diagnose/model/parameter.h"
#include "recording/subject.h"

namespace tread::blind::world {
namespace {

using diagnose::model::nuisances;
using diagnose::model::Parameter;
using recording::Subject;

// Errors that the instruments of these cases do not have: their units have no latency in common and are not askew.
constexpr std::string_view kExact[] = {"instruments.latency", "instruments.inertial_unit.yaw"};

// Errors as the diagnosis assumes them: every other number of car and instruments that has a tolerance is drawn from a
// uniform distribution of that half-width.
void errAsAssumed(Subject& car, Random& random) {
    const double most = std::sqrt(3.0);  // half-width of a uniform distribution over its standard deviation
    for (const Parameter& uncertain : nuisances(car, {})) {
        if (std::find(std::begin(kExact), std::end(kExact), uncertain.name()) != std::end(kExact)) continue;
        move(car, uncertain, std::clamp(between(random, -most, most), uncertain.lowest, uncertain.highest));
    }
}

}  // namespace

World worldNamed(std::string_view name) {
    return enumNamed<World>(name, "the world");
}

Truth drawnTruth(const VehicleParams& nominal, World world, Random& random) {
    Truth truth{.car = {.vehicle = nominal, .road = {}, .wind = {}, .instruments = {}},
                .low_pass = {},
                .push = {},
                .misread = {},
                .own = {}};
    if (world == World::assumed) {
        errAsAssumed(truth.car, random);
        return truth;
    }
    drawErrors(truth.car, random);
    std::vector<PushSource> surroundings = drawnSurroundings(nominal, random);
    const GroundSlope ground = drawnGround(random);
    truth.own = ProvingGround{std::move(surroundings), ground, drawnNoise(random)};
    return truth;
}

}  // namespace tread::blind::world
