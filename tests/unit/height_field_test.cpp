#include "tread/height_field.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/yaml/read.h"
#include "shared/scratch.h"
#include "tread/road_params.h"

namespace tread::height_field_test {
namespace {

class HeightFieldFile : public testing::Test {
protected:
    std::filesystem::path write(const std::string& name, const std::string& text) const {
        std::ofstream(scratch_.path(name)) << text;
        return scratch_.path(name);
    }

    // The only fault of a file of that text, without its path.
    std::string faultOf(const std::string& text) const {
        const auto file = write("field.csv", text);
        HeightField field;
        std::vector<Problem> problems;
        EXPECT_TRUE(readForeign(field, file, problems));
        if (problems.empty()) return "";
        Problem first = problems.front();
        first.file = "field.csv";
        return toText(first);
    }

    Scratch scratch_;
};

TEST_F(HeightFieldFile, IsReadBesideTheScenarioThatNamesIt) {
    write("field.csv", "# measured\nx\\y [m], -1, 1, 3\n10, 0, 0.1, 0.2\n\n10.5, 1, 1.1, 1.2\r\n");
    const RoadParams road = readYaml<RoadParams>(write("road.yaml", "height_field: field.csv\n"));
    ASSERT_TRUE(road.height_field);
    const HeightField& field = *road.height_field;
    EXPECT_EQ(field.x_first, 10);
    EXPECT_EQ(field.x_spacing, 0.5);
    EXPECT_EQ(field.y_first, -1);
    EXPECT_EQ(field.y_spacing, 2);
    EXPECT_EQ(field.columns, 3);
    EXPECT_EQ(field.heights, (std::vector<double>{0, 0.1, 0.2, 1, 1.1, 1.2}));
}

TEST_F(HeightFieldFile, FaultsNameLineAndColumn) {
    EXPECT_EQ(faultOf("y [m],0,1\n0,0,0\n1,0,x2\n"), "field.csv:3:5: found \"x2\", expected a number in m");
    EXPECT_EQ(faultOf("y [m],0,1\n0,0,0\n1,0,\n"), "field.csv:3:5: found \"\", expected a number in m");
    EXPECT_EQ(faultOf("y [m],0,1\n0,0,0\n1,0,1,2\n"), "field.csv:3:1: found 4 cells, expected x and 2 heights");
    EXPECT_EQ(faultOf("y [m],0,1\n0,0,0\n1,0\n"), "field.csv:3:1: found 2 cells, expected x and 2 heights");
    EXPECT_EQ(faultOf("y [m],0,1\n0,0,0\n0,0,0\n"), "field.csv:3:1: found x = 0 after 0, expected it to increase");
    EXPECT_EQ(faultOf("y [m],0,1\n0,0,0\n1,0,0\n3,0,0\n"),
              "field.csv:4:1: found x = 3 after 1, expected equal steps of 1 m");
    EXPECT_EQ(faultOf("y [m],0,1,1.5\n0,0,0,0\n"), "field.csv:1:1: found y = 1.5 after 1, expected equal steps of 1 m");
    EXPECT_EQ(faultOf("y [m],0,1\n0,0,0\n"), "field.csv: found 1 rows of heights, expected at least two");
    EXPECT_EQ(faultOf("y [m],0\n0,0\n1,0\n"), "field.csv:1:1: found one column, expected at least two");
    EXPECT_EQ(faultOf(""), "field.csv: found an empty file, expected a first row with the y of every column");
    EXPECT_NE(faultOf("0,0,1\n0,0,0\n1,0,0\n").find("expected a first cell like \"x\\y [m]\""), std::string::npos);
    EXPECT_NE(faultOf("y [m]\n0,0\n").find("field.csv:1:1: found no column"), std::string::npos);
    EXPECT_NE(faultOf(std::string("y [m],0,1\n0,\0,0\n", 17)).find("NUL"), std::string::npos);
    EXPECT_NE(faultOf("y [m],0,inf\n0,0,0\n1,0,0\n").find("found \"inf\""), std::string::npos);
}

TEST_F(HeightFieldFile, MissingFileIsOneFaultWhereItIsNamed) {
    try {
        readYaml<RoadParams>(write("road.yaml", "grade: 0\nheight_field: nowhere.csv\n"));
        FAIL();
    } catch (const LoadError& error) {
        EXPECT_NE(std::string(error.what()).find("road.yaml:2:15: height_field: "), std::string::npos) << error.what();
    }
}

TEST(HeightField, IsTwoTrianglesPerCell) {
    const HeightField field{0, 0, 2, 1, 2, {0, 1, 4, 7}};  // (0,0) (0,1) (2,0) (2,1)
    EXPECT_EQ(field.at(0, 0).height, 0);
    EXPECT_EQ(field.at(0, 1).height, 1);
    EXPECT_EQ(field.at(2, 0).height, 4);
    EXPECT_EQ(field.at(2, 1).height, 7);
    EXPECT_EQ(field.at(1, 0.5).height, 2.5) << "the diagonal joins (0, 1) and (2, 0)";
    EXPECT_EQ(field.at(0.5, 0.25).height, 1.25) << "the triangle of (0, 0)";
    EXPECT_EQ(field.at(0.5, 0.25).slope_x, 2);
    EXPECT_EQ(field.at(0.5, 0.25).slope_y, 1);
    EXPECT_EQ(field.at(1.5, 0.75).height, 4.75) << "the triangle of (2, 1)";
    EXPECT_EQ(field.at(1.5, 0.75).slope_x, 3);
    EXPECT_EQ(field.at(1.5, 0.75).slope_y, 3);
}

TEST(HeightField, GoesOnLevelBeyondItsBorder) {
    const HeightField field{0, 0, 2, 1, 2, {0, 1, 4, 7}};
    EXPECT_EQ(field.at(-5, 0.5).height, 0.5);
    EXPECT_EQ(field.at(-5, 0.5).slope_x, 0);
    EXPECT_EQ(field.at(-5, 0.5).slope_y, 1);
    EXPECT_EQ(field.at(9, 9).height, 7);
    EXPECT_EQ(field.at(9, 9).slope_x, 0);
    EXPECT_EQ(field.at(9, 9).slope_y, 0);
}

}  // namespace
}  // namespace tread::height_field_test
