#include "tyre/tir_file.h"

#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <sstream>

#include "base/fields/numbers.h"
#include "base/math/elementary.h"
#include "base/text/text_file.h"
#include "tyre/tir_map.h"
#include "tyre/tir_text.h"
#include "tyre/tir_units.h"

namespace tread {
namespace {

// Guesses for what no .tir file says, in proportion to the 205/60R15 of Pacejka's book (4000 N, 0.313 m): tyre mass,
// the part of it in the contact patch, carcass stiffness times radius over nominal load, damping ratio of patch on
// carcass.
constexpr double kTyreMassPerLoad = 9.3 / 4000;  // kg/N
constexpr double kPatchMassFraction = 1.0 / 9.3;
constexpr double kLongitudinalStiffness = 474500 * 0.313 / 4000;
constexpr double kLateralStiffness = 141800 * 0.313 / 4000;
constexpr double kDampingRatio = 0.2;
constexpr double kGyroscopic = 0.5;  // the paper's estimate for a steel belted radial car tyre, (25)-(27)

// Rolling radius lost per radial deflection, where the file has no BREFF, DREFF and FREFF: the belt of a radial tyre
// hardly changes its length, so that a third of the deflection is a fair estimate.
constexpr double kRollingRadiusLoss = 1.0 / 3;

constexpr std::string_view kDerivationKeys[] = {
    "BREFF", "DREFF", "FREFF", "PTX1", "PTY1", "PTY2", "LONGITUDINAL_STIFFNESS", "LATERAL_STIFFNESS", "IP", "IP_NOM"};

std::string text(double value) {
    std::ostringstream out;
    out << value;
    return out.str();
}

std::string inQuotes(std::string_view found) {
    std::string out("'");
    out += found;
    return out += "'";
}

class TirImport {
public:
    TirImport(const TirText& file, std::vector<Problem>& problems, std::vector<std::string>& warnings)
        : file_(file), problems_(problems), warnings_(warnings) {}

    bool isKnownModel();
    void readNumbers();
    void readUnits();
    TyreParams map();
    void derive(TyreParams& tyre);
    void warnOfLosses();

private:
    void complain(const TirEntry* at, std::string_view key, std::string what) {
        problems_.push_back({file_.file, at ? at->line : 0, at ? at->column : 0, std::string(key), std::move(what)});
    }
    void warn(std::string what) { warnings_.push_back(file_.file + ": " + std::move(what)); }
    double value(std::string_view key, double otherwise = 0) const {
        const auto found = values_.find(key);
        return found == values_.end() ? otherwise : found->second;
    }
    const TirEntry* single(std::string_view key, bool units = false);
    double unit(std::string_view key, std::span<const TirUnit> known);
    template <class Struct>
    void checkLimits(Struct& parameters, const std::map<const double*, std::string_view>& keys);
    TyreSide side();
    void deriveRollingRadius(TyreParams& tyre);
    void deriveCarcass(TyreCoefficients& p);

