// `tread run` as a user meets it: what it says of bad files and options, of a full disk and Ctrl-C, of a car that
// cannot do the manoeuvre; what it leaves behind; and that it answers the same every time.

#include <gtest/gtest.h>
#include <sched.h>
#include <signal.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "cli/program.h"
#include "log/csv.h"
#include "metrics/metrics.h"

namespace tread {
namespace {

const std::string kSource = TREAD_SOURCE_DIR;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("the text has no " + from);
    return text.replace(at, from.size(), to);
}

// "line:column" of the first place where the words stand.
std::string placeOf(const std::string& text, const std::string& words) {
    const std::size_t at = text.find(words);
    if (at == std::string::npos) throw std::logic_error("the text has no " + words);
    const std::string before = text.substr(0, at);
    const std::size_t line_start = before.rfind('\n') == std::string::npos ? 0 : before.rfind('\n') + 1;
    return std::to_string(std::count(before.begin(), before.end(), '\n') + 1) + ":" +
           std::to_string(at - line_start + 1);
}

const std::string kScenario = R"(title: A short way
start: {speed: 80 km/h}
phases:
  - name: straight
    until: {duration: 0.2 s}
)";

const std::string kTyre = "tyre: " + kSource + "/vehicles/tyres/car_205_60R15.yaml";

// Messages that several tests expect.
const std::string kManoeuvres =
    "drop_and_settle, parked, straight_braking, coast_down, step_steer, sine_steer or steady_circle, or no such line "
    "for "
    "a run without metrics";
const std::string kHeavy =
    "--set: mass: found \"heavy\", which is not a number, expected kg; write a decimal number, alone or followed by a "
    "unit";
const std::string kLongStep =
    "--set: scenario.step: found \"1\", expected a number in s from 0.00001 to 0.05; correct the value";

void expectStart(const std::string& text, const std::string& start) {
    EXPECT_EQ(text.substr(0, start.size()), start);
}

class TreadRun : public testing::Test {
protected:
    Scratch scratch;

    // The compact car, which finds its tyre from any folder, with a text replaced.
    static std::string carText(const std::string& from = "", const std::string& to = "") {
        std::string text = contentOf(kSource + "/vehicles/compact.yaml");
        for (int axle = 0; axle < 2; ++axle) {
            text = replaced(text, "tyre: tyres/", "tyre: " + kSource + "/vehicles/tyres/");
        }
        return replaced(text, from, to);
    }
    std::string car(const std::string& text = carText()) const { return scratch.file("car.yaml", text); }
    std::string scenario(const std::string& text = kScenario) const { return scratch.file("scenario.yaml", text); }
    std::string out(const std::string& name = "") const {
        return scratch.path("out") + (name.empty() ? "" : "/" + name);
    }

    std::vector<std::string> words(const std::vector<std::string>& options = {}) const {
        std::vector<std::string> all{"run", scratch.path("car.yaml"), scratch.path("scenario.yaml"), "-o", out()};
        all.insert(all.end(), options.begin(), options.end());
        return all;
    }
    Result run(const std::vector<std::string>& options = {}) const { return runProgram(words(options)); }

    std::vector<std::string> results() const {
        std::vector<std::string> names;
        if (!std::filesystem::exists(out())) return names;
        for (const auto& entry : std::filesystem::directory_iterator(out())) {
            names.push_back(entry.path().filename().string());
        }
        std::sort(names.begin(), names.end());
        return names;
    }

    // Bad input: one message, no answer, no folder.
    void expectRefused(const Result& result, const std::string& message) const {
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(result.err, message + "\n");
        EXPECT_FALSE(std::filesystem::exists(out()));
    }
    void expectCarRefused(const std::string& text, const std::string& at, const std::string& message) const {
        car(text);
        scenario();
        expectRefused(run(), scratch.path("car.yaml") + ":" + placeOf(text, at) + ": " + message);
    }
    void expectScenarioRefused(const std::string& text, const std::string& at, const std::string& message) const {
        car();
        scenario(text);
        expectRefused(run(), scratch.path("scenario.yaml") + ":" + placeOf(text, at) + ": " + message);
    }
};

using Names = std::vector<std::string>;
const Names kAllResults{"log.csv", "metrics.json", "report.html", "run.yaml"};
const Names kFailedResults{"log.incomplete.csv", "run.yaml"};

// ---- Faults of the vehicle file ------------------------------------------------------------------------------------

TEST_F(TreadRun, MissingNumberOfTheCarIsNamedWithItsPlaceUnitAndMeaning) {
    const std::string text = carText("  track: 1.53 m", "  # track");
    expectCarRefused(text, "unsprung_mass: 38",
                     "front.track: found no value, expected a number in m (distance between the contact points of both "
                     "wheels); add \"track: <number>\"");
}

