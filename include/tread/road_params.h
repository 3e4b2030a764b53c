// A road as files describe it: a plane with crown, and what lies on it.
//
// Road coordinates are those of the world: the road runs along x, y points to its left, z up. Heights add up.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "tread/describe.h"
#include "tread/height_field.h"

namespace tread {

// A rectangle of other friction; without limits it reaches to the horizon on that side.
struct FrictionPatch {
    double friction = kRequired;
    double x_from = -kInfinity;
    double x_to = kInfinity;
    double y_from = -kInfinity;
    double y_to = kInfinity;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(friction),
              About{"-", "factor on the friction of the road there", kNonNegative}.usually(0.02, 2));
        field(TREAD_FIELD(x_from), About{"m", "start along the road"}.unjudged());
        field(TREAD_FIELD(x_to), About{"m", "end along the road"}.unjudged());
        field(TREAD_FIELD(y_from), About{"m", "right edge"}.unjudged());
        field(TREAD_FIELD(y_to), About{"m", "left edge"}.unjudged());
    }

    static void check(const auto& self, auto&& complain) {
        if (!(self.x_from < self.x_to)) complain("x_to", "the patch must end beyond its beginning (x_from < x_to)");
        if (!(self.y_from < self.y_to)) complain("y_to", "the left edge must lie left of the right (y_from < y_to)");
    }
};
static_assert(describesEveryMember<FrictionPatch>());

// One period of a cosine: nothing is sharp.
struct CosineShape {
    static constexpr std::string_view kName = "cosine";
    static constexpr void describe(auto&, auto&&) {}
    bool operator==(const CosineShape&) const = default;
};
// Rises and falls linearly, level between.
struct RampShape {
    static constexpr std::string_view kName = "ramp";
    double rise = kRequired;
    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(rise), About{"m", "length of each slope", kPositive}.usually(0.001, 50));
    }
};
// Rises and falls at once.
struct PlankShape {
    static constexpr std::string_view kName = "plank";
    static constexpr void describe(auto&, auto&&) {}
    bool operator==(const PlankShape&) const = default;
};

// A bump, a kerb or, with a negative height, a pothole. Its sides are upright.
struct Obstacle {
    double x = kRequired;
    double y = 0;
    double heading = 0;
    double length = kInfinity;
    double width = kInfinity;
    double height = kRequired;
    std::variant<CosineShape, RampShape, PlankShape> shape;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(x), About{"m", "start along the road"}.unjudged());
        field(TREAD_FIELD(y), About{"m", "y of its middle"}.unjudged());
        field(TREAD_FIELD(heading),
              About{"rad", "direction of its length, 0 along x, positive to the left"}.usually(-6.3, 6.3));
        field(TREAD_FIELD(length), About{"m", "length; a kerb without one never ends", kPositive}.usually(0.005, 1000));
        field(TREAD_FIELD(width),
              About{"m", "width; without one it crosses the whole road", kPositive}.usually(0.005, 100));
        field(TREAD_FIELD(height), About{"m", "height; negative for a hole"}.usually(-1, 1));
        field(TREAD_FIELD(shape), About{"", "shape along its length"});
    }

    static void check(const auto& self, auto&& complain) {
        if (std::holds_alternative<CosineShape>(self.shape) && self.length == kInfinity)
            complain("length", "a cosine needs a length; give one, or take a ramp or a plank");
        if (const auto* ramp = std::get_if<RampShape>(&self.shape); ramp && 2 * ramp->rise > self.length)
            complain("length", "the length must hold both slopes of the ramp (2 rise <= length)");
    }
};
static_assert(describesEveryMember<Obstacle>());

// Classes of ISO 8608; each has four times the unevenness of the one before.
enum class RoadClass { none, A, B, C, D, E, F, G, H };
constexpr auto enumNames(RoadClass) {
    return std::array<std::string_view, 9>{"none", "A", "B", "C", "D", "E", "F", "G", "H"};
}

// How alike the left and the right wheel path are.
enum class Coherence { isotropic, equal, independent };
constexpr auto enumNames(Coherence) {
    return std::array<std::string_view, 3>{"isotropic", "equal", "independent"};
}

// Random unevenness after ISO 8608:2016. Every path along x has the displacement PSD Gd(n) = Gd(n0) (n / n0)^-waviness,
// n0 = 0.1 cycles/m, for wavelengths from 0.2 m to 128 m; the road repeats itself after 3276.8 m.
struct RoughnessParams {
    RoadClass road_class = RoadClass::none;
    std::optional<double> unevenness;
    double waviness = 2;
    Coherence coherence = Coherence::isotropic;
    double track = 1.5;
    int seed = 1;
    double begin = -kInfinity;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(road_class), About{"", "class of ISO 8608, at the middle of its range"});
        field(
            TREAD_FIELD(unevenness),
            About{"m3", "Gd(n0), displacement PSD at 0.1 cycles/m, instead of that of the class", kNonNegative}.usually(
                1e-8, 1));
        field(TREAD_FIELD(waviness), About{"-", "exponent with which the PSD falls", {1, 4}});
        field(TREAD_FIELD(coherence), About{"",
                                            "coherence of both wheel paths: as on a surface that looks the same in "
                                            "every direction, equal, or independent"});
        field(TREAD_FIELD(track),
              About{"m", "distance of the wheel paths at which the coherence holds", kPositive}.usually(0.1, 3));
        field(TREAD_FIELD(seed), About{"",
                                       "seed of the random road; each whole number gives another road of the same kind",
                                       {0, 2147483647}});
        field(TREAD_FIELD(begin), About{"m", "x where it begins, growing to its full height over 10 m"}.unjudged());
    }
};
static_assert(describesEveryMember<RoughnessParams>());

struct RoadParams {
    double grade = 0;
    double bank = 0;
    double crown = 0;
    double crown_y = 0;
    double crown_rounding = 0.5;
    double crown_begin = -kInfinity;
    double friction = 1;
    double contact_length = 0.15;
    std::vector<FrictionPatch> friction_patches;
    std::vector<Obstacle> obstacles;
    RoughnessParams roughness;
    std::optional<HeightField> height_field;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(grade), About{"-", "rise over run along x"}.usually(-0.6, 0.6));
        field(TREAD_FIELD(bank), About{"-", "rise over run along y"}.usually(-1.2, 1.2));
        field(TREAD_FIELD(crown), About{"-", "fall over run to both sides of the crown"}.usually(-0.1, 0.1));
        field(TREAD_FIELD(crown_y), About{"m", "y of the crown"}.unjudged());
        field(TREAD_FIELD(crown_rounding),
              About{"m", "distance over which the crown is rounded", kPositive}.usually(0.01, 50));
        field(TREAD_FIELD(crown_begin), About{"m", "x where the crown begins, growing over 20 m"}.unjudged());
        field(TREAD_FIELD(friction),
              About{"-", "factor on the friction of the tyre files", kNonNegative}.usually(0.02, 2));
        field(TREAD_FIELD(contact_length),
              About{"m",
                    "side of the square over which a tyre averages the obstacles, the roughness and the height "
                    "field; 0: none",
                    {0, 1}});
        field(TREAD_FIELD(friction_patches),
              About{"", "patches of different friction; where they overlap, the last one applies"});
        field(TREAD_FIELD(obstacles), About{"", "bumps, kerbs and potholes"});
        field(TREAD_FIELD(roughness), About{"", "random unevenness"});
        field(TREAD_FIELD(height_field), About{"", "heights on a grid, or the CSV file that holds them"});
    }
};
static_assert(describesEveryMember<RoadParams>());

}  // namespace tread
