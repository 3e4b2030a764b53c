// Numbers fitted to recordings of a car of two lines, whose true numbers are known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "calibrate/identification.h"
#include "calibrate/identification_text.h"
#include "diagnose/answer/diagnosis.h"
#include "recording/diagnosis_file.h"
#include "report/identification_report.h"
#include "shared/scratch.h"
#include "shared/simple_car.h"
#include "tread/problem.h"

namespace tread::identify_test {
namespace {

using calibrate::calibratedVehicleYaml;
using calibrate::FittedNumber;
using calibrate::hasSucceeded;
using calibrate::Identification;
using calibrate::identificationJson;
using calibrate::identificationText;
using calibrate::otherNumbersInWords;
using diagnose::answer::GapLevels;
using recording::Recording;

constexpr double kRatio = 15.2, kDrag = 0.85;  // of the true car; nominal: 16.5 and 0.66

simple_car::Case asked(std::uint64_t seed, std::vector<std::string> fit) {
    simple_car::Case made = simple_car::recorded(kRatio, kDrag, seed);
    made.file.recordings.back().hold_out = true;
    made.file.tolerances = {{"steering.ratio", 0.15, 0}, {"aero.drag_area", 0.4, 0}, {"wheelbase", 0.001, 0}};
    made.file.fit = std::move(fit);
    return made;
}

Identification identified(const simple_car::Case& made) {
    return calibrate::identificationOf(made.nominal, made.file, made.recorded, simple_car::options());
}

TEST(Identification, FindsThePlantedNumbersWithinThreeStandardDeviationsWhateverTheNoise) {
    double worst = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const Identification found = identified(asked(seed, {"steering.ratio", "aero.drag_area"}));
        ASSERT_EQ(found.numbers.size(), 2u);
        for (const FittedNumber& one : found.numbers) {
            const double truth = one.path == "steering.ratio" ? kRatio : kDrag;
            worst = std::max(worst, std::abs(one.value - truth) / one.sd);
            EXPECT_LT(one.sd, 0.5 * one.prior_sd) << one.path;
            EXPECT_TRUE(one.determined);
            EXPECT_FALSE(one.at_bound);
            EXPECT_NEAR(one.z, (one.value - one.nominal) / one.prior_sd, 1e-9);
        }
        EXPECT_TRUE(found.converged);
        // The drive that was held out is explained, too.
        const GapLevels& held_out = found.gap.how_far.held_out;
        EXPECT_GT(held_out.nominal, 2 * held_out.floor);
        EXPECT_LT(held_out.calibrated, 1.15 * held_out.floor);
    }
    EXPECT_LT(worst, 3);
    EXPECT_GT(worst, 0.1) << "the stated deviations are not so wide that nothing could miss";
}

TEST(Identification, SaysWhichNumbersTheDrivesDoNotDetermine) {
    const Identification found = identified(asked(1, {"steering.ratio", "mass"}));
    for (const FittedNumber& one : found.numbers) {
        EXPECT_EQ(one.determined, one.path == "steering.ratio") << one.path;
        if (one.path != "mass") continue;
        EXPECT_DOUBLE_EQ(one.value, one.nominal);
        EXPECT_DOUBLE_EQ(one.sd, one.prior_sd);
    }
    EXPECT_TRUE(found.answer.starts_with("1 of 2 numbers are determined by these drives")) << found.answer;
    EXPECT_NE(identificationText(found).find("not determined"), std::string::npos);
    EXPECT_EQ(identificationJson(found)["not_determined"], "mass");
}

TEST(Identification, NumbersThatOnlyTheirRatioMattersOfAreKnownTogether) {
    simple_car::Case made = asked(1, {"steering.ratio", "wheelbase"});
    made.file.tolerances = {{"steering.ratio", 0.15, 0}, {"wheelbase", 0.15, 0}, {"aero.drag_area", 0.4, 0}};
    const Identification found = identified(made);
    EXPECT_LT(found.correlation[0][1], -0.95);
    EXPECT_GT(found.condition, 100);
    EXPECT_NEAR(std::abs(found.weakest.at("wheelbase")), std::sqrt(0.5), 0.1);
    EXPECT_NEAR(found.numbers[0].value * found.numbers[1].value, kRatio * made.nominal.vehicle.wheelbase, 0.2);
}

TEST(Identification, NumberAtTheEndOfItsPlausibleRangeIsSaidSo) {
    const double nominal = simple_car::Case{}.nominal.vehicle.steering.ratio;
    simple_car::Case made = simple_car::recorded(2 * nominal, kDrag, 1);
    made.file.tolerances = {{"steering.ratio", 0.3, 0}, {"aero.drag_area", 0.4, 0}, {"wheelbase", 0.001, 0}};
    made.file.fit = {"steering.ratio"};
    const Identification found = identified(made);
    EXPECT_TRUE(found.numbers[0].at_bound);
    EXPECT_NEAR(found.numbers[0].value, 1.6 * nominal, 1e-6)
        << "other racks for the same car are up to 1.6 times slower";
    EXPECT_NE(identificationText(found).find("at the end of its plausible range"), std::string::npos);
}

TEST(Identification, CalibratedCarHasTheFittedNumbersAndNothingElseChanged) {
    const simple_car::Case made = asked(1, {"steering.ratio", "road.grade"});
    const Identification found = identified(made);
    const std::string yaml = calibratedVehicleYaml(made.nominal, found);
    const Scratch scratch;
    VehicleParams car = loadVehicle(scratch.file("car.yaml", yaml));
    EXPECT_NE(yaml.find("Not numbers of the car"), std::string::npos) << "a grade is none of the car's numbers";
    const auto ratio = std::find_if(found.numbers.begin(), found.numbers.end(),
                                    [](const FittedNumber& one) { return one.path == "steering.ratio"; });
    EXPECT_EQ(car.steering.ratio, ratio->value);
    car.steering.ratio = made.nominal.vehicle.steering.ratio;
    EXPECT_EQ(vehicleYaml(car), vehicleYaml(made.nominal.vehicle));
}

TEST(Identification, SaysWhichOtherNumbersCloseTheGapWhereThoseAskedForDoNot) {
    simple_car::Case made = asked(1, {"mass"});
    made.file.tolerances = {{"steering.ratio", 0.15, 0}, {"aero.drag_area", 0.4, 0}, {"wheelbase", 0.001, 0}};
    const std::string others = otherNumbersInWords(identified(made));
    EXPECT_TRUE(others.starts_with("most of the gap is closed by numbers that are not fitted here")) << others;
    EXPECT_NE(others.find("aero.drag_area (+1."), std::string::npos) << others;
    EXPECT_EQ(otherNumbersInWords(identified(asked(1, {"steering.ratio", "aero.drag_area"}))), "");
}

// A car that slides from 3 s on, as its lateral acceleration tells; the model does not know one.
void slide(Log& log) {
    Channel ay{"chassis.ay", "m/s2", {}};
    for (const double t : log.channels.front().values) ay.values.push_back(t < 3 ? 0 : 5);
    log.channels.push_back(std::move(ay));
}

TEST(Identification, SaysWhatItLeavesOutOfTheDrives) {
    simple_car::Case made = asked(1, {"steering.ratio"});
    EXPECT_TRUE(identified(made).gap.data_warnings.empty());
    slide(made.recorded.logs[1]);
    slide(made.recorded.logs[2]);
    const Identification found = identified(made);
    const std::vector<std::string>& said = found.gap.data_warnings;
    ASSERT_EQ(said.size(), 2u) << "one of a fitted drive, one of the drive held out";
    EXPECT_TRUE(said[0].starts_with("drive 2: not compared after 1.")) << said[0];
    EXPECT_TRUE(said[1].starts_with("drive 3: not compared after 1.")) << said[1];
    EXPECT_EQ(identificationJson(found)["data_warnings"].size(), 2u);
    EXPECT_NE(identificationReport("car", "0", found).find("drive 2: not compared after 1."), std::string::npos);
}

// The badge is the exit status, which `tread identify` takes from the same function; the shares closed follow by hand
// from the levels beside them.
TEST(Identification, PageJsonAndExitStatusSayOneThing) {
    Identification found;
    found.answer = "1 of 1 number is determined";
    found.numbers = {{.path = "mass", .determined = true}};
    found.correlation = {{1}};
    found.converged = found.better = true;
    found.gap.how_far.training = {4, 3, 2, 1};
    found.gap.how_far.in_sample = true;
    const auto page = [&] { return identificationReport("car", "0", found); };
    EXPECT_NE(page().find("verdict good\">✓ determined"), std::string::npos);
    for (const char* row : {">4</td><td class=\"number \">0 %", ">3</td><td class=\"number \">47 %",
                            ">2</td><td class=\"number \">80 %", ">1</td><td class=\"number \">100 %"})
        EXPECT_NE(page().find(row), std::string::npos) << row;
    EXPECT_NE(page().find("(nominal² - gap²) / (nominal² - noise floor²)"), std::string::npos);
    const auto json = identificationJson(found);
    EXPECT_NEAR(json["closed"]["calibrated"].get<double>(), (16.0 - 9) / (16 - 1), 1e-12);
    EXPECT_NEAR(json["closed"]["extended"].get<double>(), (16.0 - 4) / (16 - 1), 1e-12);

    found.better = false;
    EXPECT_FALSE(hasSucceeded(found));
    EXPECT_NE(page().find("verdict bad\">✗ not better"), std::string::npos);
    found.converged = false;
    EXPECT_NE(page().find("verdict bad\">✗ not converged"), std::string::npos);
    found.converged = found.better = true;
    found.numbers[0].determined = false;
    EXPECT_FALSE(hasSucceeded(found));
    EXPECT_NE(page().find("verdict bad\">✗ not all determined"), std::string::npos);
}

// The car was changed from its references on; one of three drives has no reference.
simple_car::Case changed(std::uint64_t seed) {
    simple_car::Case made = asked(seed, {"steering.ratio", "aero.drag_area"});
    made.recorded.references = made.recorded.logs;
    made.recorded.logs = simple_car::recorded(13, kDrag, seed + 100).recorded.logs;
    for (Recording& one : made.file.recordings) one.reference = "before " + one.log;
    made.file.recordings[1].reference.clear();
    return made;
}

TEST(Identification, FitsTheCarAsItWasBeforeWhereThereAreReferences) {
    double squares = 0, worst = 0;
    constexpr int kSeeds = 10;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        for (const FittedNumber& one : identified(changed(seed)).numbers) {
            const double error = (one.value - (one.path == "steering.ratio" ? kRatio : kDrag)) / one.sd;
            squares += error * error;
            worst = std::max(worst, std::abs(error));
        }
    }
    EXPECT_LT(worst, 3.5);
    EXPECT_LT(std::sqrt(squares / (2 * kSeeds)), 1.3) << "standard deviations, root mean square";

