#include "tread/road_surface.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/yaml/read.h"
#include "base/yaml/write.h"
#include "road/plane.h"

namespace tread::road_surface_test {
namespace {

constexpr double kRounding = 1e-12;

RoadParams roadOf(const std::string& yaml) {
    return readYamlText<RoadParams>(yaml, "road.yaml");
}

double heightAt(const RoadParams& params, double x, double y) {
    return RoadSurface(params).at(x, y).height;
}

TEST(RoadSurface, CosineBumpIsOnePeriodOfACosine) {
    const RoadParams road = roadOf("obstacles: [{x: 10, length: 2, height: 0.1}]");
    for (const double x : {9.9, 10.0, 10.3, 11.0, 11.7, 12.0, 12.5}) {
        const bool over = x > 10 && x < 12;
        EXPECT_NEAR(heightAt(road, x, 3), over ? 0.05 * (1 - std::cos(M_PI * (x - 10))) : 0, kRounding) << x;
    }
}

TEST(RoadSurface, RampRisesAndFallsLinearly) {
    const RoadParams road = roadOf("obstacles: [{x: 10, length: 3, height: -0.2, shape: {ramp: {rise: 1}}}]");
    EXPECT_NEAR(heightAt(road, 10.25, 0), -0.05, kRounding);
    EXPECT_NEAR(heightAt(road, 11.5, 0), -0.2, kRounding);
    EXPECT_NEAR(heightAt(road, 12.25, 0), -0.15, kRounding);
    EXPECT_EQ(heightAt(road, 13.01, 0), 0);
}

TEST(RoadSurface, KerbWithoutLengthNeverEnds) {
    const RoadParams road = roadOf("obstacles: [{x: 10, height: 0.12, shape: plank}]");
    EXPECT_EQ(heightAt(road, 9.999, 0), 0);
    EXPECT_EQ(heightAt(road, 10.001, -500), 0.12);
    EXPECT_EQ(heightAt(road, 1e6, 500), 0.12);
    EXPECT_NEAR(RoadSurface(road).averaged(1000, 3).height, 0.12, kRounding);
}

TEST(RoadSurface, ObstacleTurnsAboutTheMiddleOfItsBeginning) {
    const RoadParams road =
        roadOf("obstacles: [{x: 10, y: 2, heading: 90 deg, length: 3, width: 1, height: 0.1, shape: plank}]");
    EXPECT_EQ(heightAt(road, 10.4, 4.9), 0.1);
    EXPECT_EQ(heightAt(road, 9.6, 2.1), 0.1);
    EXPECT_EQ(heightAt(road, 10.6, 3), 0);
    EXPECT_EQ(heightAt(road, 10, 1.9), 0);
    EXPECT_EQ(heightAt(road, 10, 5.1), 0);
}

// Whatever lies on the road: the tyre's plane has the mean height of the square, and the slopes of that mean.
TEST(RoadSurface, TyreFeelsTheMeanOverItsContact) {
    for (const char* shape : {"cosine", "{ramp: {rise: 0.15}}", "plank"}) {
        const RoadParams road = roadOf(std::string("obstacles: [{x: 10, y: 0.3, length: 0.5, width: 0.8, height: ") +
                                       "0.05, shape: " + shape + "}]\ncontact_length: 0.2");
        const RoadSurface surface(road);
        constexpr int kPoints = 400;
        constexpr double kHalf = 0.1;
        for (double x = 9.85; x < 10.7; x += 0.0613) {
            for (const double y : {-0.45, -0.12, 0.3, 0.66, 0.75}) {
                double sum = 0;
                for (int i = 0; i < kPoints; ++i) {
                    for (int j = 0; j < kPoints; ++j) {
                        sum += surface
                                   .at(x - kHalf + 2 * kHalf * (i + 0.5) / kPoints,
                                       y - kHalf + 2 * kHalf * (j + 0.5) / kPoints)
                                   .height;
                    }
                }
                const SurfacePoint felt = surface.averaged(x, y);
                constexpr double kSteps = 0.05 / kPoints;  // a step falls between two of the points
                EXPECT_NEAR(felt.height, sum / kPoints / kPoints, 2 * kSteps) << shape << " at " << x << ", " << y;
                constexpr double kNear = 1e-6;
                const double rise_x = surface.averaged(x + kNear, y).height - surface.averaged(x - kNear, y).height;
                const double rise_y = surface.averaged(x, y + kNear).height - surface.averaged(x, y - kNear).height;
                EXPECT_NEAR(felt.slope_x, rise_x / 2 / kNear, 1e-4) << shape << " at " << x << ", " << y;
                EXPECT_NEAR(felt.slope_y, rise_y / 2 / kNear, 1e-4) << shape << " at " << x << ", " << y;
            }
        }
    }
}

// Nothing is lost or gained: the mean surface holds as much as the obstacle.
TEST(RoadSurface, AveragingKeepsTheVolume) {
    const RoadSurface surface(
        roadOf("obstacles: [{x: 1, length: 0.6, width: 1.2, height: 0.05, heading: 0.4, shape: plank}]"));
    double volume = 0;
    constexpr double kCell = 0.005;
    for (double x = 0; x < 3; x += kCell) {
        for (double y = -2; y < 2; y += kCell) volume += surface.averaged(x, y).height * kCell * kCell;
    }
    EXPECT_NEAR(volume, 0.6 * 1.2 * 0.05, 1e-4 * 0.036);
}

TEST(RoadSurface, PointContactFeelsTheRoadItself) {
    const RoadSurface surface(
        roadOf("{contact_length: 0, obstacles: [{x: 0, length: 2, height: 0.1}], roughness: {road_class: C}}"));
    for (double x = -0.5; x < 2.5; x += 0.137) {
        const SurfacePoint itself = surface.at(x, 0.4), felt = surface.averaged(x, 0.4);
        EXPECT_NEAR(felt.height, itself.height, kRounding);
        EXPECT_NEAR(felt.slope_x, itself.slope_x, kRounding);
    }
}

TEST(RoadSurface, SlopesAreThoseOfTheHeights) {
    const RoadSurface surface(roadOf(
        "{grade: 0.03, bank: -0.02, crown: 0.025, crown_y: -1, crown_begin: -5, roughness: {road_class: E, begin: -3}, "
        "obstacles: [{x: 1, length: 5, height: 0.2, heading: 0.3}]}"));
    constexpr double kNear = 1e-5;
    for (double x = -4; x < 9; x += 0.317) {
        for (const double y : {-2.0, -0.7, 0.9}) {
            for (const bool average : {false, true}) {
                const auto at = [&](double px, double py) {
                    return average ? surface.averaged(px, py) : surface.at(px, py);
                };
                const double rise_x = (at(x + kNear, y).height - at(x - kNear, y).height) / 2 / kNear;
                const double rise_y = (at(x, y + kNear).height - at(x, y - kNear).height) / 2 / kNear;
                EXPECT_NEAR(at(x, y).slope_x, rise_x, 1e-6) << x << ", " << y;
                EXPECT_NEAR(at(x, y).slope_y, rise_y, 1e-6) << x << ", " << y;
            }
        }
    }
}

TEST(RoadSurface, CrownFallsToBothSidesAndIsRoundOnTop) {
    const RoadSurface surface(roadOf("{crown: 2.5 %, crown_y: 1, crown_rounding: 0.5}"));
    EXPECT_EQ(surface.at(5, 1).height, 0);
    EXPECT_EQ(surface.at(5, 1).slope_y, 0);
    EXPECT_EQ(surface.at(5, 4).height, surface.at(5, -2).height);
    EXPECT_NEAR(surface.at(5, 41).slope_y, -0.025, 1e-5);
    EXPECT_NEAR(surface.at(5, 41).height, -0.025 * (40 - 0.5), 1e-3);
}

TEST(RoadSurface, LastFrictionPatchHoldsAndScalesTheRoad) {
    const RoadSurface surface(
        roadOf("friction: 0.8\n"
               "friction_patches:\n"
               "  - {friction: 0.5, y_from: 0}\n"
               "  - {friction: 0.1, x_from: 20, x_to: 30, y_from: 1, y_to: 2}\n"));
    EXPECT_EQ(surface.friction(5, -1), 0.8);
    EXPECT_EQ(surface.friction(5, 1), 0.4);
    EXPECT_NEAR(surface.friction(25, 1.5), 0.08, kRounding);
    EXPECT_EQ(surface.friction(25, 2.5), 0.4);
    EXPECT_EQ(surface.contact({25, -1.5, 0.3}, 0).friction, 0.8);
}

TEST(RoadSurface, ContactIsThePlaneBelowTheWheelCentre) {
    const RoadSurface surface(roadOf("{grade: 0.1, obstacles: [{x: 0, length: 4, height: 0.2}]}"));
    const RoadContact contact = surface.contact({1.2, 0, 5}, 2);
    const SurfacePoint felt = surface.averaged(1.2, 0);
    EXPECT_EQ(contact.point_W, Vector3(1.2, 0, felt.height));
    EXPECT_NEAR(contact.normal_W.norm(), 1, kRounding);
    EXPECT_NEAR(-contact.normal_W.x() / contact.normal_W.z(), felt.slope_x, kRounding);
    EXPECT_TRUE(contact.exists);
    EXPECT_EQ(contact.velocity_W, Vector3::Zero());
}

TEST(MakeRoad, PlainRoadIsThePlaneAsItEverWas) {
    const auto plane = makeRoad(roadOf("{grade: 0.2, bank: -0.05, friction: 0.6}"));
    EXPECT_NE(dynamic_cast<PlaneRoad*>(plane.get()), nullptr);
    EXPECT_NE(dynamic_cast<PlaneRoad*>(makeRoad({}).get()), nullptr);
    for (const char* more : {"crown: 0.02", "friction_patches: [{friction: 0.5}]",
                             "obstacles: [{x: 1, height: 0.1, "
                             "length: 1}]",
                             "roughness: {road_class: A}", "roughness: {unevenness: 1e-6}"}) {
        EXPECT_EQ(dynamic_cast<PlaneRoad*>(makeRoad(roadOf(more)).get()), nullptr) << more;
    }
}

// A surface without anything on it is the plane, to rounding.
TEST(MakeRoad, SurfaceOfAPlaneIsThatPlane) {
    const RoadParams params = roadOf("{grade: 0.2, bank: -0.05, friction: 0.6}");
    const RoadContact surface = RoadSurface(params).contact({30, -4, 1}, 0);
    const RoadContact plane = makeRoad(params)->contact({30, -4, 1}, 0);
    EXPECT_NEAR((surface.normal_W - plane.normal_W).norm(), 0, kRounding);
    EXPECT_NEAR((surface.point_W - plane.point_W).dot(plane.normal_W), 0, kRounding);
    EXPECT_EQ(surface.friction, plane.friction);
}

TEST(RoadParams, WrittenAndReadAgainIsTheSameRoad) {
    const RoadParams road = roadOf(
        "{crown: 0.02, friction_patches: [{friction: 0.3, y_to: 0}], obstacles: [{x: 3, height: 0.1, shape: plank}], "
        "roughness: {road_class: B, seed: 7, begin: 20}, height_field: {x_spacing: 1, y_spacing: 2, columns: 2, "
        "heights: [0, 0.1, 0.2, 0.3]}}");
    const std::string text = writeYaml(road);
    EXPECT_EQ(writeYaml(roadOf(text)), text);
    EXPECT_EQ(heightAt(roadOf(text), 40.3, 0.7), heightAt(road, 40.3, 0.7));
}

void expectFault(const std::string& yaml, const std::string& text) {
    try {
        roadOf(yaml);
        FAIL() << yaml << " was taken";
    } catch (const LoadError& error) {
        EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
}

TEST(RoadParams, WhatCannotBeIsRefused) {
    expectFault("obstacles: [{x: 3, height: 0.1}]", "a cosine needs a length");
    expectFault("obstacles: [{x: 3, height: 0.1, length: 1, shape: {ramp: {rise: 0.6}}}]", "both slopes");
    expectFault("friction_patches: [{friction: 1, x_from: 3, x_to: 2}]", "x_from < x_to");
    expectFault("friction_patches: [{friction: -1}]", "at least 0");
    expectFault("roughness: {road_class: Z}", "A, B, C");
    expectFault("height_field: {x_spacing: 1, y_spacing: 1, columns: 3, heights: [0, 0, 0, 0]}", "rows of 3");
}

}  // namespace
}  // namespace tread::road_surface_test
