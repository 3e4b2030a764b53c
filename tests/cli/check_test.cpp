#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>
#include <regex>

#include "cli/logs.h"
#include "cli/program.h"
#include "places/places.h"

namespace tread::check_test {
namespace {

using Json = nlohmann::json;

const std::string kVehicles = sourceFile("vehicles/");
const std::string kScenarios = sourceFile("scenarios/");

// The text with its first `from` replaced.
std::string with(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

// Line and column of a text, "14:12".
std::string place(const std::string& text, const std::string& what) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    const std::size_t line = text.rfind('\n', at) + 1;
    return std::to_string(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n') + 1) + ":" +
           std::to_string(at - line + 1);
}

// A folder with a car and its tyre, sound ones.
struct Check : testing::Test {
    Check() {
        std::filesystem::create_directory(scratch.path("tyres"));
        std::filesystem::copy(kVehicles + "tyres/car_205_60R15.yaml", tyre);
        std::filesystem::copy(kVehicles + "compact.yaml", car);
        writeLog(log, cli::stepSteer());
    }
    Scratch scratch;
    std::string car = scratch.path("car.yaml");
    std::string tyre = scratch.path("tyres/car_205_60R15.yaml");
    std::string log = scratch.path("log.csv");
};

// The least that is a .tir file.
const std::string kTir =
    "[MODEL]\nFITTYP = 52\n[COEFFICIENTS]\n"
    "FNOMIN = 4000\nUNLOADED_RADIUS = 0.313\nVERTICAL_STIFFNESS = 209000\nVERTICAL_DAMPING = 50\n"
    "PCX1 = 1.685\nPDX1 = 1.21\nPKX1 = 21.5\nPCY1 = 1.19\nPDY1 = 0.99\nPKY1 = -14.95\nPKY2 = 2.13\n";

TEST_F(Check, TellsEveryKindOfFileByItsContent) {
    const std::string tolerances = scratch.file("t.yaml", "relative: 0.01\n");
    const std::string renamed = scratch.path("car.txt");
    std::filesystem::copy(car, renamed);
    const Result result = runProgram({"check", car, tyre, tolerances, log, renamed});
    EXPECT_EQ(result.status, 0) << result.out;
    EXPECT_EQ(result.out, "5 files are fine\n" + car + ": vehicle, fine\n" + tyre + ": tyre, fine\n" + tolerances +
                              ": tolerances, fine\n" + log + ": log, fine\n" + renamed + ": vehicle, fine\n");
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(firstLine(runProgram({"check", car}).out), "1 file is fine");
}

TEST_F(Check, AHeightFieldIsNoLog) {
    const std::string field = scratch.file("field.csv", "# a ramp\nx\\y [m],0,1\n0,0,0\n1,0.1,0.1\n");
    const std::string torn = scratch.file("torn.csv", "x\\y [m],0,1\n0,0,0\n1,0.1\n");
    const Result result = runProgram({"check", field, torn});
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.out.find(field + ": height field, fine\n"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find(torn + ":3:1: found 2 cells, expected x and 2 heights"), std::string::npos) << result.out;
}

TEST_F(Check, ShippedFilesAreFine) {
    std::vector<std::string> arguments{"check"};
    for (const std::string& folder : {kVehicles, kScenarios}) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
            if (entry.path().extension() == ".yaml") arguments.push_back(entry.path().string());
        }
    }
    ASSERT_GE(arguments.size(), 11u);
    const Result result = runProgram(arguments);
    EXPECT_EQ(result.status, 0) << result.out;
    EXPECT_TRUE(firstLine(result.out).ends_with(" files are fine")) << "and none has a warning\n" << result.out;
}

TEST_F(Check, ListsAllFaultsOfAllFilesWithTheirPlace) {
    std::string text = contentOf(car);
    text = with(text, "wheelbase: 2.62 m", "wheelbase: -2.62 m");
    text = with(text, "track: 1.53 m", "track: 1.53 kg");
    text = with(text, "anti_roll_bar:", "anti_rol_bar:");
    const std::string bad = scratch.file("bad.yaml", text);
    const std::string torn = scratch.file("torn.csv", "time [s],chassis.vx [km/h]\n0,1\n");
    const Result result = runProgram({"check", car, bad, torn});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(firstLine(result.out), "4 faults in 2 of 3 files");
    EXPECT_EQ(result.err, "");
    for (const std::string& expected :
         {bad + ":" + place(text, "-2.62 m") + ": wheelbase: ", bad + ":" + place(text, "1.53 kg") + ": front.track: ",
          bad + ":" + place(text, "anti_rol_bar") + ": ", torn + ":1:10: chassis.vx: ", car + ": vehicle, fine\n"}) {
        EXPECT_NE(result.out.find(expected), std::string::npos) << expected << "\n" << result.out;
    }
    EXPECT_NE(result.out.find("did you mean \"anti_roll_bar\"?"), std::string::npos);
}

TEST_F(Check, JsonHasFaultsAndKinds) {
    const std::string bad = scratch.file("bad.yaml", with(contentOf(car), "mass: 1350 kg", "mass: -1350 kg"));
    const Result result = runProgram({"check", "--json", car, bad});
    EXPECT_EQ(result.status, 2);
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["answer"], "1 fault in 1 of 2 files");
    EXPECT_EQ(json["files"][0]["kind"], "vehicle");
    EXPECT_TRUE(json["files"][0]["problems"].empty());
    const Json problem = json["files"][1]["problems"][0];
    EXPECT_EQ(problem["file"], bad);
    EXPECT_EQ(problem["path"], "mass");
    EXPECT_EQ(problem["column"], 7);
}