    const simple_car::Case made = changed(1);
    const Identification found = identified(made);
    EXPECT_TRUE(found.of_references);
    EXPECT_EQ(found.gap.overlays.size(), 2u) << "the drive without a reference is of the car after the change";
    EXPECT_LT(found.gap.how_far.held_out.calibrated, 1.15 * found.gap.how_far.held_out.floor);
    EXPECT_NE(identificationText(found).find("BEFORE    fitted to the references"), std::string::npos);
    EXPECT_EQ(identificationJson(found)["fitted_to"], "references");
    EXPECT_NE(calibratedVehicleYaml(made.nominal, found).find("# Fitted to the references"), std::string::npos);
    EXPECT_EQ(identificationJson(identified(asked(1, {"mass"})))["fitted_to"], "recordings");
}

void expectRefused(std::vector<std::string> fit, const std::string& words) {
    try {
        identified(asked(1, std::move(fit)));
        FAIL() << "expected: " << words;
    } catch (const LoadError& error) {
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
}

TEST(Identification, RefusesNumbersThatItCannotFit) {
    expectRefused({}, "found no number to fit");
    expectRefused({"stability_control.nothing"}, "expected a number that this car has");
    expectRefused({"steering.delay"}, "expected a number with a tolerance; add one under tolerances");
}

}  // namespace
}  // namespace tread::identify_test