TEST_F(TreadRun, MisspeltKeyOfTheCarIsAnsweredWithTheRightOne) {
    expectCarRefused(carText("anti_roll_bar: 9 kN/m", "anti_rol_bar: 9 kN/m"), "anti_rol_bar",
                     "front.suspension: found the unknown key \"anti_rol_bar\", expected the name of a field; did you "
                     "mean \"anti_roll_bar\"?");
}

TEST_F(TreadRun, UnitThatDoesNotFitIsRefused) {
    expectCarRefused(carText("mass: 1350 kg", "mass: 1350 m"), "1350 m",
                     "mass: found a length (\"m\"), expected kg; correct the unit");
}

TEST_F(TreadRun, KeyThatIsGivenTwiceIsRefused) {
    const std::string text = carText("mass: 1350 kg  ", "mass: 1350 kg\nmass: 1400 kg  ");
    const std::string first = placeOf(text, "mass: 1350");
    expectCarRefused(text, "mass: 1400",
                     "found the key \"mass\" a second time, expected it once (the first is in line " +
                         first.substr(0, first.find(':')) + "); remove one of the two");
}

TEST_F(TreadRun, NegativeMassIsRefused) {
    expectCarRefused(carText("mass: 1350 kg", "mass: -1350 kg"), "-1350",
                     "mass: found \"-1350 kg\", expected a number in kg above 0; correct the value");
}

TEST_F(TreadRun, NumberThatIsNotFiniteIsRefused) {
    for (const std::string number : {"nan", ".nan", "NaN", "inf", ".inf", "-.inf", "1e999"}) {
        SCOPED_TRACE(number);
        expectCarRefused(
            carText("height: 0.54 m", "height: " + number), number + " ",
            "height: found \"" + number +
                "\", which is not a number, expected m; write a decimal number, alone or followed by a unit");
    }
}

TEST_F(TreadRun, EngineTorqueOutOfOrderIsRefused) {
    expectCarRefused(
        carText("[150, 120], [250, 138]", "[250, 138], [150, 120]"), "150, 120",
        "driveline.engine.full_load.2.x: found x = 150 after 250, expected x to increase strictly; sort the "
        "points and remove repetitions");
}

TEST_F(TreadRun, TyreFileThatDoesNotExistIsRefused) {
    expectCarRefused(carText(kTyre, "tyre: tyres/none.yaml"), "tyres/none.yaml",
                     "front.tyre: found the file name \"tyres/none.yaml\", which " + scratch.path("car.yaml") +
                         " includes, but nothing is there (tried \"" + scratch.path("tyres/none.yaml") +
                         "\"); write a path relative to the including file");
}

TEST_F(TreadRun, CarThatNamesItselfAsTyreIsRefused) {
    expectCarRefused(carText(kTyre, "tyre: car.yaml"), "car.yaml",
                     "front.tyre: found \"car.yaml\", which includes itself by way of this file; break the circle");
}

TEST_F(TreadRun, TyreFileThatNamesItselfIsRefused) {
    scratch.file("tyre.yaml", "parameters: tyre.yaml\n");
    car(carText(kTyre, "tyre: tyre.yaml"));
    scenario();
    expectRefused(run(), scratch.path("tyre.yaml") +
                             ":1:13: front.tyre.parameters: found \"tyre.yaml\", expected a map; write \"key: value\" "
                             "lines");
}

TEST_F(TreadRun, OtherCarAsTyreIsRefused) {
    const std::string other = carText();
    scratch.file("other.yaml", other);
    car(carText(kTyre, "tyre: other.yaml"));
    scenario();
    const Result result = run();
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(firstLine(result.err), scratch.path("other.yaml") + ":" + placeOf(other, "name:") +
                                         ": front.tyre.parameters.Fzo: found no value, expected a number in N (nominal "
                                         "load (29)); add \"Fzo: <number>\"");
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 21) << result.err;
    EXPECT_TRUE(result.err.ends_with(" more faults; `tread check` lists all\n")) << result.err;
}

TEST_F(TreadRun, AliasBombIsRefusedAtOnce) {
    std::string text = "a: &a [x, x, x, x, x, x, x, x, x, x]\n";
    for (char level = 'b'; level <= 'j'; ++level) {
        const std::string inner = std::string("*") + static_cast<char>(level - 1);
        text += std::string(1, level) + ": &" + level + " [";
        for (int i = 0; i < 10; ++i) text += (i > 0 ? ", " : "") + inner;
        text += "]\n";
    }
    const auto begin = std::chrono::steady_clock::now();
    expectCarRefused(text, "*e]\ng", "found more than a million values; write fewer, or fewer aliases");
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
}