TEST_F(Check, FaultOfAnIncludedFileCountsOnce) {
    scratch.file("tyres/car_205_60R15.yaml", with(contentOf(tyre), "pCx1:", "pCx:"));
    const Result alone = runProgram({"check", tyre});
    const Result both = runProgram({"check", car, tyre});
    EXPECT_EQ(firstLine(alone.out), "1 fault in 1 file") << alone.out;
    EXPECT_EQ(firstLine(both.out), "1 fault in 2 of 2 files") << "pCx is unknown, pCx1 not missing\n" << both.out;
    EXPECT_NE(both.out.find("did you mean \"pCx1\"?"), std::string::npos);
}

TEST_F(Check, NotesOfATirFileGoToStandardError) {
    const std::string tir = scratch.file("tyre.tir", kTir);
    const Result result = runProgram({"check", tir});
    EXPECT_EQ(result.status, 0) << result.out;
    EXPECT_EQ(result.out, "1 file is fine\n" + tir + ": tyre, fine\n");
    EXPECT_EQ(result.err.find(tir + ": note: "), 0u) << result.err;

    const std::string with_tir =
        scratch.file("with_tir.yaml", with(contentOf(car), "tyre: tyres/car_205_60R15.yaml", "tyre: tyre.tir"));
    const Result included = runProgram({"check", with_tir});
    EXPECT_EQ(included.status, 0) << included.out;
    EXPECT_EQ(included.err.find(with_tir + ": note: front.tyre: "), 0u) << included.err;
    EXPECT_EQ(included.err.find("rear.tyre"), std::string::npos) << "the rear tyre is YAML";

    const std::string broken = scratch.file("broken.tir", with(kTir, "FITTYP = 52", "FITTYP = 61"));
    const Result faulty = runProgram({"check", broken});
    EXPECT_EQ(faulty.status, 2);
    EXPECT_EQ(faulty.out.find("1 fault in 1 file\n" + broken + ":2:"), 0u) << faulty.out;
}

