// `tread tyre` through the real program: tables of steady-state forces, axes, page, overview.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "base/fields/numbers.h"
#include "cli/program.h"
#include "cli/tyre_table.h"
#include "shared/delft97_reference.h"
#include "shared/markup.h"
#include "shared/near.h"
#include "tread/tyre.h"

namespace tread::tyre_test {
namespace {

using reference::near;

const std::vector<std::string> kSlipColumns{"Vsy", "Fz", "Vx", "gamma", "Vsx"};  // any order will do
const std::vector<std::string> kResultColumns{"Fx", "Fy", "Mx", "My",  "Mz",  "Fx0",  "Fy0",   "t",    "Mzr",
                                              "s",  "Kx", "Ky", "mux", "muy", "SVyk", "kappa", "alpha"};

class Random {
public:
    explicit Random(unsigned seed) : generator_(seed) {}
    double operator()(double low, double high) { return std::uniform_real_distribution(low, high)(generator_); }

private:
    std::mt19937 generator_;
};

TyreTable randomSlips(int points, unsigned seed, bool with_lambdas) {
    TyreTable table{kSlipColumns, {}};
    TyreScaling lambda;
    if (with_lambdas) {
        for (const Number& n : numbers(lambda)) table.names.push_back("lambda_" + n.path);
    }
    Random random(seed);
    for (int i = 0; i < points; ++i) {
        std::vector<double>& row = table.rows.emplace_back(table.names.size());
        for (double& value : row) value = random(0.5, 1.5);
        const double Vx = random(0, 1) < 0.3 ? random(-40, 0) : random(0, 70);
        table.at(table.rows.size() - 1, "Fz") = random(-500, 12000);
        table.at(table.rows.size() - 1, "gamma") = random(-0.2, 0.2);
        table.at(table.rows.size() - 1, "Vx") = Vx;
        table.at(table.rows.size() - 1, "Vsx") = Vx * random(-1.2, 1.2);
        table.at(table.rows.size() - 1, "Vsy") = Vx * random(-1.2, 1.2);
    }
    return table;
}

TyreTable steadyTable(const TyreTable& input, const std::string& axes, std::vector<std::string> more = {}) {
    more.insert(more.end(), {"--axes", axes});
    return programTable("--table", input, more);
}

// ---- Steady state ----

long double expectedValue(const reference::Result& r, const std::string& column) {
    const std::map<std::string, long double> values{
        {"Fx", r.Fx},   {"Fy", r.Fy},   {"Mx", r.Mx},     {"My", r.My},       {"Mz", r.Mz},      {"Fx0", r.Fx0},
        {"Fy0", r.Fy0}, {"t", r.t},     {"Mzr", r.Mzr},   {"s", r.s},         {"Kx", r.Kx},      {"Ky", r.Ky},
        {"mux", r.mux}, {"muy", r.muy}, {"SVyk", r.SVyk}, {"kappa", r.kappa}, {"alpha", r.alpha}};
    return values.at(column);
}

// Below this a value counts as zero: a thousandth of its natural size, since sums of forces cancel.
double floorOf(const std::string& column, double Fz, const TyreCoefficients& p) {
    if (column == "t" || column == "s") return 1e-3 * p.Ro;
    if (column == "mux" || column == "muy") return 1e-3;
    if (column == "kappa" || column == "alpha") return 1e-15;
    return 1e-3 * std::max(Fz, 1.0) * (column[0] == 'M' ? p.Ro : 1);
}

constexpr double kSteadyTolerance = 1e-10;  // both formulations round differently

void expectReference(const TyreTable& table, const TyreParams& tyre) {
    double worst = 0;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        TyreScaling lambda = tyre.lambda;
        for (const Number& n : numbers(lambda)) {
            for (const std::string& name : table.names) {
                if (name == "lambda_" + n.path) *n.value = table.at(row, name);
            }
        }
        const double Fz = table.at(row, "Fz");
        const reference::Result expected = reference::steady(
            tyre.parameters, lambda,
            {Fz, table.at(row, "gamma"), table.at(row, "Vx"), table.at(row, "Vsx"), table.at(row, "Vsy")});
        for (const std::string& column : kResultColumns) {
            const long double value = expectedValue(expected, column);
            const long double size = std::max(std::abs(value), (long double)floorOf(column, Fz, tyre.parameters));
            EXPECT_TRUE(near(table.at(row, column), value, kSteadyTolerance * size)) << column << " of row " << row;
            worst = std::max(worst, double(std::abs(table.at(row, column) - value) / size));
        }
    }
    std::printf("%zu points, largest relative difference %.1e\n", table.rows.size(), worst);
}

TEST(TyreTable, AgreesWithASecondFormulation) {
    const TyreTable input = randomSlips(2000, 1, false);
    const TyreTable output = steadyTable(input, "paper");
    ASSERT_EQ(output.rows.size(), 2000u);
    expectReference(output, tyreWithCouples());
}

TEST(TyreTable, TakesEveryScalingFactorFromItsColumn) {
    const TyreTable input = randomSlips(1000, 2, true);
    ASSERT_EQ(input.names.size(), 30u);
    expectReference(steadyTable(input, "paper"), tyreWithCouples());
}

TEST(TyreTable, RepeatsTheInputAndThenNamesTheResultsOfTheDescription) {
    const TyreTable input = randomSlips(50, 3, true);
    const TyreTable output = steadyTable(input, "paper");
    std::vector<std::string> names = input.names;
    names.insert(names.end(), kResultColumns.begin(), kResultColumns.end());
    EXPECT_EQ(output.names, names);
    for (std::size_t row = 0; row < input.rows.size(); ++row) {
        for (const std::string& name : input.names) EXPECT_EQ(output.at(row, name), input.at(row, name));
    }
}

TEST(TyreTable, AColumnReplacesTheFactorOfTheTyre) {
    TyreTable input = randomSlips(20, 4, false);
    const TyreTable plain = steadyTable(input, "paper", {"--set", "lambda.muy=0.7"});
    input.names.push_back("lambda_muy");
    for (auto& row : input.rows) row.push_back(0.7);
    const TyreTable column = steadyTable(input, "paper", {"--set", "lambda.muy=1.3"});
    const TyreTable full = steadyTable(randomSlips(20, 4, false), "paper");
    for (std::size_t row = 0; row < 20; ++row) {
        for (const std::string& name : kResultColumns) EXPECT_EQ(column.at(row, name), plain.at(row, name)) << name;
        EXPECT_TRUE(near(plain.at(row, "muy"), 0.7 * full.at(row, "muy"), 1e-14));
    }
}

TEST(TyreTable, WritesNumbersThatReadBackExactlyAndAreShort) {
    const Scratch scratch;
    const std::string in = scratch.file("in.csv", "Fz,gamma,Vx,Vsx,Vsy\n4e3, +0.050 ,20,-1.0,1e-1\n");
    const Result result = runProgram({"tyre", kCarTyre, "--axes", "paper", "--table", in});
    EXPECT_EQ(result.status, 0);
    EXPECT_NE(result.out.find("\n4000,0.05,20,-1,0.1,"), std::string::npos) << result.out;
    const TyreTable table = parse(result.out);
    const TyreSteadyState exact = steadyState(reference::car205(), {4000, 0.05, 20, -1, 0.1});
    EXPECT_EQ(table.at(0, "Fy"), exact.Fy);
    EXPECT_EQ(table.at(0, "Mz"), exact.Mz);
}

TEST(TyreTable, ConvertsUnitsInBracketsAndThenGivesUnitsToTheResults) {
    const Scratch scratch;
    const std::string si = scratch.file("si.csv", "Fz,gamma,Vx,Vsx,Vsy\n4000,0.0349065850398866,20,-1,2\n");
    const std::string units = scratch.file(
        "units.csv",
        "\xEF\xBB\xBFVx [km/h], \"gamma [deg]\",Vsx,Fz [kN],Vsy [m/s]\r\n# a comment\r\n\r\n72,2,-1,4,2\r\n");
    const TyreTable a = parse(runProgram({"tyre", kCarTyre, "--axes", "paper", "--table", si}).out);
    const Result result = runProgram({"tyre", kCarTyre, "--axes", "paper", "--table", units});
    ASSERT_EQ(result.status, 0) << result.err;
    const TyreTable b = parse(result.out);
    const std::vector<std::string> head(b.names.begin(), b.names.begin() + 10);
    EXPECT_EQ(head, (std::vector<std::string>{"Vx [km/h]", "gamma [deg]", "Vsx", "Fz [kN]", "Vsy [m/s]", "Fx [N]",
                                              "Fy [N]", "Mx [N m]", "My [N m]", "Mz [N m]"}));
    EXPECT_EQ(b.rows[0][0], 72);
    EXPECT_EQ(b.rows[0][3], 4);
    EXPECT_TRUE(near(b.at(0, "Fy [N]"), a.at(0, "Fy"), 1e-9));
    EXPECT_TRUE(near(b.at(0, "t [m]"), a.at(0, "t"), 1e-14));
    EXPECT_TRUE(near(b.at(0, "alpha [-]"), a.at(0, "alpha"), 1e-15));
}

// ---- Axes ----

// Half a turn about x: components along y and z change sign. Written out again, to be independent of the product's.
const std::vector<std::string> kTurned{"Fy", "My", "Mz", "Fy0", "Mzr", "s", "SVyk"};

bool isTurned(const std::string& column) {
    return std::find(kTurned.begin(), kTurned.end(), column) != kTurned.end();
}

TEST(TyreAxes, IsoAndPaperAreTheSamePhysicsAfterHalfATurnAboutX) {
    const TyreTable paper_input = randomSlips(500, 5, false);
    TyreTable iso_input = paper_input;
    for (std::size_t row = 0; row < iso_input.rows.size(); ++row) iso_input.at(row, "Vsy") *= -1;
    const TyreTable paper = steadyTable(paper_input, "paper"), iso = steadyTable(iso_input, "iso");
    for (std::size_t row = 0; row < paper.rows.size(); ++row) {
        for (const std::string& column : kResultColumns) {
            const double sign = isTurned(column) ? -1 : 1;
            EXPECT_EQ(iso.at(row, column), sign * paper.at(row, column)) << column;
            EXPECT_FALSE(iso.at(row, column) == 0 && std::signbit(iso.at(row, column))) << column;
        }
    }
}

TEST(TyreAxes, TheAligningTorqueIsTheSumOfItsPartsInBothSystems) {
    const TyreTable input = randomSlips(300, 6, false);
    for (const char* axes : {"paper", "iso"}) {
        const TyreTable out = steadyTable(input, axes);
        for (std::size_t row = 0; row < out.rows.size(); ++row) {
            const auto x = [&](const char* name) { return out.at(row, name); };
            const double sum = -x("t") * (x("Fy") - x("SVyk")) + x("Mzr") + x("s") * x("Fx");  // (86), (88)
            EXPECT_TRUE(near(x("Mz"), sum, 1e-9)) << axes;
            EXPECT_EQ(x("kappa"), -x("Vsx") / std::abs(x("Vx")));
        }
    }
}

TEST(TyreAxes, ASlipAngleToTheLeftIsPositiveInIsoAndGivesAForceToTheRight) {
    // 5 deg: the wheel moves to its left, which is +y in ISO and -y in the paper; it rolls forward and is not cambered.
    const double speed = 20, slip = speed * std::tan(5 * std::numbers::pi / 180);
    const TyreTable iso = steadyTable({kSlipColumns, {{slip, 4000, speed, 0, 0}}}, "iso");
    const TyreTable paper = steadyTable({kSlipColumns, {{-slip, 4000, speed, 0, 0}}}, "paper");
    EXPECT_TRUE(near(iso.at(0, "alpha"), slip / speed, 1e-15));
    EXPECT_LT(iso.at(0, "Fy"), -2500);
    EXPECT_GT(iso.at(0, "Mz"), 20);  // turns the wheel to the left, into its direction of travel
    EXPECT_GT(iso.at(0, "t"), 0.005);
    EXPECT_LT(iso.at(0, "My"), -5);  // about +y to the left a forward rolling wheel turns positively: this brakes it
    EXPECT_GT(iso.at(0, "Ky"), 40000);
    EXPECT_GT(paper.at(0, "Fy"), 2500);
    EXPECT_LT(paper.at(0, "Mz"), -20);
    EXPECT_GT(paper.at(0, "My"), 5);
    EXPECT_EQ(paper.at(0, "alpha"), iso.at(0, "alpha"));

    // Camber to the right pulls to the right.
    const auto camberForce = [&](const char* axes) {
        const TyreTable out = steadyTable({kSlipColumns, {{0, 4000, speed, 0.1, 0}, {0, 4000, speed, -0.1, 0}}}, axes);
        return out.at(0, "Fy") - out.at(1, "Fy");
    };
    EXPECT_LT(camberForce("iso"), -500);
    EXPECT_GT(camberForce("paper"), 500);
}

TEST(TyreAxes, IsoIsTheDefault) {
    const Scratch scratch;
    const std::string in = scratch.file("in.csv", "Fz,gamma,Vx,Vsx,Vsy\n4000,0.05,20,-1,2\n");
    EXPECT_EQ(runProgram({"tyre", kCarTyre, "--table", in}).out,
              runProgram({"tyre", kCarTyre, "--table", in, "--axes", "iso"}).out);
}

// ---- Page, overview, JSON ----

TEST(TyrePlot, WritesAPageOfCurvesForEachAxisSystem) {
    const Scratch scratch;
    for (const char* axes : {"iso", "paper"}) {
        const std::string page = scratch.path(std::string(axes) + ".html");
        const Result result = runProgram({"tyre", kCarTyre, "--plot", page, "--axes", axes});
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.out, "Wrote 17 charts of car_205_60R15 to " + page + "\n");
        const std::string html = contentOf(page);
        EXPECT_NE(html.find("<h1>Tyre car_205_60R15</h1>"), std::string::npos);
        EXPECT_EQ(count(html, "class=\"tread-chart\""), 17u);
        for (const char* title : {"Longitudinal force at pure slip", "Friction ellipse", "Pneumatic trail",
                                  "Cornering stiffness", "Camber force", "after a step of slip angle"}) {
            EXPECT_NE(html.find(title), std::string::npos) << title;
        }
        EXPECT_EQ(html.find("nan"), std::string::npos);
    }
    EXPECT_NE(contentOf(scratch.path("iso.html")), contentOf(scratch.path("paper.html")));
    EXPECT_EQ(scratch.names(), (std::vector<std::string>{"iso.html", "paper.html"}));
}

