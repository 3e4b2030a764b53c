#include "tyre/tir_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/fields/numbers.h"
#include "shared/delft97_reference.h"
#include "shared/near.h"
#include "shared/scratch.h"
#include "tread/problem.h"

namespace tread::tir_file_test {
namespace {

using reference::Real;
using Keys = std::map<std::string, double>;

// Coefficients of a 205/60R15 tyre in ISO axes with the signs of a .tir file, rounded; every key that both models
// share.
const Keys kTyre{{"PCX1", 1.685},
                 {"PDX1", 1.21},
                 {"PDX2", -0.037},
                 {"PEX1", 0.344},
                 {"PEX2", 0.095},
                 {"PEX3", -0.02},
                 {"PEX4", 0.1},
                 {"PKX1", 21.5},
                 {"PKX2", -0.163},
                 {"PKX3", 0.245},
                 {"PHX1", -0.002},
                 {"PHX2", 0.002},
                 {"PVX1", 0.01},
                 {"PVX2", 0.005},
                 {"RBX1", 12.35},
                 {"RBX2", -10.8},
                 {"RCX1", 1.09},
                 {"RHX1", 0.007},
                 {"PCY1", 1.19},
                 {"PDY1", 0.99},
                 {"PDY2", -0.145},
                 {"PDY3", -11.2},
                 {"PEY1", -1.0},
                 {"PEY2", -0.54},
                 {"PEY3", -0.083},
                 {"PEY4", -4.8},
                 {"PKY1", -14.95},
                 {"PKY2", 2.13},
                 {"PKY3", -0.028},
                 {"PHY1", 0.003},
                 {"PHY2", -0.001},
                 {"PHY3", 0.075},
                 {"PVY1", 0.045},
                 {"PVY2", -0.024},
                 {"PVY3", -0.532},
                 {"PVY4", 0.039},
                 {"RBY1", 6.46},
                 {"RBY2", 4.2},
                 {"RBY3", -0.015},
                 {"RCY1", 1.08},
                 {"RHY1", 0.009},
                 {"RVY1", 0.053},
                 {"RVY2", -0.073},
                 {"RVY3", 0.517},
                 {"RVY4", 35.4},
                 {"RVY5", 1.9},
                 {"RVY6", -10.7},
                 {"QBZ1", 8.96},
                 {"QBZ2", -1.11},
                 {"QBZ3", -0.84},
                 {"QBZ4", 0.1},
                 {"QBZ5", -0.227},
                 {"QBZ9", 18.5},
                 {"QBZ10", 1.0},
                 {"QCZ1", 1.18},
                 {"QDZ1", 0.1},
                 {"QDZ2", -0.001},
                 {"QDZ3", 0.007},
                 {"QDZ4", 13.0},
                 {"QDZ6", -0.008},
                 {"QDZ7", 0.001},
                 {"QDZ8", -0.296},
                 {"QDZ9", -0.009},
                 {"QEZ1", -1.61},
                 {"QEZ2", -0.36},
                 {"QEZ3", 0.1},
                 {"QEZ4", 0.174},
                 {"QEZ5", -0.896},
                 {"QHZ1", 0.007},
                 {"QHZ2", -0.002},
                 {"QHZ3", 0.147},
                 {"QHZ4", 0.004},
                 {"SSZ1", 0.043},
                 {"SSZ2", 0.001},
                 {"SSZ3", 0.731},
                 {"SSZ4", -0.238},
                 {"QSX2", 0.4},
                 {"QSX3", 0.02},
                 {"QSY1", 0.01},
                 {"QSY2", 0.003},
                 {"FNOMIN", 4000},
                 {"UNLOADED_RADIUS", 0.313},
                 {"VERTICAL_STIFFNESS", 183600},
                 {"VERTICAL_DAMPING", 50}};

const std::string kHead =
    "[UNITS]\nLENGTH = 'meter'\nFORCE = 'newton'\nANGLE = 'radian'\nMASS = 'kg'\nTIME = 'second'\n"
    "[MODEL]\nFITTYP = 6\nTYRESIDE = 'LEFT'\n[COEFFICIENTS]\n";

std::string textOf(const Keys& keys) {
    std::ostringstream out;
    out.precision(17);
    for (const auto& [key, value] : keys) out << key << " = " << value << '\n';
    return out.str();
}

// The text as a file for the time of a test.
class TirFile : public ::testing::Test {
protected:
    TyreParams read(const std::string& text) {
        warnings.clear();
        return readTir(scratch.file("tyre.tir", text), warnings);
    }
    // The message of the failure, without the folder of the file.
    std::string faults(const std::string& text) {
        try {
            read(text);
        } catch (const LoadError& error) {
            std::string what = error.what();
            const std::string file = scratch.path("tyre.tir");
            for (std::size_t at = what.find(file); at != std::string::npos; at = what.find(file)) {
                what.replace(at, file.size(), "F");
            }
            return what;
        }
        return "no fault";
    }
    bool warns(const std::string& part) const {
        for (const std::string& warning : warnings) {
            if (warning.find(part) != std::string::npos) return true;
        }
        return false;
    }