TEST_F(Check, FileThatIsNothingKnownIsAFault) {
    const auto fault = [&](const std::string& file) {
        const Result result = runProgram({"check", file});
        EXPECT_EQ(result.status, 2) << file;
        EXPECT_EQ(firstLine(result.out), "1 fault in 1 file") << file;
        return result.out.substr(result.out.find('\n') + 1);
    };
    EXPECT_EQ(fault(scratch.path("none.yaml")),
              scratch.path("none.yaml") + ": found no file of this name; correct the path\n");
    EXPECT_EQ(fault(scratch.path("none.csv")),
              scratch.path("none.csv") + ": found no file of this name; correct the path\n");
    EXPECT_EQ(fault(scratch.path("tyres")),
              scratch.path("tyres") + ": found a directory, expected a file; name a file in it\n");
    const std::string empty = scratch.file("empty.yaml", "");
    EXPECT_EQ(fault(empty).find(empty + ": found nothing in the file"), 0u);
    const std::string open = scratch.file("open.yaml", "mass: [1\n");
    EXPECT_EQ(fault(open).find(open + ":"), 0u);
    const std::string ambiguous = scratch.file("name.yaml", "name: x\n");
    EXPECT_NE(fault(ambiguous).find("found \"name\", expected the keys of a vehicle, tyre"), std::string::npos);
    const std::string list = scratch.file("list.yaml", "- 1\n");
    EXPECT_NE(fault(list).find("found no \"key: value\" lines, expected the keys of a vehicle"), std::string::npos);
}

TEST_F(Check, ScenarioWithNamesThatNobodyKnowsIsAFault) {
    const std::string sound_text = contentOf(kScenarios + "step_steer_80.yaml");
    const std::string sound = scratch.file("sound.yaml", sound_text);
    EXPECT_EQ(runProgram({"check", sound}).out, "1 file is fine\n" + sound + ": scenario, fine\n");
    const std::string text = with(sound_text, "manoeuvre: step_steer", "manoeuvre: stp_steer");
    const std::string bad = scratch.file("bad.yaml", text);
    const Result result = runProgram({"check", bad});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out.find("1 fault in 1 file\n" + bad + ":" + place(text, "stp_steer") + ": manoeuvre: "), 0u)
        << result.out;
    EXPECT_NE(result.out.find("did you mean \"step_steer\"?"), std::string::npos) << result.out;
}

TEST_F(Check, MistypedKeysStillTellTheKind) {
    const std::string file = scratch.file("t.yaml", "relativ: 0.1\nchanels: []\n");
    const Result result = runProgram({"check", file});
    EXPECT_EQ(firstLine(result.out), "2 faults in 1 file");
    EXPECT_NE(result.out.find("did you mean \"relative\"?"), std::string::npos) << result.out;
}

TEST(HostileFile, WithoutEndIsRefused) {
    const Scratch scratch;
    ASSERT_EQ(mkfifo(scratch.path("pipe.csv").c_str(), 0600), 0);
    for (const std::string& file : {std::string("/dev/zero"), scratch.path("pipe.csv")}) {
        const Result log = runProgram({"metrics", file});
        EXPECT_EQ(log.status, 2);
        EXPECT_EQ(log.err, "tread: cannot read '" + file +
                               "': is a pipe, a socket or a device, expected a regular file; write its content into a "
                               "file first\n");
        EXPECT_EQ(runProgram({"check", file}).status, 2);
        EXPECT_EQ(runProgram({"run", file, file}).status, 2);
        EXPECT_EQ(runProgram({"import", file}).status, 2);
    }
}

TEST(HostileFile, ThatIsTooLargeIsRefusedUnlessTheLimitIsRaised) {
    const Scratch scratch;
    const std::string log = scratch.file("log.csv", "time [s],chassis.vx [m/s]\n0,1\n1,1\n");
    setenv("TREAD_LARGEST_FILE", "20", 1);
    const Result read = runProgram({"compare", log, log});
    unsetenv("TREAD_LARGEST_FILE");
    EXPECT_EQ(read.status, 2);
    EXPECT_NE(read.err.find("it holds more than 20 bytes; set the variable TREAD_LARGEST_FILE"), std::string::npos)
        << read.err;
    EXPECT_EQ(runProgram({"compare", log, log}).status, 0);
}

