#include "report/replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "report/cross_plot.h"
#include "report/pack.h"
#include "report/palette.h"
#include "report/replay_road.h"
#include "scenario/cones.h"
#include "tread/road_surface.h"

namespace tread {
namespace {

constexpr double kFrame = 0.02;            // s: between frames the script interpolates
constexpr std::size_t kMostFrames = 3000;  // of a long log fewer per second
constexpr double kPlace = 0.5;             // m between two places of the way

constexpr std::array<std::string_view, 9> kBodyChannels{"x", "y", "z", "roll", "pitch", "yaw", "vx", "ax", "ay"};
constexpr std::array<std::string_view, 5> kWheelChannels{"travel", "steer", "load", "fx", "fy"};

bool finite(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

const std::vector<double>* valuesOf(const Log& log, const std::string& name) {
    const Channel* channel = completeChannel(log, name);
    return channel && finite(channel->values) ? &channel->values : nullptr;
}

bool placed(const Log& log) {
    return log.samples() > 1 && valuesOf(log, "chassis.x") && valuesOf(log, "chassis.y") &&
           valuesOf(log, "chassis.yaw");
}

// The rows that become frames.
std::vector<std::size_t> frameRows(const std::vector<double>& time) {
    const double apart = std::max(kFrame, (time.back() - time.front()) / kMostFrames);
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < time.size(); ++i) {
        const bool last = i + 1 == time.size();
        if (rows.empty() || last || time[i] - time[rows.back()] > (1 - 1e-6) * apart) rows.push_back(i);
    }
    return rows;
}

std::string packRows(const std::vector<double>& values, const std::vector<std::size_t>& rows) {
    std::vector<float> kept;
    for (const std::size_t row : rows) kept.push_back(static_cast<float>(values[row]));
    return packed(kept);
}

// The angle through which the wheel has turned.
std::vector<double> turned(const std::vector<double>& time, const std::vector<double>& spin) {
    std::vector<double> angle(time.size(), 0.0);
    for (std::size_t i = 1; i < time.size(); ++i)
        angle[i] = angle[i - 1] + 0.5 * (spin[i] + spin[i - 1]) * (time[i] - time[i - 1]);
    return angle;
}

// The wheel's lean against the body, from its inclination against the road.
std::optional<std::vector<double>> leans(const Log& log, const CarShape& shape, const RoadSurface& road,
                                         std::size_t wheel) {
    const auto channel = [&](const char* name) { return valuesOf(log, name); };
    const auto *x = channel("chassis.x"), *y = channel("chassis.y"), *z = channel("chassis.z");
    const auto *roll = channel("chassis.roll"), *pitch = channel("chassis.pitch"), *yaw = channel("chassis.yaw");
    const std::string prefix = fmt::format("wheel.{}.", kWheelLooks[wheel].key);
    const auto *camber = valuesOf(log, prefix + "camber"), *steer = valuesOf(log, prefix + "steer");
    if (!z || !roll || !pitch || !camber || !steer) return std::nullopt;
    std::vector<double> out;
    for (std::size_t i = 0; i < log.samples(); ++i) {
        const Eigen::Matrix3d body =
            (Eigen::AngleAxisd((*yaw)[i], Vector3::UnitZ()) * Eigen::AngleAxisd((*pitch)[i], Vector3::UnitY()) *
             Eigen::AngleAxisd((*roll)[i], Vector3::UnitX()))
                .toRotationMatrix();
        const Vector3 hub = Vector3((*x)[i], (*y)[i], (*z)[i]) + body * shape.hubs[wheel];
        const Vector3 axis = body * Vector3(-std::sin((*steer)[i]), std::cos((*steer)[i]), 0);
        const double upright = std::asin(std::clamp(axis.dot(road.contact(hub, wheel).normal_W), -1.0, 1.0));
        out.push_back((*camber)[i] - upright);
    }
    return out;
}

nlohmann::ordered_json wheelData(const ReplayCar& car, const RoadSurface& road, std::size_t wheel,
                                 const std::vector<std::size_t>& rows) {
    nlohmann::ordered_json channels = nlohmann::ordered_json::object();
    const std::string prefix = fmt::format("wheel.{}.", kWheelLooks[wheel].key);
    for (const std::string_view name : kWheelChannels) {
        if (const auto* values = valuesOf(car.log, prefix + std::string(name)))
            channels[std::string(name)] = packRows(*values, rows);
    }
    if (const auto* spin = valuesOf(car.log, prefix + "spin"))
        channels["turn"] = packRows(turned(car.log.channels.front().values, *spin), rows);
    if (const auto lean = leans(car.log, car.shape, road, wheel)) channels["lean"] = packRows(*lean, rows);
    const Vector3& hub = car.shape.hubs[wheel];
    return {{"hub", {hub.x(), hub.y(), hub.z()}}, {"radius", car.shape.wheel_radius[wheel]}, {"channels", channels}};
}

nlohmann::ordered_json carData(const ReplayCar& car, const RoadSurface& road) {
    const std::vector<double>& time = car.log.channels.front().values;
    const std::vector<std::size_t> rows = frameRows(time);
    std::vector<double> times;
    for (const std::size_t row : rows) times.push_back(time[row]);

    nlohmann::ordered_json channels = nlohmann::ordered_json::object();
    for (const std::string_view name : kBodyChannels) {
        if (const auto* values = valuesOf(car.log, "chassis." + std::string(name)))
            channels[std::string(name)] = packRows(*values, rows);
    }
    if (!channels.contains("z")) {
        std::vector<double> z;
        const auto &x = *valuesOf(car.log, "chassis.x"), &y = *valuesOf(car.log, "chassis.y");
        for (std::size_t i = 0; i < x.size(); ++i) z.push_back(road.at(x[i], y[i]).height + car.shape.height);
        channels["z"] = packRows(z, rows);
    }
    auto wheels = nlohmann::ordered_json::array();
    for (std::size_t wheel = 0; wheel < kWheels; ++wheel) wheels.push_back(wheelData(car, road, wheel, rows));
    const CarShape& shape = car.shape;
    return {{"name", car.name},     {"colour", hex(car.colour)}, {"ahead", shape.ahead}, {"behind", shape.behind},
            {"width", shape.width}, {"height", shape.height},    {"roof", shape.roof},   {"time", packed(times)},
            {"channels", channels}, {"wheels", wheels}};
}

std::vector<Point> wayOf(const std::vector<ReplayCar>& cars) {
    std::vector<Point> way;
    for (const ReplayCar& car : cars) {
        const auto &x = *valuesOf(car.log, "chassis.x"), &y = *valuesOf(car.log, "chassis.y");
        for (std::size_t i = 0; i < x.size(); ++i) {
            if (i == 0 || std::hypot(x[i] - way.back().x, y[i] - way.back().y) > kPlace) way.push_back({x[i], y[i]});
        }
    }
    return way;
}

}  // namespace

ReplayScene sceneOf(const Scenario& scenario) {
    return {scenario.road, conesOf(scenario.course)};
}

std::string replayData(const std::vector<ReplayCar>& cars, const ReplayScene& scene) {
    std::vector<ReplayCar> shown;
    for (const ReplayCar& car : cars) {
        if (placed(car.log)) shown.push_back(car);
    }
    if (shown.empty()) return {};
    const RoadSurface road(scene.road);
    nlohmann::ordered_json json{{"cars", nlohmann::ordered_json::array()},
                                {"road", replayRoad(scene.road, wayOf(shown))},
                                {"cones", nlohmann::ordered_json::array()}};
    for (const ReplayCar& car : shown) json["cars"].push_back(carData(car, road));
    for (const Point& cone : scene.cones) json["cones"].push_back({cone.x, cone.y, road.at(cone.x, cone.y).height});
    return scriptJson(json);
}

}  // namespace tread