TEST(TyreOverview, SaysWhatTheTyreIs) {
    const Result result = runProgram({"tyre", kCarTyre});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(
        firstLine(result.out),
        "Tyre car_205_60R15: peak friction 1.21 longitudinal and 0.99 lateral, cornering stiffness 0.803 kN/deg at its "
        "nominal load of 4000 N");
    EXPECT_EQ(result.err, "");
}

TEST(TyreOverview, GivesSiNumbersAsJson) {
    const Result result = runProgram({"tyre", kCarTyre, "--json", "--set", "lambda.mux=0.8"});
    ASSERT_EQ(result.status, 0);
    const auto json = nlohmann::json::parse(result.out);
    const TyreCoefficients p = reference::car205().parameters;
    const double Ky = p.pKy1 * p.Fzo * std::sin(2 * std::atan(1 / p.pKy2));  // (53) at the nominal load
    EXPECT_EQ(json["tyre"], "car_205_60R15");
    EXPECT_NEAR(json["facts"]["longitudinal_friction [-]"], 0.8 * p.pDx1, 1e-12);
    EXPECT_NEAR(json["facts"]["cornering_stiffness [N/rad]"], Ky, 1e-9 * Ky);
    EXPECT_NEAR(json["facts"]["lateral_relaxation_length [m]"], Ky / p.cFy, 1e-12);
}