TEST(HostileFile, ManyFaultsOfAKindAreCounted) {
    const Scratch scratch;
    std::string car = contentOf(sourceFile("vehicles/compact.yaml"));
    for (int i = 0; i < 100; ++i)
        car += "unknown_" + std::string(1, static_cast<char>('a' + i % 26)) + std::to_string(i) + ": 1\n";
    const Result result = runProgram({"check", scratch.file("car.yaml", car)});
    EXPECT_EQ(result.status, 2);
    EXPECT_LT(std::count(result.out.begin(), result.out.end(), '\n'), 30);
    EXPECT_NE(result.out.find("... and 80 more of this kind"), std::string::npos) << result.out;
}

// ---- Implausible numbers -------------------------------------------------------------------------------------------

struct Slip {
    std::string from, to;
    std::string written;  // in `to`
    std::string path;
    std::string meant;
};

// The warning of a file that is fine otherwise.
void expectWarned(Scratch& scratch, const std::string& sound, const Slip& slip) {
    SCOPED_TRACE(slip.to);
    const std::string text = with(sound, slip.from, slip.to);
    const std::string file = scratch.file("slip.yaml", text);
    const Result result = runProgram({"check", file});
    EXPECT_EQ(result.status, 0) << result.out;
    EXPECT_EQ(firstLine(result.out), "1 file is fine, with 1 warning") << result.out;
    const std::size_t at = text.find(slip.to) + slip.to.find(slip.written);
    EXPECT_NE(result.out.find("warning: " + file + ":" + place(text, text.substr(at, text.find('\n', at) - at)) + ": " +
                              slip.path + ": found "),
              std::string::npos)
        << result.out;
    EXPECT_NE(result.out.find("did you mean " + slip.meant + "?\n"), std::string::npos) << result.out;
    EXPECT_EQ(runProgram({"check", "--strict", file}).status, 2);
}

TEST_F(Check, ImplausibleNumbersOfACarAreWarnedOfWithTheLikelySlip) {
    const std::string sound = contentOf(car);
    for (const Slip& slip : std::vector<Slip>{
             {"centre_of_gravity_height: 0.54 m", "height: 550", "550", "centre_of_gravity_height", "\"550 mm\""},
             {"camber: -0.5 deg", "camber: -0.5", "-0.5", "front.suspension.camber", "\"-0.5 deg\""},
             {"spring: 22 kN/m", "spring: 25", "25", "front.suspension.spring", "\"25 N/mm\""},
             {"spring: 22 kN/m", "spring: 250", "250", "front.suspension.spring", "\"250 N/mm\""},
             {"bump: 1250 N s/m", "bump: 1.25", "1.25", "front.suspension.damper.bump", "\"1.25 N s/mm\""},
             {"ratio: 16.5", "ratio: 0.0595", "0.0595", "steering.ratio", "the inverse, 16.8"},
             {"mass: 1350 kg", "mass: 1250 lb", "1250 lb", "mass", "\"1250 kg\""},
             {"idle_speed: 800 rpm", "idle_speed: 800", "800", "driveline.engine.idle_speed", "\"800 rpm\""},
             {"[0.8, 2.21]", "[45, 2.21]", "45", "aero.side_force_area.2.x", "\"45 deg\""},
         })
        expectWarned(scratch, sound, slip);
}

