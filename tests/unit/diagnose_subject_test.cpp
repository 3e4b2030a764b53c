#include <gtest/gtest.h>

#include <set>

#include "base/fields/numbers.h"
#include "recording/subject.h"

namespace tread::diagnose_subject_test {
namespace {

using recording::numberAt;
using recording::Subject;

TEST(DiagnosisSubject, CarKeepsItsPathsBesideRoadWindAndInstruments) {
    Subject subject;
    EXPECT_EQ(numberAt(subject, "mass"), &subject.vehicle.mass);
    EXPECT_EQ(numberAt(subject, "front.tyre.lambda.Ky"), &subject.vehicle.front.tyre.lambda.Ky);
    EXPECT_EQ(numberAt(subject, "road.grade"), &subject.road.grade);
    EXPECT_EQ(numberAt(subject, "wind.speed"), &subject.wind.speed);
    EXPECT_EQ(numberAt(subject, "instruments.yaw_rate.delay"), &subject.instruments.yaw_rate.delay);
    EXPECT_EQ(numberAt(subject, "instruments.yaw_rate.colour"), nullptr);
}

TEST(DiagnosisSubject, NoPathIsTakenTwice) {
    Subject subject;
    std::set<std::string> paths;
    for (const Number& number : numbers(subject)) EXPECT_TRUE(paths.insert(number.path).second) << number.path;
}

}  // namespace
}  // namespace tread::diagnose_subject_test
