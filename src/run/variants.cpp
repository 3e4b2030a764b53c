#include "run/variants.h"

#include <utility>

#include "base/fields/numbers.h"

namespace tread {
namespace {

constexpr std::size_t kMostKnown = 1000;  // more are forgotten: those of fits on their way are not asked for again

constexpr double kAtRest = 1e-3;  // m/s2 that are left; a car that has no equilibrium is no help to others

}  // namespace

void Variants::simulate(const VehicleParams& variant, const Scenario& scenario, const Recorder& recorder,
                        const Pushing& pushing) {
    const Settling from = settled(scenario);
    tread::simulate(variant, scenario, recorder, pushing, MovedBy::itself, from.get());
}

Variants::Settling Variants::settled(const Scenario& scenario) {
    Key key;
    const auto add = [&](auto part) {
        for (const Number& number : numbers(part)) key.push_back(*number.value);
    };
    add(scenario.start), add(scenario.road), add(scenario.wind);
    {
        const std::scoped_lock lock(guard_);
        if (const auto found = known_.find(key); found != known_.end()) return found->second;
    }
    auto here = std::make_shared<const Settled>(settledAtStart(car_, scenario));
    if (!(here->acceleration < kAtRest)) here = nullptr;
    const std::scoped_lock lock(guard_);
    if (known_.size() >= kMostKnown) known_.clear();
    return known_.try_emplace(std::move(key), here).first->second;
}

}  // namespace tread