TEST_F(TreadRun, EmptyBinaryMissingFilesAndFoldersAreRefused) {
    const std::string road = scenario();
    const std::string file = car("");
    expectRefused(run(), file + ": found nothing in the file, expected \"key: value\" lines; check the path");
    car("# nothing but a remark\n");
    expectRefused(run(), file + ": found nothing in the file, expected \"key: value\" lines; check the path");
    car(std::string("name: \0\1\2", 9));
    expectRefused(run(), file + ":1:7: found a NUL byte, expected UTF-8 text; check that this is not a binary file");
    car("name: \xff\xfe\x80");
    expectRefused(run(), file + ":1:7: found a byte that is not UTF-8; save the file as UTF-8 text");

    const std::string none = scratch.path("none.yaml");
    expectRefused(runProgram({"run", none, road, "-o", out()}),
                  none + ": found no file of this name; correct the path");
    const std::string folder = scratch.path("folder");
    std::filesystem::create_directory(folder);
    const std::string message = folder + ": found a directory, expected a file; name a file in it";
    expectRefused(runProgram({"run", folder, road, "-o", out()}), message);
    car();
    expectRefused(runProgram({"run", file, folder, "-o", out()}), message);
}

TEST_F(TreadRun, FaultsOfBothFilesAreToldAtOnce) {
    const std::string text = carText("mass: 1350 kg", "mass: 1350 m");
    car(text);
    scenario(replaced(kScenario, "title", "tilte"));
    expectRefused(
        run(), scratch.path("car.yaml") + ":" + placeOf(text, "1350 m") +
                   ": mass: found a length (\"m\"), expected kg; correct the unit\n" + scratch.path("scenario.yaml") +
                   ":1:1: found the unknown key \"tilte\", expected the name of a field; did you mean \"title\"?");
}

// ---- Faults of the scenario file -----------------------------------------------------------------------------------

TEST_F(TreadRun, MisspeltKeyOfTheScenarioIsAnsweredWithTheRightOne) {
    expectScenarioRefused(
        replaced(kScenario, "speed", "sped"), "sped",
        "start: found the unknown key \"sped\", expected the name of a field; did you mean \"speed\"?");
}

TEST_F(TreadRun, ScenarioWithoutPhasesIsRefused) {
    expectScenarioRefused(
        "title: nothing\n", "title",
        "phases: found no phase, expected at least one that says what the driver does and until when");
}

TEST_F(TreadRun, PhaseWithoutEndIsRefused) {
    expectScenarioRefused(replaced(kScenario, "    until: {duration: 0.2 s}\n", ""), "name: straight",
                          "phases.0.until.duration: found no condition, expected at least one (duration, speed_below, "
                          "speed_above, lateral_acceleration_above or distance), or the phase would never end");
}

TEST_F(TreadRun, UnitThatDoesNotFitTheScenarioIsRefused) {
    expectScenarioRefused(replaced(kScenario, "0.2 s", "0.2 m"), "0.2 m",
                          "phases.0.until.duration: found a length (\"m\"), expected s; correct the unit");
}

TEST_F(TreadRun, UnknownManoeuvreIsRefusedBeforeTheCarDrives) {
    expectScenarioRefused("manoeuvre: step_ster\n" + kScenario, "step_ster",
                          "manoeuvre: found the unknown manoeuvre \"step_ster\", expected " + kManoeuvres +
                              "; did you mean \"step_steer\"?");
}

TEST_F(TreadRun, ChannelThatDoesNotExistIsRefusedBeforeTheCarDrives) {
    const std::string text = kScenario + "log: {channels: [chassis.*, chasis.vx, wheel.*.lod]}\n";
    car();
    scenario(text);
    const std::string file = scratch.path("scenario.yaml") + ":";
    expectRefused(run(),
                  file + placeOf(text, "chasis.vx") +
                      ": log.channels.1: found \"chasis.vx\", which fits no channel, expected a name or a pattern "
                      "with *; did you mean \"chassis.vx\"? `tread describe log` lists all channels\n" +
                      file + placeOf(text, "wheel.*.lod") +
                      ": log.channels.2: found \"wheel.*.lod\", which fits no channel, expected a name or a "
                      "pattern with *; `tread describe log` lists all channels");
}

TEST_F(TreadRun, CarInPlaceOfTheScenarioIsRefused) {
    const std::string text = carText();
    const Result result = runProgram({"run", car(text), car(text), "-o", out()});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(firstLine(result.err), scratch.path("car.yaml") + ":" + placeOf(text, "name:") +
                                         ": found the unknown key \"name\", expected the name of a field; write one of "
                                         "title, description, manoeuvre, step, time_limit, road, start, phases or log");
}

// ---- Settings ------------------------------------------------------------------------------------------------------

