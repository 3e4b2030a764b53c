// Whoever moves a car moves it alike: Bullet with the plugin, the car by itself, the lanes of a convoy.
#include "run/mover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "places/places.h"
#include "run/simulate.h"
#include "run/together.h"
#include "scenario/load.h"
#include "shared/equipped_car.h"
#include "shared/vehicles.h"
#include "tread/load.h"
#include "tread/road_surface.h"

namespace tread::mover_test {
namespace {

constexpr double kLongest = 2;  // s of each scenario: past the beginning of all manoeuvres, and quickly driven

// A run, and what ended it.
struct DrivenRun {
    Log log;
    std::string end;
};

DrivenRun driven(const VehicleParams& car, const Scenario& scenario, MovedBy by) {
    DrivenRun run;
    try {
        simulate(car, scenario, recorderInto(run.log), {}, by);
    } catch (const SimulationError& error) {
        run.end = error.what();
    }
    return run;
}

void expectSame(const DrivenRun& a, const DrivenRun& b, const std::string& what) {
    EXPECT_EQ(a.end, b.end) << what;
    ASSERT_EQ(a.log.channels.size(), b.log.channels.size()) << what;
    for (std::size_t i = 0; i < a.log.channels.size(); ++i)
        ASSERT_EQ(a.log.channels[i].values, b.log.channels[i].values) << what << ": " << a.log.channels[i].name;
}

std::vector<std::filesystem::path> yamlFilesIn(const std::string& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(sourceFile(folder)))
        if (entry.path().extension() == ".yaml") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

// All shipped scenarios, shortened, with all shipped cars in turn and one that has all that can be fitted.
struct Drive {
    std::string name;
    VehicleParams car;
    Scenario scenario;
};
std::vector<Drive> shippedDrives() {
    std::vector<VehicleParams> cars{shared::withEverything(reference::compact())};
    for (const std::filesystem::path& file : yamlFilesIn("vehicles")) cars.push_back(loadVehicle(file));
    std::vector<Drive> drives;
    for (const std::filesystem::path& file : yamlFilesIn("scenarios")) {
        drives.push_back({file.stem().string(), cars[drives.size() % cars.size()], loadScenario(file)});
        drives.back().scenario.time_limit = kLongest;
    }
    return drives;
}

TEST(Mover, ShippedScenariosHaveTheSameLogsWhoeverMovesTheCar) {
    const std::vector<Drive> drives = shippedDrives();
    ASSERT_GT(drives.size(), 30u);
    std::vector<DrivenRun> together(drives.size());
    drivenTogether(drives.size(), 1,
                   [&](std::size_t i) { together[i] = driven(drives[i].car, drives[i].scenario, MovedBy::itself); });
    for (std::size_t i = 0; i < drives.size(); ++i) {
        const DrivenRun in_bullet = driven(drives[i].car, drives[i].scenario, MovedBy::bullet);
        expectSame(in_bullet, driven(drives[i].car, drives[i].scenario, MovedBy::itself), drives[i].name + ", alone");
        expectSame(in_bullet, together[i], drives[i].name + ", together");
    }
}

TEST(Mover, APushMovesTheBodyWhoeverMovesTheCar) {
    const auto road = makeRoad({});
    const VehicleParams params = reference::compact();
    const Vehicle vehicle = prepare(params);
    const Equilibrium start = equilibrium(vehicle, {*road}, {.speed = 20});
    constexpr double kStep = 0.001;  // s
    const Push push{.force = {0.4, 1, 0.2}, .moment = {0.5, 0.3, 1}};
    for (const MovedBy by : {MovedBy::bullet, MovedBy::itself}) {
        const auto pushed = mover(by, params, *road, start, kStep), left = mover(by, params, *road, start, kStep);
        for (Mover* car : {pushed.get(), left.get()}) car->setInput(start.input);
        pushed->move(kStep, push);
        left->move(kStep, std::nullopt);
        const Vector3 faster = pushed->motion().velocity_W - left->motion().velocity_W;
        const Vector3 further = pushed->motion().position_W - left->motion().position_W;
        const Vector3 spinning = pushed->motion().angular_velocity_W - left->motion().angular_velocity_W;
        const InertiaParams& inertia = params.inertia;
        const Vector3 expected = kStep / params.mass * push.force;
        const Vector3 turn = kStep * push.moment.cwiseQuotient(Vector3(inertia.roll, inertia.pitch, inertia.yaw));
        EXPECT_LT((faster - expected).norm(), 1e-6 * expected.norm());
        EXPECT_LT((further - kStep * expected).norm(), 1e-4 * kStep * expected.norm());
        EXPECT_LT((spinning - turn).norm(), 0.02 * turn.norm());  // the car leans by 2 % in its equilibrium
    }
}

// A newton in each step is far below what a body shows by rounding in a second; none of them is lost.
TEST(Mover, TheSmallestForceOfAGameIsNotLost) {
    const auto road = makeRoad({});
    const VehicleParams params = reference::compact();
    const Equilibrium start = equilibrium(prepare(params), {*road}, {.input = {.parking_brake = 0}});
    const auto pushed = mover(MovedBy::bullet, params, *road, start, 0.001);
    const auto left = mover(MovedBy::bullet, params, *road, start, 0.001);
    for (int i = 0; i < 1000; ++i) {
        pushed->move(0.001, Push{.force = {0, 0, 1}});
        left->move(0.001, std::nullopt);
    }
    // A newton lifts the body by what its springs and tyres give way, and stays.
    const double lifted = pushed->motion().position_W.z() - left->motion().position_W.z();
    EXPECT_GT(lifted, 5e-6);
    EXPECT_LT(lifted, 5e-5);
}

TEST(DrivenTogether, RunsOfDifferentStepsCarsAndLengthsAreAsAlone) {
    std::vector<Drive> drives;
    for (const int i : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}) {
        Drive drive{std::to_string(i), reference::compact(), loadScenario(sourceFile("scenarios/step_steer_80.yaml"))};
        drive.car.mass *= 1 + 0.01 * i;
        if (i % 3 == 1) drive.car.front.suspension.longitudinal_compliance = 2e-6;  // not in lanes
        if (i % 4 == 2) drive.scenario.step = 0.002;
        if (i % 5 == 3) drive.scenario.phases.front().throttle = CommandedForce{Curve{{{0, 300}, {1, -2000}}}};
        drive.scenario.time_limit = 0.2 + 0.1 * i;
        drives.push_back(drive);
    }
    std::vector<DrivenRun> together(drives.size());
    for (const int threads : {1, 2}) {
        drivenTogether(drives.size(), threads, [&](std::size_t i) {
            together[i] = driven(drives[i].car, drives[i].scenario, MovedBy::itself);
        });
        for (std::size_t i = 0; i < drives.size(); ++i) {
            expectSame(driven(drives[i].car, drives[i].scenario, MovedBy::itself), together[i], drives[i].name);
            EXPECT_GT(together[i].log.samples(), 10u);
        }
    }
}

TEST(DrivenTogether, AllRunsOfWhichEachPushesItsCarAreAsAlone) {
    Scenario scenario = loadScenario(sourceFile("scenarios/step_steer_80.yaml"));
    scenario.time_limit = 0.5;
    const auto drive = [&](std::size_t i) {
        DrivenRun run;
        const Pushing pushing = [i](double time, const VehicleInput&, const VehicleOutput&) {
            return Push{.force = {0, 100.0 * static_cast<double>(i) * time, 0}, .moment = {10, 0, 20}};
        };
        try {
            simulate(reference::compact(), scenario, recorderInto(run.log), i % 2 ? pushing : Pushing{},
                     MovedBy::itself);
        } catch (const SimulationError& error) {
            run.end = error.what();
        }
        return run;
    };
    std::vector<DrivenRun> together(10);
    drivenTogether(together.size(), 1, [&](std::size_t i) { together[i] = drive(i); });
    for (std::size_t i = 0; i < together.size(); ++i) expectSame(drive(i), together[i], std::to_string(i));
    EXPECT_NE(together[1].log.channels[1].values.size(), 0u);
}

// Exceptions end a call, and one is thrown on while others are being handled in other calls.
TEST(DrivenTogether, TheFirstFailureIsThrownAndOthersAreHandledInTheirCalls) {
    Scenario scenario = loadScenario(sourceFile("scenarios/step_steer_80.yaml"));
    scenario.time_limit = 0.1;
    std::vector<int> handled(20, 0);
    const auto work = [&](std::size_t i) {
        try {
            throw std::runtime_error(std::to_string(i));
        } catch (const std::runtime_error& error) {
            driven(reference::compact(), scenario, MovedBy::itself);
            handled[i] = error.what() == std::to_string(i) && std::uncaught_exceptions() == 0;
        }
        if (i == 5 || i == 7) throw std::invalid_argument(std::to_string(i));
    };
    try {
        drivenTogether(handled.size(), 2, work);
        ADD_FAILURE() << "nothing was thrown";
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "5");
    }
    EXPECT_EQ(handled[0], 1);
    EXPECT_EQ(handled[5], 1);
}

TEST(DrivenTogether, ACallMayDriveOthersTogether) {
    Scenario scenario = loadScenario(sourceFile("scenarios/step_steer_80.yaml"));
    scenario.time_limit = 0.1;
    const DrivenRun alone = driven(reference::compact(), scenario, MovedBy::itself);
    std::vector<std::vector<DrivenRun>> runs(4, std::vector<DrivenRun>(4));
    drivenTogether(runs.size(), 1, [&](std::size_t i) {
        drivenTogether(runs[i].size(), 1,
                       [&](std::size_t k) { runs[i][k] = driven(reference::compact(), scenario, MovedBy::itself); });
    });
    for (const std::vector<DrivenRun>& some : runs)
        for (const DrivenRun& run : some) expectSame(alone, run, "nested");
}

}  // namespace
}  // namespace tread::mover_test
