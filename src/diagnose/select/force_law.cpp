#include "diagnose/select/force_law.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "diagnose/select/screen.h"
#include "diagnose/settings.h"

namespace tread::diagnose::select {
namespace {

// Prior standard deviation of the force of a law, in usual sizes (root mean square over all drives). Half and double
// change no verdict of the development cases, but half makes the force that is told too small.
constexpr double kLawForce = 2;
constexpr double kSwingDamping = 0.1;  // damping ratio of the swinging mass

using model::Disturbed;
using recording::RecordedDrive;
using Signal = std::vector<double>;  // one value per sample of a drive

struct Law {
    std::string follows, unit;
    std::vector<Disturbed> kinds;
    std::function<Signal(const RecordedDrive&)> signal;  // from the measured channels; empty when one is missing
};

// Signal computed sample by sample from measured channels; missing samples count as 0.
template <class F>
auto of(std::vector<std::string> channels, F&& f) {
    return [=](const RecordedDrive& drive) {
        Signal signal;
        for (std::size_t i = 0; i < drive.time.size(); ++i) {
            std::vector<double> values;
            for (const std::string& name : channels) {
                const Channel* channel = drive.log.find(name);
                if (!channel) return Signal{};
                values.push_back(std::isfinite(channel->values[i]) ? channel->values[i] : 0);
            }
            signal.push_back(f(values));
        }
        return signal;
    };
}

// Force per kg, m/s2, that a mass on a spring across the car exerts on the car.
Signal swing(const RecordedDrive& drive, double frequency) {
    Signal pull = of({"chassis.ay"}, [](const auto& v) { return v[0]; })(drive);
    const double omega = 2 * std::numbers::pi * frequency;
    double place = 0, rate = 0;
    for (std::size_t i = 0; i < pull.size(); ++i) {
        const double dt = i == 0 ? 0 : drive.time[i] - drive.time[i - 1];
        rate += dt * (-pull[i] - omega * omega * place - 2 * kSwingDamping * omega * rate);
        place += dt * rate;
        pull[i] = omega * omega * place;
    }
    return pull;
}

double squareWithSign(double value) {
    return value * std::abs(value);
}

const std::vector<Law>& laws() {
    static const std::vector<Law> all = [] {
        const std::vector<Disturbed> side{Disturbed::lateral, Disturbed::yaw}, roll{Disturbed::roll},
            along{Disturbed::longitudinal};
        const char *const ax = "chassis.ax", *const ay = "chassis.ay";
        std::vector<Law> list{
            {"the magnitude of the lateral acceleration, to the same side in every turn", "m/s2", side,
             of({ay}, [](const auto& v) { return std::abs(v[0]); })},
            {"the signed square of the lateral acceleration", "m2/s4", side,
             of({ay}, [](const auto& v) { return squareWithSign(v[0]); })},
            {"the signed square of the steering-wheel angle", "rad2", side,
             of({"driver.steering_wheel_angle"}, [](const auto& v) { return squareWithSign(v[0]); })},
            {"the product of lateral and longitudinal acceleration", "m2/s4", side,
             of({ax, ay}, [](const auto& v) { return v[0] * v[1]; })},
            {"the magnitude of the lateral acceleration, to the same side in every turn", "m/s2", roll,
             of({ay}, [](const auto& v) { return std::abs(v[0]); })},
            {"the square of the lateral acceleration", "m2/s4", along,
             of({ay}, [](const auto& v) { return v[0] * v[0]; })},
        };
        for (const auto& [frequency, text] : std::initializer_list<std::pair<double, const char*>>{
                 {0.4, "0.4"}, {0.5, "0.5"}, {0.65, "0.65"}, {0.8, "0.8"}, {1, "1"}, {1.3, "1.3"}}) {
            list.push_back({std::string("the motion of a mass that oscillates laterally at ") + text + " Hz", "m/s2",
                            side, [f = frequency](const RecordedDrive& drive) { return swing(drive, f); }});
        }
        return list;
    }();
    return all;
}

// Means of a signal about the peaks of the hats, weighted by the hats.
Eigen::VectorXd atHats(const Signal& signal, const std::vector<double>& time, const model::Disturbances& disturbing) {
    const Eigen::Index hats = disturbing.hats();
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(hats), weights = sums;
    if (hats < 2) return sums;
    const double apart = disturbing.times[1] - disturbing.times[0];
    for (std::size_t i = 0; i < signal.size(); ++i) {
        const double place = (time[i] - disturbing.times[0]) / apart;
        const Eigen::Index before = std::lround(std::floor(place));
        for (const Eigen::Index hat : {before, before + 1}) {
            if (hat < 0 || hat >= hats) continue;
            const double weight = 1 - std::abs(place - static_cast<double>(hat));
            sums(hat) += weight * signal[i], weights(hat) += weight;
        }
    }
    return (weights.array() > 0).select(sums.array() / weights.array(), 0);
}

// Histories of a law at the hats of each drive, and its unit: the factor that gives the force a root mean square of
// kLawForce usual sizes over all drives. Unit 0 when the signal is 0 everywhere.
struct History {
    std::vector<Eigen::VectorXd> of_drive;
    double unit = 0;
};
History historyOf(const Law& law, const Calibration& car) {
    History history;
    double squares = 0, hats = 0;
    for (std::size_t d = 0; d < car.drives().size(); ++d) {
        const RecordedDrive& drive = car.drives()[d];
        history.of_drive.push_back(atHats(law.signal(drive), drive.time, car.uncertainty.disturbing[d]));
        squares += history.of_drive.back().squaredNorm(), hats += static_cast<double>(history.of_drive.back().size());
    }
    history.unit = squares > 0 ? kLawForce / std::sqrt(squares / hats) : 0;
    return history;
}

// Whitened columns of one drive: each kind of force of every law, then the residual of a fit (D34).
Eigen::MatrixXd columnsOf(const std::vector<History>& histories, const Calibration& car, const Fit& fit,
                          std::size_t drive) {
    const model::Disturbances& disturbing = car.uncertainty.disturbing[drive];
    const Eigen::Index hats = disturbing.hats();
    std::vector<Eigen::VectorXd> columns;
    for (std::size_t l = 0; l < laws().size(); ++l) {
        // Impulses that give these heights of the hats.
        const double unit = histories[l].unit / model::disturbanceScale(car.drives()[drive]);
        const Eigen::VectorXd impulses =
            disturbing.correlation_factor.triangularView<Eigen::Lower>().solve(unit * histories[l].of_drive[drive]);
        for (const Disturbed kind : laws()[l].kinds)
            columns.emplace_back(car.uncertainty.directions[drive].middleCols(model::placeOf(kind) * hats, hats) *
                                 impulses);
    }
    columns.push_back(model::residual(car.drives(), car.uncertainty, fit.rows, drive));
    Eigen::MatrixXd all(columns.front().size(), std::ssize(columns));
    for (Eigen::Index i = 0; i < all.cols(); ++i) all.col(i) = columns[i];
    return all;
}

// Coefficients of a law, in multiples of its unit, beside the remainder that it leaves: one estimated without the law
// has part of it. `columns`: per drive, those of all laws, then the residual.
Eigen::VectorXd unitsBeside(const Calibration& car, const Fit& fit, const std::vector<Eigen::MatrixXd>& columns,
                            Eigen::Index first, Eigen::Index count) {
    std::vector<Eigen::MatrixXd> own;
    std::vector<DriveProducts> products;
    for (std::size_t d = 0; d < columns.size(); ++d) {
        Eigen::MatrixXd all(columns[d].rows(), count + 1);
        all << columns[d].middleCols(first, count), columns[d].rightCols(1);
        products.push_back(productsBeside(fit, car.uncertainty, d, all));
        own.push_back(std::move(all));
    }
    const Sizes sizes = sizesWithAllFree(car.problem, car.uncertainty, products);
    const Eigen::MatrixXd sum = productsBeside(car, fit, own, sizes);
    return inference::bestStep({.information = sum.topLeftCorner(count, count),
                                .gradient = sum.topRightCorner(count, 1),
                                .at = Eigen::VectorXd::Zero(count)});
}

// The law with its coefficients; `units` are these in multiples of `unit`.
answer::ForceLaw lawOf(const Law& law, const Eigen::VectorXd& units, double unit, double gain,
                       const VehicleParams& car) {
    answer::ForceLaw found{.follows = law.follows, .unit = law.unit, .coefficients = {}, .gain = gain};
    Eigen::Index largest = 0;
    units.cwiseAbs().maxCoeff(&largest);
    for (Eigen::Index i = 0; i < units.size(); ++i) {
        const std::string name(model::nameOf(law.kinds[i]));
        found.coefficients[name] = units(i) * unit * model::usualSize(law.kinds[i], car);
        if (i == largest) found.generalised_force = name;
    }
    return found;
}

}  // namespace

answer::ForceLaw forceLaw(const Calibration& car, const Fit& fit) {
    std::vector<History> histories;
    for (const Law& law : laws()) histories.push_back(historyOf(law, car));
    std::vector<Eigen::MatrixXd> columns;
    for (std::size_t d = 0; d < car.drives().size(); ++d) columns.push_back(columnsOf(histories, car, fit, d));
    const Eigen::MatrixXd products = productsBeside(car, fit, columns, car.uncertainty.sizes);
    const Eigen::Index last = products.cols() - 1;
    answer::ForceLaw best{.gain = -kInfinity};
    Eigen::Index at = 0;
    for (std::size_t l = 0; l < laws().size(); ++l) {
        const Law& law = laws()[l];
        const Eigen::Index n = std::ssize(law.kinds);
        const inference::QuadraticModel forces{.information = products.block(at, at, n, n),
                                               .gradient = products.block(at, last, n, 1),
                                               .at = Eigen::VectorXd::Zero(n)};
        at += n;
        const Eigen::VectorXd units = inference::bestStep(forces);
        const double choices = static_cast<double>(laws().size());
        const double gain = inference::logEvidence(forces, units) - std::log(choices);
        if (histories[l].unit == 0 || gain <= best.gain) continue;
        const Eigen::VectorXd beside = unitsBeside(car, fit, columns, at - n, n);
        best = lawOf(law, beside, histories[l].unit, gain, car.problem.replays.nominal().vehicle);
    }
    return best;
}

}  // namespace tread::diagnose::select
