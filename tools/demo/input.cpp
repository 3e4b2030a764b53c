#include "input.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rate_slider.h"

namespace tread::demo {
namespace {

constexpr double kSteerRate = 1.6;       // rad/s, of a key that is held
constexpr double kReturnRate = 2.4;      // rad/s
constexpr double kDeadZone = 0.12;       // of a stick
constexpr double kDeadPedal = 0.05;      // of a trigger: worn ones do not come back all the way
constexpr double kMostAcross = 8;        // m/s2, that full steering asks for at speed
constexpr double kBackwardsBelow = 0.8;  // m/s: the brake then drives backwards

GLFWgamepadstate padNow() {
    GLFWgamepadstate pad;
    for (int place = GLFW_JOYSTICK_1; place <= GLFW_JOYSTICK_LAST; ++place) {
        if (glfwGetGamepadState(place, &pad)) return pad;
    }
    return restingPad();
}

// At speed the full lock would only spin the car.
double mostSteer(double speed) {
    return std::min(Car::kSteerMost, 1.5 * kMostAcross * Car::kWheelbase / std::max(speed * speed, 1.0));
}

}  // namespace

GLFWgamepadstate restingPad() {
    GLFWgamepadstate pad{};
    pad.axes[GLFW_GAMEPAD_AXIS_LEFT_TRIGGER] = pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER] = -1;
    return pad;
}

Wishes padWishes(const GLFWgamepadstate& now, const GLFWgamepadstate& before) {
    const auto pushed = [&](int button) {
        return now.buttons[button] == GLFW_PRESS && before.buttons[button] != GLFW_PRESS;
    };
    Wishes wishes;
    wishes.other_vehicle = pushed(GLFW_GAMEPAD_BUTTON_Y);
    wishes.reset = pushed(GLFW_GAMEPAD_BUTTON_BACK);
    wishes.next_camera = pushed(GLFW_GAMEPAD_BUTTON_X);
    wishes.rate_steps = pushed(GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER) - pushed(GLFW_GAMEPAD_BUTTON_LEFT_BUMPER);
    return wishes;
}

Pedals padPedals(const GLFWgamepadstate& pad, double most_steer) {
    const auto trigger = [&](int axis) {
        const double way = 0.5 * (1 + static_cast<double>(pad.axes[axis]));
        return way < kDeadPedal ? 0 : way;
    };
    Pedals pedals;
    pedals.throttle = trigger(GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER);
    pedals.brake = trigger(GLFW_GAMEPAD_AXIS_LEFT_TRIGGER);
    pedals.handbrake = pad.buttons[GLFW_GAMEPAD_BUTTON_A] == GLFW_PRESS ? 1 : 0;
    const double right = static_cast<double>(pad.axes[GLFW_GAMEPAD_AXIS_LEFT_X]);
    if (std::abs(right) >= kDeadZone) pedals.steer = -most_steer * right * std::abs(right);
    return pedals;
}

Input::Input(GLFWwindow* window) : window_(window) {
    // A key that is let go before the next picture has been pressed all the same.
    glfwSetInputMode(window, GLFW_STICKY_KEYS, GLFW_TRUE);
    glfwSetInputMode(window, GLFW_STICKY_MOUSE_BUTTONS, GLFW_TRUE);
}

bool Input::held(int key) const {
    return glfwGetKey(window_, key) == GLFW_PRESS;
}

bool Input::pressed(int key) {
    bool& before = before_[static_cast<std::size_t>(key)];
    const bool now = held(key), is_new = now && !before;
    before = now;
    return is_new;
}

Wishes Input::wishes() {
    const GLFWgamepadstate before = std::exchange(pad_, padNow());
    Wishes wishes = padWishes(pad_, before);
    wishes.other_vehicle |= pressed(GLFW_KEY_TAB);
    wishes.reset |= pressed(GLFW_KEY_R);
    wishes.arrows |= pressed(GLFW_KEY_F);
    wishes.help |= pressed(GLFW_KEY_H);
    wishes.next_camera |= pressed(GLFW_KEY_C);
    wishes.pause |= pressed(GLFW_KEY_P);
    wishes.rate_steps += (pressed(GLFW_KEY_EQUAL) || pressed(GLFW_KEY_KP_ADD)) -
                         (pressed(GLFW_KEY_MINUS) || pressed(GLFW_KEY_KP_SUBTRACT));
    wishes.rate = slid();
    for (std::size_t i = 0; i < enumNames(Place{}).size(); ++i) {
        if (pressed(GLFW_KEY_1 + static_cast<int>(i))) wishes.place = static_cast<Place>(i);
    }
    return wishes;
}

// The slider is taken by a click on it and kept until the button is let go, wherever the mouse is.
std::optional<double> Input::slid() {
    double x = 0, y = 0;
    int window = 0, picture = 0, height = 0;
    glfwGetCursorPos(window_, &x, &y);
    glfwGetWindowSize(window_, &window, &height);
    glfwGetFramebufferSize(window_, &picture, &height);
    const bool down = glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
    if (window == 0) return std::nullopt;
    const double pixels = static_cast<double>(picture) / window;
    const RateSlider slider(picture);
    slides_ = down && (slides_ || (!mouse_before_ && slider.holds(pixels * x, pixels * y)));
    mouse_before_ = down;
    return slides_ ? std::optional(slider.rateAt(pixels * x)) : std::nullopt;
}

Pedals Input::pedals(double speed, double seconds) {
    const auto either = [&](int a, int b) { return held(a) || held(b); };
    const double most = mostSteer(speed);
    Pedals pedals = padPedals(pad_, most);
    if (either(GLFW_KEY_W, GLFW_KEY_UP)) pedals.throttle = 1;
    if (either(GLFW_KEY_S, GLFW_KEY_DOWN)) pedals.brake = 1;
    if (held(GLFW_KEY_SPACE)) pedals.handbrake = 1;
    const double wanted = most * (either(GLFW_KEY_A, GLFW_KEY_LEFT) - either(GLFW_KEY_D, GLFW_KEY_RIGHT));
    const double way = seconds * (wanted == 0 ? kReturnRate : kSteerRate);
    steer_ += std::clamp(wanted - steer_, -way, way);
    if (pedals.steer == 0) pedals.steer = steer_;

    if (pedals.brake > 0 && pedals.throttle == 0 && speed < kBackwardsBelow) {
        pedals.throttle = -pedals.brake;
        pedals.brake = 0;
    } else if (pedals.throttle > 0 && speed < -kBackwardsBelow) {
        std::swap(pedals.throttle, pedals.brake);
    }
    return pedals;
}

}  // namespace tread::demo
