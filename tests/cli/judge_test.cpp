// tread compare --envelope, --score: a simulation judged against measurements.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/logs.h"
#include "cli/program.h"

namespace tread::judge_test {
namespace {

using Json = nlohmann::json;

struct Judge : testing::Test {
    Judge() {
        writeLog(measured, cli::stepSteer());
        const auto more = [](double, double wheel) { return wheel + 0.15; };  // rad: 9 deg
        writeLog(other, cli::with(cli::stepSteer(), "driver.steering_wheel_angle", more));
        writeLog(wrong, cli::with(cli::stepSteer(), "chassis.ay", [](double t, double ay) { return t > 2 ? 0 : -ay; }));
    }
    Scratch scratch;
    std::string measured = scratch.path("measured.csv");
    std::string other = scratch.path("other.csv");
    std::string wrong = scratch.path("wrong.csv");
};

TEST_F(Judge, TheSameCurvesAreAlikeAndInside) {
    const Result score = runProgram({"compare", measured, measured, "--score", "iso18571"});
    EXPECT_EQ(score.status, 0);
    EXPECT_EQ(firstLine(score.out),
              "Good agreement: lowest ISO 18571 score 1.000 (chassis.yaw_rate, excellent), threshold 0.8");
    const Result envelope = runProgram({"compare", measured, measured, "--envelope", "iso19364"});
    EXPECT_EQ(envelope.status, 0);
    EXPECT_EQ(firstLine(envelope.out).find("Inside: "), 0u) << envelope.out;
}

TEST_F(Judge, AMeasurementOutsideOrAPoorScoreIsStatusOne) {
    const Result envelope =
        runProgram({"compare", measured, measured, "--repeat", other, "--envelope", "iso19364", "--json"});
    EXPECT_EQ(envelope.status, 1);
    const Json json = Json::parse(envelope.out);
    EXPECT_EQ(json["envelope"]["inside"], false);
    EXPECT_EQ(json["envelope"]["plots"][1]["measurement"], other);
    EXPECT_EQ(json["envelope"]["plots"][1]["inside"], false);

    const Result both = runProgram({"compare", measured, wrong, "--score", "iso18571", "--envelope", "iso19364"});
    EXPECT_EQ(both.status, 1);
    EXPECT_NE(both.out.find("Poor agreement: lowest ISO 18571 score"), std::string::npos);
    EXPECT_NE(both.out.find("chassis.ay"), std::string::npos);
}

TEST_F(Judge, AFileSetsTheLimits) {
    const std::string mild = scratch.file("mild.yaml", "least: 0\nscored: [chassis.ay]\n");
    EXPECT_EQ(runProgram({"compare", measured, wrong, "--score", mild}).status, 0);
    const std::string wide = scratch.file("wide.yaml",
                                          "plots:\n"
                                          "  - channel: driver.steering_wheel_angle\n"
                                          "    tolerance: {x_offset: 0.1, y_offset: 0.2}\n");
    EXPECT_EQ(runProgram({"compare", measured, measured, "--repeat", other, "--envelope", wide}).status, 0);
    EXPECT_EQ(runProgram({"check", mild, wide}).out,
              "2 files are fine\n" + mild + ": score, fine\n" + wide + ": envelope, fine\n");
}

TEST_F(Judge, WhatCannotBeJudgedIsStatusTwo) {
    Log bare = cli::stepSteer();
    bare.channels.resize(3);
    const std::string little = scratch.path("little.csv");
    writeLog(little, bare);
    const Result nothing = runProgram({"compare", little, little, "--score", "iso18571"});
    EXPECT_EQ(nothing.status, 2);
    EXPECT_EQ(firstLine(nothing.out), "Not scored: the logs share none of the channels");

    const Result name = runProgram({"compare", measured, measured, "--score", "iso1857"});
    EXPECT_EQ(name.status, 2);
    EXPECT_EQ(name.err, "tread compare: found \"iso1857\" after --score, expected iso18571 or the name of a file\n");
    const Result report =
        runProgram({"compare", measured, measured, "--score", "iso18571", "--report", scratch.path("x.html")});
    EXPECT_EQ(report.status, 2);
    EXPECT_NE(report.err.find("--report belongs to the plain comparison"), std::string::npos);
}

}  // namespace
}  // namespace tread::judge_test
