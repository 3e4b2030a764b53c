// Makes the cases of a blind check: draws them, drives them, writes their folders and the key.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "blind/drives/measure.h"
#include "blind/faults/drawn_case.h"
#include "diagnose/catalogue/effect.h"

namespace tread::blind::make {

// Order for a number of cases.
struct Order {
    int cases = 0;
    std::uint64_t seed = 0;
    std::vector<key::CaseKind> kinds = {};  // repeated in this order; empty: all kinds in the proportions of a check
    drives::DriveSet drives = drives::DriveSet::all;
    faults::Drawing drawing = {};
    std::string vehicle;  // file name, for the key
    std::string tread_version;
};

// Kind of each case, shuffled by the seed.
std::vector<key::CaseKind> kindsOf(const Order& order);

// Writes a folder for each case and returns the key. Throws FileError, LoadError, and SimulationError when no drivable
// car was found for a case.
key::SealedKey makeCases(
    const Order& order, const VehicleParams& nominal, const std::vector<diagnose::catalogue::Effect>& effects,
    const std::filesystem::path& folder, const std::function<void(int cases)>& progress = [](int) {});

// Case number `index` (from 0) of the check with this seed, without its detectability. Deterministic. `choice`: effects
// to draw from (detectable_effects.h). `draw`: number of cars that were drawn for the case before and could not be
// driven.
faults::DrawnCase drawnCase(std::uint64_t seed, int index, key::CaseKind kind, const VehicleParams& nominal,
                            const std::vector<diagnose::catalogue::Effect>& choice, int draw = 0,
                            const faults::Drawing& drawing = {});

// A recording of a case. `name` is the stem of its log.
struct CaseRecording {
    std::string name;
    const drives::Drive* drive;
    std::uint64_t seed;
};
std::vector<CaseRecording> recordingsOf(const std::vector<drives::Drive>& drives, std::uint64_t seed, int index);

// Writes the logs of `driven`, the nominal car and diagnosis.yaml to the folder `place`, and the logs of `before`, the
// same drives of the car before the fault, to its folder `reference`.
using Driven = std::function<Log(const CaseRecording&)>;
void writeCase(const std::filesystem::path& place, const VehicleParams& nominal,
               const std::vector<CaseRecording>& recordings, const Driven& driven, const Driven& before = {});

}  // namespace tread::blind::make
