#include "input.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

#include "rate_slider.h"

namespace tread::demo {
namespace {

constexpr double kSteerRate = 1.6;       // rad/s, of a key that is held
constexpr double kReturnRate = 2.4;      // rad/s
constexpr double kDeadZone = 0.12;       // of a stick
constexpr double kMostAcross = 8;        // m/s2, that full steering asks for at speed
constexpr double kBackwardsBelow = 0.8;  // m/s: the brake then drives backwards

double stick(float value) {
    const double x = static_cast<double>(value);
    return std::abs(x) < kDeadZone ? 0 : x;
}

// At speed the full lock would only spin the car.
double mostSteer(double speed) {
    return std::min(Car::kSteerMost, 1.5 * kMostAcross * Car::kWheelbase / std::max(speed * speed, 1.0));
}

}  // namespace

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
    Wishes wishes;
    wishes.other_vehicle = pressed(GLFW_KEY_TAB);
    wishes.reset = pressed(GLFW_KEY_R);
    wishes.arrows = pressed(GLFW_KEY_F);
    wishes.help = pressed(GLFW_KEY_H);
    wishes.next_camera = pressed(GLFW_KEY_C);
    wishes.pause = pressed(GLFW_KEY_P);
    wishes.rate_steps = (pressed(GLFW_KEY_EQUAL) || pressed(GLFW_KEY_KP_ADD)) -
                        (pressed(GLFW_KEY_MINUS) || pressed(GLFW_KEY_KP_SUBTRACT));
    wishes.rate = slid();
    for (std::size_t i = 0; i < enumNames(Place{}).size(); ++i) {
        if (pressed(GLFW_KEY_1 + static_cast<int>(i))) wishes.place = static_cast<Place>(i);
    }
    GLFWgamepadstate pad;
    if (!glfwGetGamepadState(GLFW_JOYSTICK_1, &pad)) return wishes;
    const auto pushed = [&](int button) {
        bool& before = buttons_before_[static_cast<std::size_t>(button)];
        const bool now = pad.buttons[button] == GLFW_PRESS, is_new = now && !before;
        before = now;
        return is_new;
    };
    wishes.other_vehicle |= pushed(GLFW_GAMEPAD_BUTTON_Y);
    wishes.reset |= pushed(GLFW_GAMEPAD_BUTTON_BACK);
    wishes.next_camera |= pushed(GLFW_GAMEPAD_BUTTON_X);
    wishes.rate_steps += pushed(GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER) - pushed(GLFW_GAMEPAD_BUTTON_LEFT_BUMPER);
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
    Pedals pedals;
    pedals.throttle = either(GLFW_KEY_W, GLFW_KEY_UP) ? 1 : 0;
    pedals.brake = either(GLFW_KEY_S, GLFW_KEY_DOWN) ? 1 : 0;
    pedals.handbrake = held(GLFW_KEY_SPACE) ? 1 : 0;

    const double most = mostSteer(speed);
    const double wanted = most * (either(GLFW_KEY_A, GLFW_KEY_LEFT) - either(GLFW_KEY_D, GLFW_KEY_RIGHT));
    const double way = seconds * (wanted == 0 ? kReturnRate : kSteerRate);
    steer_ += std::clamp(wanted - steer_, -way, way);
    pedals.steer = steer_;
    addGamepad(pedals, most);

    if (pedals.brake > 0 && pedals.throttle == 0 && speed < kBackwardsBelow) {
        pedals.throttle = -pedals.brake;
        pedals.brake = 0;
    } else if (pedals.throttle > 0 && speed < -kBackwardsBelow) {
        std::swap(pedals.throttle, pedals.brake);
    }
    return pedals;
}

void Input::addGamepad(Pedals& pedals, double most_steer) {
    GLFWgamepadstate pad;
    if (!glfwGetGamepadState(GLFW_JOYSTICK_1, &pad)) return;
    const auto trigger = [&](int axis) { return 0.5 * (1 + static_cast<double>(pad.axes[axis])); };
    pedals.throttle = std::max(pedals.throttle, trigger(GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER));
    pedals.brake = std::max(pedals.brake, trigger(GLFW_GAMEPAD_AXIS_LEFT_TRIGGER));
    if (pad.buttons[GLFW_GAMEPAD_BUTTON_A] == GLFW_PRESS) pedals.handbrake = 1;
    const double turned = stick(pad.axes[GLFW_GAMEPAD_AXIS_LEFT_X]);
    if (turned != 0) pedals.steer = -most_steer * turned * std::abs(turned);
}

}  // namespace tread::demo
