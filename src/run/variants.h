// Runs of variants of one car. Each settles from where that car settles at the same start, on the same road and in the
// same wind, which takes a variant little time where it differs little.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "run/simulate.h"

namespace tread {

class Variants {
public:
    explicit Variants(VehicleParams car) : car_(std::move(car)) {}

    // Simulates a variant, which moves by itself (MovedBy::itself). May be called by several threads at once; its
    // result does not depend on what was simulated before.
    void simulate(const VehicleParams& variant, const Scenario& scenario, const Recorder& recorder,
                  const Pushing& pushing);

private:
    using Settling = std::shared_ptr<const Settled>;  // null: the car finds no equilibrium there
    using Key = std::vector<double>;                  // what the settling of the car depends on

    Settling settled(const Scenario& scenario);

    VehicleParams car_;
    std::mutex guard_;
    std::map<Key, Settling> known_;
};

}  // namespace tread
