// The car that is really driven in a blind case, and how it is drawn: the nominal one with small errors in every number
// that is known within a tolerance, and with what the key says.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/random.h"
#include "blind/key.h"
#include "diagnose/catalogue/effect.h"
#include "recording/subject.h"
#include "run/push.h"

namespace tread {

struct Truth {
    recording::Subject car;
    std::map<std::string, double, std::less<>> low_pass;  // 1/s, by channel: instruments that are slow
    std::function<Pushing()> push;                        // from outside the catalogue; asked once for each drive
};

// A cause that no effect of the catalogue can express, at any size.
struct Outsider {
    std::string name;
    std::string what;
    // Of these, one is where a diagnosis must find it: longitudinal, lateral, yaw, roll; empty: on an instrument.
    std::vector<std::string> generalised_forces;
    void (*plant)(Truth&, Random&);
};
const std::vector<Outsider>& outsiders();

// Throws LoadError when the kind needs effects and the car has not enough of them.
struct DrawnCase {
    Truth truth;
    CaseKey key;
};
DrawnCase drawCase(const VehicleParams& nominal, const std::vector<diagnose::catalogue::Effect>& effects, CaseKind kind,
                   Random& random);

// Seed of the nth of something that has a seed itself.
std::uint64_t seedOf(std::uint64_t seed, std::uint64_t n);

}  // namespace tread
