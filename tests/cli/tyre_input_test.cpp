// What users get wrong with `tread tyre`: status 2, a message that names the place, and no file half written.

#include <gtest/gtest.h>

#include "cli/program.h"
#include "cli/tyre_table.h"

namespace tread::tyre_input_test {
namespace {

const std::string kHeader = "Fz,gamma,Vx,Vsx,Vsy\n";
const std::string kMotionHeader = "t,Vsx,Vsy,Vx,Omega,psidot,gamma,Fz\n";

struct BadTable {
    std::string name;
    std::string option;  // --table or --transient
    std::string text;
    std::string message;  // behind the file's name
};

std::ostream& operator<<(std::ostream& out, const BadTable& bad) {
    return out << bad.name;
}

const std::vector<BadTable> kBadTables{
    {"Empty", "--table", "", ": is empty"},
    {"HeaderOnly", "--table", kHeader, ":1:1: has no rows"},
    {"RaggedRow", "--table", kHeader + "1,2,3,4,5\n1,2,3\n", ":3:5: found 3 values, the header has 5 columns"},
    {"LongRow", "--table", kHeader + "1,2,3,4,5,6\n", ":2:11: found 6 values, the header has 5 columns"},
    {"TextInANumber", "--table", kHeader + "1,2,3,fast,5\n", ":2:7: Vsx: found \"fast\", expected a number"},
    {"NumberWithATail", "--table", kHeader + "1,2,3 m/s,4,5\n", ":2:5: Vx: found \"3 m/s\", expected a number"},
    {"EmptyCell", "--table", kHeader + "1,,3,4,5\n", ":2:3: gamma: found an empty cell"},
    {"NotANumber", "--table", kHeader + "1,2,3,4,nan\n", ":2:9: Vsy: found \"nan\", expected a finite number"},
    {"Infinite", "--table", kHeader + "-inf,2,3,4,5\n", ":2:1: Fz: found \"-inf\", expected a finite number"},
    {"TooLarge", "--table", kHeader + "1,2,1e400,4,5\n", ":2:5: Vx: found \"1e400\", beyond the range"},
    {"UnknownColumn", "--table", "Fz,gama,Vx,Vsx,Vsy\n1,2,3,4,5\n",
     ":1:4: found the column \"gama\", expected Fz, gamma, Vx, Vsx or Vsy, or a scaling factor such as lambda_mux; "
     "did you mean \"gamma\"?"},
    {"UnknownScaling", "--table", "Fz,gamma,Vx,Vsx,Vsy,lambda_muz\n1,2,3,4,5,6\n", "did you mean \"lambda_mu"},
    {"RepeatedColumn", "--table", "Fz,gamma,Vx,Vsx,Vsy,Vx [km/h]\n1,2,3,4,5,6\n", ":1:21: column \"Vx\" appears twice"},
    {"MissingColumn", "--table", "Fz,gamma,Vx,Vsy\n1,2,3,4\n", ":1:1: found no column \"Vsx\" (longitudinal slip"},
    {"WrongUnit", "--table", "Fz,gamma,Vx [kg],Vsx,Vsy\n1,2,3,4,5\n",
     ":1:10: Vx: found the unit \"kg\", a mass; expected a speed such as [m/s]"},
    {"UnknownUnit", "--table", "Fz,gamma,Vx [parsec],Vsx,Vsy\n1,2,3,4,5\n", ":1:10: Vx: found the unknown unit"},
    {"ScalingBeyondItsLimits", "--table", "Fz,gamma,Vx,Vsx,Vsy,lambda_Cx\n1,2,3,4,5,-1\n",
     ":2:11: lambda_Cx: found \"-1\", expected above 0"},
    {"Semicolons", "--table", "Fz;gamma;Vx;Vsx;Vsy\n1;2;3;4;5\n", "expected column names separated by commas"},
    {"Binary", "--table", std::string("Fz\0,gamma", 9), ": is not a text file"},
    {"UnequalSampling", "--transient",
     kMotionHeader + "0,0,0,9,30,0,0,4000\n1,0,0,9,30,0,0,4000\n3,0,0,9,30,0,0,4000\n",
     ":4:1: t: found an interval of 2 s after intervals of 1 s, expected a fixed sampling interval"},
    {"SlightlyUnequalSampling", "--transient",
     kMotionHeader + "0,0,0,9,30,0,0,4000\n1,0,0,9,30,0,0,4000\n2.00001,0,0,9,30,0,0,4000\n", ":4:1: t: found an"},
    {"TimeStandsStill", "--transient", kMotionHeader + "0,0,0,9,30,0,0,4000\n0,0,0,9,30,0,0,4000\n",
     ":3:1: t: found 0 after 0, expected a time that increases"},
    {"TimeRunsBack", "--transient", "Vsx,t,Vsy,Vx,Omega,psidot,gamma,Fz\n0,5,0,9,30,0,0,4000\n0,4,0,9,30,0,0,4000\n",
     ":3:3: t: found 4 after 5, expected a time that increases"},
    {"MissingMotion", "--transient", "t,Vsx,Vsy,Vx,gamma,Fz\n0,0,0,9,0,4000\n", ":1:1: found no column \"Omega\""},
    {"ScalingInMotion", "--transient", "t,Vsx,Vsy,Vx,Omega,psidot,gamma,Fz,lambda_mux\n0,0,0,9,30,0,0,4000,1\n",
     ":1:36: found the column \"lambda_mux\""},
};

class TyreInput : public ::testing::TestWithParam<BadTable> {};

TEST_P(TyreInput, IsRejectedWithItsPlaceAndLeavesTheOutputAlone) {
    const BadTable& bad = GetParam();
    const Scratch scratch;
    const std::string in = scratch.file("in.csv", bad.text), out = scratch.file("out.csv", "kept");
    const Result result = runProgram({"tyre", kCarTyre, bad.option, in, "-o", out});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err.substr(0, in.size()), in) << result.err;
    EXPECT_NE(result.err.find(bad.message), std::string::npos) << result.err;
    EXPECT_EQ(contentOf(out), "kept");
    EXPECT_EQ(scratch.names(), (std::vector<std::string>{"in.csv", "out.csv"}));
}

INSTANTIATE_TEST_SUITE_P(All, TyreInput, ::testing::ValuesIn(kBadTables),
                         [](const auto& bad) { return bad.param.name; });

TEST(TyreInputs, EveryFaultOfATableIsNamedAtOnce) {
    const Scratch scratch;
    const std::string in = scratch.file("in.csv", kHeader + "1,2,3,4,x\n1,2,3,4,5\ny,2,3,4,5\n1,2\n");
    const Result result = runProgram({"tyre", kCarTyre, "--table", in});
    EXPECT_EQ(result.status, 2);
    for (const char* place : {":2:9: Vsy: ", ":4:1: Fz: ", ":5:3: "}) {
        EXPECT_NE(result.err.find(in + place), std::string::npos) << result.err;
    }
}

TEST(TyreInputs, AMissingFileIsNamed) {
    const Scratch scratch;
    const std::string none = scratch.path("none.csv");
    for (const char* option : {"--table", "--transient"}) {
        const Result result = runProgram({"tyre", kCarTyre, option, none, "-o", scratch.path("out.csv")});
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.err, none + ": cannot be read: No such file or directory\n");
    }
    EXPECT_EQ(runProgram({"tyre", kCarTyre, "--table", scratch.folder()})
                  .err.find(scratch.folder() + ": found a folder, expected a table of values or a log; "),
              0u);
    EXPECT_EQ(runProgram({"tyre", none, "--table", none}).status, 2);
    EXPECT_TRUE(scratch.names().empty());
}

