#include "diagnose/force_law.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "diagnose/screen.h"

namespace tread {
namespace {

constexpr double kUsual = 2;           // root mean square of such a force, in usual sizes of disturbances
constexpr double kSwingDamping = 0.1;  // of its critical one

using Signal = std::vector<double>;  // a value for each sample of a drive

struct Law {
    std::string follows, unit;
    std::vector<Disturbed> kinds;
    std::function<Signal(const RecordedDrive&)> signal;  // empty when the drive does not show it
};

// Sample by sample, of what is measured; what is missing is as if nothing happened.
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

// What a mass on a spring across the car hands back to it, per kg.
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
            {"the size of the lateral acceleration, to the same side in every turn", "m/s2", side,
             of({ay}, [](const auto& v) { return std::abs(v[0]); })},
            {"the square of the lateral acceleration, with its sign", "m2/s4", side,
             of({ay}, [](const auto& v) { return squareWithSign(v[0]); })},
            {"the square of the hand-wheel angle, with its sign", "rad2", side,
             of({"driver.steering_wheel_angle"}, [](const auto& v) { return squareWithSign(v[0]); })},
            {"the product of lateral and longitudinal acceleration", "m2/s4", side,
             of({ax, ay}, [](const auto& v) { return v[0] * v[1]; })},
            {"the size of the lateral acceleration, to the same side in every turn", "m/s2", roll,
             of({ay}, [](const auto& v) { return std::abs(v[0]); })},
            {"the square of the lateral acceleration", "m2/s4", along,
             of({ay}, [](const auto& v) { return v[0] * v[0]; })},
        };
        for (const auto& [frequency, text] : std::initializer_list<std::pair<double, const char*>>{
                 {0.4, "0.4"}, {0.5, "0.5"}, {0.65, "0.65"}, {0.8, "0.8"}, {1, "1"}, {1.3, "1.3"}}) {
            list.push_back({std::string("a mass that swings across the car at ") + text + " Hz", "m/s2", side,
                            [f = frequency](const RecordedDrive& drive) { return swing(drive, f); }});
        }
        return list;
    }();
    return all;
}

// Means about the peaks of the hats, weighted by these.
Eigen::VectorXd atHats(const Signal& signal, const std::vector<double>& time, const Disturbances& disturbing) {
    const Eigen::Index hats = disturbing.lingering.rows();
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(hats), weights = sums;
    if (hats < 2) return sums;
    const double apart = disturbing.times[1] - disturbing.times[0];
    for (std::size_t i = 0; i < signal.size(); ++i) {
        const double place = (time[i] - disturbing.times[0]) / apart;
        const auto before = static_cast<Eigen::Index>(std::floor(place));
        for (const Eigen::Index hat : {before, before + 1}) {
            if (hat < 0 || hat >= hats) continue;
            const double weight = 1 - std::abs(place - static_cast<double>(hat));
            sums(hat) += weight * signal[i], weights(hat) += weight;
        }
    }
    return (weights.array() > 0).select(sums.array() / weights.array(), 0);
}

// Every law as columns beside the model's: forces whose root mean square over all drives is the usual one.
struct Columns {
    std::vector<Eigen::MatrixXd> of_drive;  // laws' columns, then the residual
    std::vector<double> unit;               // of each law: what one unit of its columns is in units of what it follows
};

Columns columnsOf(const Study& study, const Fit& fit) {
    const std::size_t drives = fit.rows.size();
    std::vector<std::vector<Eigen::VectorXd>> histories;  // of each law in each drive
    Columns columns;
    Eigen::Index count = 0;
    for (const Law& law : laws()) {
        double squares = 0, hats = 0;
        std::vector<Eigen::VectorXd>& here = histories.emplace_back();
        for (std::size_t d = 0; d < drives; ++d) {
            const RecordedDrive& drive = study.bench.drives[d];
            here.push_back(atHats(law.signal(drive), drive.time, study.uncertainty.disturbing[d]));
            squares += here.back().squaredNorm(), hats += static_cast<double>(here.back().size());
        }
        columns.unit.push_back(squares > 0 ? kUsual / std::sqrt(squares / hats) : 0);
        count += static_cast<Eigen::Index>(law.kinds.size());
    }
    for (std::size_t d = 0; d < drives; ++d) {
        const Eigen::MatrixXd& lingering = study.uncertainty.disturbing[d].lingering;
        const Eigen::Index hats = lingering.rows();
        Eigen::MatrixXd& all = columns.of_drive.emplace_back(fit.rows[d].size(), count + 1);
        Eigen::Index at = 0;
        for (std::size_t l = 0; l < laws().size(); ++l) {
            // Impulses that build up these hats.
            const double unit = columns.unit[l] / study.bench.drives[d].disturbed();
            const Eigen::VectorXd impulses = lingering.triangularView<Eigen::Lower>().solve(unit * histories[l][d]);
            for (const Disturbed kind : laws()[l].kinds) {
                const Eigen::Index first = static_cast<Eigen::Index>(kind) * hats;
                all.col(at++) = study.uncertainty.directions[d].middleCols(first, hats) * impulses;
            }
        }
        all.col(count) = residual(study.bench, study.uncertainty, fit.rows, d);
    }
    return columns;
}

}  // namespace

ForceLaw forceLaw(const Study& study, const Fit& fit) {
    const Columns columns = columnsOf(study, fit);
    const Eigen::MatrixXd products = productsBeside(study, fit, columns.of_drive, study.uncertainty.sizes);
    const Eigen::Index last = products.cols() - 1;
    ForceLaw best{.gain = -kInfinity};
    Eigen::Index at = 0;
    for (std::size_t l = 0; l < laws().size(); ++l) {
        const Law& law = laws()[l];
        const auto n = static_cast<Eigen::Index>(law.kinds.size());
        const Eigen::VectorXd gradient = products.block(at, last, n, 1);
        const Eigen::LLT<Eigen::MatrixXd> factor(Eigen::MatrixXd::Identity(n, n) + products.block(at, at, n, n));
        at += n;
        const Eigen::VectorXd units = factor.solve(gradient);
        const double gain = 0.5 * gradient.dot(units) - factor.matrixLLT().diagonal().array().log().sum() -
                            std::log(static_cast<double>(laws().size()));
        if (columns.unit[l] == 0 || gain <= best.gain) continue;
        best = {.follows = law.follows, .unit = law.unit, .coefficients = {}, .gain = gain};
        Eigen::Index largest = 0;
        units.cwiseAbs().maxCoeff(&largest);
        for (Eigen::Index i = 0; i < n; ++i) {
            const Disturbed kind = law.kinds[static_cast<std::size_t>(i)];
            const std::string name(kDisturbedNames[static_cast<std::size_t>(kind)]);
            best.coefficients[name] = units(i) * columns.unit[l] * usualSize(kind, study.bench.nominal.vehicle);
            if (i == largest) best.generalised_force = name;
        }
    }
    return best;
}

}  // namespace tread
