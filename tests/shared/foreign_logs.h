// A drive in closed form, written as other programs write their logs.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace tread::foreign {

// Steering sine at a constant speed, answered without delay: a steady turn at every instant.
inline constexpr double kSpeed = 20;  // m/s
inline double steering(double t) {
    return 0.5 * std::sin(2 * t);  // rad, steering wheel
}
inline double yawRate(double t) {
    return 0.4 * steering(t);  // rad/s
}
inline double lateralAcceleration(double t) {
    return kSpeed * yawRate(t);  // m/s2
}

inline constexpr double kDegree = 0.017453292519943295;  // rad
inline constexpr double kGravity = 9.80665;              // m/s2

struct Column {
    std::string name;
    std::string unit;
    std::function<double(double)> value;
};

// Yaw rate in deg/s with z down, lateral acceleration in g, speed in km/h: what a foreign logger does.
inline std::vector<Column> loggerColumns() {
    return {{"Time", "s", [](double t) { return t; }},
            {"Speed", "km/h", [](double) { return 3.6 * kSpeed; }},
            {"Yaw rate", "deg/s", [](double t) { return -yawRate(t) / kDegree; }},
            {"Lateral acceleration", "g", [](double t) { return lateralAcceleration(t) / kGravity; }},
            {"Steering wheel angle", "deg", [](double t) { return steering(t) / kDegree; }}};
}

inline std::vector<double> times(int samples = 501, double step = 0.01) {
    std::vector<double> t;
    for (int i = 0; i < samples; ++i) t.push_back(i * step);
    return t;
}

struct Style {
    std::string delimiter = ",";
    char decimal = '.';
    bool units_below = true;  // a row of their own; otherwise `name [unit]`
    std::string above = "";   // lines before the header
};

inline std::string table(const std::vector<Column>& columns, const std::vector<double>& times,
                         const Style& style = {}) {
    const auto row = [&](auto&& cell) {
        std::string line;
        for (const Column& column : columns) line += (line.empty() ? "" : style.delimiter) + cell(column);
        return line + "\n";
    };
    std::string text = style.above;
    text += row([&](const Column& c) { return style.units_below ? c.name : c.name + " [" + c.unit + "]"; });
    if (style.units_below) text += row([](const Column& c) { return c.unit; });
    for (const double t : times) {
        text += row([&](const Column& c) {
            std::string number = fmt::format("{:.9g}", c.value(t));
            for (char& digit : number) {
                if (digit == '.') digit = style.decimal;
            }
            return number;
        });
    }
    return text;
}

// A VBOX file of the same drive; time is UTC from 10:53:17.00 on.
inline std::string vbo(const std::vector<double>& times) {
    std::string text =
        "File created on 01/02/2020 @ 10:53\r\n\r\n[header]\r\nsatellites\r\ntime\r\nvelocity kmh\r\n"
        "Lat accel g\r\nYawRate\r\nSWA\r\n\r\n[channel units]\r\n\xB0/s\r\nrad\r\n\r\n[comments]\r\nLog Rate (Hz) : "
        "100.00\r\n\r\n[column names]\r\nsats time velocity Latacc YawRate SWA\r\n\r\n[data]\r\n";
    for (const double t : times) {
        const double clock = 17 + t;  // stays below 60 s
        text += fmt::format("012 1053{:05.2f} {:+010.5f} {:+.6E} {:+.6E} {:+.6E}\r\n", clock, 3.6 * kSpeed,
                            lateralAcceleration(t) / kGravity, -yawRate(t) / kDegree, steering(t));
    }
    return text;
}

}  // namespace tread::foreign