TEST_F(Check, WarningsAreToldBesideFaults) {
    const std::string text = with(contentOf(car), "mass: 1350 kg", "mass: 1.35");
    const std::string file = scratch.file("tonnes.yaml", text);
    const std::string at = file + ":" + place(text, "1.35") + ": mass: ";
    const Result result = runProgram({"check", file});
    EXPECT_EQ(firstLine(result.out), "1 fault in 1 file") << result.out;
    EXPECT_NE(result.out.find("\n" + at + "the unsprung masses"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("\nwarning: " + at + "found 1.35 kg, plausible values are "), std::string::npos)
        << result.out;
    EXPECT_NE(result.out.find("did you mean \"1.35 t\"?\n"), std::string::npos) << result.out;
}

TEST_F(Check, ImplausibleNumbersOfAScenarioAreWarnedOf) {
    const std::string sound = contentOf(kScenarios + "straight_braking_100.yaml") + "road: {friction: 0.9}\n";
    for (const Slip& slip : std::vector<Slip>{
             {"friction: 0.9", "friction: 80", "80", "road.friction", "\"80 %\""},
             {"speed: 100 km/h", "speed: 80", "80", "start.speed", "\"80 km/h\""},
         })
        expectWarned(scratch, sound, slip);
}

TEST_F(Check, AWarningOfATyreFileIsPrintedOnceAndAtItsPlaceThere) {
    const std::string text = with(contentOf(tyre), "Re: 0.3055", "Re: 305.5");
    scratch.file("tyres/car_205_60R15.yaml", text);
    const Result result = runProgram({"check", car, tyre});
    EXPECT_EQ(firstLine(result.out), "2 files are fine, with 1 warning") << result.out;
    EXPECT_NE(result.out.find("warning: " + tyre + ":" + place(text, "305.5") + ": front.tyre.parameters.Re: found"),
              std::string::npos)
        << result.out;
    const Json json = Json::parse(runProgram({"check", "--json", car}).out);
    EXPECT_EQ(json["warnings"], 1);
    EXPECT_EQ(json["files"][0]["warnings"][0]["path"], "front.tyre.parameters.Re");
    EXPECT_EQ(firstLine(runProgram({"check", "--strict", car}).out), "1 fault in 1 file");
}

// ---- Files of another kind -----------------------------------------------------------------------------------------

TEST_F(Check, AFileOfAnotherKindIsOneSentenceWhateverTheCommand) {
    const std::string scenario = kScenarios + "step_steer_80.yaml", folder = scratch.path("tyres");
    const std::string tolerances = scratch.file("tolerances.yaml", "relative: 0.01\n");
    const std::string map = scratch.file("map.yaml", "time: {from: t}\nmap: []\n");
    const std::string field = scratch.file("field.csv", "x\\y [m],0,1\n0,0,0\n1,0.1,0.1\n");
    const std::string record = scratch.file("run.yaml", "tread_version: 1\nvehicle: {mass: 1}\nscenario: {}\n");
    const std::string results = scratch.file("metrics.json", R"({"tread_version": "1", "metrics": []})");
    const std::string diagnosis = kScenarios + "diagnose/liu.yaml", out = scratch.path("out");
    const std::vector<std::pair<std::vector<std::string>, std::string>> calls{
        {{"run", scenario, scenario}, "found a scenario file, expected a vehicle file"},
        {{"run", log, scenario}, "found a log, expected a vehicle file"},
        {{"run", record, scenario}, "found the record of a run, expected a vehicle file"},
        {{"run", car, results}, "found the results of a run, expected a scenario file"},
        {{"metrics", results}, "found the results of a run, expected a log"},
        {{"run", tyre, scenario}, "found a tyre file, expected a vehicle file"},
        {{"run", folder, scenario}, "found a folder, expected a vehicle file"},
        {{"run", diagnosis, scenario}, "found a diagnosis file, expected a vehicle file"},
        {{"run", car, tyre}, "found a tyre file, expected a scenario file"},
        {{"run", car, map}, "found a mapping for foreign logs, expected a scenario file"},
        {{"run", car, scenario, "--log", tyre}, "found a tyre file, expected a log"},
        {{"run", car, scenario, "--accept", tolerances}, "found a tolerances file, expected a file of conditions"},
        {{"run", car, "--all", scenario}, "found a scenario file, expected a folder"},
        {{"compare", car, log}, "found a vehicle file, expected a log or a folder"},
        {{"compare", log, field}, "found a height field, expected a log or a folder"},
        {{"compare", log, log, "--tolerances", scenario}, "found a scenario file, expected a tolerances file"},
        {{"compare", log, log, "--envelope", tolerances}, "found a tolerances file, expected an envelope file"},
        {{"compare", log, log, "--score", car}, "found a vehicle file, expected a score file"},
        {{"metrics", car}, "found a vehicle file, expected a log"},
        {{"metrics", folder}, "found a folder, expected a log"},
        {{"metrics", log, "--scenario", car}, "found a vehicle file, expected a scenario file"},
        {{"import", car}, "found a vehicle file, expected a table of values, a log"},
        {{"import", log, "--map", tolerances}, "found a tolerances file, expected a mapping for foreign logs"},
        {{"tyre", car}, "found a vehicle file, expected a tyre file or a tyre property file"},
        {{"tyre", log}, "found a log, expected a tyre file or a tyre property file"},
        {{"tyre", tyre, "--table", scenario}, "found a scenario file, expected a table of values or a log"},
        {{"diagnose", map}, "found a mapping for foreign logs, expected a diagnosis file"},
        {{"diagnose", log}, "found a log, expected a diagnosis file"},
        {{"diagnose", folder}, "found a folder, expected a diagnosis file"},
        {{"diagnose", diagnosis, "--vehicle", tyre}, "found a tyre file, expected a vehicle file"},
        {{"diagnose", "--init", car}, "found a vehicle file, expected a folder"},
        {{"identify", scenario}, "found a scenario file, expected a diagnosis file"},
        {{"blind", "make", "--cases", "1", "--seed", "1", "-o", out, "--vehicle", tyre},
         "found a tyre file, expected a vehicle file"},
        {{"describe", log}, "found a log, expected a vehicle file"},
        {{"describe", folder + "/"}, "found a folder, expected a vehicle file"},
    };
    for (auto [words, sentence] : calls) {
        if (words[0] == "run" || words[0] == "import") words.insert(words.end(), {"-o", out});
        const Result result = runProgram(words);
        SCOPED_TRACE(words[0] + " " + sentence);
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.out, "");
        EXPECT_NE(result.err.find(": " + sentence), std::string::npos) << result.err;
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
        EXPECT_FALSE(std::filesystem::exists(out)) << "nothing is begun";
    }
}