TEST_F(TreadRun, SettingsReachCarAndScenario) {
    car();
    scenario();
    const Result result =
        run({"--set", "mass=1400", "--set", "front.suspension.spring=25 kN/m", "--set", "scenario.step=0.016666",
             "--set", "scenario.phases.0.until.duration=0.1 s", "--set", "scenario.log.channels=[chassis.vx]"});
    EXPECT_EQ(result.status, 0) << result.err;
    const std::string resolved = contentOf(out("run.yaml"));
    for (const char* line : {"  mass: 1400 ", "      spring: 25000 ", "  step: 0.016666 ", "        duration: 0.1 "}) {
        EXPECT_NE(resolved.find(line), std::string::npos) << line;
    }
    const Log log = readLog(out("log.csv"));
    EXPECT_EQ(log.channels.size(), 2u);
    EXPECT_EQ(log.channels[0].values[1], 0.016666);
    EXPECT_NEAR(log.channels[0].values.back(), 0.1, 0.016666);
}

TEST_F(TreadRun, UnknownPathIsAnsweredWithTheRightOne) {
    car();
    scenario();
    const auto expectAnswer = [&](const std::string& path, const std::string& suggestion) {
        const Result result = run({"--set", path + "=1"});
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.out, "");
        const std::string expected = "--set: " + path + ": found the unknown path \"" + path +
                                     "\", expected the path of a field; did you mean " + suggestion + "? ";
        EXPECT_EQ(result.err.substr(0, expected.size()), expected);
        EXPECT_FALSE(std::filesystem::exists(out()));
    };
    expectAnswer("front.suspension.sprng", "\"front.suspension.spring\"");
    expectAnswer("spring", "front.suspension.spring or rear.suspension.spring");
    expectAnswer("scenario.stp", "\"scenario.step\"");
    expectAnswer("step", "scenario.step");
}

TEST_F(TreadRun, BadValueOfASettingIsRefused) {
    car();
    scenario();
    expectRefused(run({"--set", "mass=1350 m"}), "--set: mass: found a length (\"m\"), expected kg; correct the unit");
    expectRefused(run({"--set", "mass=heavy"}), kHeavy);
    expectRefused(run({"--set", "mass"}),
                  "--set: found \"mass\", expected path=value; write for example front.damper.bump=1800");
    expectRefused(run({"--set", "front_axle_distance=3"}),
                  "--set: front_axle_distance: the centre of gravity must lie between the axles (front_axle_distance < "
                  "wheelbase)");
    expectRefused(run({"--set", "scenario.step=1"}), kLongStep);
    expectRefused(run({"--set", "scenario.manoeuvre=turn"}),
                  "--set: scenario.manoeuvre: found the unknown manoeuvre \"turn\", expected " + kManoeuvres);
    expectRefused(run({"--set", "scenario.log.channels=[chassis.vxx]"}),
                  "--set: scenario.log.channels.0: found \"chassis.vxx\", which fits no channel, expected a name or a "
                  "pattern with *; did you mean \"chassis.vx\"? `tread describe log` lists all channels");
}

TEST_F(TreadRun, AllBadSettingsAreToldAtOnce) {
    car();
    scenario();
    expectRefused(run({"--set", "mass=heavy", "--set", "scenario.step=1"}), kHeavy + "\n" + kLongStep);
}

TEST_F(TreadRun, SettingMayStandBeforeTheFiles) {
    const Result result = runProgram({"run", "--set", "mass=1400", car(), scenario(), "-o", out()});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(contentOf(out("run.yaml")).find("  mass: 1400 "), std::string::npos);
}

// ---- Folders and disks ---------------------------------------------------------------------------------------------

TEST_F(TreadRun, OutputBelowAFileIsRefused) {
    const std::string file = car();
    scenario();
    const Result result = runProgram({"run", file, scratch.path("scenario.yaml"), "-o", file + "/out"});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err,
              "tread: cannot create the folder " + file + "/out: Not a directory; choose another with -o\n");
}

TEST_F(TreadRun, OutputThatCannotBeWrittenIsRefused) {
    car();
    scenario();
    for (const std::string folder : {"/proc/tread/out", "/dev/null/x"}) {
        const Result result =
            runProgram({"run", scratch.path("car.yaml"), scratch.path("scenario.yaml"), "-o", folder});
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.out, "");
        expectStart(result.err, "tread: cannot create the folder " + folder + ": ");
        EXPECT_TRUE(result.err.ends_with("; choose another with -o\n")) << result.err;
    }
}

TEST_F(TreadRun, EarlierResultThatCannotBeReplacedIsRefused) {
    car();
    scenario();
    std::filesystem::create_directories(out("log.csv/in the way"));
    const Result result = run();
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "tread: cannot remove " + out("log.csv") +
                              ", which an earlier run has left: Directory not empty; choose another folder with -o\n");
}

// No file may grow beyond this size, as on a disk that is full; for this program and those that it starts.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit narrow{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &narrow);
    }
    ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

