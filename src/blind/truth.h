// The car that is really driven in a blind case, and how it is drawn: the nominal one with errors, and with what the
// key says.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "blind/draws.h"
#include "blind/errors.h"
#include "blind/key.h"
#include "blind/reading_noise.h"
#include "blind/surroundings.h"
#include "diagnose/effect.h"
#include "diagnose/subject.h"
#include "log/log.h"
#include "run/push.h"

namespace tread {

// Where and with what the drives of one case are driven, in World::own.
struct ProvingGround {
    std::vector<PushSource> surroundings;
    GroundSlope ground;
    std::vector<ReadingNoise> noise;  // in the order of gauges()
};

struct Truth {
    Subject car;
    std::map<std::string, double, std::less<>> low_pass;  // 1/s, by channel: instruments that are slow
    std::function<Pushing()> push;                        // from outside the catalogue; asked once for each drive
    // What instruments from outside the catalogue make of the readings of a drive, before their noise.
    std::function<void(Log& log, Random& random)> misread;
    std::optional<ProvingGround> own;  // nothing: World::assumed
};

struct DrawnCase {
    Truth truth;
    CaseKey key;
    Truth sound;                           // without anything that is wrong
    std::map<std::string, Truth> without;  // one of the things that are wrong, by its name: all else as it is
};

// What a case is drawn with besides its kind.
struct Drawing {
    World world = World::own;
    bool frozen = false;  // outsiders of both families, else of the first
};

// Throws LoadError when the kind needs effects and the car has not enough of them.
DrawnCase drawCase(const VehicleParams& nominal, const std::vector<Effect>& effects, CaseKind kind, Random& random,
                   const Drawing& drawing = {});

// Whether they move the same number.
bool sharePaths(const Effect& a, const Effect& b);

}  // namespace tread
