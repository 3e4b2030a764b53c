#include "vehicle/relations.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/text/concat.h"
#include "base/text/number_text.h"
#include "tread/vector.h"

namespace tread {
namespace {

// All ends are [guess], about the published numbers that their lines name, with room on both sides.

// Mass over the 3/2 power of wheelbase times mean track, kg/m3: solar racing cars 27, karts and light sports cars 60 to
// 80, cars 170, trucks of 40 t 900, the 1:10 model of 1.6 kg 970.
constexpr Usual kDensity{15, 3000, true};

// Yaw radius of gyration squared over the product of the distances of both axles from the centre of gravity: cars 0.8
// to 1.2, the 1:10 model 0.41, buses with long overhangs 1.5.
constexpr Usual kYawIndex{0.2, 2, true};

// Frequency of the body on one spring, Hz: cars 1 to 2, racing cars 3 to 8, the 1:10 model 10.
constexpr Usual kBounce{0.4, 25, true};

// Damping over critical damping: friction of the links alone 0.1, cars 0.2 to 0.4, racing cars up to 1 and more.
constexpr Usual kDampingRatio{0.01, 5, true};

// Load on the standing wheel over the nominal load of its tyre: cars 0.5 to 1.
constexpr Usual kTyreLoad{0.05, 5, true};

// Deflection of the tyre by that load over its radius: cars 0.06, models with hard tyres less.
constexpr Usual kTyreDeflection{0.0005, 0.3, true};

// Force of all brakes at full pedal over the weight: cars 1 to 2.
constexpr Usual kBraking{0.1, 10, true};

// The values of a number at which another that is `per` of it is usual: the ends in the order of their size.
Usual multiple(double factor, const Usual& usual) {
    return {factor * usual.lowest, factor * usual.highest, true};
}
Usual over(double factor, const Usual& usual) {
    return {factor / usual.highest, factor / usual.lowest, true};
}

std::string about(double value, std::string_view unit) {
    const double digits = std::pow(10, 2 - std::floor(std::log10(value)));
    return concat({numberText(std::round(value * digits) / digits), " ", unit});
}

class Relations {
public:
    explicit Relations(const VehicleParams& car) : car_(car), alone_(implausible(car)) {}

    std::vector<Implausible> all() {
        const double size = car_.wheelbase * 0.5 * (car_.front.track + car_.rear.track);
        const double behind = car_.wheelbase - car_.front_axle_distance;
        if (sound({"mass", "wheelbase", "front.track", "rear.track"})) {
            judge("mass", car_.mass, "kg", multiple(std::pow(size, 1.5), kDensity),
                  "for wheelbase and tracks of this car");
        }
        if (sound({"mass", "inertia.yaw", "wheelbase", "front_axle_distance"})) {
            judge("mass", car_.mass, "kg", over(car_.inertia.yaw / (car_.front_axle_distance * behind), kYawIndex),
                  "for the moment of inertia inertia.yaw of " + about(car_.inertia.yaw, "kg m2"));
        }
        if (!sound({"mass", "wheelbase", "front_axle_distance"})) return std::move(found_);
        axle("front", car_.front, behind / car_.wheelbase);
        axle("rear", car_.rear, car_.front_axle_distance / car_.wheelbase);
        const double radius = 0.5 * (car_.front.tyre.parameters.Ro + car_.rear.tyre.parameters.Ro);
        if (sound({"brakes.full_pedal_torque", "front.tyre.parameters.Ro", "rear.tyre.parameters.Ro"}) &&
            car_.brakes.full_pedal_torque != 0) {
            judge("brakes.full_pedal_torque", car_.brakes.full_pedal_torque, "N m",
                  multiple(radius * car_.mass * kStandardGravity, kBraking), "for wheels and weight of this car");
        }
        return std::move(found_);
    }

private:
    bool sound(std::initializer_list<std::string_view> paths) const {
        return std::none_of(paths.begin(), paths.end(), [&](std::string_view path) {
            const auto is = [&](const Implausible& one) { return one.path == path; };
            return std::any_of(alone_.begin(), alone_.end(), is) || std::any_of(found_.begin(), found_.end(), is);
        });
    }

    void judge(const std::string& path, double value, const std::string& unit, const Usual& usual, std::string why) {
        const bool comparable = std::isfinite(usual.lowest) && std::isfinite(usual.highest) && !std::isnan(value);
        if (comparable && !usual.has(value)) found_.push_back({path, {path}, value, unit, usual, std::move(why)});
    }

    void axle(const std::string& name, const AxleParams& axle, double share) {
        const double carried = 0.5 * share * car_.mass, load = carried * kStandardGravity;
        const std::string for_load = "for a wheel that carries " + about(load, "N");
        const double sprung = carried - axle.unsprung_mass;
        const SuspensionParams& suspension = axle.suspension;
        const std::string spring = name + ".suspension.spring", damper = name + ".suspension.damper.";
        if (sprung > 0 && sound({spring, name + ".unsprung_mass"})) {
            const double squared = std::pow(2 * std::numbers::pi, 2) * sprung;
            if (suspension.spring_curve.empty()) {
                judge(spring, suspension.spring, "N/m",
                      {squared * kBounce.lowest * kBounce.lowest, squared * kBounce.highest * kBounce.highest, true},
                      for_load);
            }
            const Usual damping = multiple(2 * std::sqrt(suspension.spring * sprung), kDampingRatio);
            if (suspension.spring_curve.empty() && sound({spring})) {
                judgeDamping(damper + "bump", suspension.damper.bump, suspension.damper.bump_curve, damping);
                judgeDamping(damper + "rebound", suspension.damper.rebound, suspension.damper.rebound_curve, damping);
            }
        }
        const std::string tyre = name + ".tyre.parameters.";
        const TyreCoefficients& p = axle.tyre.parameters;
        if (sound({tyre + "Fzo"}))
            judge(tyre + "Fzo", p.Fzo, "N", over(load / axle.tyre.lambda.Fzo, kTyreLoad), for_load);
        if (sound({tyre + "pz1", tyre + "Ro"}))
            judge(tyre + "pz1", p.pz1, "N/m", over(load / (p.Ro * axle.tyre.lambda.Cz), kTyreDeflection), for_load);
    }

    void judgeDamping(const std::string& path, double value, const Curve& curve, const Usual& usual) {
        if (value != 0 && curve.empty() && sound({path}))
            judge(path, value, "N s/m", usual, "for this wheel's spring and load");
    }

    const VehicleParams& car_;
    std::vector<Implausible> alone_;  // numbers that are implausible by themselves
    std::vector<Implausible> found_;
};

}  // namespace

std::vector<Implausible> implausibleRelations(const VehicleParams& car) {
    return Relations(car).all();
}

}  // namespace tread
