#include "blind/other_match.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/threads/parallel.h"
#include "blind/drives/measure.h"
#include "blind/other_measure.h"
#include "run/simulate.h"

namespace other_car {
namespace {

using tread::blind::drives::caseDrives;
using tread::blind::drives::Drive;
using tread::blind::drives::kIdeal;
using tread::blind::world::InstrumentSheet;
using tread::blind::world::instrumentSheets;

constexpr std::size_t kMean = 5;     // rows
constexpr int kRounds = 5;           // most steps with the same derivatives
constexpr int kNewColumns = 2;       // how often derivatives are computed anew
constexpr double kSettled = 0.005;   // a step that improves the sum of squares by less than this share is the last one
constexpr double kDifference = 0.1;  // finite difference, in standard deviations of the prior

// A number that the two models define differently, and the standard deviation of its prior. All others keep their
// values: a brake torque on another radius, or a drag torque beside another rolling resistance, would be another fault.
struct Free {
    double* value;
    double by;
};

std::vector<Free> freeNumbers(Truth& truth) {
    std::vector<Free> free;
    for (Axle* axle : {&truth.car.front, &truth.car.rear}) {
        Tyre& tyre = axle->tyre;
        for (double* value :
             {&axle->damping, &axle->anti_roll_bar, &tyre.stiffness, &tyre.stiffness_load, &tyre.friction,
              &tyre.friction_by_load, &tyre.slip_stiffness, &tyre.slip_stiffness_by_load, &tyre.camber_stiffness,
              &tyre.trail, &tyre.curvature, &tyre.carcass})
            free.push_back({value, 0.1 * std::abs(*value)});
        for (double* radius : {&tyre.rolling_radius, &tyre.loaded_radius})  // at different loads in the two models
            free.push_back({radius, 0.005 * *radius});
        free.push_back({&axle->compliance_steer, 1e-6});
        free.push_back({&axle->toe_by_travel, 0.02});
        free.push_back({&axle->roll_axis, 0.02});
        free.push_back({&axle->brake_support, 0.04});
    }
    return free;
}

// All readings of the training drives over their noise.
template <class Measure>
Eigen::VectorXd readings(const Measure& measured) {
    std::vector<double> all;
    for (const Drive& drive : caseDrives()) {
        if (drive.hold_out) continue;
        const tread::Log log = measured(drive);
        for (const InstrumentSheet& sheet : instrumentSheets()) {
            if (sheet.channel.starts_with("driver.")) continue;
            for (const double mean : means(log, sheet.channel)) all.push_back(mean / noiseOfMeans(sheet));
        }
    }
    return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

Eigen::VectorXd readingsOf(const Truth& truth) {
    return readings([&](const Drive& drive) { return replay(truth, drive).log; });
}

Truth moved(const Truth& begin, const Structure& structure, const Eigen::VectorXd& at) {
    Truth truth = begin;
    truth.car.structure = structure;
    const std::vector<Free> free = freeNumbers(truth);
    for (std::size_t i = 0; i < free.size(); ++i) *free[i].value += at(static_cast<Eigen::Index>(i)) * free[i].by;
    return truth;
}

Eigen::MatrixXd columnsAt(const Truth& begin, const Structure& structure, const Eigen::VectorXd& at) {
    const Eigen::VectorXd here = readingsOf(moved(begin, structure, at));
    Eigen::MatrixXd columns(here.size(), at.size());
    tread::inParallel(static_cast<std::size_t>(at.size()), 0, [&](std::size_t i) {
        Eigen::VectorXd there = at;
        there(static_cast<Eigen::Index>(i)) += kDifference;
        columns.col(static_cast<Eigen::Index>(i)) = (readingsOf(moved(begin, structure, there)) - here) / kDifference;
    });
    return columns;
}

// Residuals of the readings; empty for a car that cannot be driven.
std::optional<Eigen::VectorXd> missing(const Matching& matching, const Structure& structure,
                                       const Eigen::VectorXd& at) {
    try {
        return matching.wanted - readingsOf(moved(matching.begin, structure, at));
    } catch (const tread::SimulationError&) {
        return std::nullopt;
    }
}

// Gauss-Newton steps with fixed derivatives while they improve the fit; a step that does not is halved. What the fit
// misses at first counts as noise, so that no number moves far from its prior to make up for the structure.
void approach(Matching& matching, const Structure& structure) {
    Eigen::VectorXd& at = matching.at;
    Eigen::VectorXd misses = matching.wanted - readingsOf(moved(matching.begin, structure, at));
    const double noise = std::max(1.0, misses.squaredNorm() / static_cast<double>(misses.size()));
    const Eigen::MatrixXd& columns = matching.columns;
    const Eigen::Index n = columns.cols();
    const Eigen::LLT<Eigen::MatrixXd> information(columns.transpose() * columns +
                                                  noise * Eigen::MatrixXd::Identity(n, n));
    double squares = misses.squaredNorm() + noise * at.squaredNorm(), share = 1;
    for (int round = 0; round < kRounds; ++round) {
        const Eigen::VectorXd next = at + share * information.solve(columns.transpose() * misses - noise * at);
        const std::optional<Eigen::VectorXd> then = missing(matching, structure, next);
        const double nearer = then ? then->squaredNorm() + noise * next.squaredNorm() : squares;
        if (!(nearer < squares)) {
            share /= 2;
            continue;
        }
        const bool settled = nearer > (1 - kSettled) * squares;
        at = next, misses = *then, squares = nearer;
        if (settled) break;
    }
}

}  // namespace

tread::Log drivenByTread(const tread::VehicleParams& vehicle, const Drive& drive) {
    tread::blind::world::Truth car;
    car.car.vehicle = vehicle;
    std::vector<double>& ratios = car.car.vehicle.driveline.gearbox.ratios;
    ratios = {ratios.back()};
    return tread::blind::drives::measure(car, drive, 1, kIdeal);
}

std::vector<double> means(const tread::Log& log, std::string_view channel) {
    const std::vector<double>& values = log.find(channel)->values;
    std::vector<double> result;
    for (std::size_t i = 0; i + kMean <= values.size(); i += kMean) {
        double sum = 0;
        for (std::size_t k = i; k < i + kMean; ++k) sum += values[k];
        result.push_back(sum / kMean);
    }
    return result;
}

double noiseOfMeans(const InstrumentSheet& sheet) {
    return sheet.noise / std::sqrt(static_cast<double>(kMean));
}

Matching matchingOf(const Truth& begin, const tread::VehicleParams& vehicle) {
    Matching matching{begin, readings([&](const auto& drive) { return drivenByTread(vehicle, drive); }), {}, {}};
    Truth copy = begin;
    matching.at = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(freeNumbers(copy).size()));
    for (int i = 0; i < kNewColumns; ++i) {
        matching.columns = columnsAt(begin, {}, matching.at);
        approach(matching, {});
    }
    return matching;
}

Truth plainCar(const Matching& matching) {
    return moved(matching.begin, {}, matching.at);
}

Truth matched(const Matching& matching, const Structure& structure) {
    Matching own = matching;
    approach(own, structure);
    for (int i = 0; i < kNewColumns; ++i) {
        own.columns = columnsAt(own.begin, structure, own.at);
        approach(own, structure);
    }
    return moved(own.begin, structure, own.at);
}

}  // namespace other_car
