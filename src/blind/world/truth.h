// The car that is really driven in a blind case: the nominal car with the errors of its numbers, the proving ground on
// which it is driven, and whatever acts on it or on its instruments that no number of the car can express.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "blind/world/errors.h"
#include "blind/world/reading_noise.h"
#include "blind/world/surroundings.h"
#include "log/log.h"
#include "recording/subject.h"
#include "run/push.h"

namespace tread::blind::world {

// Source of the errors, disturbances and noise of the cases. `own`: the examiner's (errors.h, surroundings.h,
// instruments.h). `assumed`: the distributions that the diagnosis itself assumes, for comparison.
enum class World { own, assumed };
constexpr auto enumNames(World) {
    return std::array<std::string_view, 2>{"own", "assumed"};
}
// Throws LoadError that lists the valid names.
World worldNamed(std::string_view name);

// Surroundings and instruments that all drives of one case share; World::own only.
struct ProvingGround {
    std::vector<PushSource> surroundings;
    GroundSlope ground;
    std::vector<ReadingNoise> noise;  // in the order of instrumentSheets()
};

struct Truth {
    recording::Subject car;
    std::map<std::string, double, std::less<>> low_pass;  // 1/s, corner frequency of slow instruments, by channel
    std::function<Pushing()> push;                        // force of an outsider; called once for each drive
    // Distorts the readings of a drive before noise is added: an outsider in an instrument.
    std::function<void(Log& log, Random& random)> misread;
    std::optional<ProvingGround> own;  // empty in World::assumed
};

// A car without any fault.
Truth drawnTruth(const VehicleParams& nominal, World world, Random& random);

}  // namespace tread::blind::world
