// A car as an FMU: its description keeps the rules of the standard, and a master drives it as the headless run does.
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "program.h"
#include "shared/fmu_importer.h"
#include "shared/vehicle_run.h"

namespace tread::fmu_test {
namespace {

using shared::carOf;
using shared::channel;
using shared::Fmu;
using shared::FmuCar;
using Attributes = std::map<std::string, std::string>;

const double kNaN = std::numeric_limits<double>::quiet_NaN();

// Written once for all tests of a version.
class FmuOf : public testing::TestWithParam<int> {
protected:
    static std::string write(const Scratch& folder, int version, const std::vector<std::string>& more = {}) {
        const std::string file = folder.path("car.fmu");
        std::vector<std::string> words{
            "fmu", sourceFile("vehicles/compact.yaml"), "-o", file, "--fmi", std::to_string(version)};
        words.insert(words.end(), more.begin(), more.end());
        const Result result = runProgram(words);
        EXPECT_EQ(result.status, 0) << result.err;
        return file;
    }
    static const Fmu& fmu() {
        static std::map<int, std::unique_ptr<Fmu>> made;
        std::unique_ptr<Fmu>& one = made[GetParam()];
        if (!one) {
            const Scratch scratch;
            one = std::make_unique<Fmu>(write(scratch, GetParam()));
        }
        return *one;
    }
    static bool fmi3() { return GetParam() == 3; }
};

struct ModelVariable {
    Attributes is;    // name, valuereference, causality, ...
    Attributes type;  // unit, start, min, max
    bool flag;
};

std::vector<ModelVariable> variablesIn(const Fmu& fmu, bool fmi3) {
    std::vector<ModelVariable> variables;
    for (std::size_t i = 0; i < fmu.tags.size(); ++i) {
        const Tag& tag = fmu.tags[i];
        if (tag.closes) continue;
        if (fmi3 && (tag.name == "float64" || tag.name == "boolean"))
            variables.push_back({tag.attributes, tag.attributes, tag.name == "boolean"});
        if (!fmi3 && tag.name == "scalarvariable")
            variables.push_back({tag.attributes, fmu.tags[i + 1].attributes, fmu.tags[i + 1].name == "boolean"});
    }
    return variables;
}

std::string saidBy(const auto& action) {
    try {
        action();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "nothing";
}

// ---- The description ----

// identifier ("[" number "]")* joined by dots.
bool isStructured(const std::string& name) {
    std::istringstream parts(name);
    for (std::string part; std::getline(parts, part, '.');) {
        const std::string identifier = part.substr(0, part.find('['));
        if (identifier.empty() || std::isdigit(static_cast<unsigned char>(identifier[0]))) return false;
        for (const char c : identifier)
            if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_') return false;
        const std::string index = part.substr(identifier.size());
        if (index.find_first_not_of("[]0123456789") != std::string::npos) return false;
    }
    return true;
}

TEST_P(FmuOf, VariablesKeepTheRulesOfTheStandard) {
    const auto variables = variablesIn(fmu(), fmi3());
    std::set<std::string> units, names;
    for (const Tag& tag : fmu().tags) {
        if (tag.name == "unit" && !tag.closes) {
            EXPECT_TRUE(units.insert(tag.attributes.at("name")).second);
        }
    }
    std::set<std::string> references;
    int independent = 0;
    for (const auto& [is, type, flag] : variables) {
        const std::string& name = is.at("name");
        EXPECT_TRUE(names.insert(name).second) << name << " twice";
        EXPECT_TRUE(references.insert(is.at("valuereference")).second) << name;
        EXPECT_TRUE(isStructured(name)) << name;
        EXPECT_FALSE(is.at("description").empty()) << name;
        if (type.contains("unit")) {
            EXPECT_TRUE(units.contains(type.at("unit"))) << name << ": " << type.at("unit");
        }
        const std::string& causality = is.at("causality");
        const std::string& variability = is.at("variability");
        const bool given = causality == "input" || causality == "parameter";
        EXPECT_EQ(type.contains("start"), given) << name;
        const std::string initial = is.contains("initial") ? is.at("initial") : "";
        const Attributes expected{{"parameter", "fixedexact"},
                                  {"calculatedParameter", "fixedcalculated"},
                                  {"output", "continuouscalculated"},
                                  {"input", "continuous"},
                                  {"independent", "continuous"}};
        EXPECT_EQ(variability + initial, expected.at(causality)) << name;
        independent += causality == "independent";
        if (flag) {
            EXPECT_EQ(causality, "parameter") << name;
        }
        if (!given || flag) continue;
        const double start = std::stod(type.at("start"));
        EXPECT_TRUE(std::isfinite(start)) << name;
        if (type.contains("min")) {
            EXPECT_LE(std::stod(type.at("min")), start) << name;
        }
        if (type.contains("max")) {
            EXPECT_GE(std::stod(type.at("max")), start) << name;
        }
    }
    EXPECT_EQ(independent, 1);
    for (const char* name : {"driver.steering_wheel_angle", "ground.rear_left.nx", "wind.x", "start.speed",
                             "settings.external_ground", "car.mass", "car.front.suspension.spring", "found.throttle",
                             "chassis.yaw_rate", "wheel.front_left.load", "wheel_centre.front_left.x"})
        EXPECT_TRUE(names.contains(name)) << name;
}

TEST_P(FmuOf, StructureListsOutputsByIndexOrReference) {
    const auto variables = variablesIn(fmu(), fmi3());
    std::vector<std::string> expected, initial;
    for (std::size_t i = 0; i < variables.size(); ++i) {
        const std::string key = fmi3() ? variables[i].is.at("valuereference") : std::to_string(i + 1);
        const std::string& causality = variables[i].is.at("causality");
        if (causality == "output") expected.push_back(key);
        if (causality == "output" || causality == "calculatedParameter") initial.push_back(key);
    }
    std::vector<std::string> outputs, unknowns;
    std::string list;
    for (const Tag& tag : fmu().tags) {
        if (fmi3() && tag.name == "output") outputs.push_back(tag.attributes.at("valuereference"));
        if (fmi3() && tag.name == "initialunknown") unknowns.push_back(tag.attributes.at("valuereference"));
        if (tag.name == "outputs" || tag.name == "initialunknowns") list = tag.name;
        if (tag.name == "unknown") (list == "outputs" ? outputs : unknowns).push_back(tag.attributes.at("index"));
    }
    EXPECT_EQ(outputs, expected);
    EXPECT_EQ(unknowns, initial);
}

TEST_P(FmuOf, UnitsAreMadeOfBaseUnits) {
    Attributes found;
    for (std::size_t i = 0; i + 1 < fmu().tags.size(); ++i) {
        const Tag& tag = fmu().tags[i];
        if (tag.name != "unit" || tag.closes) continue;
        std::string base;
        for (const auto& [unit, exponent] : fmu().tags[i + 1].attributes) base += unit + exponent + " ";
        found[tag.attributes.at("name")] = base;
    }
    EXPECT_EQ(found.at("N"), "kg1 m1 s-2 ");
    EXPECT_EQ(found.at("rad/s"), "rad1 s-1 ");
    EXPECT_EQ(found.at("kg m2"), "kg1 m2 ");
    EXPECT_EQ(found.at("K"), "k1 ");
    for (const auto& [unit, base] : found) EXPECT_FALSE(base.empty()) << unit;
}

TEST_P(FmuOf, ArchiveHoldsThreeFilesAndIsTheSameEachTime) {
    std::vector<std::string> names;
    for (const auto& [name, content] : fmu().files) names.push_back(name);
    const std::string object = fmi3() ? "binaries/x86_64-linux/tread.so" : "binaries/linux64/tread.so";
    EXPECT_EQ(names, (std::vector<std::string>{object, "modelDescription.xml", "resources/car.yaml"}));
    const Scratch first, second;
    const std::string bytes = contentOf(write(first, GetParam()));
    EXPECT_TRUE(bytes == contentOf(write(second, GetParam())));
    const Fmu other(write(second, GetParam(), {"--set", "mass=1300"}));
    EXPECT_NE(other.token, fmu().token);
    EXPECT_EQ(carOf(other)->get("car.mass"), 1300);
}

// ---- A master ----

// A turn, logged at 1000 rows per second, and the FMU's outputs after the same inputs.
Log headlessTurn() {
    Scenario scenario;
    scenario.start.speed = 20;
    scenario.log.rate = 1000;
    Phase& phase = scenario.phases.emplace_back();
    phase.steering = Table<Angle>{Curve{{{0.2, 0}, {0.5, 0.9}, {1, -0.9}}}};
    phase.brake = Table<Pedal>{Curve{{{0.8, 0}, {1, 0.3}}}};
    phase.until.duration = 1.2;
    return simulate(shared::compact(), scenario);
}

struct Signals {
    std::vector<std::string> names;
    std::vector<unsigned> references;
};
Signals signalsOf(const Fmu& fmu, bool fmi3, const std::string& causality, const std::string& beginning = {}) {
    Signals signals;
    for (const ModelVariable& one : variablesIn(fmu, fmi3)) {
        const std::string& name = one.is.at("name");
        if (one.is.at("causality") != causality || !name.starts_with(beginning) || name.starts_with("wheel_centre"))
            continue;
        signals.names.push_back(name);
        signals.references.push_back(fmu.reference(name));
    }
    return signals;
}

TEST_P(FmuOf, HasTheNumbersOfTheHeadlessRun) {
    const Log log = headlessTurn();
    const Signals inputs = signalsOf(fmu(), fmi3(), "input", "driver.");
    const Signals outputs = signalsOf(fmu(), fmi3(), "output");
    ASSERT_EQ(inputs.names.size() * sizeof(double), sizeof(VehicleInput));
    ASSERT_EQ(outputs.names.size() * sizeof(double), sizeof(VehicleOutput));
    const auto car = carOf(fmu());
    car->start({{"start.speed", 20}}, {{"settings.ramp_inputs", true}});
    std::vector<double> difference(outputs.names.size()), peak(outputs.names.size());
    double time = 0;
    for (std::size_t row = 0; row < channel(log, "time").size(); ++row) {
        std::vector<double> given;
        for (const std::string& name : inputs.names) given.push_back(channel(log, name)[row]);
        car->setAll(inputs.references, given);
        // The first input is that of the start: a ramp to it takes no time that matters.
        if (row > 0) {
            car->step(time, 0.001);
            time += 0.001;
        }
        const std::vector<double> got = car->getAll(outputs.references);
        for (std::size_t i = 0; i < got.size(); ++i) {
            const double expected = channel(log, outputs.names[i])[row];
            difference[i] = std::max(difference[i], std::abs(got[i] - expected));
            peak[i] = std::max(peak[i], std::abs(expected));
        }
    }
    double worst = 0;
    for (std::size_t i = 0; i < peak.size(); ++i)
        worst = peak[i] > 0 ? std::max(worst, difference[i] / peak[i]) : worst;
    std::printf("FMI %d: %.2g of the peak\n", GetParam(), worst);
    EXPECT_LT(worst, 1e-9);
    EXPECT_NEAR(car->get("time"), 1.2, 1e-9);
}

// Steps through a turn from `time` on, with outputs at the end.
std::vector<double> turn(FmuCar& car, const std::vector<unsigned>& outputs, double time, int steps, double angle) {
    for (int i = 0; i < steps; ++i) {
        car.set("driver.steering_wheel_angle", angle);
        car.step(time + 0.01 * i, 0.01);
    }
    return car.getAll(outputs);
}

TEST_P(FmuOf, TwoCarsAtOnceGoBackInTheirTurnsBitForBit) {
    const std::vector<unsigned> outputs = signalsOf(fmu(), fmi3(), "output").references;
    const auto left = carOf(fmu()), right = carOf(fmu());
    left->start({{"start.speed", 20}}, {});
    right->start({{"start.speed", 25}, {"start.y", 10}, {"car.mass", 1400}}, {});
    turn(*left, outputs, 0, 40, 0.5);
    turn(*right, outputs, 0, 40, -0.4);
    void* const in_left_turn = left->save();
    void* const in_right_turn = right->save();
    const std::string bytes = right->serialise(in_right_turn);
    const auto left_end = turn(*left, outputs, 0.4, 40, 0.5);
    const auto right_end = turn(*right, outputs, 0.4, 40, -0.4);
    EXPECT_GT(left->get("chassis.yaw_rate"), 0.1);
    EXPECT_LT(right->get("chassis.yaw_rate"), -0.1);
    EXPECT_LT(right->get("chassis.y"), 10);

    left->restore(in_left_turn);
    right->restore(in_right_turn);
    EXPECT_NEAR(left->get("time"), 0.4, 1e-12);
    EXPECT_EQ(turn(*left, outputs, 0.4, 40, 0.5), left_end);
    EXPECT_EQ(turn(*right, outputs, 0.4, 40, -0.4), right_end);

    // The bytes make any other instance of the FMU this car, with its parameters.
    const auto third = carOf(fmu());
    void* const read = third->deserialise(bytes);
    third->restore(read);
    EXPECT_EQ(third->get("car.mass"), 1400);
    EXPECT_EQ(turn(*third, outputs, 0.4, 40, -0.4), right_end);
    std::string damaged = bytes;
    damaged[damaged.size() / 2] ^= 1;
    EXPECT_NE(saidBy([&] { third->deserialise(damaged); }).find("damaged"), std::string::npos);
    EXPECT_NE(saidBy([&] { third->deserialise("short"); }).find("5 bytes"), std::string::npos);
    third->release(read);
    left->release(in_left_turn);
    right->release(in_right_turn);

    left->reset();
    left->start({{"start.speed", 20}}, {});
    turn(*left, outputs, 0, 40, 0.5);
    EXPECT_EQ(turn(*left, outputs, 0.4, 40, 0.5), left_end) << "anew from the beginning";
}

TEST_P(FmuOf, AnyCommunicationStepGivesTheSame) {
    const auto yaw = [](const std::vector<double>& steps) {
        const auto car = carOf(fmu());
        car->start({{"start.speed", 20}, {"driver.steering_wheel_angle", 0.5}}, {});
        double time = 0;
        for (std::size_t i = 0; time < 0.6 - 1e-9; ++i) {
            const double step = std::min(steps[i % steps.size()], 0.6 - time);
            car->step(time, step);
            time += step;
        }
        return car->get("chassis.yaw");
    };
    const double reference = yaw({0.001});
    EXPECT_GT(reference, 0.05);
    EXPECT_EQ(yaw({0.02}), reference);
    EXPECT_EQ(yaw({0.003, 0.007, 0.05}), reference);
    EXPECT_NEAR(yaw({0.0137, 0.0004}), reference, 1e-3 * reference);
}

TEST_P(FmuOf, DrivesOnTheGroundOfTheMaster) {
    // A slope of 10 %, of which the master knows the height under each wheel.
    const auto car = carOf(fmu());
    const double length = std::hypot(1, 0.1);
    const std::vector<std::string> wheels{"front_left", "front_right", "rear_left", "rear_right"};
    std::map<std::string, double> start{{"start.speed", 10}};
    for (const std::string& wheel : wheels) {
        start["ground." + wheel + ".nx"] = -0.1 / length;
        // Where the wheels stand at the start is not known before; the plane through the origin is.
        start["ground." + wheel + ".height"] = wheel.starts_with("front") ? 0.1 : -0.15;
    }
    car->start(start, {{"settings.external_ground", true}});
    const double throttle = car->get("found.throttle");
    EXPECT_GT(throttle, 0.1) << "uphill";
    car->set("driver.throttle", throttle);
    for (int i = 0; i < 200; ++i) {
        for (const std::string& wheel : wheels)
            car->set("ground." + wheel + ".height", 0.1 * car->get("wheel_centre." + wheel + ".x"));
        car->step(0.005 * i, 0.005);
    }
    EXPECT_NEAR(car->get("chassis.pitch"), -std::atan(0.1), 0.01);
    EXPECT_NEAR(car->get("chassis.vx"), 10 * std::cos(std::atan(0.1)), 0.3);
    const double height = car->get("chassis.z") - 0.1 * car->get("chassis.x");
    EXPECT_NEAR(height, 0.55, 0.1) << "of the centre of gravity above the slope";
}

TEST_P(FmuOf, RefusesWithASentence) {
    EXPECT_NE(saidBy([&] { carOf(fmu(), "{00000000-0000}"); }).find("found the GUID"), std::string::npos);
    const auto car = carOf(fmu());
    EXPECT_NE(saidBy([&] { car->set("car.mass", -1); }).find("car.mass: found -1, expected"), std::string::npos);
    EXPECT_NE(saidBy([&] { car->set("chassis.x", 1); }).find("chassis.x is computed"), std::string::npos);
    EXPECT_NE(saidBy([&] { car->setAll({99999}, {1}); }).find("value reference 99999"), std::string::npos);
    EXPECT_NE(saidBy([&] { car->get("chassis.x"); }).find("not known before"), std::string::npos);
    EXPECT_NE(saidBy([&] { car->set("settings.ramp_inputs", 1); }).find("is a boolean"), std::string::npos);
    EXPECT_NE(saidBy([&] { car->step(0, 0.01); }).find("initialisation mode"), std::string::npos);
    car->start({{"start.speed", 10}}, {});
    EXPECT_NE(saidBy([&] { car->set("car.mass", 1000); }).find("is a parameter"), std::string::npos);
    EXPECT_NE(saidBy([&] { car->set("driver.throttle", kNaN); }).find("driver.throttle: found"), std::string::npos);
    EXPECT_NE(saidBy([&] { car->step(0.5, 0.01); }).find("begins at 0.5 s"), std::string::npos);
    EXPECT_EQ(saidBy([&] { car->step(0, 0.01); }), "nothing") << "it goes on";
    const auto fast = carOf(fmu());
    EXPECT_NE(saidBy([&] {
                  fast->start({{"start.speed", 90}}, {});
              }).find("cannot hold the 90 m/s"),
              std::string::npos);
    const auto long_nose = carOf(fmu());
    EXPECT_NE(saidBy([&] {
                  long_nose->start({{"car.front_axle_distance", 5}}, {});
              }).find("front_axle_distance"),
              std::string::npos)
        << "a rule across parameters";
}

INSTANTIATE_TEST_SUITE_P(Version, FmuOf, testing::Values(2, 3), testing::PrintToStringParamName());

TEST(FmuCommand, AnswersInASentenceAndRefusesFaults) {
    const Scratch scratch;
    const Result result = runProgram({"fmu", sourceFile("vehicles/compact.yaml"), "-o", scratch.path("a.fmu")});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("FMI 2.0 for co-simulation"), std::string::npos) << result.out;
    EXPECT_EQ(scratch.names(), std::vector<std::string>{"a.fmu"});
    EXPECT_EQ(runProgram({"fmu", "no_such.yaml"}).status, 2);
    EXPECT_EQ(runProgram({"fmu", sourceFile("vehicles/compact.yaml"), "--fmi", "1"}).status, 2);
    const Result faulty = runProgram({"fmu", sourceFile("vehicles/compact.yaml"), "--set", "mas=1", "-o", "x.fmu"});
    EXPECT_EQ(faulty.status, 2);
    EXPECT_NE(faulty.err.find("did you mean \"mass\"?"), std::string::npos) << faulty.err;
}

TEST(FmuCommand, TakesTheNameOfAShippedCar) {
    const Scratch scratch;
    std::filesystem::current_path(sourceFile(""));  // where the shipped cars are looked for
    ASSERT_EQ(runProgram({"fmu", "compact", "-o", scratch.path("a.fmu")}).status, 0);
    ASSERT_EQ(runProgram({"fmu", "vehicles/compact.yaml", "-o", scratch.path("b.fmu")}).status, 0);
    EXPECT_EQ(contentOf(scratch.path("a.fmu")), contentOf(scratch.path("b.fmu")));
}

TEST(FmuObject, ShowsTheFunctionsOfTheStandardAndNeedsTheCLibraryAlone) {
    const std::string object = std::filesystem::path(programFile()).replace_filename("tread_fmu.so");
    const Result names = runOther("/usr/bin/nm", {"-D", "--defined-only", object});
    std::istringstream lines(names.out);
    int fmi2 = 0, fmi3 = 0;
    for (std::string address, kind, name; lines >> address >> kind >> name;) {
        EXPECT_TRUE(name.starts_with("fmi2") || name.starts_with("fmi3")) << name;
        (name.starts_with("fmi2") ? fmi2 : fmi3) += 1;
    }
    EXPECT_EQ(fmi2, 34);
    EXPECT_EQ(fmi3, 75);
    const Result needs = runOther("/usr/bin/readelf", {"--dynamic", "--wide", object});
    std::istringstream entries(needs.out);
    for (std::string line; std::getline(entries, line);) {
        if (line.find("(NEEDED)") == std::string::npos) continue;
        const bool of_the_c_library = line.find("[libc.so") != std::string::npos ||
                                      line.find("[libm.so") != std::string::npos ||
                                      line.find("[ld-linux") != std::string::npos ||
                                      line.find("san.so") != std::string::npos;  // of a build with sanitizers
        EXPECT_TRUE(of_the_c_library) << line;
    }
}

}  // namespace
}  // namespace tread::fmu_test
