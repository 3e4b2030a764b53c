#include "road/plane.h"

#include <gtest/gtest.h>

namespace tread::plane_road_test {
namespace {

double heightAt(const Road& road, double x, double y) {
    const RoadContact contact = road.contact({x, y, 3}, 0);
    const Vector3& n = contact.normal_W;
    return contact.point_W.z() - (n.x() * (x - contact.point_W.x()) + n.y() * (y - contact.point_W.y())) / n.z();
}

TEST(PlaneRoad, LevelRoadIsTheGround) {
    const PlaneRoad road;
    EXPECT_EQ(road.contact({4, 5, 6}, 2).normal_W, Vector3::UnitZ());
    EXPECT_EQ(heightAt(road, 10, -3), 0);
    EXPECT_EQ(road.contact({0, 0, 0}, 0).friction, 1);
    EXPECT_TRUE(road.contact({0, 0, 0}, 0).exists);
}

TEST(PlaneRoad, GradeRisesAlongXAndBankAlongY) {
    const PlaneRoad road(0.2, -0.05, 0.6);
    EXPECT_NEAR(heightAt(road, 10, 0), 2, 1e-12);
    EXPECT_NEAR(heightAt(road, 0, 10), -0.5, 1e-12);
    EXPECT_NEAR(road.contact({1, 1, 0}, 0).normal_W.norm(), 1, 1e-15);
    EXPECT_EQ(road.contact({1, 1, 0}, 3).friction, 0.6);
}

}  // namespace
}  // namespace tread::plane_road_test
