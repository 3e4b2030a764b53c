// Wind over a manoeuvre: a steady part, given by speed and direction or by its components, and one gust.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "tread/describe.h"
#include "tread/vector.h"

namespace tread {

enum class GustShape { none, step, ramp, cosine };
constexpr auto enumNames(GustShape) {
    return std::array<std::string_view, 4>{"none", "step", "ramp", "cosine"};
}

// Begins at a time, and then lasts for a time; or where the car comes to a place, and then reaches over a length.
struct GustParams {
    GustShape shape = GustShape::none;
    double speed = 0;
    std::optional<double> time{};
    std::optional<double> duration{};
    std::optional<double> x{};
    std::optional<double> length{};

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(shape), About{"",
                                        "none; step and stay; ramp over duration or length and stay; cosine: 1 - cos, "
                                        "from nothing up and down again over duration or length"});
        field(TREAD_FIELD(speed),
              About{"m/s", "what it adds to the wind at most, in the wind's direction"}.usually(-40, 40));
        field(TREAD_FIELD(time), About{"s", "when it begins", kNonNegative}.usually(0, 3600));
        field(TREAD_FIELD(duration),
              About{"s", "how long a ramp or cosine takes that begins at a time", kPositive}.usually(0.01, 600));
        field(TREAD_FIELD(x), About{"m", "where it begins, for a car that drives along x"}.unjudged());
        field(TREAD_FIELD(length),
              About{"m", "how long a ramp or cosine is that begins at a place", kPositive}.usually(0.1, 1000));
    }

    static void check(const auto& self, auto&& complain) {
        if (self.shape == GustShape::none) return;
        const bool extends = self.shape != GustShape::step;
        if (self.time.has_value() == self.x.has_value()) {
            complain("time", self.time ? "found time and x, expected one of them: the gust begins once"
                                       : "found neither time nor x, expected one that says where the gust begins");
        } else if (extends && self.time && !self.duration) {
            complain("duration", "missing, expected how long the gust takes (it begins at a time)");
        } else if (extends && self.x && !self.length) {
            complain("length", "missing, expected how long the gust is (it begins at a place)");
        }
    }
};
static_assert(describesEveryMember<GustParams>());

struct WindParams {
    double speed = 0;
    double direction = 0;
    double x = 0;
    double y = 0;
    GustParams gust;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(speed), About{"m/s", "speed of the steady wind", kNonNegative}.usually(0, 40));
        field(TREAD_FIELD(direction),
              About{"rad", "to where it blows: 0 along x, a quarter turn (90 deg) to the left of that along y"}.usually(
                  -6.3, 6.3));
        field(TREAD_FIELD(x), About{"m/s", "steady wind along x, in addition"}.usually(-40, 40));
        field(TREAD_FIELD(y), About{"m/s", "steady wind along y, in addition"}.usually(-40, 40));
        field(TREAD_FIELD(gust), About{"", "gust"});
    }
};
static_assert(describesEveryMember<WindParams>());

// Velocity of the air at a time, for a car at x.
Vector3 windAt(const WindParams& wind, double time, double x);

}  // namespace tread