TEST_F(Check, WhatARunHasWrittenIsOneFault) {
    const std::string record = scratch.file("run.yaml", "tread_version: 1\nvehicle: {mass: 1}\nscenario: {}\n");
    const Result result = runProgram({"check", record});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out.find("1 fault in 1 file\n" + record + ": found the record of a run, which `tread run` has "),
              0u)
        << result.out;
}

TEST_F(Check, AnIncludedFileOfAnotherKindIsOneFault) {
    const std::string text = with(contentOf(car), "tyres/car_205_60R15.yaml", kScenarios + "step_steer_80.yaml");
    const std::string bad = scratch.file("bad.yaml", text);
    const Result result = runProgram({"check", bad});
    EXPECT_EQ(firstLine(result.out), "1 fault in 1 file") << result.out;
    EXPECT_NE(result.out.find(bad + ":" + place(text, kScenarios) + ": front.tyre: found "), std::string::npos);
    EXPECT_NE(result.out.find("a file of another kind"), std::string::npos) << result.out;
}

// Each number of a file is exchanged by what no car has, each line left out.
TEST_F(Check, AndRunRefuseTheSameFiles) {
    const std::string scenario = scratch.file(
        "short.yaml", "title: short\nstart: {speed: 15 km/h}\nphases:\n  - {name: on, until: {duration: 0.01 s}}\n");
    const auto refusals = [&](const std::vector<std::string>& run) {
        const Result checked = runProgram({"check", run[1] == car ? run[2] : run[1]}), driven = runProgram(run);
        EXPECT_TRUE(checked.status == 0 || checked.status == 2) << checked.out;
        EXPECT_TRUE(driven.status >= 0 && driven.status <= 3) << driven.err;
        EXPECT_EQ(checked.status == 2, driven.status == 2) << checked.out << driven.err;
    };
    const auto expectSame = [&](const std::string& file, bool is_car) {
        SCOPED_TRACE(file);
        if (is_car) refusals({"run", file, scenario, "-o", scratch.path("out")});
        else refusals({"run", car, file, "-o", scratch.path("out"), "--set", "scenario.time_limit=0.01"});
    };
    for (const std::string& folder : {kVehicles, kScenarios}) {
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            if (entry.path().extension() == ".yaml") expectSame(entry.path().string(), folder == kVehicles);
    }
    const std::regex number(R"((^|[^\w.])-?[0-9]+(\.[0-9]+)?)");
    std::mt19937 random(3);
    for (const bool is_car : {true, false}) {
        const std::string text = contentOf(is_car ? car : kScenarios + "double_lane_change.yaml");
        for (std::size_t begin = 0; begin < text.size();) {
            const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
            const std::string line = text.substr(begin, end - begin);
            const std::string values[] = {"", "$010e-308", "$01-1", "$010", "$011e308", "$01x"};
            const std::string& value = values[random() % std::size(values)];
            const std::string other =
                value.empty() ? "" : std::regex_replace(line, number, value, std::regex_constants::format_first_only);
            if (random() % 3 == 0)
                expectSame(scratch.file("other.yaml", text.substr(0, begin) + other + text.substr(end)), is_car);
            begin = end;
        }
    }
}