    const TirText& file_;
    std::vector<Problem>& problems_;
    std::vector<std::string>& warnings_;
    std::map<std::string_view, double> values_;  // as in the file
    TirScale scale_;
};

// The entry of a key that may be given once only, in whatever section.
const TirEntry* TirImport::single(std::string_view key, bool units) {
    const auto found = file_.find(key, units);
    if (found.size() > 1) complain(found[1], key, "is given twice, first in line " + std::to_string(found[0]->line));
    return found.empty() ? nullptr : found[0];
}

bool TirImport::isKnownModel() {
    const TirEntry* type = single("FITTYP");
    if (!type) type = single("PROPERTY_FILE_FORMAT");
    if (!type) {
        complain(nullptr, "FITTYP", "is missing, and so is PROPERTY_FILE_FORMAT: not a Magic Formula tyre file");
        return false;
    }
    const std::optional<double> number = numberIn(*type);
    const bool known = type->key == "FITTYP" && (number == 5 || number == 51 || number == 52 || number == 6);
    if (known || upperCase(type->value) == "PAC2002") return true;
    complain(
        type, type->key,
        "cannot read tyre model " + inQuotes(type->value) + "; expected FITTYP 5, 51, 52 or 6, or the format PAC2002");
    return false;
}

void TirImport::readNumbers() {
    const auto read = [this](std::string_view key) {
        const TirEntry* entry = single(key);
        if (!entry) return;
        if (const auto number = numberIn(*entry)) {
            values_[key] = *number;
        } else {
            complain(entry, key, "expected a number, found " + inQuotes(entry->value));
        }
    };
    for (const TirKey& row : tir::kCoefficients) read(row.key);
    for (const tir::ScalingKey& row : tir::kScaling) read(row.key);
    for (const tir::ForeignKey& row : tir::kForeign) read(row.key);
    for (const std::string_view key : kDerivationKeys) read(key);
}

// Factor from a unit of the file to SI.
double TirImport::unit(std::string_view key, std::span<const TirUnit> known) {
    const TirEntry* entry = single(key, true);
    if (!entry) {
        warn("[UNITS] does not give " + std::string(key) + ": taken as SI");
        return 1;
    }
    const std::string name = upperCase(entry->value);
    std::string expected;
    for (const TirUnit& candidate : known) {
        if (candidate.name == name) return candidate.si;
        if (!expected.empty()) expected += ", ";
        expected += candidate.name;
    }
    complain(entry, key, "cannot read the unit " + inQuotes(entry->value) + "; expected one of " + expected);
    return 1;
}

void TirImport::readUnits() {
    scale_.length = unit("LENGTH", kTirLengths);
    scale_.force = unit("FORCE", kTirForces);
    scale_.time = unit("TIME", kTirTimes);
    unit("ANGLE", kTirAngles);
    scale_.d = value("PDY1") < 0 ? -1 : 1;
    scale_.radius = value("UNLOADED_RADIUS") * scale_.length;
    scale_.nominal_load = value("FNOMIN") * scale_.force;
}

// `keys`: from which key of the file each parameter was read.
template <class Struct>
void TirImport::checkLimits(Struct& parameters, const std::map<const double*, std::string_view>& keys) {
    for (const Number& number : numbers(parameters)) {
        const auto read = keys.find(number.value);
        if (read == keys.end() || number.about.limits.allow(*number.value)) continue;
        const std::string_view key = read->second;
        complain(file_.find(key).front(), key,
                 "gives " + number.path + " = " + text(*number.value) + " (" + std::string(number.about.meaning) +
                     "), expected " + (number.about.limits.lowest_open ? "more than " : "at least ") +
                     text(number.about.limits.lowest));
    }
}

TyreSide TirImport::side() {
    const TirEntry* entry = single("TYRESIDE");
    const std::string name = entry ? upperCase(entry->value) : "";
    if (name == "RIGHT") return TyreSide::right;
    if (name != "LEFT") warn("TYRESIDE is " + (entry ? inQuotes(entry->value) : "not given") + ": taken as left");
    return TyreSide::left;
}

TyreParams TirImport::map() {
    TyreParams tyre;
    tyre.name = std::filesystem::path(file_.file).stem().string();
    tyre.side = side();
    std::map<const double*, std::string_view> keys;
    for (const TirKey& row : tir::kCoefficients) {
        double& parameter = tyre.parameters.*row.parameter;
        if (values_.contains(row.key)) {
            parameter = value(row.key) * factor(row.rule, scale_) + 0.0;  // no negative zeros
            keys[&parameter] = row.key;
        } else if (std::isnan(parameter) && file_.find(row.key).empty()) {
            complain(nullptr, row.key, "is missing");
        }
    }
    for (const tir::ScalingKey& row : tir::kScaling) {
        tyre.lambda.*row.parameter = value(row.key, 1);
        if (values_.contains(row.key)) keys[&(tyre.lambda.*row.parameter)] = row.key;
    }
    checkLimits(tyre.parameters, keys);
    checkLimits(tyre.lambda, keys);
    return tyre;
}

// The effective rolling radius at the nominal load, scaled as the file says.
void TirImport::deriveRollingRadius(TyreParams& tyre) {
    TyreCoefficients& p = tyre.parameters;
    const double nominal_deflection = p.Fzo / (p.pz1 * tyre.lambda.Cz);
    if (value("DREFF") != 0 || value("FREFF") != 0) {
        // Pacejka, "Tyre and Vehicle Dynamics": deflections over the nominal one
        const double loss =
            value("DREFF") * arctan(value("BREFF") * tyre.lambda.Fzo) + value("FREFF") * tyre.lambda.Fzo;
        const double x = value("BREFF") * tyre.lambda.Fzo;
        const double slope = tyre.lambda.Fzo * (value("DREFF") * value("BREFF") / (1 + x * x) + value("FREFF"));
        p.Re = p.Ro - nominal_deflection * loss;
        p.pRe1 = -nominal_deflection * slope / p.Re;
        warn("Re = " + text(p.Re) + " m and pRe1 = " + text(p.pRe1) +
             ", by BREFF, DREFF and FREFF at and about the nominal load");
    } else {
        const double loss = kRollingRadiusLoss * nominal_deflection * tyre.lambda.Fzo;
        p.Re = p.Ro - loss;
        p.pRe1 = -loss / p.Re;
        warn("Re = " + text(p.Re) + " m and pRe1 = " + text(p.pRe1) +
             ", guessed: UNLOADED_RADIUS minus a third of the deflection");
    }
    if (!(p.Re > 0) || !std::isfinite(p.Re) || !kRollingRadiusByLoad.allow(p.pRe1)) {
        complain(nullptr, "Re",
                 "the effective rolling radius comes out as " + text(p.Re) +
                     " m, and its variation with load, pRe1, as " + text(p.pRe1) +
                     "; see VERTICAL_STIFFNESS, LCZ, BREFF, DREFF and FREFF");
    }
}

// Carcass stiffness from (28), c = K / relaxation length, at the nominal load; else in proportion to a known tyre.
void TirImport::deriveCarcass(TyreCoefficients& p) {
    const auto choose = [&](double& stiffness, const std::string& name, std::string_view measured,
                            double slip_stiffness, double relaxation_length, double guess) {
        stiffness = value(measured) * factor(TirRule::stiffness, scale_);
        if (stiffness > 0) return;
        const bool relaxation_known = relaxation_length > 0;
        stiffness = relaxation_known ? slip_stiffness / relaxation_length : guess;
        warn(name + " = " + text(stiffness) + " N/m, " +
             (relaxation_known ? "from a relaxation length of " + text(relaxation_length) + " m at the nominal load"
                               : "guessed in proportion to FNOMIN / UNLOADED_RADIUS"));
    };
    const double load_by_radius = p.Fzo / p.Ro;
    const double lateral_peak = value("PTY2") == 0 ? 0 : sine(2 * arctan(1 / value("PTY2")));
    choose(p.cFx, "cFx", "LONGITUDINAL_STIFFNESS", p.Fzo * p.pKx1, value("PTX1") * p.Ro,
           kLongitudinalStiffness * load_by_radius);
    choose(p.cFy, "cFy", "LATERAL_STIFFNESS", p.pKy1 * p.Fzo * sine(2 * arctan(1 / p.pKy2)),
           value("PTY1") * lateral_peak * p.Ro, kLateralStiffness * load_by_radius);
}

void TirImport::derive(TyreParams& tyre) {
    TyreCoefficients& p = tyre.parameters;
    deriveRollingRadius(tyre);
    deriveCarcass(p);
    p.mt = kTyreMassPerLoad * p.Fzo;
    p.mc = kPatchMassFraction * p.mt;
    p.kFx = 2 * kDampingRatio * std::sqrt(p.cFx * p.mc);
    p.kFy = 2 * kDampingRatio * std::sqrt(p.cFy * p.mc);
    p.pTy8 = p.pTy9 = 0;
    p.czgyr = p.cygyr = p.cpsigyr = kGyroscopic;
    warn("guessed in proportion to a 205/60R15: mt = " + text(p.mt) + " kg, mc = " + text(p.mc) +
         " kg, kFx = " + text(p.kFx) + " N s/m, kFy = " + text(p.kFy) + " N s/m; gyroscopic coefficients " +
         text(kGyroscopic) + "; all of the camber force lags (pTy8 = pTy9 = 0)");
}

// What the 1997 model leaves out of the file.
void TirImport::warnOfLosses() {
    for (const tir::ForeignKey& row : tir::kForeign) {
        const double found = value(row.key, row.neutral);
        if (found != row.neutral) {
            warn(std::string(row.key) + " = " + text(found) + " has no counterpart in the 1997 model and is dropped");
        }
    }
    const auto approximate = [this](std::string_view key, bool differs, const char* how) {
        if (value(key, 1) != 1 && differs) warn(std::string(key) + " = " + text(value(key)) + how);
    };
    const auto any = [this](std::initializer_list<std::string_view> keys) {
        for (const std::string_view key : keys) {
            if (value(key) != 0) return true;
        }
        return false;
    };
    approximate("LFZO", true,
                ": the trail (66) becomes that many times as long as in MF 5.2; lambda.t can compensate for it");
    approximate("LHY", any({"PHY3"}), " also scales the camber part PHY3 here, as in (55)");
    approximate("LVY", any({"PVY3", "PVY4"}), " also scales the camber part PVY3, PVY4 here, as in (56)");
    approximate("LRES", any({"QDZ8", "QDZ9"}), " also scales the camber part QDZ8, QDZ9 here, as in (70)");
    if (value("RBX1") * value("RCX1") == 0) warn("RBX1 or RCX1 is zero: Fx does not depend on lateral slip");
    if (value("RBY1") * value("RCY1") == 0) warn("RBY1 or RCY1 is zero: Fy does not depend on longitudinal slip");
    for (const char* curve : {"DEFLECTION_LOAD_CURVE", "BOTTOMING_CURVE"}) {
        if (file_.hasSection(curve)) warn(curve + std::string(" is dropped: the radial stiffness is constant (83)"));
    }
    if (value("IP") != value("IP_NOM")) warn("the influence of inflation pressure (IP against IP_NOM) is dropped");
}

}  // namespace

TyreParams readTir(const std::filesystem::path& file, std::vector<std::string>& warnings) {
    std::string fault;
    const auto content = readTextFile(file, fault);
    if (!content) throw LoadError({{file.string(), 0, 0, "", fault}});
    if (content->size() > kLargestFile)
        throw LoadError({{file.string(), 0, 0, "", "is larger than 4 MB, expected a tyre property file"}});
    return parseTir(*content, file.string(), warnings);
}

TyreParams parseTir(std::string_view written, const std::string& file, std::vector<std::string>& warnings) {
    std::vector<Problem> problems;
    const auto throwIfAny = [&problems] {
        if (!problems.empty()) throw LoadError(problems);
    };
    const TirText content = parseTirText(written, file, problems);
    if (content.entries.empty()) throwIfAny();
    TirImport import(content, problems, warnings);
    if (!import.isKnownModel()) throwIfAny();
    import.readNumbers();
    import.readUnits();
    TyreParams tyre = import.map();
    throwIfAny();
    import.derive(tyre);
    import.warnOfLosses();
    throwIfAny();
    return tyre;
}

}  // namespace tread

namespace tread {

bool readForeign(TyreParams& tyre, const std::filesystem::path& file, std::vector<Problem>& problems) {
    if (file.extension() != ".tir" && file.extension() != ".TIR") return false;
    try {
        std::vector<std::string> warnings;
        tyre = readTir(file, warnings);
        tyre.notes = std::move(warnings);
    } catch (const LoadError& error) {
        problems.insert(problems.end(), error.problems().begin(), error.problems().end());
    }
    return true;
}

}  // namespace tread
