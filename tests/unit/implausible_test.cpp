#include "base/fields/implausible.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/units/slip.h"
#include "places/places.h"
#include "scenario/scenario.h"
#include "tread/load.h"
#include "tread/vehicle.h"
#include "vehicle/relations.h"

namespace tread::implausible_test {
namespace {

using Texts = std::vector<std::string>;

// ---- Every number of a car and a scenario says what is plausible ---------------------------------------------------

// Limits on both sides say as much, where they are not those of all that can be computed with.
bool isSaid(const Usual& usual, const Limits& limits) {
    return usual.said || (limits.lowest > -kInfinity && limits.highest < kInfinity);
}

struct Unsaid {
    Texts paths;
    Texts implausible_defaults;

    void judge(const std::string& path, double value, const Usual& usual, const Limits& limits) {
        if (!isSaid(usual, limits)) paths.push_back(path);
        if (usual.said && !std::isnan(value) && !usual.has(value)) implausible_defaults.push_back(path);
    }

    template <class T>
    void look(const std::string& path, const T& value, const About& about) {
        if constexpr (std::is_same_v<T, double> || std::is_same_v<T, int>) {
            judge(path, static_cast<double>(value), about.usual, about.limits);
        } else if constexpr (std::is_same_v<T, Curve>) {
            judge(path + ".y", 0, about.usual, about.limits);
            judge(path + ".x", 0, about.usual_argument, kAny);
            for (const Curve::Point& point : value.points) {
                judge(path + ".y", point.y, about.usual, about.limits);
                judge(path + ".x", point.x, about.usual_argument, kAny);
            }
        } else if constexpr (Described<T>) {
            fields(path, value);
        } else if constexpr (tread::detail::IsOptional<T>::value || tread::detail::IsVector<T>::value) {
            look(path, typename T::value_type{}, about);
        } else if constexpr (tread::detail::IsVariant<T>::value) {
            alternatives(path, value);
        }
    }
    template <class... T>
    void alternatives(const std::string& path, const std::variant<T...>&) {
        (fields(path + "." + std::string(T::kName), T{}), ...);
    }
    template <class T>
    void fields(const std::string& path, const T& object) {
        T::describe(object, [&](std::string_view name, const auto& value, const About& about) {
            look(joinPath(path, name), value, about);
        });
    }
};

template <class T>
Unsaid unsaidOf() {
    Unsaid unsaid;
    unsaid.fields("", T{});
    return unsaid;
}

TEST(Implausible, EveryNumberOfCarTyreAndScenarioHasAPlausibleRangeOrSaysThatItHasNone) {
    EXPECT_EQ(unsaidOf<VehicleParams>().paths, Texts{});
    EXPECT_EQ(unsaidOf<TyreParams>().paths, Texts{});
    EXPECT_EQ(unsaidOf<Scenario>().paths, Texts{});
}

TEST(Implausible, EveryDefaultIsPlausible) {
    EXPECT_EQ(unsaidOf<VehicleParams>().implausible_defaults, Texts{});
    EXPECT_EQ(unsaidOf<TyreParams>().implausible_defaults, Texts{});
    EXPECT_EQ(unsaidOf<Scenario>().implausible_defaults, Texts{});
}

// ---- Slips ---------------------------------------------------------------------------------------------------------

TEST(Slip, AUnitThatWasLeftOutIsNamed) {
    EXPECT_EQ(likelySlip("550", "m", {0.02, 3, true}), "\"550 mm\"");
    EXPECT_EQ(likelySlip("-0.5", "rad", {-0.2, 0.2, true}), "\"-0.5 deg\"");
    EXPECT_EQ(likelySlip("25", "N/m", {100, 2e6, true}), "\"25 N/mm\"");
    EXPECT_EQ(likelySlip("80", "m/s", {0, 70, true}), "\"80 km/h\"");
    EXPECT_EQ(likelySlip("80", "-", {0.02, 2, true}), "\"80 %\"");
    EXPECT_EQ(likelySlip("2.2", "Pa", {2e4, 1.2e6, true}), "\"2.2 bar\"");
    EXPECT_EQ(likelySlip("220", "Pa", {2e4, 1.2e6, true}), "\"220 kPa\"");
    EXPECT_EQ(likelySlip("6000", "rad/s", {50, 4000, true}), "\"6000 rpm\"");
    EXPECT_EQ(likelySlip("20", "K", {230, 420, true}), "\"20 degC\"");
    EXPECT_EQ(likelySlip("1.35", "kg", {300, 3000, true}), "\"1.35 t\"");
    EXPECT_EQ(likelySlip("1350000", "kg", {300, 3000, true}), "1350 kg, if the value is in g");
}

TEST(Slip, AUnitTooManyAndAnInvertedRatioAreNamed) {
    EXPECT_EQ(likelySlip("1250 lb", "kg", {600, 3000, true}), "\"1250 kg\"");
    EXPECT_EQ(likelySlip("0.0595", "-", {0.5, 40, true}), "the inverse, 16.8");
    EXPECT_EQ(likelySlip("1e9", "m", {0.02, 3, true}), "");
    EXPECT_EQ(likelySlip("soft", "N/m", {100, 2e6, true}), "");
}

TEST(Implausible, TheMessageHasValueUnitRangeAndSlip) {
    const Implausible height{"height", {"height"}, 550, "m", {0.02, 3, true}};
    EXPECT_EQ(implausibleText(height, "550"),
              "found 550 m, plausible values are 0.02 to 3 m; did you mean \"550 mm\"?");
    const Implausible mass{"mass", {"mass"}, 566.99, "kg", {613, 6130, true}, "for this size"};
    EXPECT_EQ(implausibleText(mass, "1250 lb"),
              "found 1250 lb (567 kg), plausible values are 613 to 6130 kg for this size; did you mean \"1250 kg\"?");
    const Implausible far{"height", {"height"}, 1e9, "m", {0.02, 3, true}};
    EXPECT_EQ(implausibleText(far, ""), "found 1000000000 m, plausible values are 0.02 to 3 m; check value and unit");
}

// ---- Numbers beside each other -------------------------------------------------------------------------------------

Texts pathsOf(const std::vector<Implausible>& numbers) {
    Texts paths;
    for (const Implausible& number : numbers) paths.push_back(number.path);
    return paths;
}

TEST(Relations, NumbersThatDoNotGoTogetherAreFound) {
    const VehicleParams sound = loadVehicle(sourceFile("vehicles/compact.yaml"));
    EXPECT_EQ(pathsOf(implausibleRelations(sound)), Texts{});
    const auto with = [&](auto change) {
        VehicleParams car = sound;
        change(car);
        return pathsOf(implausibleRelations(car));
    };
    EXPECT_EQ(with([](VehicleParams& car) { car.mass = 567; }), Texts{"mass"}) << "1250 lb";
    EXPECT_EQ(with([](VehicleParams& car) { car.mass = 1.35; }), Texts{"mass"}) << "tonnes";
    EXPECT_EQ(with([](VehicleParams& car) { car.front.suspension.spring = 250; }), Texts{"front.suspension.spring"});
    EXPECT_EQ(with([](VehicleParams& car) { car.rear.suspension.damper.bump = 1.8; }),
              Texts{"rear.suspension.damper.bump"});
    EXPECT_EQ(with([](VehicleParams& car) { car.brakes.full_pedal_torque = 5; }), Texts{"brakes.full_pedal_torque"});
    EXPECT_EQ(with([](VehicleParams& car) { car.front.tyre.parameters.Fzo = 40; }), Texts{"front.tyre.parameters.Fzo"});
}

TEST(Relations, NothingIsConcludedFromANumberThatIsImplausibleItself) {
    VehicleParams car = loadVehicle(sourceFile("vehicles/compact.yaml"));
    car.wheelbase = 2620;
    car.front.suspension.spring = 22;
    EXPECT_EQ(pathsOf(implausible(car)), (Texts{"wheelbase", "front.suspension.spring"}));
    EXPECT_EQ(pathsOf(implausibleRelations(car)), Texts{});
}

}  // namespace
}  // namespace tread::implausible_test