    Scratch scratch;
    std::vector<std::string> warnings;
};

// ---- Magic Formula 5.2 in ISO axes (x forward, y left, z up), the terms that the 1997 model shares ------------------

struct IsoForces {
    Real Fx, Fy, Mx, My, Mz;
};

// Slip alpha = Vsy / |Vx| as a tangent; speed of rolling Vr (the 1997 model's factor on the rolling resistance).
IsoForces magicFormula52(const Keys& keys, Real Fz, Real kappa, Real alpha, Real gamma, Real Vr, Real cosine) {
    using std::atan, std::cos, std::sin, std::sqrt, std::abs, std::exp, std::min, std::max;
    const auto k = [&](const char* key) -> Real { return keys.contains(key) ? keys.at(key) : key[0] == 'L' ? 1 : 0; };
    const auto sign = [](Real x) { return x < 0 ? -1.0L : 1.0L; };
    const auto hill = [](Real C, Real Bx, Real E) { return cos(C * atan(Bx - E * (Bx - atan(Bx)))); };
    const auto wave = [](Real C, Real Bx, Real E) { return sin(C * atan(Bx - E * (Bx - atan(Bx)))); };
    const Real Fz0 = k("FNOMIN"), Fz0s = Fz0 * k("LFZO"), R0 = k("UNLOADED_RADIUS"), dfz = (Fz - Fz0s) / Fz0s;
    const Real gy = gamma * k("LGAY"), gz = gamma * k("LGAZ"), pi = std::numbers::pi_v<Real>;

    const Real kx = kappa + (k("PHX1") + k("PHX2") * dfz) * k("LHX"), Cx = k("PCX1") * k("LCX");
    const Real Dx = (k("PDX1") + k("PDX2") * dfz) * k("LMUX") * Fz;
    const Real Ex =
        min(1.0L, (k("PEX1") + k("PEX2") * dfz + k("PEX3") * dfz * dfz) * (1 - k("PEX4") * sign(kx)) * k("LEX"));
    const Real Kx = Fz * (k("PKX1") + k("PKX2") * dfz) * exp(k("PKX3") * dfz) * k("LKX");
    const Real SVx = Fz * (k("PVX1") + k("PVX2") * dfz) * k("LVX") * k("LMUX");
    const Real Fx0 = Dx * wave(Cx, Kx / (Cx * Dx) * kx, Ex) + SVx;

    const Real SHy = (k("PHY1") + k("PHY2") * dfz) * k("LHY") + k("PHY3") * gy, Cy = k("PCY1") * k("LCY"),
               ay = alpha + SHy;
    const Real muy = (k("PDY1") + k("PDY2") * dfz) * (1 - k("PDY3") * gy * gy) * k("LMUY"), Dy = muy * Fz;
    const Real Ey = min(1.0L, (k("PEY1") + k("PEY2") * dfz) * (1 - (k("PEY3") + k("PEY4") * gy) * sign(ay)) * k("LEY"));
    const Real Ky = k("PKY1") * Fz0s * sin(2 * atan(Fz / (k("PKY2") * Fz0s))) * (1 - k("PKY3") * abs(gy)) * k("LKY");
    const Real By = Ky / (Cy * Dy);
    const Real SVy = Fz * ((k("PVY1") + k("PVY2") * dfz) * k("LVY") + (k("PVY3") + k("PVY4") * dfz) * gy) * k("LMUY");
    const Real Fy0 = Dy * wave(Cy, By * ay, Ey) + SVy;

    const Real Bxa = k("RBX1") * cos(atan(k("RBX2") * kappa)) * k("LXAL"), SHxa = k("RHX1"), Cxa = k("RCX1");
    const Real Byk = k("RBY1") * cos(atan(k("RBY2") * (alpha - k("RBY3")))) * k("LYKA"), SHyk = k("RHY1"),
               Cyk = k("RCY1");
    const Real SVyk = muy * Fz * (k("RVY1") + k("RVY2") * dfz + k("RVY3") * gamma) * cos(atan(k("RVY4") * alpha)) *
                      sin(k("RVY5") * atan(k("RVY6") * kappa)) * k("LVYKA");
    const Real Fx = Fx0 * hill(Cxa, Bxa * (alpha + SHxa), 0) / hill(Cxa, Bxa * SHxa, 0);
    const Real Fy_slip = Fy0 * hill(Cyk, Byk * (kappa + SHyk), 0) / hill(Cyk, Byk * SHyk, 0), Fy = Fy_slip + SVyk;

    const Real at = alpha + k("QHZ1") + k("QHZ2") * dfz + (k("QHZ3") + k("QHZ4") * dfz) * gz,
               ar = alpha + SHy + SVy / Ky;
    const Real ate = sqrt(at * at + Kx * Kx / (Ky * Ky) * kappa * kappa) * sign(at);
    const Real are = sqrt(ar * ar + Kx * Kx / (Ky * Ky) * kappa * kappa) * sign(ar);
    const Real Bt = (k("QBZ1") + k("QBZ2") * dfz + k("QBZ3") * dfz * dfz) * (1 + k("QBZ4") * gz + k("QBZ5") * abs(gz)) *
                    k("LKY") / k("LMUY");
    const Real Ct = k("QCZ1");
    const Real Dt =
        Fz * (k("QDZ1") + k("QDZ2") * dfz) * (1 + k("QDZ3") * gz + k("QDZ4") * gz * gz) * R0 / Fz0s * k("LTR");
    const Real Et = min(1.0L, (k("QEZ1") + k("QEZ2") * dfz + k("QEZ3") * dfz * dfz) *
                                  (1 + (k("QEZ4") + k("QEZ5") * gz) * 2 / pi * atan(Bt * Ct * at)));
    const Real Br = k("QBZ9") * k("LKY") / k("LMUY") + k("QBZ10") * By * Cy;
    const Real Dr =
        Fz * ((k("QDZ6") + k("QDZ7") * dfz) * k("LRES") + (k("QDZ8") + k("QDZ9") * dfz) * gz) * R0 * k("LMUY");
    const Real s = R0 * (k("SSZ1") + k("SSZ2") * Fy / Fz0 + (k("SSZ3") + k("SSZ4") * dfz) * gamma) * k("LS");
    const Real Mz = -Dt * hill(Ct, Bt * ate, Et) * cosine * Fy_slip + Dr * cos(atan(Br * are)) * cosine + s * Fx;
    const Real Mx = R0 * Fz * (-k("QSX2") * gamma + k("QSX3") * Fy / Fz0) * k("LMX");
    const Real My = -R0 * Fz * (k("QSY1") + k("QSY2") * Fx / Fz0) * k("LMY") * 2 / pi * atan(Vr);
    return {Fx, Fy, Mx, My, Mz};
}

// Forces of the imported tyre against those of the file, at random states; tolerances are fractions of the load.
void expectSameForces(const TyreParams& tyre, const Keys& keys, std::mt19937& random, int states) {
    constexpr Real kRounding = 1e-12L;  // of Fz and of Fz times 1 m: the factors of the map round in double
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int i = 0; i < states; ++i) {
        const reference::Inputs in{4000 + 3500 * unit(random), 0.15 * unit(random), 20 + 15 * unit(random),
                                   6 * unit(random), 6 * unit(random)};
        const reference::Result paper = reference::steady(tyre.parameters, tyre.lambda, in);
        const IsoForces iso = magicFormula52(keys, in.Fz, -in.Vsx / in.Vx, -in.Vsy / in.Vx, in.gamma, in.Vx - in.Vsx,
                                             in.Vx / std::hypot(in.Vx, in.Vsy));
        ASSERT_TRUE(reference::near(paper.Fx, iso.Fx, kRounding * in.Fz));
        ASSERT_TRUE(reference::near(paper.Fy, -iso.Fy, kRounding * in.Fz));
        ASSERT_TRUE(reference::near(paper.Mx, iso.Mx, kRounding * in.Fz));
        ASSERT_TRUE(reference::near(paper.My, -iso.My, kRounding * in.Fz));
        ASSERT_TRUE(reference::near(paper.Mz, -iso.Mz, kRounding * in.Fz));
    }
}

TEST_F(TirFile, ImportedTyreGivesTheForcesOfTheFileTurnedToThePaperAxes) {
    std::mt19937 random(97);
    std::uniform_real_distribution<double> factor(0.7, 1.3);
    for (int file = 0; file < 60; ++file) {
        Keys keys = kTyre;
        for (auto& [key, value] : keys) value *= factor(random);
        for (const char* lambda : {"LCX",  "LMUX", "LEX",  "LKX",  "LHX",  "LVX",   "LCY", "LMUY", "LEY", "LKY",
                                   "LGAY", "LTR",  "LGAZ", "LXAL", "LYKA", "LVYKA", "LS",  "LMX",  "LMY", "LCZ"}) {
            keys[lambda] = factor(random);
        }
        if (file % 2 == 1) {  // the sign of the books' tables
            keys["PDY1"] *= -1;
            keys["PDY2"] *= -1;
        }
        const TyreParams tyre = read(kHead + textOf(keys));
        expectSameForces(tyre, keys, random, 300);
    }
}

// Would the comparison notice a wrong sign? Every parameter with its sign turned must move some force, but for those in
// which the formulas are even.
TEST_F(TirFile, TheComparisonWouldNoticeAWrongSignOfAnyKey) {
    const std::set<std::string> even{"pCx1", "pCy1", "rBx1", "rBx2", "rCx1", "rBy1", "rBy2", "rCy1", "rVy4"};
    const std::set<std::string> not_steady{"Re",  "pRe1", "pz1", "pz2", "pTy8",  "pTy9",  "mc",     "kFx",
                                           "kFy", "cFx",  "cFy", "mt",  "czgyr", "cygyr", "cpsigyr"};
    const TyreParams tyre = read(kHead + textOf(kTyre));
    TyreParams turned = tyre;
    for (const Number& number : numbers(turned.parameters)) {
        if (even.contains(number.path) || not_steady.contains(number.path)) continue;
        *number.value = -*number.value;
        Real largest = 0;
        for (const Real side : {-1.0L, 1.0L}) {
            for (const Real Vsx : {-1.0L, 0.0L, 1.0L}) {
                const reference::Inputs in{5000, 0.06L * side, 20, Vsx, side};
                const auto a = reference::steady(tyre.parameters, tyre.lambda, in);
                const auto b = reference::steady(turned.parameters, turned.lambda, in);
                for (const auto m : {&reference::Result::Fx, &reference::Result::Fy, &reference::Result::Mx,
                                     &reference::Result::My, &reference::Result::Mz}) {
                    largest = std::max(largest, std::abs(a.*m - b.*m));
                }
            }
        }
        EXPECT_FALSE(largest <= 1e-6L * 5000) << number.path;
        *number.value = -*number.value;
    }
}

TEST_F(TirFile, ScalingsThatMeanSomethingElseInTheFileAreNamed) {
    std::mt19937 random(3);
    Keys keys = kTyre;
    keys["LFZO"] = 0.8;
    TyreParams tyre = read(kHead + textOf(keys));
    EXPECT_TRUE(warns("LFZO = 0.8"));
    tyre.lambda.t /= 0.8;  // the remedy that the warning names
    expectSameForces(tyre, keys, random, 100);

    keys = kTyre;
    keys["LHY"] = keys["LVY"] = keys["LRES"] = 0.5;
    read(kHead + textOf(keys));
    for (const char* key : {"LHY = 0.5", "LVY = 0.5", "LRES = 0.5"}) EXPECT_TRUE(warns(key)) << key;
    for (const char* camber : {"PHY3", "PVY3", "PVY4", "QDZ8", "QDZ9"}) keys.erase(camber);
    tyre = read(kHead + textOf(keys));
    for (const char* key : {"LHY", "LVY", "LRES"}) EXPECT_FALSE(warns(key)) << key;
    expectSameForces(tyre, keys, random, 100);
}

// ---- Syntax and units ----------------------------------------------------------------------------------------------

TEST_F(TirFile, SectionsCommentsQuotesCaseTablesAndLineEndsAreRead) {
    std::string text =
        "\xEF\xBB\xBF$ remark = 1\r\n! another\r\n[MDI_HEADER]\r\n FILE_TYPE = 'tir'\r\n(COMMENTS)\r\n{comment}\r\n"
        "'no $ comment = here'\r\n" +
        kHead +
        "  pcx1=1.5$ shape\r\n[SHAPE]\r\n{radial width}\r\n 1.0 0.0\r\n"
        "[INERTIA]\r\nMASS = 9.3 ! another MASS than that of [UNITS]\r\n[REST]\r\n";
    Keys keys = kTyre;
    keys.erase("PCX1");
    keys.erase("PDX1");
    text += "PDX1 = +1.25e+000 \t $ with a plus\r\n" + textOf(keys);
    const TyreParams tyre = read(text);
    EXPECT_EQ(tyre.parameters.pCx1, 1.5);
    EXPECT_EQ(tyre.parameters.pDx1, 1.25);
    EXPECT_EQ(tyre.name, "tyre");
    EXPECT_EQ(tyre.side, TyreSide::left);
}

TEST_F(TirFile, UnitsOfTheFileAreConverted) {
    const TyreParams si = read(kHead + textOf(kTyre));
    Keys keys = kTyre;
    keys["UNLOADED_RADIUS"] = 313;
    keys["FNOMIN"] = 4;
    keys["VERTICAL_STIFFNESS"] = 0.1836;  // kN/mm
    keys["VERTICAL_DAMPING"] = 0.05;      // kN ms/mm
    keys["LATERAL_STIFFNESS"] = 0.12;     // kN/mm
    TyreParams tyre = read(
        "[UNITS]\nLENGTH='mm'\nFORCE='kN'\nANGLE='RADIANS'\nTIME='millisecond'\n[MODEL]\nFITTYP=51\n" + textOf(keys));
    const TyreCoefficients &a = si.parameters, &b = tyre.parameters;
    EXPECT_DOUBLE_EQ(b.Ro, a.Ro);
    EXPECT_DOUBLE_EQ(b.Fzo, a.Fzo);
    EXPECT_DOUBLE_EQ(b.pz1, a.pz1);
    EXPECT_DOUBLE_EQ(b.pz2, a.pz2);
    EXPECT_DOUBLE_EQ(b.qx1, a.qx1);
    EXPECT_DOUBLE_EQ(b.qy1, a.qy1);
    EXPECT_DOUBLE_EQ(b.Re, a.Re);
    EXPECT_DOUBLE_EQ(b.cFy, 120000);

    keys = kTyre;
    keys["UNLOADED_RADIUS"] = 0.313 / 0.0254;
    keys["FNOMIN"] = 4000 / 4.4482216152605;
    tyre = read("[UNITS]\nLENGTH='inch'\nFORCE='lbf'\nANGLE='rad'\nTIME='sec'\n[MODEL]\nFITTYP=5\n" + textOf(keys));
    EXPECT_NEAR(tyre.parameters.Ro, 0.313, 1e-15);
    EXPECT_NEAR(tyre.parameters.Fzo, 4000, 1e-11);

    read("[MODEL]\nFITTYP=5\n" + textOf(kTyre));
    for (const char* unit : {"LENGTH", "FORCE", "TIME", "ANGLE"}) EXPECT_TRUE(warns(unit)) << unit;
}

TEST_F(TirFile, UnknownUnitsAreErrorsWithTheirPlace) {
    const std::string units =
        "[UNITS]\nLENGTH = 'ell'\nFORCE='newton'\nTIME='s'\n ANGLE =  'degrees'\n[MODEL]\nFITTYP=5\n";
    const std::string message = faults(units + textOf(kTyre));
    EXPECT_NE(message.find("F:2:10: LENGTH: cannot read the unit 'ell'; expected one of M, METER"), std::string::npos)
        << message;
    EXPECT_NE(message.find("F:5:11: ANGLE: cannot read the unit 'degrees'"), std::string::npos) << message;
}

TEST_F(TirFile, AllFaultyLinesAreReportedAtOnceWithLineAndColumn) {
    const std::string text = kHead +
                             "PCX1 = 1.6x\n"     // 11
                             "  PDX1 = 'one'\n"  // 12
                             "PDX2 = \n"         // 13
                             "PKX1 = 20\n"       // 14
                             "pkx1 = 21\n"       // 15
                             "nonsense\n"        // 16
                             "PCY1 = 'open\n"    // 17
                             "[BROKEN\n"         // 18
                             "PEX1 = inf\n"      // 19
                             "PEX2 = 1 2\n";     // 20
    Keys keys = kTyre;
    for (const char* key : {"PCX1", "PDX1", "PDX2", "PKX1", "PCY1", "PEX1", "PEX2"}) keys.erase(key);
    const std::string message = faults(text + textOf(keys));
    for (const char* fault :
         {"F:11:8: PCX1: expected a number, found '1.6x'", "F:12:10: PDX1: expected a number, found 'one'",
          "F:13:7: PDX2: expected a number, found ''", "F:15:1: PKX1: is given twice, first in line 14",
          "F:16:1: expected KEY = value", "F:17:8: PCY1: the quote is not closed", "F:18:1: expected [SECTION]",
          "F:19:8: PEX1: expected a number, found 'inf'", "F:20:8: PEX2: expected a number, found '1 2'"}) {
        EXPECT_NE(message.find(fault), std::string::npos) << fault << "\nnot in\n" << message;
    }
}

TEST_F(TirFile, AKeyInTwoSectionsIsAnErrorWhereItIsRead) {
    const std::string twice = kHead + textOf(kTyre) + "[MORE]\nPKY1 = -15\n";
    EXPECT_NE(faults(twice).find("PKY1: is given twice, first in line "), std::string::npos);
    EXPECT_EQ(faults(kHead + "DATE = 1\n" + textOf(kTyre) + "[MORE]\nDATE = 2\n"), "no fault");
}

TEST_F(TirFile, MissingKeysAreReportedTogether) {
    Keys keys = kTyre;
    for (const char* key : {"FNOMIN", "PCX1", "PKY1", "VERTICAL_STIFFNESS", "PEX1"}) keys.erase(key);
    EXPECT_EQ(faults(kHead + textOf(keys)),
              "F: FNOMIN: is missing\nF: VERTICAL_STIFFNESS: is missing\nF: PCX1: is missing\nF: PKY1: is missing");
}

TEST_F(TirFile, ValuesOutsideTheirRangeAreErrorsWithTheParameterTheyGive) {
    Keys keys = kTyre;
    keys["PKY1"] = 14.95;  // the sign of other axes
    EXPECT_NE(faults(kHead + textOf(keys)).find("PKY1: gives pKy1 = -14.95"), std::string::npos);
    keys = kTyre;
    keys["LMUY"] = -1;
    EXPECT_NE(faults(kHead + textOf(keys)).find("LMUY: gives muy = -1"), std::string::npos);
}

TEST_F(TirFile, OnlyTheModelsThatMapAreAccepted) {
    const auto with = [&](const std::string& model) { return faults("[MODEL]\n" + model + "\n[C]\n" + textOf(kTyre)); };
    for (const char* good : {"FITTYP = 5", "FITTYP = 51", "FITTYP = 52 $ MF 5.2", "fittyp = 6", "FITTYP = 'PAC2002'",
                             "PROPERTY_FILE_FORMAT = 'PAC2002'", "PROPERTY_FILE_FORMAT = 'MF_05'\nFITTYP = 5"}) {
        EXPECT_EQ(with(good), "no fault") << good;
    }
    EXPECT_EQ(with("FITTYP = 61"),
              "F:2:10: FITTYP: cannot read tyre model '61'; expected FITTYP 5, 51, 52 or 6, or the format PAC2002");
    EXPECT_NE(with("PROPERTY_FILE_FORMAT = 'PAC89'").find("cannot read tyre model 'PAC89'"), std::string::npos);
    EXPECT_NE(with("X = 1").find("FITTYP: is missing"), std::string::npos);
    EXPECT_NE(faults("").find("FITTYP: is missing"), std::string::npos);
    EXPECT_THROW(readTir("no/such/file.tir", warnings), LoadError);
}

// ---- What a file does not say, and what it says in vain ------------------------------------------------------------

TEST_F(TirFile, RollingRadiusFollowsTheBookWhereTheFileAllowsIt) {
    Keys keys = kTyre;
    keys["BREFF"] = 9;
    keys["DREFF"] = 0.23;
    keys["FREFF"] = 0.01;
    const double deflection = 4000 / 183600.0;
    EXPECT_DOUBLE_EQ(read(kHead + textOf(keys)).parameters.Re, 0.313 - deflection * (0.23 * std::atan(9.0) + 0.01));
    EXPECT_TRUE(warns("Re = 0.3054"));
    EXPECT_DOUBLE_EQ(read(kHead + textOf(kTyre)).parameters.Re, 0.313 - deflection / 3);
    EXPECT_TRUE(warns("Re = 0.3057"));
    keys["DREFF"] = 15;
    EXPECT_NE(faults(kHead + textOf(keys)).find("effective rolling radius comes out as"), std::string::npos);
}

// The slope of the book's formula, as a difference quotient of the radii of two files that differ in their nominal
// load.
TEST_F(TirFile, RollingRadiusVariesWithTheLoadAsTheBooksDoesAboutTheNominalOne) {
    Keys keys = kTyre;
    keys["BREFF"] = 3;
    keys["DREFF"] = 0.23;
    keys["FREFF"] = 0.08;
    keys["LFZO"] = 1.1;
    const TyreCoefficients p = read(kHead + textOf(keys)).parameters;
    const double step = 1e-4;
    keys["LFZO"] = 1.1 * (1 + step);
    const double more = read(kHead + textOf(keys)).parameters.Re;
    keys["LFZO"] = 1.1 * (1 - step);
    const double less = read(kHead + textOf(keys)).parameters.Re;
    EXPECT_NEAR(p.pRe1, (more - less) / (2 * step * p.Re), 1e-8);
    EXPECT_LT(p.pRe1, -0.005);

    const TyreCoefficients guessed = read(kHead + textOf(kTyre)).parameters;
    EXPECT_NEAR(guessed.Re * (1 - guessed.pRe1), 0.313, 1e-15);  // without load, the unloaded radius
}

TEST_F(TirFile, CarcassStiffnessComesFromTheFileThenFromRelaxationLengthsThenFromAGuess) {
    TyreCoefficients p = read(kHead + textOf(kTyre)).parameters;
    EXPECT_NEAR(p.cFx, 474500, 1e-6);
    EXPECT_NEAR(p.cFy, 141800, 1e-6);
    EXPECT_TRUE(warns("cFx = 474500 N/m, guessed"));
    EXPECT_NEAR(p.mt, 9.3, 1e-12);
    EXPECT_NEAR(p.mc, 1, 1e-12);
    EXPECT_NEAR(p.kFx / (2 * std::sqrt(p.cFx * p.mc)), 0.2, 1e-12);
    EXPECT_EQ(p.czgyr, 0.5);

    // (28): sigma = K / c, with the relaxation lengths of the file at nominal load
    Keys keys = kTyre;
    keys["PTX1"] = 1.9;
    keys["PTY1"] = 2.1;
    keys["PTY2"] = 2.0;
    const TyreParams tyre = read(kHead + textOf(keys));
    const auto nominal = reference::steady(tyre.parameters, tyre.lambda, {4000, 0, 20, 0, 0});
    p = tyre.parameters;
    EXPECT_NEAR(static_cast<double>(nominal.Kx) / p.cFx, 1.9 * 0.313, 1e-12);
    EXPECT_NEAR(static_cast<double>(nominal.Ky) / p.cFy, 2.1 * std::sin(2 * std::atan(0.5)) * 0.313, 1e-12);
    EXPECT_TRUE(warns("from a relaxation length of 0.5947 m"));

    keys["LONGITUDINAL_STIFFNESS"] = 400000;
    keys["LATERAL_STIFFNESS"] = 120000;
    p = read(kHead + textOf(keys)).parameters;
    EXPECT_EQ(p.cFx, 400000);
    EXPECT_EQ(p.cFy, 120000);
    EXPECT_FALSE(warns("cFx = ")) << "nothing was guessed";
}

TEST_F(TirFile, WhatTheModelCannotRepresentIsNamedWithItsValue) {
    Keys keys = kTyre;
    read(kHead + textOf(keys));
    EXPECT_FALSE(warns("no counterpart"));
    for (const char* zero : {"PDX3", "REX1", "REX2", "REY1", "REY2", "RHY2", "QSX1", "QSY3", "QSY4"}) keys[zero] = 0;
    for (const char* one : {"LGAX", "LVMX", "LSGKP", "LSGAL", "LGYR"}) keys[one] = 1;
    read(kHead + textOf(keys));
    EXPECT_FALSE(warns("no counterpart")) << "neutral values are not worth a word";
    for (const char* key : {"PDX3", "REX1", "REX2", "REY1", "REY2", "RHY2", "QSX1", "QSY3", "QSY4", "LGAX", "LVMX",
                            "LSGKP", "LSGAL", "LGYR"}) {
        keys[key] = 0.62;
        read(kHead + textOf(keys));
        EXPECT_TRUE(warns(std::string(key) + " = 0.62 has no counterpart")) << key;
    }
    keys = kTyre;
    keys["RBX1"] = 0;
    keys.erase("RCY1");
    read(kHead + textOf(keys) + "[DEFLECTION_LOAD_CURVE]\n{pen fz}\n0 0\n");
    EXPECT_TRUE(warns("Fx does not depend on lateral slip"));
    EXPECT_TRUE(warns("Fy does not depend on longitudinal slip"));
    EXPECT_TRUE(warns("DEFLECTION_LOAD_CURVE"));
}

TEST_F(TirFile, TheSideIsThatOfTheFile) {
    const auto side = [&](const std::string& line) {
        return read("[MODEL]\nFITTYP = 6\n" + line + "\n" + textOf(kTyre)).side;
    };
    EXPECT_EQ(side("TYRESIDE = 'Right'"), TyreSide::right);
    EXPECT_EQ(side("TYRESIDE = LEFT"), TyreSide::left);
    EXPECT_FALSE(warns("TYRESIDE"));
    EXPECT_EQ(side("TYRESIDE = 'UNKNOWN'"), TyreSide::left);
    EXPECT_TRUE(warns("TYRESIDE is 'UNKNOWN': taken as left"));
}

// Files of others, not part of this repository: TREAD_TIR_FILES names a folder of them.
TEST(TirFilesOfOthers, AreReadToParametersWithinTheirLimits) {
    const char* folder = std::getenv("TREAD_TIR_FILES");
    if (!folder) GTEST_SKIP() << "TREAD_TIR_FILES is not set";
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".tir") continue;
        std::vector<std::string> warnings;
        TyreParams tyre = readTir(entry.path(), warnings);
        ++files;
        for (const Number& number : numbers(tyre)) {
            EXPECT_TRUE(number.about.limits.allow(*number.value))
                << entry.path() << ' ' << number.path << ' ' << *number.value;
        }
        for (const Real side : {-1.0L, 1.0L}) {  // slip of 5.7 degrees: more than any shift of the curves
            const auto r = reference::steady(tyre.parameters, tyre.lambda, {tyre.parameters.Fzo, 0, 20, 0, -2 * side});
            EXPECT_GT(r.Fy * side, 0) << entry.path() << ": the force must oppose the slip velocity";
            EXPECT_LT(r.Mz * side, 0) << entry.path() << ": the moment must turn the wheel into its path";
        }
        EXPECT_GT(tyre.parameters.Re, 0.9 * tyre.parameters.Ro) << entry.path();
        EXPECT_LT(tyre.parameters.Re, tyre.parameters.Ro) << entry.path();
    }
    EXPECT_GT(files, 0);
}

}  // namespace
}  // namespace tread::tir_file_test
