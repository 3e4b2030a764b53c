// Every access to a file fails once, in every way that the tests know (faults/faults.cpp): the program says so in one
// sentence, what was there is whole, and the next call gives what an undisturbed one gives.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "cli/answered_check.h"
#include "cli/kept_files.h"
#include "cli/logs.h"
#include "cli/tread_run.h"
#include "log/csv.h"
#include "store/result_folder.h"

namespace tread::faults_test {
namespace {

namespace fs = std::filesystem;

// While it lives, programs that are started have their files disturbed.
class Disturbed {
public:
    Disturbed(const std::string& fault, const std::string& calls) {
        setenv("LD_PRELOAD", TREAD_FAULTS_LIBRARY, 1);
        if (!fault.empty()) setenv("TREAD_FAULT", fault.c_str(), 1);
        if (!calls.empty()) setenv("TREAD_CALLS", calls.c_str(), 1);
    }
    ~Disturbed() {
        for (const char* const name : {"LD_PRELOAD", "TREAD_FAULT", "TREAD_CALLS"}) unsetenv(name);
    }
    Disturbed(const Disturbed&) = delete;
    Disturbed& operator=(const Disturbed&) = delete;
};

// Without the process and the count that a temporary name holds, and without hashes.
std::string withoutMaker(const std::string& path) {
    static const std::regex maker(R"(\.[^./]*\.[0-9]+\.[0-9]+\.tread\.part)"), hash("[0-9a-f]{64}");
    return std::regex_replace(std::regex_replace(path, maker, ".part"), hash, "hash");
}

struct Call {
    long number;
    std::string what;  // function and file
};

std::vector<Call> callsIn(const std::string& file) {
    std::vector<Call> calls;
    std::istringstream lines(contentOf(file));
    for (std::string line; std::getline(lines, line);) {
        const std::size_t space = line.find(' ');
        calls.push_back({std::stol(line.substr(0, space)), withoutMaker(line.substr(space + 1))});
    }
    return calls;
}

// Functions that a way of failing concerns; empty: all.
const std::map<std::string, std::set<std::string>> kConcerned{
    {"error", {}},
    {"full", {"open", "write", "pwrite", "pwrite64", "mkdir", "ftruncate"}},
    {"short", {"read", "pread", "pread64", "fread", "write", "pwrite", "pwrite64"}},
    {"interrupt", {"open", "read", "write", "fsync", "flock", "ftruncate"}},
    {"kill", {"write", "pwrite", "pwrite64", "mkdir", "fsync", "flock", "rename", "remove", "unlink"}}};

// The first call of each function on each file; where what is left behind depends on it, the last one, too.
std::set<long> eachKind(const std::vector<Call>& calls, const std::string& how, const std::vector<std::string>& only) {
    std::map<std::string, std::pair<long, long>> ends;
    const std::set<std::string>& concerned = kConcerned.at(how);
    for (const Call& call : calls) {
        if (!concerned.empty() && !concerned.contains(call.what.substr(0, call.what.find(' ')))) continue;
        const auto is_end = [&](const std::string& end) { return call.what.ends_with(end); };
        if (!only.empty() && std::none_of(only.begin(), only.end(), is_end)) continue;
        const auto [known, is_new] = ends.emplace(call.what, std::pair(call.number, call.number));
        if (!is_new) known->second.second = call.number;
    }
    std::set<long> numbers;
    for (const auto& [what, pair] : ends) {
        numbers.insert(pair.first);
        if (how == "full" || how == "kill") numbers.insert(pair.second);
    }
    return numbers;
}

struct Command {
    std::string name;
    std::set<std::string> ways;                    // in which its files fail; the time of all tests is bounded
    std::vector<std::vector<std::string>> before;  // calls that make what is there before
    std::vector<std::string> words;                // "@" stands for the folder
    std::vector<std::string> volatile_files = {};  // the ends of their names: they hold times
    std::vector<std::string> only = {};            // the ends of the names of files that fail; none: all
    int status = 0;                                // of an undisturbed call
};
std::ostream& operator<<(std::ostream& out, const Command& command) {
    return out << command.name;
}

const std::string kShort = kShortStop + "log: {rate: 50, channels: [chassis.*, driver.*]}\n";

const std::string kStops = R"(title: Stops
vehicles: [car.yaml]
scenarios: [short.yaml]
factors:
  - {path: scenario.road.friction, uniform: {from: 0.6, to: 1}}
samples: 2
runs_per_piece: 1
)";

const std::string kDiagnosis =
    "vehicle: car.yaml\nrecordings: [{log: drive.csv, speed: followed}]\neffects: [steering_delay]\n";

class Faults : public TreadRun, public testing::WithParamInterface<Command> {
protected:
    void SetUp() override {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        GTEST_SKIP() << "a sanitizer stands before libc itself";
#endif
        fs::create_directory(place());
        for (const auto& [name, text] : Files{{"car.yaml", carText()},
                                              {"short.yaml", kShort},
                                              {"stops.yaml", kStops},
                                              {"diagnosis.yaml", kDiagnosis}})
            fs::copy_file(scratch.file("input", text), place(name), fs::copy_options::overwrite_existing);
        writeLog(place("log.csv"), cli::stepSteer());
        for (const std::string cause : {"mass", "drag_area"})
            AnsweredCheck(cause).write(place("check"), place("score/answers"), place(cause + ".key.json"));
        Log drive = cli::stepSteer();
        for (Channel& channel : drive.channels) channel.values.resize(150);
        writeLog(place("drive.csv"), drive);
        for (const auto& words : GetParam().before) {
            const Result made = runProgram(placed(words));
            ASSERT_LE(made.status, 1) << made.err;
        }
        before_ = files();
    }

