// `tread run` as a user meets it: what it says of bad files and options, of a full disk and Ctrl-C, of a car that
// cannot do the manoeuvre; what it leaves behind; and that it answers the same every time.

#include <gtest/gtest.h>
#include <sched.h>
#include <signal.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
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
    expectCarRefused(text, "track: 1.51", "");
}

TEST_F(TreadRun, MisspeltKeyOfTheCarIsAnsweredWithTheRightOne) {
    const std::string text = carText("    anti_roll_bar: 9 kN/m", "    anti_rol_bar: 9 kN/m");
    expectCarRefused(text, "anti_rol_bar", "");
}

TEST_F(TreadRun, UnitThatDoesNotFitIsRefused) {
    expectCarRefused(carText("mass: 1350 kg", "mass: 1350 m"), "1350 m", "");
}

TEST_F(TreadRun, KeyThatIsGivenTwiceIsRefused) {
    const std::string text = carText("mass: 1350 kg  ", "mass: 1350 kg\nmass: 1400 kg  ");
    expectCarRefused(text, "mass: 1400", "");
}

TEST_F(TreadRun, NegativeMassIsRefused) {
    expectCarRefused(carText("mass: 1350 kg", "mass: -1350 kg"), "-1350", "");
}

TEST_F(TreadRun, NumberThatIsNotFiniteIsRefused) {
    for (const std::string number : {"nan", ".nan", "NaN", "inf", ".inf", "-.inf", "1e999"}) {
        SCOPED_TRACE(number);
        expectCarRefused(carText("height: 0.54 m", "height: " + number), number + " ", number);
    }
}

TEST_F(TreadRun, EngineTorqueOutOfOrderIsRefused) {
    expectCarRefused(carText("[150, 120], [250, 138]", "[250, 138], [150, 120]"), "150, 120", "");
}

TEST_F(TreadRun, TyreFileThatDoesNotExistIsRefused) {
    const std::string text =
        carText("tyre: " + kSource + "/vehicles/tyres/car_205_60R15.yaml", "tyre: tyres/none.yaml");
    expectCarRefused(text, "tyres/none.yaml", "");
}

TEST_F(TreadRun, CarThatNamesItselfAsTyreIsRefused) {
    const std::string text = carText("tyre: " + kSource + "/vehicles/tyres/car_205_60R15.yaml", "tyre: car.yaml");
    expectCarRefused(text, "car.yaml", "");
}

TEST_F(TreadRun, TyreFileThatNamesItselfIsRefused) {
    const std::string tyre = "parameters: tyre.yaml\n";
    scratch.file("tyre.yaml", tyre);
    const std::string text = carText("tyre: " + kSource + "/vehicles/tyres/car_205_60R15.yaml", "tyre: tyre.yaml");
    car(text);
    scenario();
    expectRefused(run(), scratch.path("tyre.yaml") + ":1:13: ");
}

TEST_F(TreadRun, OtherCarAsTyreIsRefused) {
    scratch.file("other.yaml", carText());
    car(carText("tyre: " + kSource + "/vehicles/tyres/car_205_60R15.yaml", "tyre: other.yaml"));
    scenario();
    const Result result = run();
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(firstLine(result.err), scratch.path("other.yaml") + ":8:1: ");
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
    expectCarRefused(text, "g: &g", "");
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
}

TEST_F(TreadRun, EmptyBinaryMissingFilesAndFoldersAreRefused) {
    scenario();
    const std::string file = car("");
    expectRefused(run(), file + ": ");
    car(std::string("name: \0\1\2", 9));
    expectRefused(run(), file + ":1:7: ");
    car("\xff\xfe\x80");
    expectRefused(run(), file + ":1:1: ");
    expectRefused(runProgram({"run", scratch.path("none.yaml"), scenario(), "-o", out()}),
                  scratch.path("none.yaml") + ": ");
    const std::filesystem::path folder = scratch.path("");
    expectRefused(runProgram({"run", folder.string(), scenario(), "-o", out()}), folder.string() + ": ");
    car();
    expectRefused(runProgram({"run", file, folder.string(), "-o", out()}), folder.string() + ": ");
}

TEST_F(TreadRun, FaultsOfBothFilesAreToldAtOnce) {
    const std::string car_text = carText("mass: 1350 kg", "mass: 1350 m");
    const std::string scenario_text = replaced(kScenario, "title", "tilte");
    car(car_text);
    scenario(scenario_text);
    expectRefused(run(), "");
}