TEST(TyreInputs, OptionsThatDoNotFitTogetherAreNamed) {
    const Scratch scratch;
    const std::string in = scratch.file("in.csv", kHeader + "4000,0,20,0,1\n");
    const auto errorsOf = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"tyre", kCarTyre});
        const Result result = runProgram(arguments);
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.out, "");
        return result.err;
    };
    EXPECT_NE(errorsOf({"--table", in, "--transient", in}).find("--transient: given together with --table"),
              std::string::npos);
    EXPECT_NE(errorsOf({"-o", scratch.path("out.csv")}).find("--output: nothing to write"), std::string::npos);
    EXPECT_NE(errorsOf({"--table", in, "--substeps", "2"}).find("--substeps: expected only with --transient"),
              std::string::npos);
    EXPECT_NE(errorsOf({"--standstill"}).find("--standstill: expected only with --transient"), std::string::npos);
    EXPECT_EQ(errorsOf({"--set", "lambda.muu=1"}),
              "--set: lambda.muu: found the unknown path \"lambda.muu\", expected the path of a field; did you mean "
              "\"lambda.mux\"? `tread describe tyre` lists all paths\n");
    EXPECT_EQ(runProgram({"tyre", kCarTyre, "--axes", "sae"}).status, 2);
    EXPECT_EQ(scratch.names(), std::vector<std::string>{"in.csv"});
}

}  // namespace
}  // namespace tread::tyre_input_test
