// How well the numbers of a car are known after the car before its change was fitted.
#include "diagnose/select/car_before.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "shared/vehicle_run.h"

namespace tread::diagnose_car_before_test {
namespace {

using diagnose::answer::NuisanceEstimate;
using diagnose::select::tolerancesAfter;
using recording::DiagnosisFile;
using recording::KnownWithin;

const std::string kToe = "rear.suspension.toe";
const NuisanceEstimate kWithin{.value = 0.003, .sd = 0.0005, .nominal = 0.002, .prior_sd = 0.001, .z = 1};
const NuisanceEstimate kBeyond{.value = -0.014, .sd = 0.0005, .nominal = 0.002, .prior_sd = 0.003, .z = -5.3};

DiagnosisFile fileWithToe() {
    DiagnosisFile file;
    file.tolerances = {{kToe, 0, 0.004}};
    return file;
}

// The last one counts.
double toleranceOf(const std::string& path, const DiagnosisFile& file, const NuisanceEstimate& moved) {
    recording::Subject nominal;
    nominal.vehicle = shared::compact();
    const std::vector<KnownWithin> all = tolerancesAfter(nominal, file, {{path, moved}});
    return std::find_if(all.rbegin(), all.rend(), [&](const KnownWithin& one) { return one.path == path; })->absolute;
}

TEST(CarBefore, NumberMovedBeyondItsUncertaintyIsKnownToThatDistance) {
    const DiagnosisFile file = fileWithToe();
    EXPECT_NEAR(toleranceOf(kToe, file, kWithin), 0.004, 1e-12) << "as the file tells";
    EXPECT_NEAR(toleranceOf(kToe, file, kBeyond), 0.016, 1e-12);
}

TEST(CarBefore, NumbersAreKnownAsTheFitLeavesThemWhereNothingIsSubtracted) {
    DiagnosisFile file = fileWithToe();
    file.before.emplace_back();
    EXPECT_NEAR(toleranceOf(kToe, file, kWithin), std::hypot(std::sqrt(3.0) * 0.0005, 0.2 * 0.004), 1e-12);
    EXPECT_NEAR(toleranceOf(kToe, file, kBeyond), std::hypot(std::sqrt(3.0) * 0.0005, 0.2 * 0.016), 1e-12);
    // The road is another one on another day.
    const std::string bank = "road.bank";
    file.tolerances.push_back({bank, 0, 0.004});
    EXPECT_NEAR(toleranceOf(bank, file, kWithin), std::hypot(std::sqrt(3.0) * 0.0005, 0.004), 1e-12);
}

}  // namespace
}  // namespace tread::diagnose_car_before_test
