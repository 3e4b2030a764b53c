#include "shared/layers.h"

#include <gtest/gtest.h>

#include "places/places.h"
#include "shared/source_files.h"

namespace tread::layers {
namespace {

std::string faults(const char* file, const char* text) {
    std::string all;
    for (const std::string& fault : faultsOf(file, text)) all += fault + "\n";
    return all;
}

TEST(Layers, OfTheProjectAreKept) {
    const auto is_code = [](const Path& name) {
        const std::string top = name.begin()->string();
        return (name.extension() == ".h" || name.extension() == ".cpp") &&
               (top == "src" || top == "include" || top == "tools" || top == "tests");
    };
    const std::vector<SourceFile> files = sourceFiles(sourceFile(), is_code);
    std::size_t includes = 0;
    for (const SourceFile& file : files) {
        includes += includesOf(file.text).size();
        for (const std::string& fault : faultsOf(file.name, file.text)) ADD_FAILURE() << fault;
    }
    EXPECT_GT(files.size(), 100u) << "the search must find the project";
    EXPECT_GT(includes, 500u);
}

TEST(Layers, AllowWhatLiesBelowAndBeside) {
    EXPECT_EQ(faults("src/vehicle/wheel.cpp",
                     "#include \"vehicle/wheel.h\"\n#include \"tread/tyre.h\"\n"
                     "#include \"tyre/dual.h\"\n#include <vector>\n#include <Eigen/Dense>\n"),
              "");
    EXPECT_EQ(faults("src/bullet/a.cpp", "#include <LinearMath/btVector3.h>\n#include \"tread/vehicle.h\"\n"), "");
    EXPECT_EQ(faults("tools/tread/main.cpp", "#include \"commands.h\"\n#include \"report/html.h\"\n"), "");
    EXPECT_EQ(faults("src/log/csv.cpp", "#include <fmt/format.h>\n"), "");
    EXPECT_EQ(faults("include/tread/vehicle.h", "#include \"tread/aero.h\"\n#include \"tread/tyre.h\"\n"), "");
}

TEST(Layers, MessageNamesFileLineAndRule) {
    EXPECT_EQ(
        faults("src/tyre/a.cpp", "// head\n\n#include \"tread/vehicle.h\"\n"),
        "src/tyre/a.cpp:3: includes tread/vehicle.h: layer tyre may not use layer vehicle, which lies above it\n");
}

TEST(Layers, FindWhatLiesAbove) {
    EXPECT_NE(faults("src/base/a.h", "#include \"tread/road.h\""), "");
    EXPECT_NE(faults("include/tread/tyre.h", "#include <tread/vehicle.h>"), "") << "in angle brackets too";
    EXPECT_NE(faults("include/tread/vehicle.h", "#include \"tread/bullet_vehicle.h\""), "");
    EXPECT_NE(faults("src/vehicle/a.cpp", "  #  include \"bullet/convert.h\""), "") << "however it is spaced";
    EXPECT_NE(faults("src/log/a.cpp", "#include \"run/simulate.h\""), "");
    EXPECT_NE(faults("src/metrics/a.cpp", "#include \"report/html.h\"\r\n"), "");
}

TEST(Layers, FindForeignLibraries) {
    EXPECT_NE(faults("src/tyre/a.cpp", "#include <LinearMath/btScalar.h>"), "");
    EXPECT_NE(faults("src/vehicle/a.cpp", "#include <btBulletDynamicsCommon.h>"), "");
    EXPECT_NE(faults("src/vehicle/a.cpp", "#include <yaml-cpp/yaml.h>"), "");
    EXPECT_NE(faults("src/bullet/a.cpp", "#include <fmt/format.h>"), "");
    EXPECT_NE(faults("src/diagnose/a.cpp", "#include <btBulletDynamicsCommon.h>"), "");
    EXPECT_NE(faults("src/report/a.cpp", "#include <CLI/CLI.hpp>"), "");
}

TEST(Layers, FindSubModelsThatKnowEachOther) {
    EXPECT_NE(faults("include/tread/steering.h", "#include \"tread/suspension.h\""), "");
    EXPECT_NE(faults("include/tread/suspension.h", "#include \"tread/tyre.h\""), "") << "though tyre lies below";
}

TEST(Layers, FindPrivateAndVectorCodeInPublicHeaders) {
    EXPECT_NE(faults("include/tread/vehicle.h", "#include \"tyre/four_tyres.h\""), "") << "though tyre lies below";
    EXPECT_NE(faults("include/tread/vehicle.h", "#include \"lanes.h\""), "");
    EXPECT_NE(faults("include/tread/tyre.h", "#include <immintrin.h>"), "");
    EXPECT_NE(faults("include/tread/tyre.h", "typedef double V __attribute__((vector_size(32)));"), "");
    EXPECT_NE(faults("include/tread/vehicle.h", "    BasicTyreScaling<Lanes> lambda;"), "");
    EXPECT_EQ(faults("src/tyre/lanes.h", "typedef double V __attribute__((vector_size(32)));"), "");
}

TEST(Layers, FindSourcesThatAreIncludedAndFilesWithoutLayer) {
    EXPECT_NE(faults("tests/unit/a_test.cpp", "#include \"base/units.cpp\""), "");
    EXPECT_NE(faults("tools/tread/main.cpp", "#include \"run.cpp\""), "");
    EXPECT_NE(faults("src/common/a.h", ""), "");
    EXPECT_NE(faults("include/tread/surprise.h", ""), "");
    EXPECT_NE(faults("src/base/a.cpp", "#include \"common/a.h\""), "");
    EXPECT_NE(faults("src/base/a.cpp", "#include \"../base/units.h\""), "");
}

}  // namespace
}  // namespace tread::layers