TEST(TyreOptions, TakeOneValueEachAndLeaveTheFileThatFollows) {
    const Scratch scratch;
    const std::string in = scratch.file("in.csv", "Fz,gamma,Vx,Vsx,Vsy\n4000,0.05,20,-1,2\n");
    const std::string motion = scratch.file("motion.csv", "t,Vsx,Vsy,Vx,Omega,psidot,gamma,Fz\n0,0,0,9,30,0,0,4000\n");
    const std::vector<std::vector<std::string>> options{{"--set", "lambda.mux=0.8"},
                                                        {"--axes", "paper"},
                                                        {"--plot", scratch.path("plot.html")},
                                                        {"--table", in},
                                                        {"--table", in, "-o", scratch.path("out.csv")},
                                                        {"--transient", motion, "--substeps", "2"},
                                                        {"--transient", motion, "--interpolate", "linear"}};
    for (std::vector<std::string> words : options) {
        SCOPED_TRACE(words.front());
        words.insert(words.begin(), "tyre");
        std::vector<std::string> last = words;
        words.push_back(kCarTyre);
        last.insert(last.begin() + 1, kCarTyre);
        const Result result = runProgram(words);
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.out, runProgram(last).out);
    }
}

TEST(TyreAnswer, GoesToStandardErrorWhenTheTableGoesToStandardOutput) {
    const Scratch scratch;
    const std::string in = scratch.file("in.csv", "Fz,gamma,Vx,Vsx,Vsy\n4000,0.05,20,-1,2\n");
    const Result table = runProgram({"tyre", kCarTyre, "--table", in});
    EXPECT_EQ(parse(table.out).rows.size(), 1u);
    EXPECT_EQ(table.err, "Wrote 1 point to standard output\n");
    const Result file = runProgram({"tyre", kCarTyre, "--table", in, "-o", scratch.path("out.csv"), "--json"});
    EXPECT_EQ(file.err, "");
    const auto json = nlohmann::json::parse(file.out);
    EXPECT_EQ(json["answer"], "Wrote 1 point to " + scratch.path("out.csv"));
    EXPECT_EQ(json["table"]["rows"], 1);
    EXPECT_EQ(contentOf(scratch.path("out.csv")), table.out);
}

