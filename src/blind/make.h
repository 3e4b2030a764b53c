// Making the cases of a blind check.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "blind/measure.h"
#include "diagnose/catalogue/effect.h"

namespace tread {

struct BlindOrder {
    int cases = 0;
    std::uint64_t seed = 0;
    std::vector<CaseKind> kinds = {};  // none: all, in the proportions of a check
    DriveSet drives = DriveSet::all;
    Drawing drawing = {};
    std::string vehicle;  // file, for the key
    std::string tread_version;
};

// The kind of each case, in an order that tells nothing.
std::vector<CaseKind> kindsOf(const BlindOrder& order);

// A folder for each case with its logs, its nominal car and diagnosis.yaml; returns what belongs into the sealed key.
// Throws FileError, LoadError, and SimulationError when a car cannot be driven.
BlindKey makeCases(
    const BlindOrder& order, const VehicleParams& nominal, const std::vector<diagnose::catalogue::Effect>& effects,
    const std::filesystem::path& folder, const std::function<void(int cases)>& progress = [](int) {});

// A case of a check with this seed, `index` from 0: the same whenever it is drawn, but for what it shows. `shown` are
// the effects to choose from (shown.h), `draw` says the how manieth car for it this is.
DrawnCase drawnCase(std::uint64_t seed, int index, CaseKind kind, const VehicleParams& nominal,
                    const std::vector<diagnose::catalogue::Effect>& shown, int draw = 0, const Drawing& drawing = {});

// The recordings of a case, each named as its log.
struct BlindRecording {
    std::string name;
    const Drive* drive;
    std::uint64_t seed;
};
std::vector<BlindRecording> recordingsOf(const std::vector<Drive>& drives, std::uint64_t seed, int index);

// A case in its folder: the logs that are driven, the nominal car, and diagnosis.yaml. With `before`, the same drives
// of the car as it was before lie in a folder `reference`.
using Driven = std::function<Log(const BlindRecording&)>;
void writeCase(const std::filesystem::path& place, const VehicleParams& nominal,
               const std::vector<BlindRecording>& recordings, const Driven& driven, const Driven& before = {});

}  // namespace tread