private:
    rlimit before_{};
};

TEST_F(TreadRun, LogThatFillsTheDiskKeepsItsWholeRows) {
    car();
    scenario(replaced(kScenario, "0.2 s", "2 s") + "log: {rate: 1000}\n");
    Result result;
    {
        const FileSizeLimit limit(200'000);
        result = run();
    }
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "tread: cannot write '" + out("log.csv") + "': File too large; the rows so far are in '" +
                              out("log.incomplete.csv") + "'\n");
    EXPECT_EQ(results(), kFailedResults);
    const Log log = readLog(out("log.incomplete.csv"));
    EXPECT_GT(log.samples(), 50u);
    EXPECT_EQ(log.channels[0].values[7], 0.007);
    EXPECT_GT(std::filesystem::file_size(out("log.incomplete.csv")), 190'000u);
}

TEST_F(TreadRun, ReportThatFillsTheDiskLeavesTheLogAndNoReport) {
    car();
    scenario();
    Result result;
    {
        const FileSizeLimit limit(45'000);
        result = run({"--set", "scenario.log.rate=50"});
    }
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "tread: cannot write '" + out("report.html") + "': File too large\n");
    EXPECT_EQ(results(), (Names{"log.csv", "metrics.json", "run.yaml"}));
    EXPECT_GT(readLog(out("log.csv")).samples(), 10u);
}

TEST_F(TreadRun, DiskWithoutSpaceIsTold) {
    car();
    scenario();
    std::filesystem::create_directories(out());
    std::filesystem::create_symlink("/dev/full", out("log.csv.part"));
    const Result result = run();
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("cannot write '" + out("log.csv") + "': No space left on device"), std::string::npos)
        << result.err;
    EXPECT_FALSE(std::filesystem::exists(out("log.csv")));
    EXPECT_FALSE(std::filesystem::exists(out("report.html")));
}

TEST_F(TreadRun, AnswerThatCannotBePrintedIsAFault) {
    car();
    scenario();
    const Result result = runProgram(words(), "/dev/full");
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err, "tread: cannot write the answer to standard output: No space left on device\n");
}

// ---- Ctrl-C --------------------------------------------------------------------------------------------------------

