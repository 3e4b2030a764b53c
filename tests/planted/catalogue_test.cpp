// A row of the catalogue, planted into a car that has the parts for it and recovered from two drives, against the rows
// beside it. Of what is uncertain about a car only a few numbers are: all of them belong to the blind check. Every
// eighth row; all of them, if the environment variable TREAD_ROWS is "all".
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>
#include <set>
#include <string>
#include <string_view>

#include "base/math/random.h"
#include "blind/drives/measure.h"
#include "blind/world/instruments.h"
#include "diagnose/answer/diagnosis.h"
#include "diagnose/catalogue/effect.h"
#include "diagnose/diagnose.h"
#include "diagnose/model/parameter.h"
#include "diagnose/settings.h"
#include "places/places.h"
#include "recording/diagnosis_file.h"
#include "recording/subject.h"
#include "tread/load.h"

namespace tread::catalogue_test {
namespace {

using blind::drives::caseDrives;
using blind::drives::Drive;
using blind::drives::kIdeal;
using blind::drives::measure;
using blind::world::InstrumentSheet;
using blind::world::instrumentSheets;
using blind::world::Truth;
using diagnose::kSettings;
using diagnose::answer::Diagnosis;
using diagnose::answer::Verdict;
using diagnose::catalogue::applies;
using diagnose::catalogue::Direction;
using diagnose::catalogue::Effect;
using diagnose::catalogue::effectCatalogue;
using diagnose::catalogue::Knob;
using recording::DiagnosisFile;
using recording::MeasuredChannel;
using recording::numberAt;
using recording::Recording;
using recording::Subject;

constexpr double kSize = 1.3;  // of the typical size: what a test of a few drives can ask
constexpr std::size_t kDrives = 2;
constexpr std::size_t kRivals = 2;  // rows of the catalogue on either side
constexpr std::array<const char*, 4> kUncertain{"mass", "inertia.yaw", "front.tyre.lambda.Ky",
                                                "brakes.full_pedal_torque"};
constexpr double kTolerance = 0.02;

// Rows that no two of the drives show: less is to be expected of them than stands out. drive_delay needs a command in
// place of pedals (command_test.cpp).
const std::set<std::string> kHidden{
    "ackermann",      "aero_lift",     "anti_lock",   "belt_gyroscopics",     "bump_stops",
    "camber_gain",    "conicity",      "drive_delay", "pneumatic_trail",      "shaft_stiffness",
    "sideslip_delay", "sideslip_zero", "toe_front",   "tyre_radial_stiffness"};

// The compact car with what its file leaves out, so that every row has something to move.
VehicleParams completeCar() {
    VehicleParams car = loadVehicle(sourceFile("vehicles/compact.yaml"));
    for (DiscParams* disc : {&car.brakes.front_disc, &car.brakes.rear_disc}) disc->heat_capacity = 2500;
    for (AxleParams* axle : {&car.front, &car.rear}) {
        TyreTemperatureParams& temperature = axle->tyre_surroundings.temperature;
        temperature.heat_capacity = 4000;
        temperature.cooling = 40;
        TyrePressureParams& pressure = axle->tyre_surroundings.pressure;
        pressure.radial_stiffness = 0.8;
        pressure.cornering_stiffness = 0.3;
        pressure.cornering_peak_load = 0.5;
    }
    return car;
}

// The drives in which an effect changes the readings most, in squares over their noise.
std::vector<std::size_t> telling(const Truth& truth, const Truth& nominal, const std::vector<Drive>& drives) {
    std::vector<double> changes;
    for (const Drive& drive : drives) {
        const Log with = measure(truth, drive, 1, kIdeal), without = measure(nominal, drive, 1, kIdeal);
        double sum = 0;
        for (const InstrumentSheet& sheet : instrumentSheets()) {
            const auto &x = with.find(sheet.channel)->values, &y = without.find(sheet.channel)->values;
            for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i)
                sum += (x[i] - y[i]) * (x[i] - y[i]) / (sheet.noise * sheet.noise);
        }
        changes.push_back(sum);
    }
    std::vector<std::size_t> best(drives.size());
    std::iota(best.begin(), best.end(), 0u);
    std::sort(best.begin(), best.end(), [&](auto a, auto b) { return changes[a] > changes[b]; });
    best.resize(kDrives);
    return best;
}

Diagnosis diagnosed(const Truth& truth, const VehicleParams& car, const std::vector<Effect>& effects,
                    const std::vector<std::size_t>& chosen) {
    const std::vector<Drive> drives = caseDrives();
    DiagnosisFile file;
    file.vehicle = "car";
    for (const InstrumentSheet& sheet : instrumentSheets()) {
        MeasuredChannel channel;
        channel.channel = sheet.channel;
        channel.noise = sheet.noise;
        file.channels.push_back(channel);
    }
    std::vector<Log> logs;
    for (const std::size_t d : chosen) {
        Recording recording;
        recording.log = recording.name = drives[d].name;
        file.recordings.push_back(recording);
        logs.push_back(measure(truth, drives[d], 100 + d));
    }
    file.tolerances.push_back({"*", 0, 0});
    for (const char* uncertain : kUncertain) file.tolerances.push_back({uncertain, kTolerance, 0});
    Subject nominal;
    nominal.vehicle = car;
    return diagnose::diagnosisOf(nominal, file, {logs}, effects);
}

class CatalogueRow : public testing::TestWithParam<std::size_t> {};

TEST_P(CatalogueRow, IsNamedWhereItsDrivesShowItAndNothingIsBlamedWhereTheyDoNot) {
    const std::vector<Effect>& all = effectCatalogue();
    const Effect& effect = all[GetParam()];
    const VehicleParams car = completeCar();
    Truth nominal, truth;
    nominal.car.vehicle = truth.car.vehicle = car;
    ASSERT_TRUE(applies(effect, nominal.car)) << effect.name << " moves no number of a car that has every part";
    for (const Knob& knob : effect.knobs)
        move(truth.car, knob, (knob.direction == Direction::down ? -kSize : kSize) * knob.typical);
    const std::size_t first = GetParam() > kRivals ? GetParam() - kRivals : 0;
    const std::size_t last = std::min(all.size(), GetParam() + kRivals + 1);
    const std::vector<Effect> considered(all.begin() + static_cast<long>(first), all.begin() + static_cast<long>(last));
    const Diagnosis d = diagnosed(truth, car, considered, telling(truth, nominal, caseDrives()));
    ASSERT_FALSE(d.effects.empty());
    const double expected = d.expected_evidence.at(effect.name);
    if (kHidden.contains(effect.name)) {
        EXPECT_LT(expected, kSettings.clear) << "the drives show it: it belongs to the others";
        // Expected evidence is that of one parameter: two together may show all the same, and then it must be right.
        EXPECT_TRUE(d.causes.empty() || d.causes == std::vector<std::string>{effect.name}) << d.answer;
        return;
    }
    ASSERT_GE(expected, kSettings.clear) << "the drives do not show it any more";
    // What these drives show only just may be too little for a verdict, but nothing is likelier.
    constexpr double kPlain = 25;  // nats to expect: two standard deviations above what a verdict asks for
    if (expected * kSize * kSize < kPlain && d.causes.empty()) {
        EXPECT_EQ(d.effects.front().name, effect.name) << d.answer;
        return;
    }
    // Two drives do not separate every pair: then the truth is among those that cannot be told apart.
    std::vector<std::string> named = d.causes;
    for (const auto& alternative : d.alternatives) named.insert(named.end(), alternative.begin(), alternative.end());
    EXPECT_NE(std::find(named.begin(), named.end(), effect.name), named.end())
        << d.answer << " (" << expected << " nats expected at typical size; best " << d.effects.front().name << " with "
        << d.effects.front().log_evidence << ")";
}

std::vector<std::size_t> rows() {
    const char* const asked = std::getenv("TREAD_ROWS");
    const std::size_t apart = asked && asked == std::string_view("all") ? 1 : 8;
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < effectCatalogue().size(); i += apart) indices.push_back(i);
    return indices;
}

