#include "shared/layers.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "places/places.h"
#include "shared/source_files.h"

namespace tread::layers::layers_test {
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

TEST(Layers, InferenceKnowsNoCarAndNoFile) {
    EXPECT_EQ(faults("src/inference/a.cpp", "#include \"base/math/median.h\"\n#include <Eigen/Dense>\n"), "");
    EXPECT_NE(faults("src/inference/a.cpp", "#include \"log/log.h\""), "");
    EXPECT_NE(faults("src/inference/a.cpp", "#include \"tread/vehicle.h\""), "");
    EXPECT_NE(faults("src/inference/a.cpp", "#include \"recording/recorded_drive.h\""), "");
    EXPECT_NE(faults("src/inference/a.cpp", "#include <fmt/format.h>"), "");
    EXPECT_NE(faults("src/base/a.cpp", "#include \"inference/laplace.h\""), "");
}

TEST(Layers, OnlyTheStoreHashes) {
    EXPECT_EQ(faults("src/store/a.cpp", "#include <openssl/evp.h>\n#include <nlohmann/json.hpp>\n"), "");
    EXPECT_NE(faults("src/diagnose/model/a.cpp", "#include <openssl/evp.h>"), "");
}

TEST(Layers, ChecksLieAboveTheRestOfTheirLayer) {
    EXPECT_EQ(faults("src/recording/checks/a.cpp", "#include \"recording/replay.h\"\n#include \"log_checks.h\"\n"), "");
    EXPECT_EQ(faults("src/recording/a.cpp", "#include \"recording/checks/left_out.h\"\n"),
              "src/recording/a.cpp:1: includes recording/checks/left_out.h: the layer's own files may not use "
              "room checks of the same layer\n");
    EXPECT_NE(faults("src/recording/a.cpp", "#include \"diagnose/settings.h\""), "");
    EXPECT_NE(faults("src/recording/loose/a.cpp", ""), "") << "a room that nobody named";
}

TEST(Layers, RoomsOfADiagnosisUseOnlyThoseBeforeThem) {
    EXPECT_EQ(faults("src/diagnose/select/a.cpp",
                     "#include \"diagnose/settings.h\"\n#include \"diagnose/options.h\"\n"
                     "#include \"diagnose/answer/diagnosis.h\"\n#include \"diagnose/model/problem.h\"\n"
                     "#include \"diagnose/select/fit.h\"\n#include \"recording/checks/left_out.h\"\n"),
              "");
    EXPECT_EQ(faults("src/diagnose/precheck.cpp", "#include \"diagnose/explain/where.h\""), "");
    EXPECT_EQ(faults("src/diagnose/model/a.h", "#include \"diagnose/select/fit.h\""),
              "src/diagnose/model/a.h:1: includes diagnose/select/fit.h: room model may not use room select of "
              "the same layer\n");
    const std::vector<std::string> rooms{"answer", "catalogue", "model", "select", "explain"};
    for (std::size_t here = 0; here < rooms.size(); ++here) {
        const std::string file = "src/diagnose/" + rooms[here] + "/a.cpp";
        for (std::size_t there = 0; there < rooms.size(); ++there) {
            const std::string include = "#include \"diagnose/" + rooms[there] + "/b.h\"";
            EXPECT_EQ(faults(file.c_str(), include.c_str()).empty(), there <= here) << file << " " << include;
        }
        EXPECT_NE(faults(file.c_str(), "#include \"diagnose/diagnose.h\""), "") << file;
        EXPECT_NE(faults(file.c_str(), "#include \"diagnose/precheck.h\""), "") << file;
        EXPECT_EQ(faults(file.c_str(), "#include \"diagnose/settings.h\""), "") << file;
        EXPECT_NE(faults("src/diagnose/options.h", ("#include \"diagnose/" + rooms[here] + "/b.h\"").c_str()), "");
        EXPECT_NE(faults("src/diagnose/settings.h", ("#include \"diagnose/" + rooms[here] + "/b.h\"").c_str()), "");
    }
}

TEST(Layers, RoomsOfABlindCheckUseOnlyThoseBeforeThem) {
    const std::vector<std::string> rooms{"world",         "drives", "key",     "faults",
                                         "detectability", "make",   "answers", "score"};
    for (std::size_t here = 0; here < rooms.size(); ++here) {
        const std::string file = "src/blind/" + rooms[here] + "/a.cpp";
        for (std::size_t there = 0; there < rooms.size(); ++there) {
            const std::string include = "#include \"blind/" + rooms[there] + "/b.h\"";
            EXPECT_EQ(faults(file.c_str(), include.c_str()).empty(), there <= here) << file << " " << include;
        }
    }
    EXPECT_NE(faults("src/blind/a.cpp", ""), "") << "every file has a room";
}

TEST(Layers, WhatComputesAnAnswerDoesNotPutItIntoWords) {
    for (const std::string room : {"catalogue", "model", "select", "explain"}) {
        const std::string file = "src/diagnose/" + room + "/a.cpp";
        for (const std::string header : {"words", "diagnosis_text", "diagnosis_json", "precheck_text"}) {
            EXPECT_NE(faults(file.c_str(), ("#include \"diagnose/answer/" + header + ".h\"").c_str()), "")
                << file << " " << header;
        }
        EXPECT_EQ(faults(file.c_str(), "#include \"diagnose/answer/diagnosis.h\""), "") << file;
    }
    EXPECT_EQ(faults("src/diagnose/diagnose.cpp", "#include \"diagnose/answer/words.h\""), "");
    EXPECT_EQ(faults("src/diagnose/answer/precheck_text.cpp", "#include \"diagnose/answer/words.h\""), "");
    EXPECT_EQ(faults("src/report/a.cpp", "#include \"diagnose/answer/words.h\""), "");
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
    EXPECT_EQ(faults("src/base/math/lanes.h", "typedef double V __attribute__((vector_size(32)));"), "");
}

TEST(Layers, FindSourcesThatAreIncludedAndFilesWithoutLayer) {
    EXPECT_NE(faults("tests/unit/a_test.cpp", "#include \"base/units/units.cpp\""), "");
    EXPECT_NE(faults("tools/tread/main.cpp", "#include \"run.cpp\""), "");
    EXPECT_NE(faults("src/common/a.h", ""), "");
    EXPECT_NE(faults("include/tread/surprise.h", ""), "");
    EXPECT_NE(faults("src/base/a.cpp", "#include \"common/a.h\""), "");
    EXPECT_NE(faults("src/base/a.cpp", "#include \"../base/units.h\""), "");
}

}  // namespace
}  // namespace tread::layers::layers_test