// The program while it runs.
class Running {
public:
    Running(std::vector<std::string> words, const std::string& out, const std::string& err) {
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        words.insert(words.begin(), TREAD_PROGRAM);
        std::vector<char*> argv;
        for (std::string& word : words) argv.push_back(word.data());
        argv.push_back(nullptr);
        const int fault = posix_spawn(&child_, TREAD_PROGRAM, &actions, nullptr, argv.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        if (fault != 0) throw std::runtime_error("cannot start " TREAD_PROGRAM);
    }
    ~Running() {
        if (child_ == 0) return;
        kill(child_, SIGKILL);
        waitpid(child_, nullptr, 0);
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    void send(int signal) const { kill(child_, signal); }
    int waitForStatus() {
        int state = 0;
        waitpid(child_, &state, 0);
        child_ = 0;
        return WIFEXITED(state) ? WEXITSTATUS(state) : -1;
    }

private:
    pid_t child_ = 0;
};

// True when the file has that many bytes before the time is over.
bool grows(const std::string& file, std::uintmax_t bytes) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(300);
    std::error_code error;
    while (std::chrono::steady_clock::now() < end) {
        const std::uintmax_t size = std::filesystem::file_size(file, error);
        if (!error && size >= bytes) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

class TreadRunInterrupted : public TreadRun, public testing::WithParamInterface<std::pair<int, int>> {};

TEST_P(TreadRunInterrupted, KeepsTheLogSoFarAndSaysWhere) {
    const auto [signal, status] = GetParam();
    car();
    scenario();
    Running program(words({"--set", "scenario.phases.0.until.duration=100000", "--set", "scenario.time_limit=200000"}),
                    scratch.path("stdout"), scratch.path("stderr"));
    ASSERT_TRUE(grows(out("log.csv.part"), 1));
    program.send(signal);
    EXPECT_EQ(program.waitForStatus(), status);

    EXPECT_EQ(results(), kFailedResults);
    const Log log = readLog(out("log.incomplete.csv"));
    ASSERT_GT(log.samples(), 1u);
    for (const Channel& channel : log.channels) EXPECT_EQ(channel.values.size(), log.samples());
    const std::string err = contentOf(scratch.path("stderr"));
    EXPECT_EQ(err.rfind("tread run: interrupted at t = ", 0), 0u) << err;
    EXPECT_TRUE(err.ends_with(" s; the log so far is in " + out("log.incomplete.csv") + "\n")) << err;
    EXPECT_EQ(contentOf(scratch.path("stdout")), "");
}

INSTANTIATE_TEST_SUITE_P(By, TreadRunInterrupted, testing::Values(std::pair(SIGINT, 130), std::pair(SIGTERM, 143)),
                         [](const auto& by) { return by.param.first == SIGINT ? "CtrlC" : "Termination"; });

TEST_F(TreadRun, InterruptIsHeardBetweenRowsThatAreFarApart) {
    car();
    scenario();
    Running program(words({"--set", "scenario.phases.0.until.duration=100000", "--set", "scenario.time_limit=200000",
                           "--set", "scenario.log.rate=0.00001"}),
                    scratch.path("stdout"), scratch.path("stderr"));
    ASSERT_TRUE(grows(out("log.csv.part"), 0));
    program.send(SIGINT);
    EXPECT_EQ(program.waitForStatus(), 130);
    EXPECT_EQ(readLog(out("log.incomplete.csv")).samples(), 1u);
}

TEST_F(TreadRun, ProgressIsShownOnATerminalAndWipedBeforeTheMessage) {
    car();
    scenario();
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    ASSERT_GE(terminal, 0);
    ASSERT_EQ(grantpt(terminal), 0);
    ASSERT_EQ(unlockpt(terminal), 0);
    Running program(words({"--set", "scenario.phases.0.until.duration=100000", "--set", "scenario.time_limit=200000"}),
                    scratch.path("stdout"), ptsname(terminal));

    std::string shown;
    char piece[256];
    bool interrupted = false;
    for (ssize_t size = 0; (size = read(terminal, piece, sizeof piece)) > 0;) {
        shown.append(piece, static_cast<std::size_t>(size));
        if (!interrupted && shown.find(" s [") != std::string::npos) {
            interrupted = true;
            program.send(SIGINT);
        }
    }
    close(terminal);
    EXPECT_EQ(program.waitForStatus(), 130);
    EXPECT_EQ(shown.front(), '\r') << shown;
    EXPECT_NE(shown.find("\r\033[Ktread run: interrupted at t = "), std::string::npos) << shown;
}

// ---- What the car cannot do ----------------------------------------------------------------------------------------

TEST_F(TreadRun, SpeedThatIsNeverReachedFailsAndNamesThePhase) {
    car();
    scenario(R"(time_limit: 1.5 s
start: {speed: 80 km/h}
phases:
  - name: run up
    throttle: {constant: {value: 1}}
    until: {speed_above: 300 km/h}
)");
    const Result result = run();
    EXPECT_EQ(result.status, 3);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err.substr(0, result.err.find("; the car has ")),
              "tread run: the manoeuvre did not end within 1.5 s: phase \"run up\" waits for a speed above 83.33 m/s");
    EXPECT_TRUE(result.err.ends_with(" to the side; change the scenario, or raise time_limit; the log so far is in " +
                                     out("log.incomplete.csv") + "\n"))
        << result.err;
    EXPECT_EQ(results(), kFailedResults);
    EXPECT_NEAR(readLog(out("log.incomplete.csv")).channels[0].values.back(), 1.5, 0.011);
}

TEST_F(TreadRun, StartSpeedThatTheCarCannotHoldFails) {
    car();
    scenario(replaced(kScenario, "80 km/h", "250 km/h"));
    const Result result = run();
    EXPECT_EQ(result.status, 3);
    EXPECT_EQ(result.out, "");
    expectStart(
        result.err,
        "tread run: the car cannot hold the 69.4 m/s at which the scenario starts: that would take a throttle of ");
    EXPECT_TRUE(result.err.ends_with(", and only 0 to 1 is possible; lower start.speed or give the car more power\n"))
        << result.err;
    EXPECT_EQ(results(), Names{"run.yaml"});
}

TEST_F(TreadRun, StandingOnASlopeWithoutBrakesFails) {
    car();
    scenario("road: {grade: 20 %}\nphases: [{until: {duration: 1}}]\n");
    const Result result = run();
    EXPECT_EQ(result.status, 3);
    expectStart(result.err, "tread run: the car finds no equilibrium to start from: ");
    EXPECT_TRUE(
        result.err.ends_with(" m/s2 are left after settling (does it stand on a slope with its brakes off, or on "
                             "ice?)\n"))
        << result.err;
    EXPECT_EQ(results(), Names{"run.yaml"});
}

TEST_F(TreadRun, CarThatRollsOverFailsAndKeepsItsLog) {
    car();
    scenario(R"(start: {speed: 80 km/h}
phases:
  - {steering: {ramp: {to: 400 deg, rate: 1000 deg/s}}, until: {duration: 10 s}}
)");
    const Result result = run({"--set", "height=1.6"});
    EXPECT_EQ(result.status, 3);
    EXPECT_EQ(result.out, "");
    expectStart(result.err, "tread run: the car rolled over at t = ");
    EXPECT_NE(result.err.find(" s: chassis.roll is 8"), std::string::npos) << result.err;
    EXPECT_TRUE(result.err.ends_with("; the log so far is in " + out("log.incomplete.csv") + "\n")) << result.err;
    EXPECT_EQ(results(), kFailedResults);
}

TEST_F(TreadRun, CarThatBreaksDownNumericallyFailsAndNamesTheChannel) {
    car();
    scenario();
    const Result result = run({"--set", "driveline.shaft_stiffness=1e300", "--set", "scenario.log.rate=1000"});
    EXPECT_EQ(result.status, 3);
    EXPECT_EQ(result.out, "");
    expectStart(result.err, "tread run: the simulation broke down at t = 0.00");
    EXPECT_NE(result.err.find(" s: chassis."), std::string::npos) << result.err;
    EXPECT_TRUE(
        result.err.ends_with(" (a parameter far from that of a real car, or a step that is too long, can do "
                             "this); the log so far is in " +
                             out("log.incomplete.csv") + "\n"))
        << result.err;
    EXPECT_EQ(results(), kFailedResults);
    for (const Channel& channel : readLog(out("log.incomplete.csv")).channels) {
        for (const double value : channel.values) EXPECT_TRUE(std::isfinite(value)) << channel.name;
    }
}

TEST_F(TreadRun, CarThatBreaksDownWhileItSettlesFails) {
    car();
    scenario();
    const Result result = run({"--set", "inertia.roll=1e-9"});
    EXPECT_EQ(result.status, 3);
    EXPECT_EQ(result.out, "");
    expectStart(result.err,
                "tread run: the simulation broke down before the start, while the car settled on its wheels: its "
                "acceleration is ");
    EXPECT_EQ(results(), Names{"run.yaml"});
}

TEST_F(TreadRun, FailureDoesNotPassOffAnEarlierLogAsItsOwn) {
    car();
    scenario();
    std::filesystem::create_directories(out());
    for (const char* name : {"log.csv", "log.incomplete.csv", "report.html", "metrics.json"}) {
        std::ofstream(out(name)) << "of an earlier run\n";
    }
    const Result result = run({"--set", "scenario.start.speed=250 km/h"});
    EXPECT_EQ(result.status, 3);
    EXPECT_EQ(result.err.find("log so far"), std::string::npos) << result.err;
    EXPECT_EQ(results(), Names{"run.yaml"});
}

TEST_F(TreadRun, BadInputLeavesEarlierResultsAlone) {
    car();
    scenario();
    std::filesystem::create_directories(out());
    std::ofstream(out("log.csv")) << "of an earlier run\n";
    EXPECT_EQ(run({"--set", "mass=-1"}).status, 2);
    EXPECT_EQ(contentOf(out("log.csv")), "of an earlier run\n");
}

// ---- What a good run leaves and says -------------------------------------------------------------------------------

TEST_F(TreadRun, WritesLogInputsMetricsAndReport) {
    car();
    scenario();
    const Result result = run();
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(results(), kAllResults);
    EXPECT_EQ(result.out,
              "A short way, compact front-drive hatchback: drove 0.2 s\nReport: " + out("report.html") + "\n");
    EXPECT_EQ(readLog(out("log.csv")).samples(), 21u);
}

TEST_F(TreadRun, JsonIsAllThatItPrints) {
    car();
    scenario();
    const Result result = run({"--json"});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.err, "");
    const nlohmann::json json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["answer"], "A short way, compact front-drive hatchback: drove 0.2 s");
    EXPECT_EQ(json, nlohmann::json::parse(contentOf(out("metrics.json"))));
}

