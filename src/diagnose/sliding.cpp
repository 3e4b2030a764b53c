#include "diagnose/sliding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tread {
namespace {

constexpr double kSlideApart = 0.08;  // rad in the window: as much as a car slips in all that still grips
constexpr double kSlideWindow = 1.5;  // s
constexpr double kSlowestSlide = 5;   // m/s, at which an angle of the velocity means much
constexpr double kWorthSliding = 1;   // s: who slides before has not driven at all

}  // namespace

double slideApart(const RecordedDrive& drive, const Eigen::VectorXd& model) {
    const auto find = [&](const char* name) {
        return std::find_if(drive.channels.begin(), drive.channels.end(),
                            [&](const ObservedChannel& channel) { return channel.name == name; });
    };
    const auto ay = find("chassis.ay"), yaw_rate = find("chassis.yaw_rate"), vx = find("chassis.vx");
    const auto none = drive.channels.end();
    if (ay == none || yaw_rate == none || vx == none) return kInfinity;
    const std::vector<double>& times = ay->times;
    if (times != yaw_rate->times || times != vx->times) return kInfinity;

    const auto rate = [&](const Eigen::VectorXd& rows, Eigen::Index row) {
        const double speed = std::max(rows(vx->first_row + row), kSlowestSlide);
        return rows(ay->first_row + row) / speed - rows(yaw_rate->first_row + row);
    };
    const auto window = static_cast<std::size_t>(kSlideWindow / kBlock);
    std::vector<double> apart(times.size(), 0);
    for (std::size_t i = 1; i < times.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        apart[i] = apart[i - 1] + (rate(drive.measured, row) - rate(model, row)) * (times[i] - times[i - 1]);
        const std::size_t before = i > window ? i - window : 0;
        if (std::abs(apart[i] - apart[before]) > kSlideApart) return times[before];
    }
    return kInfinity;
}

std::vector<std::string> leftOut(std::span<const RecordedDrive> drives) {
    std::vector<std::string> sentences;
    for (const RecordedDrive& drive : drives) {
        if (!std::isfinite(drive.until)) continue;
        if (drive.gap && drive.gap->from == drive.until) {
            sentences.push_back(fmt::format(
                "{}: from {:.1f} s of {:.1f} s on nothing is compared, for {} is missing for {:.1f} s there, and "
                "without it the drive cannot be repeated. Choose a window (from, to) before or after the gap.",
                drive.name, drive.until, drive.duration(), drive.gap->channel, drive.gap->to - drive.gap->from));
            continue;
        }
        const char* const car = drive.until < drive.until_reference ? "the car" : "the car of the reference";
        if (drive.until < kWorthSliding) {
            sentences.push_back(fmt::format(
                "{}: from {:.1f} s of {:.1f} s on {} turns otherwise than its model by more than any small cause "
                "explains, so it is left out: hardly anything remains of this drive. Look at the file of the car, and "
                "at the units and signs of steering, speed, yaw rate and lateral acceleration.",
                drive.name, drive.until, drive.duration(), car));
            continue;
        }
        sentences.push_back(
            fmt::format("{}: from {:.1f} s of {:.1f} s on {} slides and its model does not, or the other way round. "
                        "What they do then differs by more than any small cause explains, so it is left out. Drive a "
                        "little slower if the end of this matters.",
                        drive.name, drive.until, drive.duration(), car));
    }
    return sentences;
}

}  // namespace tread
