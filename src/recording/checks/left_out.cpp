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
                "{}: not compared after {:.1f} s of {:.1f} s. {} is missing for {:.1f} s there, and the drive cannot "
                "be "
                "replayed without it. Choose a window (from, to) before or after the gap.",
                drive.name, until[d], drive.duration(), drive.gap->channel, drive.gap->to - drive.gap->from));
            continue;
        }
        const char* const car = until[d] < drive.until_reference ? "the car" : "the car of the reference";
        if (until[d] < kWorthSliding) {
            sentences.push_back(fmt::format(
                "{}: not compared after {:.1f} s of {:.1f} s, so hardly anything of this drive remains. The motion of "
                "{} "
                "differs from that of its model by more than any small cause can explain. Check the vehicle file, and "
                "the units and signs of steering, speed, yaw rate and lateral acceleration.",
                drive.name, until[d], drive.duration(), car));
            continue;
        }
        sentences.push_back(fmt::format(
            "{}: not compared after {:.1f} s of {:.1f} s. From then on, {} slides and its model does not, or vice "
            "versa, and they differ by more than any small cause can explain. Drive a little slower if the "
            "rest of the drive matters.",
            drive.name, until[d], drive.duration(), car));
    }
    return sentences;
}

}  // namespace tread::recording::checks
