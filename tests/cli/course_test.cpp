// Courses from a file, through the program: laps, speed, metrics, log, page, faults.

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/tread_run.h"
#include "log/csv.h"

namespace tread::course_test {
namespace {

using Json = nlohmann::json;

struct Course : TreadRun {
    Course() { car(); }
    double valueOf(const std::string& name) const {
        const Json result = Json::parse(contentOf(out("metrics.json")));
        for (const Json& one : result["metrics"]) {
            if (one["name"] == name) return one["value"].is_null() ? std::nan("") : one["value"].get<double>();
        }
        ADD_FAILURE() << "no metric " << name;
        return 0;
    }
    // A circle of 40 m radius to the left, with a column of the speed.
    std::string circle(double speed) const {
        std::string text = "x [m],y [m],width [m],speed [m/s]\n";
        for (int i = 0; i < 72; ++i) {
            const double a = i * 2 * 3.14159265358979 / 72;
            text += std::to_string(40 * std::sin(a)) + "," + std::to_string(40 - 40 * std::cos(a)) + ",7," +
                    std::to_string(speed) + "\n";
        }
        return scratch.file("circle.csv", text);
    }
    static std::string drive(const std::string& line) {
        return "title: Circle\nmanoeuvre: course\nstep: 0.002\nstart: {speed: 10}\ncourse:\n  line: " + line +
               "\nphases:\n  - steering: {follow_path: {preview_time: 0.5, lead: 1, understeer: 0.003, delay: 0}}\n"
               "    throttle: {follow_course: {}}\n    until: {laps: 2, duration: 100 s}\n";
    }
};

TEST_F(Course, LapTimeOfACircleIsItsLengthOverTheSpeed) {
    circle(10);
    scenario(drive("{file: circle.csv, closed: true}"));
    const Result result = run();
    ASSERT_EQ(result.status, 0) << result.err;
    // The second lap, without the way into the circle.
    EXPECT_NEAR(valueOf("lap_time"), 2 * 3.14159265358979 * 40 / 10, 0.1);
    EXPECT_EQ(valueOf("laps"), 2);
    EXPECT_LT(valueOf("largest_cross_track_error"), 0.5);
    EXPECT_LT(valueOf("rms_speed_error"), 0.3);
    const Log log = readLog(out("log.csv"));
    EXPECT_NEAR(log.find("course.distance")->values.back(), 2 * 2 * 3.14159265358979 * 40, 0.3);
    EXPECT_NEAR(log.find("course.speed")->values[100], 10, 1e-6);
    const std::string page = contentOf(out("report.html"));
    EXPECT_NE(page.find("path of the course"), std::string::npos);
    EXPECT_NE(page.find("Course from above"), std::string::npos);
    // What was resolved has the points, so that it repeats the run without the file.
    std::filesystem::remove(scratch.path("circle.csv"));
    EXPECT_NE(contentOf(out("run.yaml")).find("points:"), std::string::npos);
}

TEST_F(Course, SpeedFollowsFromTheLateralLimit) {
    circle(0);
    scenario(drive("{file: circle.csv, closed: true, limits: {lateral: 3 m/s2}}"));
    ASSERT_EQ(run().status, 0);
    const Log log = readLog(out("log.csv"));
    EXPECT_NEAR(log.find("course.speed")->values.back(), std::sqrt(3 * 40.0), 0.05);
    EXPECT_NEAR(log.find("chassis.vx")->values.back(), std::sqrt(3 * 40.0), 0.1);
    EXPECT_NEAR(log.find("chassis.ay")->values.back(), 3, 0.2);
}

TEST_F(Course, FaultsOfTheFileAndOfItsUseAreRefusedAtTheirPlace) {
    const std::string file = scratch.file("bad.csv", "x,y\n0,0\n10,nan\n");
    const std::string yaml = scenario(drive("{file: bad.csv}"));
    Result result = run();
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err.find(file + ":3:4: "), 0u) << result.err;
    EXPECT_NE(result.err.find("found \"nan\" in column y, expected a number"), std::string::npos) << result.err;
    EXPECT_NE(runProgram({"check", yaml}).out.find(file + ":3:4: "), std::string::npos);

    scenario(drive("{file: none.csv}"));
    result = run();
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err.find(yaml + ":6:16: course.line.file: "), 0u) << result.err;

    circle(0);
    scenario(drive("{file: circle.csv, closed: true}"));
    result = run();
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("found a driver who follows the speed of the course, which has none"), std::string::npos)
        << result.err;
}

TEST_F(Course, TheShippedLapStaysOnItsTrack) {
    const Result result = runProgram({"run", scratch.path("car.yaml"), kSource + "/scenarios/lap.yaml", "-o", out(),
                                      "--set", "scenario.step=0.002", "--set", "scenario.phases.0.until.laps=1"});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(valueOf("clean"), 1);
    EXPECT_LT(valueOf("largest_cross_track_error"), 0.5);
    EXPECT_NEAR(valueOf("lap_time"), 65, 5);
}

TEST_F(Course, TheSlalomCountsConesAndSides) {
    const auto drive = [&](const std::string& path) {
        const Result result =
            runProgram({"run", scratch.path("car.yaml"), kSource + "/scenarios/slalom.yaml", "-o", out(), "--set",
                        "scenario.series.highest.highest=32 km/h", "--set", "scenario.step=0.002", "--set", path});
        EXPECT_EQ(result.status, 0) << result.err;
        return Json::parse(contentOf(out("metrics.json")))["runs"][0]["passed"].get<bool>();
    };
    EXPECT_TRUE(drive("scenario.title=as shipped"));
    EXPECT_FALSE(drive("scenario.course.cones.3.y=-1.2")) << "in the way";
    EXPECT_FALSE(drive("scenario.phases.0.steering={constant: {value: 0}}")) << "straight over all of them";
}

}  // namespace
}  // namespace tread::course_test
