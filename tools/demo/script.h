// A drive without a driver: where it begins, on which vehicle, and what the pedals do when.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "car.h"
#include "tread/describe.h"

namespace tread::demo {

// Holds until the next one begins.
struct Act {
    double time = kRequired;
    double throttle = 0;
    double brake = 0;
    double handbrake = 0;
    double steer = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(time), About{"s", "when it begins", kNonNegative});
        field(TREAD_FIELD(throttle), About{"-", "negative drives backwards", {-1, 1}});
        field(TREAD_FIELD(brake), About{"-", "of all wheels", kFraction});
        field(TREAD_FIELD(handbrake), About{"-", "of the rear wheels", kFraction});
        field(TREAD_FIELD(steer), About{"rad", "of the front wheels, positive to the left", {-1, 1}});
    }
};
static_assert(describesEveryMember<Act>());

enum class Camera { behind, side, above };
constexpr auto enumNames(Camera) {
    return std::array<std::string_view, 3>{"behind", "side", "above"};
}

struct Script {
    Place place = Place::plane;
    Kind vehicle = Kind::tread;
    Camera camera = Camera::behind;
    double rate = 60;
    double seconds = 5;
    double speed = 0;
    double heading = 0;
    std::vector<Act> acts;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(place), About{"", "where the car begins"});
        field(TREAD_FIELD(vehicle), About{"", "which vehicle rolls under the chassis"});
        field(TREAD_FIELD(camera), About{"", "from where it is seen"});
        field(TREAD_FIELD(rate), About{"Hz", "steps of the world per second", {20, 240}});
        field(TREAD_FIELD(seconds), About{"s", "length of the drive", {0, 3600}});
        field(TREAD_FIELD(speed), About{"m/s", "at the beginning", {-30, 60}});
        field(TREAD_FIELD(heading), About{"rad", "at the beginning, positive to the left"});
        field(TREAD_FIELD(acts), About{"", "what the driver does, in the order of time"});
    }
};
static_assert(describesEveryMember<Script>());

// A file, or the name of one of the demo's own scripts; LoadError when it is neither or wrong.
Script loadScript(const std::string& file_or_name, const std::filesystem::path& own_scripts);

Pedals pedalsAt(const Script& script, double time);

}  // namespace tread::demo
