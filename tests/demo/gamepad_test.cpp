// What a gamepad means: by plain states of a pad, and plugged into a window system that has nothing else.
#include <gtest/gtest.h>

#include <map>
#include <optional>

#include "tools/demo/input.h"

namespace {

// In the place of GLFW: the pads that are plugged in, on a system where no key is held and nothing points.
std::map<int, GLFWgamepadstate> plugged;

}  // namespace

extern "C" {
int glfwGetGamepadState(int place, GLFWgamepadstate* state) {
    const auto pad = plugged.find(place);
    *state = pad == plugged.end() ? GLFWgamepadstate{} : pad->second;  // as GLFW: nothing there is all zeros
    return pad == plugged.end() ? GLFW_FALSE : GLFW_TRUE;
}
int glfwGetKey(GLFWwindow*, int) {
    return GLFW_RELEASE;
}
int glfwGetMouseButton(GLFWwindow*, int) {
    return GLFW_RELEASE;
}
void glfwSetInputMode(GLFWwindow*, int, int) {}
void glfwGetCursorPos(GLFWwindow*, double* x, double* y) {
    *x = *y = 0;
}
void glfwGetWindowSize(GLFWwindow*, int* width, int* height) {
    *width = *height = 100;
}
void glfwGetFramebufferSize(GLFWwindow*, int* width, int* height) {
    *width = *height = 100;
}
}