// ---- Faults of the scenario file -----------------------------------------------------------------------------------

TEST_F(TreadRun, MisspeltKeyOfTheScenarioIsAnsweredWithTheRightOne) {
    expectScenarioRefused(replaced(kScenario, "speed", "sped"), "sped", "");
}

TEST_F(TreadRun, ScenarioWithoutPhasesIsRefused) {
    expectScenarioRefused("title: nothing\n", "title", "");
}

TEST_F(TreadRun, PhaseWithoutEndIsRefused) {
    expectScenarioRefused(replaced(kScenario, "    until: {duration: 0.2 s}\n", ""), "name: straight", "");
}

TEST_F(TreadRun, UnitThatDoesNotFitTheScenarioIsRefused) {
    expectScenarioRefused(replaced(kScenario, "0.2 s", "0.2 m"), "0.2 m", "");
}

TEST_F(TreadRun, UnknownManoeuvreIsRefusedBeforeTheCarDrives) {
    expectScenarioRefused("manoeuvre: step_ster\n" + kScenario, "step_ster", "");
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
    expectRefused(run({"--set", "front.suspension.sprng=25000"}), "");
    expectRefused(run({"--set", "spring=25000"}), "");
    expectRefused(run({"--set", "scenario.stp=0.002"}), "");
    expectRefused(run({"--set", "step=0.002"}), "");
}

TEST_F(TreadRun, BadValueOfASettingIsRefused) {
    car();
    scenario();
    expectRefused(run({"--set", "mass=1350 m"}), "");
    expectRefused(run({"--set", "mass=heavy"}), "");
    expectRefused(run({"--set", "mass"}), "");
    expectRefused(run({"--set", "scenario.step=1"}), "");
    expectRefused(run({"--set", "scenario.manoeuvre=turn"}), "");
    expectRefused(run({"--set", "front_axle_distance=3"}), "");
    expectRefused(run({"--set", "scenario.phases.0.until={}"}), "");
}

TEST_F(TreadRun, AllBadSettingsAreToldAtOnce) {
    car();
    scenario();
    expectRefused(run({"--set", "mass=heavy", "--set", "scenario.step=1"}), "");
}

// ---- Folders and disks ---------------------------------------------------------------------------------------------

TEST_F(TreadRun, OutputBelowAFileIsRefused) {
    const std::string file = car();
    scenario();
    const Result result = runProgram({"run", file, scratch.path("scenario.yaml"), "-o", file + "/out"});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "");
}

TEST_F(TreadRun, OutputThatCannotBeWrittenIsRefused) {
    car();
    scenario();
    for (const std::string folder : {"/proc/tread/out", "/dev/null/x"}) {
        const Result result =
            runProgram({"run", scratch.path("car.yaml"), scratch.path("scenario.yaml"), "-o", folder});
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(result.err, "");
    }
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
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(results(), kFailedResults);
    EXPECT_NEAR(readLog(out("log.incomplete.csv")).channels[0].values.back(), 1.5, 0.011);
}

TEST_F(TreadRun, StartSpeedThatTheCarCannotHoldFails) {
    car();
    scenario(replaced(kScenario, "80 km/h", "250 km/h"));
    const Result result = run();
    EXPECT_EQ(result.status, 3);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(results(), Names{"run.yaml"});
}

TEST_F(TreadRun, StandingOnASlopeWithoutBrakesFails) {
    car();
    scenario("road: {grade: 20 %}\nphases: [{until: {duration: 1}}]\n");
    const Result result = run();
    EXPECT_EQ(result.status, 3);
    EXPECT_EQ(result.err, "");
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
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(results(), kFailedResults);
}

TEST_F(TreadRun, CarThatBreaksDownNumericallyFailsAndNamesTheChannel) {
    car();
    scenario();
    const Result result = run({"--set", "front.unsprung_mass=1e-9", "--set", "rear.wheel_inertia=1e-30"});
    EXPECT_EQ(result.status, 3);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(results(), kFailedResults);
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

TEST_F(TreadRun, FirstLineTellsTheManoeuvreInWords) {
    car();
    scratch.file("scenario.yaml", contentOf(kSource + "/scenarios/straight_braking_100_part.yaml"));
    const Result result = run();
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(firstLine(result.out), "");
}

}  // namespace
}  // namespace tread