// ---- All faults at once, and no other ------------------------------------------------------------------------------

TEST_F(Check, FaultsOfASecondStageAreToldWithTheOthers) {
    std::string text = with(contentOf(kScenarios + "step_steer_80.yaml"), "manoeuvre: step_steer", "manoeuvre: stp");
    text = with(text, "speed: 80 km/h", "speed: 80 km") + "accept: {sidesway: \"< 4 m\"}\n" +
           "wind: {gust: {shape: ramp, speed: 3, time: 1}}\n";
    const std::string bad = scratch.file("bad.yaml", text);
    const Result result = runProgram({"check", bad});
    EXPECT_EQ(firstLine(result.out), "3 faults in 1 file") << result.out;
    for (const std::string expected : {": start.speed: ", ": manoeuvre: ", ": wind.gust.duration: "})
        EXPECT_NE(result.out.find(expected), std::string::npos) << expected << result.out;

    std::string of_car = with(contentOf(car), "front_axle_distance: 1.03 m", "front_axle_distance: 3 m");
    of_car = with(of_car, "drag_area: 0.66 m2", "drag_area: 0.66 m");
    of_car = with(of_car, "tyres/car_205_60R15.yaml", "tyre.yaml");
    scratch.file("tyre.yaml", with(contentOf(tyre), "Fzo: 4000", "Fzo: -4000"));
    const Result car_result = runProgram({"check", scratch.file("bad_car.yaml", of_car)});
    EXPECT_EQ(firstLine(car_result.out), "3 faults in 1 file") << car_result.out;
}

TEST_F(Check, AMisspeltRequiredFieldIsOneFault) {
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{{"wheelbase:", "wheelbas:"},
                                                                                   {"\nfront:", "\nfrnt:"},
                                                                                   {"brakes:", "brake:"},
                                                                                   {"    clutch:", "    cluch:"}}) {
        const Result result = runProgram({"check", scratch.file("bad.yaml", with(contentOf(car), from, to))});
        EXPECT_EQ(firstLine(result.out), "1 fault in 1 file") << result.out;
        EXPECT_NE(result.out.find("did you mean"), std::string::npos) << result.out;
    }
}

TEST_F(Check, AMissingPartIsOneFault) {
    std::string text = contentOf(car);
    text = text.substr(0, text.find("\nrear:")) + text.substr(text.find("\nsteering:"));
    const Result result = runProgram({"check", scratch.file("bad.yaml", text)});
    EXPECT_EQ(firstLine(result.out), "1 fault in 1 file") << result.out;
    EXPECT_NE(result.out.find(": rear: found nothing, expected a map with at least \"track\", \"unsprung_mass\""),
              std::string::npos)
        << result.out;
}

}  // namespace
}  // namespace tread::check_test