    std::string place(const std::string& name = "") const {
        return scratch.path("place") + (name.empty() ? "" : "/" + name);
    }
    std::vector<std::string> placed(std::vector<std::string> words) const {
        for (std::string& word : words)
            if (word.starts_with("@")) word = place(word.substr(1));
        return words;
    }
    Result call() const {
        return runProgram(placed(GetParam().words));
    }

    Files files() const {
        return filesIn(place());
    }
    bool isVolatile(const std::string& name) const {
        for (const std::string& file : GetParam().volatile_files)
            if (name.ends_with(file)) return true;
        return false;
    }
    Files comparable(Files all) const {
        std::erase_if(all, [&](const auto& file) { return isVolatile(file.first); });
        return all;
    }
    static int faultsIn(const std::string& text) {
        int faults = 0;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) faults += line.starts_with("warning: ") ? 0 : 1;
        return faults;
    }

    // Whatever happened, each file is the old one, the new one, or says what it is; its folder is of one call, or says
    // that it is not.
    void expectNothingSpoilt(const Files& after, bool killed) const {
        std::map<std::string, std::set<std::string>> of_folder;  // "old", "new"
        for (const auto& [name, content] : after) {
            const std::string file = fs::path(name).filename().string(), folder = fs::path(name).parent_path().string();
            const bool says = file == kIncomplete || name.find(".incomplete.") != std::string::npos || file == "claims";
            if (says || isVolatile(name)) continue;
            if (file.ends_with(".tread.part")) {
                EXPECT_TRUE(killed) << name << " is left";
                continue;
            }
            const auto old = before_.find(name), now = after_.find(name);
            const bool is_old = old != before_.end() && old->second == content;
            const bool is_new = now != after_.end() && now->second == content;
            EXPECT_TRUE(is_old || is_new) << name << " is neither the old nor the new one";
            if (!is_old) of_folder[folder].insert("new");
            else if (!is_new) of_folder[folder].insert("old");
        }
        for (const auto& [folder, ages] : of_folder) {
            const bool is_marked = after.contains((folder.empty() ? "" : folder + "/") + kIncomplete);
            EXPECT_TRUE(ages.size() < 2 || is_marked || after.contains(std::string(kIncomplete)))
                << "old and new files in the folder '" << folder << "': " << namesOf(after);
        }
        for (const auto& [name, content] : before_) {  // inputs, and files of others
            const auto now = after_.find(name);
            const bool stays = now != after_.end() && now->second == content;
            EXPECT_TRUE(!stays || after.contains(name)) << name << " is lost";
        }
    }

    Files before_, after_;
};

