// Choice of windows in long recordings.
#include <gtest/gtest.h>

#include <cmath>

#include "recording/choose_windows.h"

namespace tread::diagnose_windows_test {
namespace {

using recording::chooseWindows;
using recording::DiagnosisFile;
using recording::Recorded;

// Half an hour at 20 Hz: straight on, with slaloms of 30 s that begin at these times.
Recorded halfAnHour(const std::vector<double>& slaloms) {
    Log log{{{"time", "s", {}}, {"chassis.vx", "m/s", {}}, {"chassis.yaw_rate", "rad/s", {}}}};
    for (int i = 0; i < 1800 * 20; ++i) {
        const double t = i / 20.0;
        double rate = 0;
        for (const double from : slaloms)
            if (t >= from && t < from + 30) rate = 0.3 * std::sin(2 * (t - from));
        const double row[] = {t, 20, rate};
        for (std::size_t c = 0; c < 3; ++c) log.channels[c].values.push_back(row[c]);
    }
    return {.logs = {log}, .references = {Log{}}};
}

DiagnosisFile fileOf(const char* name) {
    DiagnosisFile file;
    file.recordings = {{.log = name, .name = name}};
    return file;
}

TEST(ChosenWindows, AreThoseWithTheLargestAccelerationsAndDoNotOverlap) {
    Recorded recorded = halfAnHour({200, 900, 1500});
    DiagnosisFile file = fileOf("long");
    file.windows = 3;
    chooseWindows(file, recorded);
    ASSERT_EQ(recorded.logs.size(), 3u);
    ASSERT_EQ(file.recordings.size(), 3u);
    ASSERT_EQ(recorded.references.size(), 3u);
    for (const Log& log : recorded.logs) {
        EXPECT_EQ(log.channels[0].values.front(), 0);
        EXPECT_NEAR(log.channels[0].values.back(), 20, 0.06);
        EXPECT_LT(std::abs(20 * log.channels[2].values.front()), 0.5) << "begins nearly straight on";
        double squares = 0;
        for (const double rate : log.channels[2].values) squares += rate * rate;
        EXPECT_GT(std::sqrt(squares / static_cast<double>(log.samples())), 0.15) << "and holds a slalom";
    }
    EXPECT_NE(file.recordings[0].name, file.recordings[1].name);
    ASSERT_EQ(recorded.notes.size(), 1u);
    EXPECT_NE(recorded.notes[0].find("long: lasts 1800 s"), std::string::npos) << recorded.notes[0];
}

TEST(ChosenWindows, AreThoseOfTheCarBeforeAsWell) {
    Recorded recorded = halfAnHour({200});
    recorded.before = halfAnHour({900}).logs;
    DiagnosisFile file = fileOf("long");
    file.before = {{.log = "before", .name = "before"}};
    file.windows = 1;
    chooseWindows(file, recorded);
    ASSERT_EQ(recorded.before.size(), 1u);
    EXPECT_NEAR(recorded.before[0].channels[0].values.back(), 20, 0.06);
    EXPECT_EQ(file.before[0].name.find("before, 9"), 0u) << file.before[0].name;
}

TEST(ChosenWindows, ShortRecordingsAndAllWithoutWindowsStayWhole) {
    Recorded recorded = halfAnHour({200});
    DiagnosisFile file = fileOf("long");
    file.windows = 0;
    chooseWindows(file, recorded);
    EXPECT_EQ(recorded.logs[0].samples(), 36000u);
    file.windows = 6;
    for (Channel& channel : recorded.logs[0].channels) channel.values.resize(20 * 170);
    chooseWindows(file, recorded);
    ASSERT_EQ(recorded.logs.size(), 1u);
    EXPECT_EQ(recorded.logs[0].samples(), 3400u);
    EXPECT_TRUE(recorded.notes.empty());
}

}  // namespace
}  // namespace tread::diagnose_windows_test