TEST_F(TreadRun, JsonOfAFailureIsNoHalfAnswer) {
    car();
    scenario();
    const Result result = run({"--json", "--set", "scenario.start.speed=250 km/h"});
    EXPECT_EQ(result.status, 3);
    EXPECT_EQ(result.out, "");
}

TEST_F(TreadRun, WarningsGoToStandardErrorAndIntoTheResults) {
    car();
    scenario("manoeuvre: step_steer\n" + kScenario);
    const Result result = run({"--json"});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.err.rfind("warning: no metrics of step_steer: ", 0), 0u) << result.err;
    const nlohmann::json json = nlohmann::json::parse(result.out);
    EXPECT_EQ("warning: " + json["warnings"][0].get<std::string>() + "\n", result.err);
    EXPECT_TRUE(json["metrics"].empty());
}

TEST_F(TreadRun, SameRunGivesTheSameBytesOnEveryProcessor) {
    car();
    scenario(
        "title: step\nstart: {speed: 80 km/h}\nphases:\n"
        "  - {steering: {ramp: {to: 60 deg, rate: 500 deg/s}}, until: {duration: 1 s}}\n");
    cpu_set_t allowed;
    ASSERT_EQ(sched_getaffinity(0, sizeof allowed, &allowed), 0);
    ASSERT_EQ(run().status, 0);
    const std::string first = contentOf(out("log.csv"));
    ASSERT_GT(first.size(), 10'000u);
    ASSERT_EQ(run().status, 0);
    EXPECT_EQ(contentOf(out("log.csv")), first);

    int pinned = 0;
    for (int processor = 0; processor < CPU_SETSIZE && pinned < 2; ++processor) {
        if (!CPU_ISSET(processor, &allowed)) continue;
        ++pinned;
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(processor, &one);
        ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
        const int status = run().status;
        ASSERT_EQ(sched_setaffinity(0, sizeof allowed, &allowed), 0);
        EXPECT_EQ(status, 0);
        EXPECT_EQ(contentOf(out("log.csv")), first) << "processor " << processor;
    }
    EXPECT_GE(pinned, 1);
}

// The lines of a top-level key, less their indentation.
std::string sectionOf(const std::string& yaml, const std::string& key) {
    std::istringstream lines(yaml);
    std::string line, section;
    bool inside = false;
    while (std::getline(lines, line)) {
        if (!line.empty() && line.front() != ' ') inside = line == key + ":";
        else if (inside) section += (line.size() > 2 ? line.substr(2) : "") + "\n";
    }
    return section;
}

TEST_F(TreadRun, ResolvedInputsGiveTheSameRunAgain) {
    car();
    scenario(
        "title: step\nstart: {speed: 80 km/h}\nphases:\n  - {throttle: {hold_speed: {}}, until: {duration: 0.1 s}}\n"
        "  - {steering: {ramp: {to: 60 deg, rate: 500 deg/s}}, until: {duration: 0.3 s}}\n");
    ASSERT_EQ(run({"--set", "mass=1401.7", "--set", "front.tyre.lambda.mux=0.93"}).status, 0);
    const std::string first = contentOf(out("log.csv"));
    const std::string resolved = contentOf(out("run.yaml"));

    car(sectionOf(resolved, "vehicle"));
    scenario(sectionOf(resolved, "scenario"));
    const Result again = run();
    ASSERT_EQ(again.status, 0) << again.err;
    EXPECT_EQ(contentOf(out("log.csv")), first);
    EXPECT_EQ(contentOf(out("run.yaml")), resolved);
}

// ---- The first line of the answer ----------------------------------------------------------------------------------

// Words with # for every number; a number that ends in useless zeros stays.
std::string withoutNumbers(const std::string& text) {
    std::istringstream words(text);
    std::string word, result;
    while (words >> word) {
        const std::string comma = word.ends_with(',') ? "," : "";
        const std::string number = word.substr(0, word.size() - comma.size());
        const bool is_number = number.find_first_not_of("-0123456789.") == std::string::npos;
        const bool is_short = number.find('.') == std::string::npos || !number.ends_with('0');
        result += (result.empty() ? "" : " ") + (is_number && is_short ? "#" + comma : word);
    }
    return result;
}

// The scenario files with the compact car. How many digits are right is for other tests; here the words count.
struct Answer {
    std::string scenario;
    std::string words;  // # stands for a number
};
class TreadRunAnswer : public TreadRun, public testing::WithParamInterface<Answer> {};

TEST_P(TreadRunAnswer, FirstLineTellsTheManoeuvreInWords) {
    const Result result = runProgram({"run", kSource + "/vehicles/compact.yaml",
                                      kSource + "/scenarios/" + GetParam().scenario + ".yaml", "-o", out()});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "");
    const std::string answer = firstLine(result.out);
    const std::string words = answer.substr(answer.rfind(": ") + 2);
    EXPECT_EQ(withoutNumbers(words), GetParam().words) << answer;
}

INSTANTIATE_TEST_SUITE_P(
    Of, TreadRunAnswer,
    testing::Values(
        Answer{"drop_and_settle", "settles within # s, bounces at # Hz, damping ratio #"},
        Answer{"straight_braking_100_part",
               "stops within # m, mean fully developed deceleration # m/s2, front left wheel locked for # % "
               "of the time"},
        Answer{"step_steer_80",
               "yaw rate answers within # ms, overshoots by # %, settles at # m/s2 of lateral acceleration"},
        Answer{"sine_steer", "yaw rate gain # 1/s, yaw rate lags by # deg, lateral acceleration by # deg"},
        Answer{"steady_circle",
               "understeer gradient # deg/g, roll gradient # deg/g, up to # m/s2 of lateral acceleration"},
        Answer{"coast_down", "coasts for # s, rolls # m, rolling resistance coefficient #"},
        Answer{"parked_on_slope", "creeps by # mm in a minute, moves by at most # mm, turns by # deg in a minute"}),
    [](const auto& answer) { return answer.param.scenario; });

}  // namespace
}  // namespace tread
