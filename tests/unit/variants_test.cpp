// Variants of a car settle from where that car has settled: at the same place, sooner.
#include "run/variants.h"

#include <gtest/gtest.h>

#include <memory>
#include <string_view>
#include <vector>

#include "shared/vehicles.h"
#include "tread/road_surface.h"
#include "vehicle/settling.h"

namespace tread::variants_test {
namespace {

Scenario straightDrive() {
    Scenario scenario;
    scenario.step = scenario.substep = 0.004;
    scenario.start.speed = 25;
    scenario.road.grade = 0.01;
    Phase phase;
    phase.until.duration = 0.4;
    scenario.phases = {phase};
    scenario.log.rate = 250;
    return scenario;
}

std::vector<VehicleParams> variantsOf(const VehicleParams& car) {
    std::vector<VehicleParams> all(4, car);
    all[0].mass *= 1.1;
    all[1].front_axle_distance += 0.05;
    all[1].centre_of_gravity_height += 0.03;
    all[2].front.suspension.spring *= 0.8;
    all[3].front.tyre.parameters.pHy1 += 0.01;  // pulls to a side
    return all;
}

Log simulated(Variants& variants, const VehicleParams& car, const Scenario& scenario) {
    Log log;
    variants.simulate(car, scenario, recorderInto(log), {});
    return log;
}

TEST(Variants, MoveAsIfTheyHadSettledFromStaticHeight) {
    const VehicleParams car = reference::compact();
    const Scenario scenario = straightDrive();
    Variants variants(car);
    for (const VehicleParams& variant : variantsOf(car)) {
        const Log cold = simulate(variant, scenario, MovedBy::itself), near = simulated(variants, variant, scenario);
        for (const char* name : {"chassis.z", "chassis.pitch", "chassis.roll", "chassis.vx", "chassis.vy", "chassis.ax",
                                 "chassis.ay", "chassis.yaw_rate", "wheel.front_left.load"}) {
            const std::vector<double>&expected = cold.find(name)->values, &found = near.find(name)->values;
            ASSERT_EQ(found.size(), expected.size());
            // What is left of settling is 1e-6 m/s2 and rad/s2: so much in a second of the drive, or of its load.
            const double allowed = std::string_view(name).ends_with("load") ? 1e-2 : 2e-6;
            for (std::size_t i = 0; i < found.size(); ++i) ASSERT_NEAR(found[i], expected[i], allowed) << name << i;
        }
    }
}

TEST(Variants, DoNotDependOnWhatWasSimulatedBefore) {
    const VehicleParams car = reference::compact();
    Scenario scenario = straightDrive();
    const std::vector<VehicleParams> all = variantsOf(car);
    Variants fresh(car), used(car);
    simulated(used, all[3], scenario);
    scenario.start.speed = 20;
    simulated(used, all[0], scenario);
    scenario.start.speed = 25;
    const Log expected = simulated(fresh, all[2], scenario), found = simulated(used, all[2], scenario);
    ASSERT_EQ(found.channels.size(), expected.channels.size());
    for (std::size_t i = 0; i < found.channels.size(); ++i)
        EXPECT_EQ(found.channels[i].values, expected.channels[i].values) << found.channels[i].name;
}

// Counts the steps of a car that settles.
class Counting final : public Settling {
public:
    Counting(const Vehicle& vehicle, const Surroundings& surroundings, int& steps)
        : vehicle_(vehicle), surroundings_(surroundings), steps_(steps) {}

    void advance(ChassisMotion& motion, VehicleState& state, const VehicleInput& input, double dt) override {
        ++steps_;
        tread::advance(motion, state, vehicle_, input, input, surroundings_, dt);
    }
    void complete(VehicleState&) override {}

private:
    const Vehicle& vehicle_;
    const Surroundings& surroundings_;
    int& steps_;
};

TEST(Settling, TakesLessTimeFromNearby) {
    const auto road = makeRoad({});
    const Surroundings surroundings{*road};
    const Start start{.speed = 25};
    const auto stepsOf = [&](const VehicleParams& params, const Settled* from) {
        int steps = 0;
        settle(prepare(params), surroundings, start, from,
               [&](const Vehicle& vehicle) { return std::make_unique<Counting>(vehicle, surroundings, steps); });
        return steps;
    };
    const VehicleParams car = reference::compact();
    const Settled settled = settle(prepare(car), surroundings, start);
    EXPECT_LE(stepsOf(car, &settled), 27);  // the 0.05 s for which it must be quiet
    // What is left falls exponentially, so that each tenth of the way that is saved saves as much time.
    for (const VehicleParams& variant : variantsOf(car))
        EXPECT_LT(stepsOf(variant, &settled), stepsOf(variant, nullptr));
    VehicleParams near = car;
    near.front.suspension.spring *= 1.02;
    EXPECT_LT(stepsOf(near, &settled), 0.8 * stepsOf(near, nullptr));
}

}  // namespace
}  // namespace tread::variants_test