INSTANTIATE_TEST_SUITE_P(Planted, CatalogueRow, testing::ValuesIn(rows()),
                         [](const auto& row) { return effectCatalogue()[row.param].name; });

// A car that errs only within its tolerances, against the whole catalogue.
class PlantedNothing : public testing::TestWithParam<std::uint64_t> {};

TEST_P(PlantedNothing, IsBlamedOnNoEffect) {
    const VehicleParams car = completeCar();
    Truth truth;
    truth.car.vehicle = car;
    Random random(GetParam());
    for (const char* uncertain : kUncertain)
        *numberAt(truth.car, uncertain) *= 1 + kTolerance * (2 * random.uniform() - 1);
    const std::vector<Drive> drives = caseDrives();
    std::vector<std::size_t> chosen;
    for (std::size_t d = 0; d < drives.size(); ++d)
        if (drives[d].name == "step_steer_80" || drives[d].name == "braking_in_turn_90") chosen.push_back(d);
    ASSERT_EQ(chosen.size(), kDrives);
    const Diagnosis d = diagnosed(truth, car, effectCatalogue(), chosen);
    EXPECT_EQ(d.verdict, Verdict::nothing) << d.answer;
    EXPECT_TRUE(d.causes.empty());
    EXPECT_GT(d.probability_of_nothing, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Planted, PlantedNothing, testing::Values(1u, 2u, 3u));

}  // namespace
}  // namespace tread::catalogue_test
