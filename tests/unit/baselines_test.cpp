// What simpler methods answer, on linear models that can be solved by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/diagnose.h"
#include "diagnose/select/baselines.h"
#include "shared/simple_car.h"

namespace tread::baselines_test {
namespace {

using diagnose::answer::Baselines;
using diagnose::answer::Diagnosis;
using diagnose::select::largestReduction;
using diagnose::select::leastBic;
using diagnose::select::LinearEffect;
using diagnose::select::reduction;

// Of one number that moves a sum of squares `column`, with so large a product with the residual.
LinearEffect effect(const std::string& name, double column, double with_residual, double highest = 4) {
    LinearEffect one{
        name, Eigen::MatrixXd(2, 2), {Eigen::VectorXd::Constant(1, -4), Eigen::VectorXd::Constant(1, highest)}};
    one.products << column, with_residual, with_residual, 1000;
    return one;
}

TEST(Baselines, ReductionIsTheSquareOfTheProjectionOnTheColumn) {
    EXPECT_NEAR(reduction(effect("a", 100, 30)), 30.0 * 30 / 100, 1e-12);
    // The best would be 2; at the bound 1 it is 2 * 200 - 100.
    EXPECT_NEAR(reduction(effect("a", 100, 200, 1)), 300, 1e-12);
    EXPECT_EQ(reduction(effect("a", 0, 0)), 0);
    LinearEffect pair{
        "pair", Eigen::MatrixXd(3, 3), {Eigen::VectorXd::Constant(2, -9), Eigen::VectorXd::Constant(2, 9)}};
    pair.products << 4, 0, 8, 0, 25, 50, 8, 50, 1000;
    EXPECT_NEAR(reduction(pair), 64.0 / 4 + 2500.0 / 25, 1e-9);
}

TEST(Baselines, LargestReductionClaimsWhateverTakesMoreThanItsNumbers) {
    EXPECT_EQ(largestReduction({effect("a", 100, 30), effect("b", 1, 3.5), effect("c", 100, 5)}), "b");
    EXPECT_EQ(largestReduction({effect("a", 100, 11)}), "a");  // 1.21
    EXPECT_EQ(largestReduction({effect("a", 100, 9)}), "none");
    EXPECT_EQ(largestReduction({}), "none");
}

TEST(Baselines, BicAsksTheLogarithmOfTheRowsForEachNumber) {
    // A reduction of 9 against ln(1000) = 6.9 and ln(20000) = 9.9.
    const std::vector<LinearEffect> effects{effect("a", 100, 30), effect("b", 100, 20)};
    EXPECT_EQ(leastBic(effects, 1000), "a");
    EXPECT_EQ(leastBic(effects, 20000), "none");
}

TEST(Baselines, BothNameAPlantedRatioOfASimpleCar) {
    const simple_car::Case made =
        simple_car::recorded(14.5, loadVehicle(sourceFile("vehicles/compact.yaml")).aero.drag_area, 3);
    const Diagnosis d = diagnose::diagnosisOf(
        made.nominal, made.file, made.recorded,
        {simple_car::effect("drag", "aero.drag_area"), simple_car::effect("ratio", "steering.ratio")},
        simple_car::options(2));
    EXPECT_EQ(d.baselines.largest_reduction, "ratio");
    EXPECT_EQ(d.baselines.bic, "ratio");
}

}  // namespace
}  // namespace tread::baselines_test