TEST_P(Faults, SpoilNothing) {
    const std::string calls = scratch.path("calls");
    {
        const Disturbed watched("", calls);
        const Result result = call();
        ASSERT_EQ(result.status, GetParam().status) << result.err;
    }
    after_ = files();
    const std::vector<Call> all = callsIn(calls);
    ASSERT_GT(all.size(), 3u);
    int failed = 0;
    for (const std::string& how : GetParam().ways) {
        for (const long number : eachKind(all, how, GetParam().only)) {
            SCOPED_TRACE(how + " in " + std::to_string(number) + " " + all[static_cast<std::size_t>(number - 1)].what);
            putBack(before_, place());
            Result result;
            {
                const Disturbed disturbed(how + ":" + std::to_string(number), "");
                result = call();
            }
            const Files after = files();
            if (result.status == GetParam().status) {
                EXPECT_EQ(comparable(after) == comparable(after_), true) << namesOf(after) << "\n" << namesOf(after_);
            } else if (how == "kill") {
                EXPECT_EQ(result.status, -1);
                ++failed;
            } else {
                EXPECT_TRUE(result.status == 2 || result.status == 3) << result.status;
                EXPECT_EQ(faultsIn(result.err), 1) << result.err;
                EXPECT_NE(how, "short") << result.err;
                ++failed;
            }
            expectNothingSpoilt(after, how == "kill");
            if (HasFailure()) return;  // one is enough to see
            if (result.status == GetParam().status) continue;
            const Disturbed not_at_all("", "");
            const Result next = call();
            EXPECT_EQ(next.status, GetParam().status) << next.err;
            EXPECT_EQ(comparable(files()) == comparable(after_), true) << namesOf(files()) << "\n" << namesOf(after_);
            if (HasFailure()) return;
        }
    }
    EXPECT_GT(failed, 0);
}

const std::set<std::string> kAll{"error", "full", "short", "interrupt", "kill"};
const std::vector<std::string> kRun{"run", "@car.yaml", "@short.yaml", "-o", "@out"};
std::vector<std::string> with(std::vector<std::string> words, const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}
const std::vector<std::string> kOld{"--set", "mass=1400", "--set", "load.mass=50"};
const std::vector<std::string> kCampaign{"campaign", "@stops.yaml", "-o", "@out", "--threads", "1"};

INSTANTIATE_TEST_SUITE_P(
    Of, Faults,
    testing::Values(Command{"Run", kAll, {with(kRun, kOld)}, kRun},
                    Command{"Update",
                            {"error", "kill"},
                            {{"run", "@car.yaml", "@short.yaml", "-o", "@new"},
                             with({"run", "@car.yaml", "@short.yaml", "-o", "@base"}, kOld)},
                            {"compare", "@base", "@new", "--update"}},
                    Command{"Import", kAll, {}, {"import", "@log.csv", "-o", "@imported.csv"}},
                    Command{"Mcap", kAll, {}, {"log", "@log.csv", "-o", "@log.mcap"}},
                    Command{"Sheet", {"full"}, {}, {"describe", "@car.yaml", "--report", "@sheet.html"}},
                    Command{"Schema", {"error", "kill"}, {}, {"schema", "tyre", "-o", "@tyre.json"}},
                    Command{"Fmu", {"full"}, {}, {"fmu", "@car.yaml", "-o", "@car.fmu"}, {}, {"car.fmu.part"}},
                    Command{"Diagnosis",
                            {"full"},
                            {},
                            {"diagnose", "@diagnosis.yaml", "-o", "@answer", "--threads", "1"},
                            {"diagnosis.json", "report.html"},
                            {"hash.part", "diagnosis.json.part"},
                            1},
                    Command{"Cases",
                            {"kill"},
                            {},
                            {"blind", "make", "--cases", "1", "--seed", "3", "--kinds", "none", "--drives",
                             "step_steers", "--vehicle", "@car.yaml", "-o", "@cases"},
                            {},
                            {"cases.key.json", "cases/INCOMPLETE"}},
                    Command{"Score",
                            {"error", "full", "kill"},
                            {{"blind", "score", "@check", "@mass.key.json", "-o", "@score"}},
                            {"blind", "score", "@check", "@drag_area.key.json", "-o", "@score"}},
                    // The case is empty: its answer says that it cannot be diagnosed.
                    Command{"Answer",
                            {"error", "kill"},
                            {},
                            {"blind", "score", "@check", "@mass.key.json", "-o", "@scored"},
                            {},
                            {},
                            3},
                    Command{"Campaign", {"error", "full"}, {}, kCampaign, {"timings.csv", "report.html", ".piece"}},
                    Command{"Resume",
                            {"kill"},
                            {with(kCampaign, {"--shard", "1/2"})},
                            kCampaign,
                            {"timings.csv", "report.html", ".piece"}},
                    Command{"Merge",
                            {"error", "kill"},
                            {with(kCampaign, {"--shard", "1/2"}),
                             {"campaign", "@stops.yaml", "-o", "@two", "--shard", "2/2"}},
                            {"campaign", "merge", "@out", "@two", "-o", "@all"},
                            {"timings.csv", "report.html", ".piece"}}),
    [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace tread::faults_test
