#include "diagnose/explain/where.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>

#include "diagnose/model/gap.h"
#include "log/resample.h"

namespace tread::diagnose::explain {
namespace {

using answer::Shares;
using recording::kBlock;
using recording::RecordedDrive;

// Thresholds that separate the phases and regimes of a drive.
// Pedal positions, 0 to 1: braking above kBrakes; accelerating above the throttle at the start plus kAccelerates.
constexpr double kBrakes = 0.02, kAccelerates = 0.1;
constexpr double kTurns = 0.3;             // rad/s, of the steering wheel
constexpr double kJustAfter = 0.4;         // s after the last movement of the steering wheel
constexpr double kHolds = 0.1;             // rad, steering wheel
constexpr double kGentle = 2, kBrisk = 4;  // m/s2, lateral
constexpr double kLongitudinal = 1.5;      // m/s2

// A channel of the log at the given times; 0 where it was not logged or is not finite.
std::vector<double> at(const RecordedDrive& drive, const char* channel, const std::vector<double>& times) {
    const Channel* found = drive.log.find(channel);
    std::vector<double> values(times.size(), 0);
    if (!found) return values;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double value = valueAt(drive.time, found->values, std::min(times[i], drive.time.back()));
        values[i] = std::isfinite(value) ? value : 0;
    }
    return values;
}

std::vector<std::string> phases(const RecordedDrive& drive, const std::vector<double>& times) {
    const auto steering = at(drive, "driver.steering_wheel_angle", times);
    const auto throttle = at(drive, "driver.throttle", times), brake = at(drive, "driver.brake", times);
    std::vector<std::string> names;
    double turned = -kInfinity;  // s, last time at which the steering wheel moved
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double rate = i > 0 ? (steering[i] - steering[i - 1]) / kBlock : 0;
        if (std::abs(rate) > kTurns) turned = times[i];
        const bool braking = brake[i] > kBrakes, turning = times[i] == turned;
        if (turning) names.emplace_back(braking ? "steering while braking" : "steering");
        else if (times[i] - turned < kJustAfter) names.emplace_back("just after steering");
        else if (braking) names.emplace_back(std::abs(steering[i]) > kHolds ? "braking in a turn" : "braking");
        else if (throttle[i] > throttle[0] + kAccelerates) names.emplace_back("accelerating");
        else names.emplace_back(std::abs(steering[i]) > kHolds ? "cornering" : "straight");
    }
    return names;
}

std::vector<std::string> regimes(const RecordedDrive& drive, const std::vector<double>& times) {
    const auto ax = at(drive, "chassis.ax", times), ay = at(drive, "chassis.ay", times);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double side = std::abs(ay[i]);
        if (side > kBrisk) names.emplace_back("lateral acceleration above 4 m/s2");
        else if (side > kGentle) names.emplace_back("lateral acceleration 2 to 4 m/s2");
        else if (ax[i] < -kLongitudinal) names.emplace_back("braking above 1.5 m/s2");
        else if (ax[i] > kLongitudinal) names.emplace_back("driving above 1.5 m/s2");
        else names.emplace_back("gentle");
    }
    return names;
}

const char* band(double frequency) {
    return frequency < 0.3 ? "below 0.3 Hz"
           : frequency < 1 ? "0.3 to 1 Hz"
           : frequency < 3 ? "1 to 3 Hz"
                           : "above 3 Hz";
}

// Adds the energy of evenly spaced values to the frequency bands.
void addBands(const Eigen::VectorXd& values, Shares& bands) {
    const Eigen::Index n = values.size();
    Eigen::FFT<double> transform;
    transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    std::vector<std::complex<double>> spectrum;
    transform.fwd(spectrum, std::vector<double>(values.begin(), values.end()));
    for (Eigen::Index k = 0; k <= n / 2; ++k) {
        const double weight = k == 0 || 2 * k == n ? 1 : 2;
        bands[band(static_cast<double>(k) / (static_cast<double>(n) * kBlock))] += weight * std::norm(spectrum[k]);
    }
}

void normalise(Shares& shares, double sum) {
    for (auto& [name, share] : shares) share = sum > 0 ? share / sum : 0;
}

void normalise(Shares& shares) {
    double sum = 0;
    for (const auto& [name, share] : shares) sum += share;
    normalise(shares, sum);
}

}  // namespace

answer::WhereItLies whereItLies(const Calibration& car, const MissingForce& missing) {
    answer::WhereItLies where;
    double all = 0;
    for (std::size_t d = 0; d < car.drives().size(); ++d) {
        const RecordedDrive& drive = car.drives()[d];
        const Eigen::VectorXd gap = model::gapOf(car.drives(), car.uncertainty, car.nominal[d], d);
        for (const recording::ObservedChannel& channel : drive.channels) {
            const Eigen::VectorXd here = gap.segment(channel.first_row, channel.rows());
            const auto count = static_cast<double>(channel.rows());
            // Energy that a perfect model would leave is not part of the gap.
            const double energy = std::max(0.0, here.squaredNorm() - count);
            if (energy == 0) continue;
            all += energy;
            where.channels[channel.name] += energy;
            where.recordings[drive.name] += energy;
            where.channels_of_recording[drive.name][channel.name] += energy;
            const double scale = energy / here.squaredNorm();
            const std::vector<std::string> phase = phases(drive, channel.times), regime = regimes(drive, channel.times);
            for (Eigen::Index i = 0; i < channel.rows(); ++i) {
                where.phases[phase[i]] += scale * here(i) * here(i);
                where.regimes[regime[i]] += scale * here(i) * here(i);
            }
            addBands(here * std::sqrt(scale / count), where.bands);
        }
    }
    for (Shares* shares : {&where.channels, &where.recordings, &where.phases, &where.bands, &where.regimes})
        normalise(*shares);
    for (auto& [name, shares] : where.channels_of_recording) normalise(shares, all);
    where.generalised_force = missing.shares;
    where.axle_force = missing.axles;
    return where;
}

}  // namespace tread::diagnose::explain
