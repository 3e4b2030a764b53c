// The driver's hands: keyboard and gamepad through GLFW.
#pragma once

#include <GLFW/glfw3.h>

#include <array>
#include <optional>
#include <string_view>

#include "script.h"

namespace tread::demo {

// What was asked for since one looked last.
struct Wishes {
    bool other_vehicle = false;
    bool reset = false;  // back to the place where the car began
    bool arrows = false;
    bool help = false;
    bool next_camera = false;
    bool pause = false;
    int rate_steps = 0;          // up or down the list of rates
    std::optional<double> rate;  // Hz, where the slider is held
    std::optional<Place> place;
};

// What a gamepad asks for; a button once for each push. A pad that is not plugged in is like one that nobody touches.
GLFWgamepadstate restingPad();
Wishes padWishes(const GLFWgamepadstate& now, const GLFWgamepadstate& before);
Pedals padPedals(const GLFWgamepadstate& pad, double most_steer);

class Input {
public:
    explicit Input(GLFWwindow* window);

    // Looks at keys, mouse and gamepad.
    Wishes wishes();
    // Pedals and steering a moment later; keys are smoothed to what hands can do.
    Pedals pedals(double speed, double seconds);

private:
    bool held(int key) const;
    bool pressed(int key);
    std::optional<double> slid();

    GLFWwindow* window_;
    std::array<bool, 512> before_{};
    GLFWgamepadstate pad_ = restingPad();
    double steer_ = 0;
    bool mouse_before_ = false, slides_ = false;
};

inline constexpr std::array<std::string_view, 3> kKeys{
    "W A S D or arrows: drive     Space: handbrake     Tab: stock or tread     + -, slider: steps per second",
    "1 plane  2 hill  3 kerbs  4 ice  5 platform  6 jump     R: back     C: camera     F: arrows     P: pause     H: "
    "hide this",
    "Gamepad: left stick, triggers, A handbrake, Y stock or tread, shoulders steps per second, back: reset"};

}  // namespace tread::demo
