// Campaigns by the real program: one result whatever happens on the way.

#include <sqlite3.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/text/number_text.h"
#include "cli/killed.h"
#include "cli/tread_run.h"
#include "log/csv.h"
#include "shared/file_size_limit.h"

namespace tread::campaign_test {
namespace {

namespace fs = std::filesystem;

const std::string kCampaign = R"(title: Stops
vehicles: [car.yaml]
scenarios: [stop.yaml]
factors:
  - {path: scenario.road.friction, uniform: {from: 0.6, to: 1}}
  - {path: load.mass, list: [0, 100 kg, 200 kg]}
samples: 20
runs_per_piece: 4
)";
constexpr int kRuns = 60;

class TreadCampaign : public TreadRun {
protected:
    void SetUp() override {
        car();
        scratch.file("stop.yaml", kShortStop);
        campaign();
    }
    std::string campaign(const std::string& text = kCampaign) const { return scratch.file("campaign.yaml", text); }
    std::string folder(const std::string& name) const { return scratch.path(name); }

    std::vector<std::string> call(const std::string& name, const Names& more = {}) const {
        Names all{"campaign", scratch.path("campaign.yaml"), "-o", folder(name)};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    Result drive(const std::string& name, const Names& more = {}) const { return runProgram(call(name, more)); }

    // What must not depend on how it was computed.
    std::string bytesOf(const std::string& name) const {
        return contentOf(folder(name) + "/results.csv") + contentOf(folder(name) + "/results.sqlite");
    }
    bool isDone(const std::string& name) const { return fs::exists(folder(name) + "/report.html"); }
    std::vector<std::string> lines(const std::string& name) const {
        std::vector<std::string> all;
        std::istringstream text(contentOf(folder(name) + "/results.csv"));
        for (std::string line; std::getline(text, line);) all.push_back(line);
        return all;
    }
    std::size_t pieces(const std::string& name) const {
        std::size_t count = 0;
        for (const auto& entry : fs::directory_iterator(folder(name) + "/pieces"))
            count += entry.path().extension() == ".piece";
        return count;
    }
    void expectFault(const Result& result, const std::string& words) const {
        EXPECT_EQ(result.status, 2);
        EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    }
};

TEST_F(TreadCampaign, OneTableWhateverThreadsAndShards) {
    const Result one = drive("one", {"--threads", "1"});
    ASSERT_EQ(one.status, 0) << one.err;
    EXPECT_EQ(firstLine(one.out), "Stops: 60 runs");
    const auto table = lines("one");
    ASSERT_EQ(table.size(), 1u + kRuns);
    EXPECT_EQ(table[0].substr(0, 151),
              "run,vehicle,scenario,repetition,status,message,missed,scenario.road.friction [-],load.mass [kg],"
              "initial_speed [m/s],stopping_distance [m],corrected_sto");
    EXPECT_EQ(table[1].substr(0, 14), "0,car,stop,0,o");
    ASSERT_EQ(drive("three", {"--threads", "3"}).status, 0);
    EXPECT_EQ(bytesOf("three"), bytesOf("one"));

    for (const char* shard : {"2/3", "1/3", "3/3"}) {
        const std::string part = std::string("part") + shard[0];
        const Result result = drive(part, {"--shard", shard});
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_FALSE(isDone(part));
    }
    const Result early = runProgram({"campaign", "merge", folder("part1"), folder("part2"), "-o", folder("early")});
    EXPECT_EQ(early.status, 1);
    EXPECT_EQ(firstLine(early.out).substr(0, 24), "20 runs of 60 missing: `");
    EXPECT_FALSE(isDone("early"));
    const Result joined =
        runProgram({"campaign", "merge", folder("part3"), folder("part1"), folder("part2"), "-o", folder("joined")});
    ASSERT_EQ(joined.status, 0) << joined.err;
    EXPECT_EQ(bytesOf("joined"), bytesOf("one"));
}

TEST_F(TreadCampaign, TakesNamesOfShippedCarsAndScenariosAndFilesBesideItFirst) {
    campaign("title: Stops\nvehicles: [compact, car.yaml]\nscenarios: [straight_braking_100]\n");
    fs::create_directory(scratch.path("compact"));  // is no file of a car
    const Result driven = drive("out");
    ASSERT_EQ(driven.status, 0) << driven.err;
    EXPECT_EQ(lines("out")[1].substr(0, 31), "0,compact,straight_braking_100,");
    EXPECT_EQ(lines("out")[2].substr(0, 27), "1,car,straight_braking_100,");
    campaign("title: Stops\nvehicles: [compakt]\nscenarios: [./straight_braking_100]\n");
    const Result unknown = drive("none");
    expectFault(unknown, scratch.path("compakt"));
    expectFault(unknown, scratch.path("straight_braking_100"));
}

TEST_F(TreadCampaign, DatabaseHasViewsAndDefinitions) {
    ASSERT_EQ(drive("out", {"--set", "samples=2"}).status, 0);
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open((folder("out") + "/results.sqlite").c_str(), &database), SQLITE_OK);
    const auto ask = [&](const std::string& question) {
        sqlite3_stmt* statement = nullptr;
        EXPECT_EQ(sqlite3_prepare_v2(database, question.c_str(), -1, &statement, nullptr), SQLITE_OK) << question;
        const bool row = sqlite3_step(statement) == SQLITE_ROW;
        const std::string answer = row ? reinterpret_cast<const char*>(sqlite3_column_text(statement, 0)) : "none";
        sqlite3_finalize(statement);
        return answer;
    };
    EXPECT_EQ(ask("SELECT count(*) FROM runs WHERE status = 'ok' AND vehicle = 'car'"), "6");
    EXPECT_EQ(ask("SELECT count(*) FROM metrics WHERE \"stopping_distance [m]\" > 0.5"), "6");
    EXPECT_EQ(ask("SELECT max(\"load.mass [kg]\") FROM factors"), "200.0");
    EXPECT_EQ(ask("SELECT unit FROM columns WHERE name = 'stopping_distance [m]' AND kind = 'metric'"), "m");
    EXPECT_EQ(ask("SELECT value FROM campaign WHERE key = 'title'"), "Stops");
    sqlite3_close(database);
}

// TREAD_KILLS=200 asks for as many.
TEST_F(TreadCampaign, KilledAtAnyMomentItGoesOnToTheSameBytes) {
    ASSERT_EQ(drive("whole").status, 0);
    const char* const asked = std::getenv("TREAD_KILLS");
    const int wanted = asked ? std::atoi(asked) : 20;
    int finished = 0;
    std::string name = "killed0";
    killAtRandom(
        wanted, std::chrono::milliseconds(300),
        [&] {
            return call(name, {"--threads", "2"});
        },
        [&] {
            if (!isDone(name)) return;
            EXPECT_EQ(bytesOf(name), bytesOf("whole"));
            name = "killed" + std::to_string(++finished);
        });
    const Result last = drive(name);
    EXPECT_EQ(last.status, 0) << last.err;
    EXPECT_EQ(last.err, "");
    EXPECT_EQ(bytesOf(name), bytesOf("whole"));
    EXPECT_EQ(lines(name).size(), 1u + kRuns);
    for (const auto& entry : fs::recursive_directory_iterator(folder(name)))
        EXPECT_NE(entry.path().extension(), ".part") << "left by a killed process";
}

TEST_F(TreadCampaign, CtrlCKeepsWhatIsDone) {
    Running program(call("out", {"--threads", "1", "--set", "samples=100"}), scratch.path("stdout"),
                    scratch.path("stderr"));
    while (!fs::exists(folder("out") + "/pieces") || pieces("out") < 2)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    program.send(SIGINT);
    EXPECT_EQ(program.waitForStatus(), 130);
    const std::string err = contentOf(scratch.path("stderr"));
    int runs = 0;
    ASSERT_EQ(std::sscanf(err.c_str(), "tread campaign: interrupted after %d runs", &runs), 1) << err;
    EXPECT_GE(runs, 8) << "two pieces were there";
    const Result status = runProgram({"campaign", "status", folder("out"), "--json"});
    EXPECT_EQ(status.status, 1);
    const auto json = nlohmann::json::parse(status.out);
    EXPECT_EQ(json["result"]["runs"].get<std::size_t>(), 4 * pieces("out"));
    EXPECT_GT(json["seconds_left_on_one_core"].get<double>(), 0);
    EXPECT_EQ(json["pieces_running"], 0);
    const Result partial = runProgram({"campaign", "merge", folder("out"), "--partial"});
    EXPECT_EQ(partial.status, 0) << partial.err;
    EXPECT_EQ(lines("out").size(), 1 + 4 * pieces("out"));
}

TEST_F(TreadCampaign, TwoCallsAtOnceShareTheWork) {
    ASSERT_EQ(drive("alone").status, 0);
    Running first(call("both", {"--threads", "1"}), scratch.path("out1"), scratch.path("err1"));
    Running second(call("both", {"--threads", "1"}), scratch.path("out2"), scratch.path("err2"));
    EXPECT_EQ(first.waitForStatus(), 0) << contentOf(scratch.path("err1"));
    EXPECT_EQ(second.waitForStatus(), 0) << contentOf(scratch.path("err2"));
    EXPECT_EQ(bytesOf("both"), bytesOf("alone"));
}

TEST_F(TreadCampaign, RunThatFailsIsARow) {
    campaign(replaced(kCampaign, "list: [0, 100 kg, 200 kg]}",
                      "list: [0]}\n  - {path: scenario.start.speed, list: [15 km/h, 900 km/h]}\n"
                      "  - {path: mass, list: [1350 kg, 0.01 kg]}"));
    const Result result = drive("out", {"--set", "samples=1"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(firstLine(result.out).starts_with("Stops: 4 runs, ")) << result.out;
    std::string failed;
    for (const std::string& line : lines("out"))
        failed += line.find(",failed,") != std::string::npos ? line + "\n" : "";
    EXPECT_NE(failed.find("\"the simulation broke down before the start, while the car settled on its wheels: "),
              std::string::npos)
        << failed;
    EXPECT_NE(contentOf(folder("out") + "/report.html").find("Failures"), std::string::npos);

    campaign(replaced(kCampaign, "list: [0, 100 kg, 200 kg]}",
                      "list: [0]}\n  - {path: scenario.start.speed, list: [900 km/h]}"));
    EXPECT_EQ(drive("none", {"--set", "samples=2"}).status, 3) << "none succeeded";
}

TEST_F(TreadCampaign, RunCanBeDrivenAgainFromTheFolderAlone) {
    ASSERT_EQ(drive("out", {"--set", "samples=2"}).status, 0);
    fs::remove(scratch.path("campaign.yaml"));
    fs::remove(scratch.path("stop.yaml"));
    fs::remove(scratch.path("car.yaml"));
    const Result again = runProgram({"campaign", folder("out"), "--run", "5", "--json"});
    ASSERT_EQ(again.status, 0) << again.err;
    const auto json = nlohmann::json::parse(again.out);
    EXPECT_TRUE(fs::exists(folder("out") + "/runs/5/report.html"));
    EXPECT_EQ(readLog(folder("out") + "/runs/5/log.csv").channels.front().name, "time");
    const std::string row = lines("out").at(6);
    for (const auto& metric : json["metrics"]) {
        if (metric["name"] != "stopping_distance") continue;
        EXPECT_NE(row.find("," + numberText(metric["value"].get<double>()) + ","), std::string::npos) << row;
    }
    // And the campaign goes on from it: a piece that is gone is computed again.
    const std::string before = bytesOf("out");
    fs::remove(folder("out") + "/pieces/000000000-000000003.piece");
    EXPECT_EQ(runProgram({"campaign", folder("out")}).status, 0);
    EXPECT_EQ(bytesOf("out"), before);
}

TEST_F(TreadCampaign, DamagedPieceIsNamedAndComputedAgain) {
    ASSERT_EQ(drive("out").status, 0);
    const std::string before = bytesOf("out"), piece = folder("out") + "/pieces/000000008-000000011.piece";
    std::string text = contentOf(piece);
    text[text.size() / 2] = '!';
    std::ofstream(piece) << text;
    const Result again = drive("out");
    EXPECT_EQ(again.status, 0);
    EXPECT_EQ(again.err,
              "warning: " + piece + " is damaged (its checksum does not fit); its runs are computed again\n");
    EXPECT_EQ(bytesOf("out"), before);
}

TEST_F(TreadCampaign, FolderOfAnotherCampaignIsRefusedWithTheDifference) {
    ASSERT_EQ(drive("out", {"--set", "samples=2"}).status, 0);
    expectFault(drive("out", {"--set", "samples=3"}),
                "/out/inputs.yaml: found the results of another campaign: in campaign it has \"samples: 2\" in line ");
    campaign(replaced(kCampaign, "samples: 20", "samples: 2"));
    car(carText("mass: 1350 kg", "mass: 1351 kg"));
    expectFault(drive("out"), "in vehicles.vehicle it has \"mass: 1350  # kg\" in line ");
}

TEST_F(TreadCampaign, FactorThatChangesNothingIsSaid) {
    campaign(kCampaign + "  \n");
    const Result result = drive("out", {"--dry-run", "--set", "factors.1.path=driveline.engine.idle_speed", "--set",
                                        "factors.1.list=[80, 90]"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(firstLine(result.out).starts_with("40 runs; about ")) << result.out;
    EXPECT_EQ(result.err.substr(0, 80),
              "warning: the factor driveline.engine.idle_speed changes nothing: all metrics are")
        << result.err;
    EXPECT_FALSE(fs::exists(folder("out")));
}

TEST_F(TreadCampaign, DiskThatIsTooSmallIsSaidBefore) {
    constexpr std::uintmax_t kAtLeast = 300'000'000'000;  // bytes of a table of 10^9 runs: 300 a run in any case
    if (fs::space(scratch.folder()).available > kAtLeast) GTEST_SKIP() << "this disk is not too small";
    const Result result =
        drive("out", {"--dry-run", "--set", "sampling=sobol", "--set", "samples=100000000", "--set",
                      "factors.1.list=[0, 1, 2, 3, 4, 5, 6, 7, 8, 9]", "--set", "runs_per_piece=100000"});
    expectFault(result, "out: the campaign needs ");
    EXPECT_NE(result.err.find(" are free; choose another folder with -o"), std::string::npos) << result.err;
}

TEST_F(TreadCampaign, FaultsHaveTheirPlace) {
    const std::string text = replaced(kCampaign, "path: load.mass", "path: load.mas");
    campaign(text);
    expectFault(drive("out"),
                "campaign.yaml:" + placeOf(text, "load.mas") +
                    ": factors.1.path: found the unknown path \"load.mas\", expected the path of a field; did "
                    "you mean \"load.mass\"?");
    const std::string empty = replaced(kCampaign, "list: [0, 100 kg, 200 kg]", "list: []");
    campaign(empty);
    expectFault(drive("out"), "found no values, expected one of list (with at least one value), grid, uniform, normal");
    const std::string twice = kCampaign + "correlated:\n  - {paths: [load.mass, mass], covariance: [[1, 2], [2, 1]]}\n";
    campaign(twice);
    expectFault(drive("out"), "campaign.yaml:" + placeOf(twice, "[[1, 2]") +
                                  ": correlated.0.covariance: found the covariance 2 in row 2, column 1");
    campaign();
    expectFault(drive("out", {"--shard", "4/3"}), "--shard: found \"4/3\", expected i/N");
    expectFault(drive("out", {"--run", "60"}), "--run: found 60, expected a run from 0 to 59");
    expectFault(runProgram({"campaign", scratch.folder()}), "found no inputs.yaml, expected the folder of a campaign");
    expectFault(runProgram({"campaign"}), "found no campaign, expected a file");
    expectFault(runProgram({"campaign", scratch.path("campaign.yaml"), "-o", "/proc/stops"}),
                "cannot create the folder /proc/stops: ");
    EXPECT_FALSE(fs::exists(folder("out")));
}

TEST_F(TreadCampaign, FullDiskKeepsWhatIsDone) {
    ASSERT_EQ(drive("whole").status, 0);
    ASSERT_EQ(drive("out", {"--shard", "1/2"}).status, 0);
    {
        const FileSizeLimit limit(800);  // bytes: no further piece fits
        expectFault(drive("out"), ".piece': File too large");
    }
    EXPECT_EQ(pieces("out"), 8u);
    EXPECT_EQ(drive("out").status, 0);
    EXPECT_EQ(bytesOf("out"), bytesOf("whole"));
}

TEST_F(TreadCampaign, LogsAreKeptAndConverted) {
    ASSERT_EQ(drive("out", {"--set", "samples=1", "--set", "logs=true"}).status, 0);
    const std::string log = folder("out") + "/logs/000000002.tlog";
    ASSERT_EQ(runProgram({"log", log, "-o", scratch.path("x.csv")}).status, 0);
    ASSERT_EQ(runProgram({"campaign", folder("out"), "--run", "2"}).status, 0);
    EXPECT_EQ(contentOf(scratch.path("x.csv")), contentOf(folder("out") + "/runs/2/log.csv"));
    EXPECT_EQ(runProgram({"compare", folder("out") + "/runs/2/log.csv", log}).status, 0) << "read as it is";
    std::ofstream(scratch.path("bad.tlog"), std::ios::binary) << contentOf(log).substr(0, 200);
    expectFault(runProgram({"log", scratch.path("bad.tlog")}), "found a damaged Zstandard frame");
}

TEST_F(TreadCampaign, PageShowsLimitsEffectsAndWorstRuns) {
    campaign(kCampaign + "accept: {stopping_distance: \"< 1.4 m\"}\n");
    ASSERT_EQ(drive("out").status, 0);
    const std::string page = contentOf(folder("out") + "/report.html");
    for (const char* words : {"wanted &lt; 1.4 m", "Main effects", "load.mass", "Worst runs", " --run "})
        EXPECT_NE(page.find(words), std::string::npos) << words;
}

// ---- Slurm ----

// A program of that name that is found first.
class FakePath {
public:
    FakePath(const Scratch& scratch, const std::string& script) : before_(std::getenv("PATH")) {
        fs::create_directories(scratch.path("bin"));
        if (!script.empty()) {
            const std::string file = scratch.file("bin/sbatch", "#!/bin/sh\n" + script);
            fs::permissions(file, fs::perms::owner_all);
        }
        setenv("PATH", script.empty() ? scratch.path("bin").c_str() : (scratch.path("bin") + ":" + before_).c_str(), 1);
    }
    ~FakePath() { setenv("PATH", before_.c_str(), 1); }

private:
    std::string before_;
};

TEST_F(TreadCampaign, SlurmScriptsAreWrittenAndSubmitted) {
    Names slurm{"campaign", "slurm", scratch.path("campaign.yaml"), "-o", folder("out"), "--tasks", "3", "--submit"};
    {
        const FakePath none(scratch, "");
        expectFault(runProgram(slurm), "found no sbatch: Slurm is not installed on this machine; the scripts are in ");
    }
    {
        const FakePath refuses(scratch, "echo 'sbatch: error: invalid partition specified: none' >&2; exit 1\n");
        expectFault(runProgram(slurm), "Slurm refuses ");
    }
    const FakePath takes(scratch, "echo \"$@\" >> " + scratch.path("calls") + "; echo 4711\n");
    const Result result = runProgram(slurm);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(firstLine(result.out), "submitted 3 tasks in job 4711, the merge in job 4711");
    const std::string array = folder("out") + "/slurm/array.sh", join = folder("out") + "/slurm/merge.sh";
    EXPECT_EQ(contentOf(scratch.path("calls")),
              "--parsable " + array + "\n--parsable --dependency=afterany:4711 " + join + "\n");
    // The tasks in any order, one of them lost; the merge job makes up for it.
    for (const char* task : {"3", "1"}) {
        setenv("SLURM_ARRAY_TASK_ID", task, 1);
        EXPECT_EQ(std::system(("sh " + array).c_str()), 0);
    }
    unsetenv("SLURM_ARRAY_TASK_ID");
    EXPECT_FALSE(isDone("out"));
    EXPECT_EQ(std::system(("sh " + join + " > /dev/null").c_str()), 0);
    ASSERT_EQ(drive("local").status, 0);
    EXPECT_EQ(bytesOf("out"), bytesOf("local"));
}

// A real cluster of two nodes on this machine.
class Cluster {
public:
    explicit Cluster(const Scratch& scratch) : folder_(scratch.path("slurm")) {
        fs::create_directories(folder_);
        fs::permissions(scratch.folder(), fs::perms(0755));  // its daemon of authentication is another user
        const int port = 20000 + getpid() % 20000;           // three ports, others' tests may run beside this one
        runs = std::system((kScript + "start " + folder_ + " " + std::to_string(port)).c_str()) == 0;
        setenv("SLURM_CONF", (folder_ + "/slurm.conf").c_str(), 1);
    }
    ~Cluster() {
        if (std::system((kScript + "stop " + folder_).c_str()) != 0) ADD_FAILURE() << "the cluster did not stop";
        unsetenv("SLURM_CONF");
    }
    bool runs = false;

private:
    const std::string kScript = "bash " + sourceFile("tests/cli/slurm_one_machine.sh") + " ";
    std::string folder_;
};

// One task is killed, one is begun anew; the merge job ends with the bytes of local threads.
TEST_F(TreadCampaign, SlurmTasksMayDie) {
    for (const char* daemon : {"/usr/sbin/slurmctld", "/usr/sbin/slurmd", "/usr/sbin/munged", "/usr/bin/sbatch"})
        if (!fs::exists(daemon)) GTEST_SKIP() << "Slurm is not installed here: there is no " << daemon;
    if (geteuid() != 0) GTEST_SKIP() << "a cluster on one machine needs root";
    const Cluster cluster(scratch);
    if (!cluster.runs) GTEST_SKIP() << "Slurm does not start on this machine";
    const Names size{"--set", "samples=150"};
    Names slurm{"campaign", "slurm", scratch.path("campaign.yaml"), "-o", folder("out"), "--tasks", "2",
                "--submit", "--json"};
    slurm.insert(slurm.end(), size.begin(), size.end());
    const Result result = runProgram(slurm);
    ASSERT_EQ(result.status, 0) << result.err;
    const std::string job = nlohmann::json::parse(result.out)["array_job"];
    const auto wait = [](const auto& reached) {
        for (int i = 0; i < 600 && !reached(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(100));
        return reached();
    };
    ASSERT_TRUE(wait([&] { return pieces("out") >= 10; }));
    EXPECT_EQ(std::system(("scancel --signal=KILL --full " + job + "_1").c_str()), 0);
    EXPECT_EQ(std::system(("scontrol requeue " + job + "_2 2> /dev/null").c_str()), 0);
    ASSERT_TRUE(wait([&] { return isDone("out"); })) << contentOf(folder("out") + "/slurm/merge.log");
    ASSERT_EQ(drive("local", size).status, 0);
    EXPECT_EQ(bytesOf("out"), bytesOf("local"));
}

// ---- Scenarios with a search, and with numbers from other scenarios ----

TEST_F(TreadCampaign, MetricOfASearchIsTheHighestValueThatPasses) {
    const std::string search = kSource + "/scenarios/obstacle_avoidance.yaml";
    campaign("title: Entry speeds\nvehicles: [car.yaml]\nscenarios: [" + search + R"(]
settings: [scenario.series.highest.resolution=2 km/h]
factors:
  - {path: scenario.road.friction, list: [0.6, 1, 0.1]}
accept: {highest_start.speed: "> 15 m/s"}
logs: true
)");
    const Result result = drive("out");
    ASSERT_EQ(result.status, 0) << result.err;
    const auto table = lines("out");
    ASSERT_EQ(table.size(), 4u);
    EXPECT_TRUE(table[0].ends_with("scenario.road.friction [-],highest_start.speed [m/s]")) << table[0];
    const auto speedOf = [&](std::size_t run) { return std::stod(table[run].substr(table[run].rfind(',') + 1)); };
    EXPECT_NE(table[1].find(",rejected,"), std::string::npos) << table[1];
    EXPECT_NE(table[2].find(",ok,"), std::string::npos) << table[2];
    EXPECT_LT(speedOf(1), speedOf(2));
    EXPECT_NE(table[3].find("no_metrics,\"no run passes, not even with start.speed = 45 km/h\""), std::string::npos)
        << table[3];

    // The same as `tread run` finds, and the log is that of the highest value.
    ASSERT_EQ(runProgram({"run", scratch.path("car.yaml"), search, "-o", folder("alone"), "--set",
                          "scenario.series.highest.resolution=2 km/h"})
                  .status,
              0);
    const nlohmann::json found = nlohmann::json::parse(contentOf(folder("alone") + "/metrics.json"));
    EXPECT_EQ(found["metrics"][0]["value"].get<double>(), speedOf(2));
    ASSERT_EQ(runProgram({"log", folder("out") + "/logs/000000001.tlog", "-o", scratch.path("1.csv")}).status, 0);
    EXPECT_NEAR(readLog(scratch.path("1.csv")).find("chassis.vx")->values.front(), speedOf(2), 0.01);
}

TEST_F(TreadCampaign, SearchAndVariationAreNotTheSame) {
    campaign("title: Varied\nvehicles: [car.yaml]\nscenarios: [" + kSource +
             "/scenarios/sine_with_dwell_series.yaml]\nfactors: [{path: load.mass, list: [0, 100 kg]}]\n");
    expectFault(drive("out"),
                "scenarios.0: found a scenario with series.vary, which gives several values of each "
                "metric, expected one value; make phases.1.steering.sine_with_dwell.amplitude a factor");
}

// The steering of the fishhook is a multiple of an angle that another scenario gives for each car.
TEST_F(TreadCampaign, NumbersFromOtherScenariosAreFoundForEachCar) {
    const std::string fishhook = kSource + "/scenarios/fishhook_1a.yaml";
    campaign("title: Fishhooks\nvehicles: [car.yaml]\nscenarios: [" + fishhook +
             "]\nfactors: [{path: load.mass, list: [0, 300 kg]}]\nlogs: true\n");
    ASSERT_EQ(drive("out").status, 0);
    ASSERT_EQ(
        runProgram({"run", scratch.path("car.yaml"), fishhook, "-o", folder("alone"), "--set", "load.mass=300 kg"})
            .status,
        0);
    ASSERT_EQ(runProgram({"log", folder("out") + "/logs/000000001.tlog", "-o", scratch.path("1.csv")}).status, 0);
    const auto steering = [](const std::string& file) {
        return readLog(file).find("driver.steering_wheel_angle")->values;
    };
    EXPECT_EQ(steering(scratch.path("1.csv")), steering(folder("alone") + "/log.csv"));
}

// ---- The shipped campaigns ----

TEST_F(TreadCampaign, ShippedOnesRunAtASmallSize) {
    const auto small = [&](const std::string& name, const Names& more) {
        Names words{"campaign", kSource + "/scenarios/campaigns/" + name + ".yaml", "-o", folder(name)};
        words.insert(words.end(), more.begin(), more.end());
        const Result result = runProgram(words);
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.err, "") << name;
        for (const std::string& line : lines(name)) EXPECT_EQ(line.find(",failed,"), std::string::npos) << line;
        return lines(name).size() - 1;
    };
    EXPECT_EQ(small("lane_change_tolerances", {"--set", "samples=2"}), 16u);
    EXPECT_EQ(small("braking_friction_load",
                    {"--set", "samples=1", "--set", "factors.0.grid.count=2", "--set", "factors.1.list=[0, 300 kg]"}),
              16u);
    EXPECT_EQ(small("sine_with_dwell_fleet", {"--set", "samples=1"}), 32u);
}

}  // namespace
}  // namespace tread::campaign_test
