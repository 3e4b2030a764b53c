#include "recording/checks/left_out.h"

#include <fmt/format.h>

#include <cmath>

namespace tread::recording::checks {
namespace {

constexpr double kWorthSliding = 1;  // s; an earlier end points to a wrong model, unit or sign, not to sliding

}  // namespace

std::vector<std::string> leftOut(Drives drives, const std::vector<double>& until) {
    std::vector<std::string> sentences;
    for (std::size_t d = 0; d < drives.size(); ++d) {
        const RecordedDrive& drive = drives[d];
        if (!std::isfinite(until[d])) continue;
        if (drive.gap && drive.gap->from == until[d]) {
            sentences.push_back(fmt::format(
                "{}: from {:.1f} s of {:.1f} s on nothing is compared, for {} is missing for {:.1f} s there, and "
                "without it the drive cannot be repeated. Choose a window (from, to) before or after the gap.",
                drive.name, until[d], drive.duration(), drive.gap->channel, drive.gap->to - drive.gap->from));
            continue;
        }
        const char* const car = until[d] < drive.until_reference ? "the car" : "the car of the reference";
        if (until[d] < kWorthSliding) {
            sentences.push_back(fmt::format(
                "{}: from {:.1f} s of {:.1f} s on {} turns otherwise than its model by more than any small cause "
                "explains, so it is left out: hardly anything remains of this drive. Look at the file of the car, and "
                "at the units and signs of steering, speed, yaw rate and lateral acceleration.",
                drive.name, until[d], drive.duration(), car));
            continue;
        }
        sentences.push_back(
            fmt::format("{}: from {:.1f} s of {:.1f} s on {} slides and its model does not, or the other way round. "
                        "What they do then differs by more than any small cause explains, so it is left out. Drive a "
                        "little slower if the end of this matters.",
                        drive.name, until[d], drive.duration(), car));
    }
    return sentences;
}

}  // namespace tread::recording::checks
