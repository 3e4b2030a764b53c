// Cars of another simulator after one thing was changed, beside the same drives before. What was changed is not told:
// what is found must explain the gap, with one cause that is surer than any other. The logs are not part of this
// project: the test is skipped where TREAD_SHARED_DATA does not name their folder.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/catalogue/effects_to_consider.h"
#include "diagnose/diagnose.h"
#include "places/places.h"
#include "recording/diagnosis_file.h"

namespace tread::other_simulator_test {
namespace {

using diagnose::answer::Diagnosis;
using diagnose::answer::Verdict;
using diagnose::catalogue::effectsToConsider;
using recording::DiagnosisFile;
using recording::loadDiagnosis;
using recording::nominalSubject;
using recording::readRecordings;

struct Changed {
    const char* folder;
    const char* cause;
};

class OtherSimulator : public testing::TestWithParam<Changed> {};

TEST_P(OtherSimulator, ChangeIsNamedFirstAndExplainsTheGap) {
    const char* data = std::getenv("TREAD_SHARED_DATA");
    if (!data) GTEST_SKIP() << "TREAD_SHARED_DATA is not set";
    const std::filesystem::path logs = std::filesystem::path(data) / "chrono" / GetParam().folder;
    ASSERT_TRUE(std::filesystem::exists(logs)) << logs;
    const DiagnosisFile file = loadDiagnosis(sourceFile("scenarios/diagnose/chrono_case.yaml"), logs);
    const Diagnosis d =
        diagnose::diagnosisOf(nominalSubject(file), file, readRecordings(file), effectsToConsider(file));
    EXPECT_EQ(d.verdict, Verdict::explained) << d.answer;
    ASSERT_FALSE(d.causes.empty());
    EXPECT_EQ(d.effects.front().name, GetParam().cause);
    EXPECT_GT(d.effects.front().probability, 0.9);
    EXPECT_LT(d.how_far.held_out.extended, 1.1);
    EXPECT_LT(d.how_far.training.extended, 0.9 * d.how_far.training.nominal);
}

INSTANTIATE_TEST_SUITE_P(Cases, OtherSimulator,
                         testing::Values(Changed{"case_a", "brake_balance"}, Changed{"case_b", "aero_drag"}));

}  // namespace
}  // namespace tread::other_simulator_test