namespace tread::demo {
namespace {

constexpr double kMost = 0.4;  // rad

GLFWgamepadstate withAxis(int axis, float value) {
    GLFWgamepadstate pad = restingPad();
    pad.axes[axis] = value;
    return pad;
}
GLFWgamepadstate withButtons(std::initializer_list<int> buttons) {
    GLFWgamepadstate pad = restingPad();
    for (const int button : buttons) pad.buttons[button] = GLFW_PRESS;
    return pad;
}
double steer(float to_the_right) {
    return padPedals(withAxis(GLFW_GAMEPAD_AXIS_LEFT_X, to_the_right), kMost).steer;
}

void expectNothing(const Wishes& wishes) {
    EXPECT_FALSE(wishes.other_vehicle || wishes.reset || wishes.arrows || wishes.help || wishes.next_camera ||
                 wishes.pause || wishes.rate || wishes.place);
    EXPECT_EQ(wishes.rate_steps, 0);
}
void expectNothing(const Pedals& pedals) {
    EXPECT_EQ(pedals.throttle, 0);
    EXPECT_EQ(pedals.brake, 0);
    EXPECT_EQ(pedals.handbrake, 0);
    EXPECT_EQ(pedals.steer, 0);
}

TEST(Gamepad, AtRestAsksForNothing) {
    expectNothing(padPedals(restingPad(), kMost));
    expectNothing(padWishes(restingPad(), restingPad()));
}

TEST(Gamepad, TriggersArePedalsFromMinusOneToOne) {
    const auto throttle = [](float x) { return padPedals(withAxis(GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER, x), kMost); };
    const auto brake = [](float x) { return padPedals(withAxis(GLFW_GAMEPAD_AXIS_LEFT_TRIGGER, x), kMost); };
    EXPECT_EQ(throttle(0).throttle, 0.5);
    EXPECT_EQ(throttle(1).throttle, 1);
    EXPECT_EQ(throttle(1).brake, 0);
    EXPECT_EQ(brake(0).brake, 0.5);
    EXPECT_EQ(brake(1).brake, 1);
    EXPECT_EQ(brake(1).throttle, 0);
    expectNothing(throttle(-0.95F));
    expectNothing(brake(-0.95F));
}

TEST(Gamepad, StickToTheLeftSteersToTheLeft) {
    EXPECT_EQ(steer(-1), kMost) << "ISO 8855: positive to the left";
    EXPECT_EQ(steer(1), -kMost);
    for (float x = 0.15F; x < 1; x += 0.1F) {
        EXPECT_EQ(steer(-x), -steer(x));
        EXPECT_GT(steer(-x - 0.1F), steer(-x));
        EXPECT_LT(steer(-x), kMost * static_cast<double>(x)) << "finer about the middle";
    }
}

TEST(Gamepad, StickAboutItsMiddleDoesNotSteer) {
    for (const float x : {-0.11F, -0.02F, 0.02F, 0.11F}) EXPECT_EQ(steer(x), 0) << x;
    EXPECT_NE(steer(0.13F), 0);
    EXPECT_EQ(padPedals(withAxis(GLFW_GAMEPAD_AXIS_LEFT_Y, 1), kMost).steer, 0);
    EXPECT_EQ(padPedals(withAxis(GLFW_GAMEPAD_AXIS_RIGHT_X, 1), kMost).steer, 0);
}

TEST(Gamepad, AHoldsTheHandbrakeAndNothingElseDoes) {
    for (int button = 0; button <= GLFW_GAMEPAD_BUTTON_LAST; ++button) {
        const Pedals pedals = padPedals(withButtons({button}), kMost);
        EXPECT_EQ(pedals.handbrake, button == GLFW_GAMEPAD_BUTTON_A ? 1 : 0) << button;
        EXPECT_EQ(pedals.throttle + pedals.brake, 0) << button;
    }
}

TEST(Gamepad, EachButtonCountsOncePerPush) {
    for (int button = 0; button <= GLFW_GAMEPAD_BUTTON_LAST; ++button) {
        SCOPED_TRACE(button);
        const GLFWgamepadstate held = withButtons({button});
        const Wishes pushed = padWishes(held, restingPad());
        EXPECT_EQ(pushed.other_vehicle, button == GLFW_GAMEPAD_BUTTON_Y);
        EXPECT_EQ(pushed.reset, button == GLFW_GAMEPAD_BUTTON_BACK);
        EXPECT_EQ(pushed.next_camera, button == GLFW_GAMEPAD_BUTTON_X);
        EXPECT_EQ(pushed.rate_steps,
                  (button == GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER) - (button == GLFW_GAMEPAD_BUTTON_LEFT_BUMPER));
        expectNothing(padWishes(held, held));
        expectNothing(padWishes(restingPad(), held));
    }
}

TEST(Gamepad, OnePushDoesNotHideAnother) {
    const GLFWgamepadstate one = withButtons({GLFW_GAMEPAD_BUTTON_Y});
    const Wishes wishes = padWishes(withButtons({GLFW_GAMEPAD_BUTTON_Y, GLFW_GAMEPAD_BUTTON_X}), one);
    EXPECT_TRUE(wishes.next_camera);
    EXPECT_FALSE(wishes.other_vehicle);
    const auto shoulders = {GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER, GLFW_GAMEPAD_BUTTON_LEFT_BUMPER};
    EXPECT_EQ(padWishes(withButtons(shoulders), restingPad()).rate_steps, 0);
}

// Of a driver at 10 m/s who looks at the pad in this state.
struct Look {
    Wishes wishes;
    Pedals pedals;
};
Look look(Input& input, const std::optional<GLFWgamepadstate>& pad, int place = GLFW_JOYSTICK_1, double speed = 10) {
    plugged.clear();
    if (pad) plugged[place] = *pad;
    const Wishes wishes = input.wishes();
    return {wishes, input.pedals(speed, 0.01)};
}

TEST(Gamepad, UnpluggedWhileHeldLetsGoOfEverything) {
    GLFWgamepadstate held = withButtons({GLFW_GAMEPAD_BUTTON_A, GLFW_GAMEPAD_BUTTON_Y});
    held.axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER] = 1;
    held.axes[GLFW_GAMEPAD_AXIS_LEFT_X] = -1;
    Input input(nullptr);
    const Look first = look(input, held), second = look(input, held), gone = look(input, std::nullopt);
    EXPECT_TRUE(first.wishes.other_vehicle);
    expectNothing(second.wishes);
    EXPECT_EQ(second.pedals.throttle, 1);
    EXPECT_EQ(second.pedals.handbrake, 1);
    EXPECT_GT(second.pedals.steer, 0);
    expectNothing(gone.wishes);
    expectNothing(gone.pedals);
    EXPECT_TRUE(look(input, held).wishes.other_vehicle) << "plugged in again, a push is a push";
}

TEST(Gamepad, IsFoundWhereverItIsPluggedIn) {
    Input input(nullptr);
    EXPECT_EQ(look(input, withAxis(GLFW_GAMEPAD_AXIS_LEFT_TRIGGER, 1), GLFW_JOYSTICK_3).pedals.brake, 1);
}

TEST(Gamepad, BrakeOfAStandingCarDrivesBackwards) {
    Input input(nullptr);
    const auto at = [&](double speed) {
        return look(input, withAxis(GLFW_GAMEPAD_AXIS_LEFT_TRIGGER, 1), GLFW_JOYSTICK_1, speed).pedals;
    };
    EXPECT_EQ(at(10).brake, 1);
    EXPECT_EQ(at(0).throttle, -1);
    EXPECT_EQ(at(0).brake, 0);
}

}  // namespace
}  // namespace tread::demo
