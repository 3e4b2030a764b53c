// The colours of curves: told apart with the common forms of colour blindness, and readable on white and on near-black.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace tread {

enum class Colour { automatic, blue, vermillion, sky, amber, green, purple, grey };

constexpr std::string_view hex(Colour colour) {
    switch (colour) {
        case Colour::blue:
            return "#1f6fd0";
        case Colour::vermillion:
            return "#d9480f";
        case Colour::sky:
            return "#2ea3dd";
        case Colour::amber:
            return "#d98e04";
        case Colour::green:
            return "#1a9a6b";
        case Colour::purple:
            return "#a35bc4";
        default:
            return "#8a8f98";
    }
}

// The colour and the stroke of a curve that was given none: six colours, then the same six dashed.
struct CurveLook {
    Colour colour;
    bool dashed;
};
constexpr CurveLook automaticLook(std::size_t index) {
    constexpr std::array order = {Colour::blue,   Colour::vermillion, Colour::green,
                                  Colour::purple, Colour::amber,      Colour::sky};
    return {order[index % order.size()], (index / order.size()) % 2 == 1};
}

// A wheel looks the same in every chart: blues left, oranges right, rear wheels lighter and dashed.
struct WheelLook {
    std::string_view key;    // in channel names
    std::string_view label;  // for people
    Colour colour;
    bool dashed;
};
inline constexpr std::array<WheelLook, 4> kWheelLooks = {{{"front_left", "front left", Colour::blue, false},
                                                          {"front_right", "front right", Colour::vermillion, false},
                                                          {"rear_left", "rear left", Colour::sky, true},
                                                          {"rear_right", "rear right", Colour::amber, true}}};

}  // namespace tread
