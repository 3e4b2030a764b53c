// Scenarios against their golden logs. `tests_golden --update` renews the logs (see tools/update_golden).

#include <gtest/gtest.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "golden/golden_run.h"
#include "log/csv.h"

namespace tread {
namespace {

constexpr std::uintmax_t kLargestFile = 60'000;  // bytes: golden logs live in the repository

class Golden : public testing::TestWithParam<std::string> {};

TEST_P(Golden, RunIsAsItWas) {
    const std::string& name = GetParam();
    const Comparison comparison = golden::compareToGolden(name, golden::run(name, golden::car()));
    EXPECT_TRUE(comparison.same) << text(comparison) << "\nIf the change is meant, `tools/update_golden " << name
                                 << "` shows it and renews the log.";
}

TEST_P(Golden, LogIsSmall) {
    EXPECT_LT(std::filesystem::file_size(golden::fileOf(GetParam())), kLargestFile);
}

INSTANTIATE_TEST_SUITE_P(Scenario, Golden, testing::ValuesIn(golden::names()),
                         [](const auto& scenario) { return scenario.param; });

TEST(GoldenLogs, ShowAThousandthOfTheMass) {
    VehicleParams heavier = golden::car();
    heavier.mass *= 1.001;
    const Comparison comparison = golden::compareToGolden("step_steer_80", golden::run("step_steer_80", heavier));
    EXPECT_FALSE(comparison.same);
    EXPECT_GT(comparison.differing(), 10u) << text(comparison);
}

TEST(GoldenLogs, EachBelongsToAScenario) {
    const std::vector<std::string> scenarios = golden::scenarios();
    for (const std::string& name : golden::names()) {
        EXPECT_TRUE(std::binary_search(scenarios.begin(), scenarios.end(), name)) << name << " has no scenario";
    }
    EXPECT_GE(golden::names().size(), 10u);
}

// ---- Renewal ----

bool confirmed(std::size_t logs) {
    std::cout << "Overwrite " << logs << (logs == 1 ? " log" : " logs") << "? [y/N] " << std::flush;
    std::string answer;
    std::getline(std::cin, answer);
    return answer == "y" || answer == "Y" || answer == "yes";
}

// Runs the scenarios of these names (none: all that have a golden log), shows channel by channel what is out of
// tolerance, asks, writes.
int update(std::vector<std::string> wanted, bool ask) {
    const std::vector<std::string> known = golden::scenarios();
    if (wanted.empty()) wanted = golden::names();
    std::vector<std::pair<std::string, Log>> changed;
    for (const std::string& name : wanted) {
        if (!std::binary_search(known.begin(), known.end(), name)) {
            std::cerr << "update_golden: there is no scenarios/" << name << ".yaml\n";
            return 2;
        }
        Log log = golden::run(name, golden::car());
        if (!std::filesystem::exists(golden::fileOf(name))) {
            std::cout << name << ": new\n";
        } else {
            const Comparison comparison = golden::compareToGolden(name, log);
            const std::string found = text(comparison, comparison.channels.size());
            std::cout << name << ": " << (comparison.same ? found.substr(0, found.find('\n')) : found) << '\n';
            if (comparison.same) continue;
        }
        changed.emplace_back(name, std::move(log));
    }
    if (changed.empty()) std::cout << "All golden logs are up to date.\n";
    if (changed.empty()) return 0;
    if (ask && !confirmed(changed.size())) return 1;
    for (const auto& [name, log] : changed) writeLog(golden::fileOf(name), log);
    return 0;
}

}  // namespace
}  // namespace tread

int main(int argc, char** argv) {
    std::vector<std::string> words(argv + 1, argv + argc);
    if (words.empty() || words.front() != "--update") {
        testing::InitGoogleTest(&argc, argv);
        return RUN_ALL_TESTS();
    }
    words.erase(words.begin());
    const bool ask = std::erase(words, "--yes") == 0;
    try {
        return tread::update(words, ask);
    } catch (const std::exception& error) {
        std::cerr << "update_golden: " << error.what() << '\n';
        return 2;
    }
}