TEST(TyreNotes, OfATirFileAreWarningsAndStandOnThePage) {
    const Scratch scratch;
    const std::string tyre = scratch.file(
        "small.tir",
        "[MODEL]\nFITTYP = 52\n[UNITS]\nLENGTH = 'meter'\nFORCE = 'newton'\nANGLE = 'radians'\nMASS = 'kg'\n"
        "TIME = 'second'\n[DIMENSION]\nUNLOADED_RADIUS = 0.31\n[VERTICAL]\nFNOMIN = 4000\n"
        "VERTICAL_STIFFNESS = 2e5\n[LONGITUDINAL_COEFFICIENTS]\nPCX1 = 1.6\nPDX1 = 1.1\nPKX1 = 20\n"
        "REX1 = 0.6\n[LATERAL_COEFFICIENTS]\nPCY1 = 1.3\nPDY1 = 1\nPKY1 = -14\nPKY2 = 1.8\n");
    const Result result = runProgram({"tyre", tyre, "--plot", scratch.path("p.html")});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.err.find("warning: "), std::string::npos);
    EXPECT_NE(result.err.find("REX1"), std::string::npos) << result.err;
    EXPECT_NE(contentOf(scratch.path("p.html")).find("REX1"), std::string::npos);
    EXPECT_EQ(result.out, "Wrote 17 charts of small to " + scratch.path("p.html") + "\n");
}

}  // namespace
}  // namespace tread::tyre_test
