// tread_demo: a window to drive in, on Bullet's stock vehicle or on tread's, or a script that ends in a picture.
#include <epoxy/gl.h>
// after OpenGL's own header
#include <GLFW/glfw3.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>
#include <stdexcept>

#include "camera.h"
#include "drive.h"
#include "input.h"
#include "picture.h"

namespace tread::demo {
namespace {

struct Options {
    std::string script;
    std::string screenshot;
    std::string vehicle;
    double seconds = -1;
    int width = 1280, height = 720;
};

struct Show {
    Camera camera = Camera::behind;
    bool arrows = true, help = true, paused = false;
};

struct Window {
    explicit Window(const Options& options) {
        glfwSetErrorCallback([](int, const char* words) { std::fprintf(stderr, "tread_demo: %s\n", words); });
        if (!glfwInit())
            throw std::runtime_error(
                "no window system; without a screen: xvfb-run tread_demo --script NAME --screenshot FILE");
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
        if (!options.screenshot.empty()) glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
        handle = glfwCreateWindow(options.width, options.height, "tread", nullptr, nullptr);
        if (!handle) {
            glfwTerminate();
            throw std::runtime_error("OpenGL 3.3 gives no window");
        }
        glfwMakeContextCurrent(handle);
        glfwSwapInterval(1);
    }
    ~Window() {
        glfwDestroyWindow(handle);
        glfwTerminate();
    }
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle;
};

std::string print(const char* format, auto... values) {
    char text[200];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

Frame frameOf(const Drive& drive, const Show& show, const View& view, const Mesh& marks, const Mesh& arrows,
              double pictures) {
    const Car& car = drive.car;
    const bool stock = car.kind() == Kind::stock;
    Frame frame{drive.track, car,         drive.shown,
                view.eye,    view.target, marks,
                arrows,      drive.rate,  stock ? "btRaycastVehicle (stock)" : "tread::RaycastVehicle",
                {},          {}};
    const bool rests = !car.chassis().isActive();
    frame.lines = {print("%.0f km/h%s", 3.6 * std::abs(car.speed()), rests ? ", asleep" : ""),
                   pictures > 0 ? print("%.0f pictures/s", pictures) : print("%.1f s", drive.time),
                   "front: " + std::string(car.ground(0)) + " | " + std::string(car.ground(1)),
                   "rear: " + std::string(car.ground(2)) + " | " + std::string(car.ground(3))};
    frame.lines.push_back("grid 1 m, bold lines 10 m");
    if (show.paused) frame.lines.push_back("paused (P)");
    if (show.arrows)
        frame.lines.push_back(stock ? "arrows: load, slip (stock tells no tyre force)"
                                    : "arrows: load, tyre force, slip");
    if (show.help) frame.help.assign(kKeys.begin(), kKeys.end());
    return frame;
}

void draw(Picture& picture, const Drive& drive, const Show& show, const View& view, int width, int height,
          double pictures) {
    Mesh arrows;
    if (show.arrows) addArrows(arrows, drive.car);
    const Mesh marks = drive.marks.mesh();
    picture.draw(frameOf(drive, show, view, marks, arrows, pictures), width, height);
}

// Drives a script as fast as it goes and keeps the last picture.
void driveScript(const Options& options, Drive& drive, const Script& script, const Show& show, Picture& picture) {
    const double seconds = options.seconds >= 0 ? options.seconds : script.seconds;
    Chase chase;
    View view = chase.look(drive.shown.chassis, show.camera, 0);
    while (drive.time < seconds - 0.5 / drive.rate) {
        drive.step(pedalsAt(script, drive.time));
        view = chase.look(drive.shown.chassis, show.camera, 1 / drive.rate);
    }
    draw(picture, drive, show, view, options.width, options.height, 0);
    if (!options.screenshot.empty()) picture.save(options.screenshot);
    const btVector3 at = drive.car.chassis().getWorldTransform().getOrigin();
    std::printf("%s, %s: %.1f s, %.1f km/h, at %.3f %.3f %.3f\n",
                enumNames(Place{})[static_cast<std::size_t>(drive.place)].data(),
                enumNames(Kind{})[static_cast<std::size_t>(drive.car.kind())].data(), drive.time,
                3.6 * drive.car.speed(), static_cast<double>(at.x()), static_cast<double>(at.y()),
                static_cast<double>(at.z()));
}

void obey(const Wishes& wishes, Drive& drive, Show& show, Chase& chase) {
    if (wishes.other_vehicle) drive.car.choose(drive.car.kind() == Kind::stock ? Kind::tread : Kind::stock);
    if (wishes.reset || wishes.place) {
        drive.begin(wishes.place.value_or(drive.place));
        chase.cut();
    }
    drive.changeRate(wishes.rate_steps);
    drive.rate = wishes.rate.value_or(drive.rate);
    show.arrows ^= wishes.arrows;
    show.help ^= wishes.help;
    show.paused ^= wishes.pause;
    const std::size_t cameras = enumNames(Camera{}).size();
    if (wishes.next_camera) show.camera = static_cast<Camera>((static_cast<std::size_t>(show.camera) + 1) % cameras);
}

void driveByHand(GLFWwindow* window, Drive& drive, Show& show, Picture& picture) {
    Input input(window);
    Chase chase;
    double last = glfwGetTime(), pictures = 0;
    while (!glfwWindowShouldClose(window) && glfwGetKey(window, GLFW_KEY_ESCAPE) != GLFW_PRESS) {
        glfwPollEvents();
        const double now = glfwGetTime(), seconds = now - last;
        last = now;
        pictures += 0.1 * (1 / std::max(seconds, 1e-3) - pictures);
        obey(input.wishes(), drive, show, chase);
        const Pedals pedals = input.pedals(drive.car.speed(), seconds);
        if (!show.paused) drive.run(pedals, seconds);
        int width = 0, height = 0;
        glfwGetFramebufferSize(window, &width, &height);
        if (width == 0 || height == 0) continue;
        draw(picture, drive, show, chase.look(drive.shown.chassis, show.camera, seconds), width, height, pictures);
        picture.show(0);
        glfwSwapBuffers(window);
    }
}

int run(const Options& options) {
    Script script;
    if (!options.script.empty()) script = loadScript(options.script, TREAD_DEMO_SCRIPTS);
    if (!options.vehicle.empty()) script.vehicle = options.vehicle == "stock" ? Kind::stock : Kind::tread;
    const bool scripted = !options.script.empty() || !options.screenshot.empty();

    Drive drive;
    Show show{.camera = script.camera, .help = !scripted};
    drive.rate = script.rate;
    drive.car.choose(script.vehicle);
    drive.begin(script.place, script.speed, script.heading);

    const Window window(options);
    Picture picture(drive.track, TREAD_DEMO_FONT);
    if (scripted) driveScript(options, drive, script, show, picture);
    else driveByHand(window.handle, drive, show, picture);
    return 0;
}

}  // namespace
}  // namespace tread::demo

int main(int argc, char** argv) {
    CLI::App app("Drive a car in Bullet, on its stock vehicle or on tread's", "tread_demo");
    tread::demo::Options options;
    app.add_option("--script", options.script,
                   "drive without a driver: a script file (YAML) or the name of one of the demo's");
    app.add_option("--screenshot", options.screenshot, "end the script with this picture (PNG)");
    app.add_option("--seconds", options.seconds, "end the script at this time")->check(CLI::Range(0.0, 3600.0));
    app.add_option("--vehicle", options.vehicle, "stock or tread (default: as the script says, or tread)")
        ->check(CLI::IsMember({"stock", "tread"}));
    app.add_option("--width", options.width, "of the picture")->check(CLI::Range(160, 7680));
    app.add_option("--height", options.height, "of the picture")->check(CLI::Range(120, 4320));
    CLI11_PARSE(app, argc, argv);
    try {
        return tread::demo::run(options);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "tread_demo: %s\n", e.what());
        return 2;
    }
}
