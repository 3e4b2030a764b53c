// Files of a diagnosis: what it is asked, effects of one's own, and the recordings that it names.

#include <gtest/gtest.h>

#include <algorithm>

#include "diagnose/catalogue/effect.h"
#include "diagnose/catalogue/effects_to_consider.h"
#include "log/csv.h"
#include "places/places.h"
#include "recording/diagnosis_file.h"
#include "recording/subject.h"
#include "shared/foreign_logs.h"
#include "shared/scratch.h"
#include "tread/problem.h"

namespace tread::diagnose_load_test {
namespace {

using diagnose::catalogue::Direction;
using diagnose::catalogue::effectCatalogue;
using diagnose::catalogue::effectsToConsider;
using diagnose::catalogue::loadOwnEffects;
using diagnose::catalogue::OwnEffects;
using recording::DiagnosisFile;
using recording::loadDiagnosis;
using recording::nominalSubject;
using recording::readRecordings;
using recording::Recorded;
using recording::Subject;

// The faults that loading throws, one line each.
template <class Load>
std::vector<std::string> faultsOf(Load load) {
    try {
        load();
    } catch (const LoadError& error) {
        std::vector<std::string> lines;
        for (const Problem& problem : error.problems()) lines.push_back(toText(problem));
        return lines;
    }
    return {};
}

std::string withoutFolder(const std::string& text, const Scratch& scratch) {
    std::string out = text;
    const std::string folder = scratch.folder() + "/";
    for (std::size_t at = out.find(folder); at != std::string::npos; at = out.find(folder))
        out.erase(at, folder.size());
    return out;
}

// A turn of 3 s at 20 m/s as a log of tread.
Log turn() {
    Log log{{{"time", "s", {}},
             {"driver.steering_wheel_angle", "rad", {}},
             {"chassis.vx", "m/s", {}},
             {"gyro", "rad/s", {}}}};
    for (const double t : foreign::times(301)) {
        const double row[] = {t, foreign::steering(t), foreign::kSpeed, foreign::yawRate(t)};
        for (std::size_t i = 0; i < 4; ++i) log.channels[i].values.push_back(row[i]);
    }
    return log;
}

std::string compact() {
    return "vehicle: " + sourceFile("vehicles/compact.yaml") + "\n";
}

TEST(OwnEffects, ShippedExampleIsFine) {
    const auto own = loadOwnEffects(sourceFile("scenarios/diagnose/own_effects.yaml"));
    ASSERT_EQ(own.size(), 2u);
    EXPECT_EQ(own[0].name, "roof_box");
    EXPECT_EQ(own[0].knobs[1].typical, 0.045) << "m";
    EXPECT_EQ(own[1].knobs[0].direction, Direction::up);
    EXPECT_EQ(own[1].knobs[0].shares, (std::vector<double>{-1, 0.2}));
}

TEST(OwnEffects, WrongOnesAreRefusedWhereTheyStand) {
    const Scratch scratch;
    const std::string file = scratch.file("own.yaml",
                                          "catalogue:\n"
                                          "  - name: grip\n"
                                          "    question: Again?\n"
                                          "    knobs:\n"
                                          "      - {paths: [mass, inertia.yow], typical: 0.2}\n");
    const auto faults = faultsOf([&] { loadOwnEffects(file); });
    ASSERT_EQ(faults.size(), 2u);
    EXPECT_EQ(withoutFolder(faults[0], scratch),
              "own.yaml:2:11: catalogue.0.name: found \"grip\", the name of another effect; expected a name that is "
              "not yet taken");
    EXPECT_EQ(
        withoutFolder(faults[1], scratch).find("own.yaml:5:24: catalogue.0.knobs.0.paths.1: found \"inertia.yow\""), 0u)
        << faults[1];
    EXPECT_NE(faults[1].find("did you mean \"inertia.yaw\"?"), std::string::npos);
}

TEST(OwnEffects, KnobsWithoutSizeOrWithSharesAmissAreRefused) {
    const Scratch scratch;
    const std::string file = scratch.file("own.yaml",
                                          "catalogue:\n"
                                          "  - name: a\n"
                                          "    knobs: [{paths: [mass]}]\n"
                                          "  - name: b\n"
                                          "    knobs: [{paths: [mass], typical: 1, shares: [1, 2]}]\n");
    const auto faults = faultsOf([&] { loadOwnEffects(file); });
    ASSERT_EQ(faults.size(), 2u);
    EXPECT_NE(faults[0].find("catalogue.0.knobs.0.typical"), std::string::npos) << faults[0];
    EXPECT_NE(faults[1].find("expected one share for each path"), std::string::npos) << faults[1];
}

TEST(DiagnosisFile, NamesAreRelativeToTheFileAndLogsToTheFolderOfData) {
    const Scratch scratch;
    std::filesystem::create_directory(scratch.path("data"));
    writeLog(scratch.path("a.csv"), turn());
    writeLog(scratch.path("data/a.csv"), turn());
    const std::string file = scratch.file("diagnosis.yaml", compact() + "recordings: [{log: a.csv}, {log: a.csv}]\n");
    const DiagnosisFile own = loadDiagnosis(file);
    EXPECT_EQ(own.recordings[0].log, scratch.path("a.csv"));
    EXPECT_EQ(own.recordings[0].name, "a");
    EXPECT_EQ(own.recordings[1].name, "a (2)") << "names tell recordings apart";
    EXPECT_EQ(loadDiagnosis(file, scratch.path("data")).recordings[0].log, scratch.path("data/a.csv"));
}

TEST(DiagnosisFile, NamesOfNothingAreRefusedWithASuggestion) {
    const Scratch scratch;
    const std::string file = scratch.file("diagnosis.yaml",
                                          "vehicle: none.yaml\n"
                                          "recordings: [{log: none.csv, hold_out: true}]\n"
                                          "channels: [{channel: chassis.yawrate}]\n"
                                          "tolerances: [{path: \"front.tire.*\", relative: 0.1}]\n");
    const auto faults = faultsOf([&] { loadDiagnosis(file); });
    ASSERT_EQ(faults.size(), 5u);
    const char* const expected[] = {":1:10: vehicle", ":2:13: recordings: found hold_out", ":2:20: recordings.0.log",
                                    ":3:22: channels.0.channel", ":4:21: tolerances.0.path"};
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NE(faults[i].find(expected[i]), std::string::npos) << faults[i];
    EXPECT_NE(faults[3].find("did you mean \"chassis.yaw_rate\"?"), std::string::npos) << faults[3];
}

TEST(DiagnosisFile, DrivesBeforeTheChangeAreReadLikeRecordings) {
    const Scratch scratch;
    writeLog(scratch.path("a.csv"), turn());
    const std::string file = scratch.file("diagnosis.yaml", compact() +
                                                                "recordings: [{log: a.csv}]\n"
                                                                "before: [{log: a.csv, from: 1, to: 2.5}]\n");
    const DiagnosisFile loaded = loadDiagnosis(file);
    ASSERT_EQ(loaded.before.size(), 1u);
    EXPECT_EQ(loaded.before[0].log, scratch.path("a.csv"));
    EXPECT_EQ(loaded.before[0].name, "a (2)");
    const Recorded recorded = readRecordings(loaded);
    ASSERT_EQ(recorded.before.size(), 1u);
    EXPECT_EQ(recorded.before[0].samples(), 151u);
}

TEST(DiagnosisFile, DrivesBeforeTheChangeHaveNoReferenceAndAreNotHeldOut) {
    const Scratch scratch;
    writeLog(scratch.path("a.csv"), turn());
    writeLog(scratch.path("b.csv"), turn());
    const std::string file = scratch.file("diagnosis.yaml", compact() +
                                                                "recordings: [{log: a.csv}]\n"
                                                                "before:\n"
                                                                "  - {log: a.csv, reference: b.csv}\n"
                                                                "  - {log: b.csv, hold_out: true}\n"
                                                                "  - {log: none.csv}\n");
    const auto faults = faultsOf([&] { loadDiagnosis(file); });
    ASSERT_EQ(faults.size(), 3u);
    const char* const expected[] = {
        ":4:29: before.0.reference: found a reference for a drive of the car before the change",
        ":5:28: before.1.hold_out: found true for a drive of the car before the change", ":6:11: before.2.log: found"};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NE(faults[i].find(expected[i]), std::string::npos) << faults[i];
}

TEST(DiagnosisFile, EffectsAreChosenByPatternsAndUnknownOnesRefused) {
    DiagnosisFile file;
    EXPECT_EQ(effectsToConsider(file).size(), effectCatalogue().size());
    file.own_effects = sourceFile("scenarios/diagnose/own_effects.yaml");
    EXPECT_EQ(effectsToConsider(file).size(), effectCatalogue().size() + 2);
    file.effects = {"brake_*", "roof_box"};
    const auto chosen = effectsToConsider(file);
    EXPECT_EQ(chosen.size(), 9u);
    file.effects = {"brake_gian"};
    const auto faults = faultsOf([&] { effectsToConsider(file); });
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_NE(faults[0].find("did you mean \"brake_gain\"?"), std::string::npos) << faults[0];
}

TEST(DiagnosisFile, NominalCarHasItsSettingsAndInstruments) {
    DiagnosisFile file;
    file.vehicle = sourceFile("vehicles/compact.yaml");
    file.vehicle_settings = {"mass=1500 kg"};
    file.instruments.yaw_rate.delay = 0.02;
    const Subject subject = nominalSubject(file);
    EXPECT_EQ(subject.vehicle.mass, 1500);
    EXPECT_EQ(subject.instruments.yaw_rate.delay, 0.02);
}

TEST(Recordings, TreadLogIsCutToItsWindowAndItsColumnsRenamed) {
    const Scratch scratch;
    writeLog(scratch.path("a.csv"), turn());
    DiagnosisFile file;
    file.recordings = {{.log = scratch.path("a.csv"), .name = "a", .from = 1, .to = 2.5}};
    file.channels = {{.channel = "chassis.yaw_rate", .column = "gyro"}};
    const Recorded recorded = readRecordings(file);
    ASSERT_EQ(recorded.logs.size(), 1u);
    const Log& log = recorded.logs[0];
    EXPECT_EQ(log.samples(), 151u);
    EXPECT_EQ(log.channels[0].values.front(), 0);
    ASSERT_TRUE(log.find("chassis.yaw_rate"));
    EXPECT_DOUBLE_EQ(log.find("chassis.yaw_rate")->values[10], foreign::yawRate(1.1));
    EXPECT_TRUE(recorded.notes.empty());
}

TEST(Recordings, ForeignLogIsReadByNamesAndSaysWhatWasGuessed) {
    const Scratch scratch;
    std::string text = "t,swa,vx,r_degs,acc_side\n";
    for (const double t : foreign::times(301))
        text +=
            fmt::format("{},{},{},{},{}\n", t, foreign::steering(t), foreign::kSpeed,
                        foreign::yawRate(t) / foreign::kDegree, foreign::lateralAcceleration(t) / foreign::kGravity);
    DiagnosisFile file;
    file.recordings = {{.log = scratch.file("b.csv", text), .name = "b"}};
    file.channels = {{.channel = "chassis.ay", .column = "acc_side", .unit = "g"}};
    const Recorded recorded = readRecordings(file);
    const Log& log = recorded.logs.at(0);
    ASSERT_TRUE(log.find("chassis.yaw_rate") && log.find("chassis.ay") && log.find("driver.steering_wheel_angle"));
    EXPECT_NEAR(log.find("chassis.yaw_rate")->values[50], foreign::yawRate(0.5), 1e-9);
    EXPECT_NEAR(log.find("chassis.ay")->values[50], foreign::lateralAcceleration(0.5), 1e-9);
    const auto says = [&](const char* what) {
        return std::any_of(recorded.notes.begin(), recorded.notes.end(),
                           [&](const std::string& note) { return note.find(what) != std::string::npos; });
    };
    EXPECT_TRUE(says("b: column swa has no unit that tread knows: assumed to be in rad"));
}

TEST(Recordings, ShortOrUnreadableOnesAreRefusedTogether) {
    const Scratch scratch;
    writeLog(scratch.path("a.csv"), turn());
    DiagnosisFile file;
    file.recordings = {{.log = scratch.path("a.csv"), .name = "a", .from = 2.5},
                       {.log = scratch.path("a.csv"), .name = "b"}};
    file.channels = {{.channel = "chassis.yaw_rate", .column = "giro"}};
    const auto faults = faultsOf([&] { readRecordings(file); });
    ASSERT_EQ(faults.size(), 2u);
    EXPECT_NE(faults[0].find("did you mean \"gyro\"?"), std::string::npos) << faults[0];
    file.channels.clear();
    const auto shorter = faultsOf([&] { readRecordings(file); });
    ASSERT_EQ(shorter.size(), 1u);
    EXPECT_NE(shorter[0].find("has 0.5 s within the window"), std::string::npos) << shorter[0];
}

}  // namespace
}  // namespace tread::diagnose_load_test
