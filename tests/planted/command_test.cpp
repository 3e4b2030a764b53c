// An automated car whose force answers its command late and too strongly, found from the recorded command.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/catalogue/effect.h"
#include "diagnose/diagnose.h"
#include "planted.h"

namespace tread::command_test {
namespace {

using diagnose::answer::Diagnosis;
using diagnose::answer::Estimate;
using diagnose::answer::Verdict;
using diagnose::catalogue::Effect;
using recording::SpeedReplay;

using namespace planted;

// N over s: off, hold, brake, off again.
const Curve kCommand{
    {{0, 300}, {1, 300}, {1.2, 3000}, {4, 3000}, {4.3, 0}, {6, 0}, {6.2, -5000}, {8, -5000}, {8.2, 2000}, {10, 2000}}};
constexpr double kDelay = 0.07;  // s
constexpr double kGain = 1.1;

Scenario automated(double speed) {
    Curve force = kCommand;
    for (Curve::Point& point : force.points) point = {point.x + kDelay, kGain * point.y};
    Phase whole = phase(10);
    whole.throttle = CommandedForce{force};
    Scenario scenario = drive(speed, {});
    scenario.phases = {whole};
    return scenario;
}

// The pedals' place in the log is taken by the command.
Case commanded() {
    Case made = recorded({.vehicle = nominalCar(), .road = {}, .wind = {}, .instruments = {}},
                         {{"off at 10 m/s", automated(10)}, {"off at 20 m/s", automated(20)}});
    for (recording::Recording& recording : made.file.recordings) recording.speed = SpeedReplay::command;
    for (Log& log : made.logs) {
        std::erase_if(log.channels, [](const Channel& channel) {
            return channel.name == "driver.throttle" || channel.name == "driver.brake";
        });
        Channel command{"command.force", "N", {}};
        for (const double t : log.channels.front().values) command.values.push_back(kCommand(t));
        log.channels.push_back(std::move(command));
    }
    return made;
}

// The car was weighed: these drives cannot tell its mass from the gain of the command.
TEST(PlantedCommand, DelayAndGainOfTheForceAreFoundWithTheirSizes) {
    const std::set<std::string> considered{"drive_delay", "drive_gain", "drive_response", "brake_delay",
                                           "brake_gain",  "aero_drag",  "speed_delay"};
    std::vector<Effect> effects = diagnose::catalogue::effectCatalogue();
    std::erase_if(effects, [&](const Effect& effect) { return !considered.contains(effect.name); });
    ASSERT_EQ(effects.size(), considered.size());
    const Case made = commanded();
    const Diagnosis d = diagnose::diagnosisOf(made.nominal, made.file, {made.logs}, effects);
    EXPECT_EQ(d.verdict, Verdict::explained) << d.answer;
    std::vector<std::string> causes = d.causes;
    std::sort(causes.begin(), causes.end());
    EXPECT_EQ(causes, (std::vector<std::string>{"drive_delay", "drive_gain"})) << d.answer;
    for (const auto& effect : d.effects) {
        if (effect.name == "drive_delay") {
            const Estimate delay = effect.parameters.at("instruments.command.delay");
            EXPECT_NEAR(delay.value, kDelay, 3 * delay.sd + 0.002);
        }
        if (effect.name == "drive_gain") {
            const Estimate gain = effect.parameters.at("instruments.command.gain");
            EXPECT_NEAR(gain.value, kGain, 3 * gain.sd + 0.01);
        }
    }
}

}  // namespace
}  // namespace tread::command_test
