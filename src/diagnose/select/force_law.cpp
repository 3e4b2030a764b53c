#include "diagnose/select/force_law.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "base/threads/parallel.h"
#include "diagnose/model/remainder.h"
#include "diagnose/select/screen.h"
#include "diagnose/settings.h"

namespace tread::diagnose::select {
namespace {

// Prior standard deviations of the force of a law, in usual sizes (root mean square over all drives), each as probable:
// of a small, a large and a very large force.
constexpr std::array kLawForces{2.0, 8.0, 32.0};
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
            along{Disturbed::longitudinal}, oblique{Disturbed::longitudinal, Disturbed::yaw};
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
            // Of a drive or brakes that pull to one side.
            {"the longitudinal acceleration while the car speeds up", "m/s2", side,
             of({ax}, [](const auto& v) { return std::max(v[0], 0.0); })},
            {"the longitudinal deceleration while the car slows down", "m/s2", side,
             of({ax}, [](const auto& v) { return std::max(-v[0], 0.0); })},
            {"the magnitude of the lateral acceleration, to the same side in every turn", "m/s2", roll,
             of({ay}, [](const auto& v) { return std::abs(v[0]); })},
            // Of springs or bushes that stiffen, and of slack. (The noise of a roll rate would follow itself.)
            {"the signed square of the lateral acceleration", "m2/s4", roll,
             of({ay}, [](const auto& v) { return squareWithSign(v[0]); })},
            {"the lateral acceleration up to 1 m/s2", "m/s2", roll,
             of({ay}, [](const auto& v) { return std::clamp(v[0], -1.0, 1.0); })},
            {"the square of the lateral acceleration", "m2/s4", along,
             of({ay}, [](const auto& v) { return v[0] * v[0]; })},
            {"no motion", "", oblique, of({}, [](const auto&) { return 1.0; })},
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
Eigen::VectorXd atHats(const Signal& signal, const std::vector<double>& time, const model::Hats& hats) {
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(hats.count()), weights = sums;
    for (std::size_t i = 0; i < signal.size(); ++i) {
        const double place = time[i] / hats.apart;
        const Eigen::Index before = std::lround(std::floor(place));
        for (const Eigen::Index hat : {before, before + 1}) {
            if (hat < 0 || hat >= hats.count()) continue;
            const double weight = 1 - std::abs(place - static_cast<double>(hat));
            sums(hat) += weight * signal[i], weights(hat) += weight;
        }
    }
    return (weights.array() > 0).select(sums.array() / weights.array(), 0);
}

// Histories of a law at the hats of each drive and kind of force, and its unit: the factor that gives the force a root
// mean square of one usual size over all drives. Unit 0 when the signal is 0 everywhere.
struct History {
    std::vector<std::vector<Eigen::VectorXd>> of_drive;
    double unit = 0;
};
History historyOf(const Law& law, const Calibration& car) {
    History history;
    double squares = 0, hats = 0;
    for (std::size_t d = 0; d < car.drives().size(); ++d) {
        const RecordedDrive& drive = car.drives()[d];
        const Signal signal = law.signal(drive);
        std::vector<Eigen::VectorXd>& of_kinds = history.of_drive.emplace_back();
        for (const Disturbed kind : law.kinds) {
            of_kinds.push_back(atHats(signal, drive.time, car.uncertainty.disturbing[d].of(kind)));
            squares += of_kinds.back().squaredNorm(), hats += static_cast<double>(of_kinds.back().size());
        }
    }
    history.unit = squares > 0 ? std::sqrt(hats / squares) : 0;
    return history;
}

// Changes of the rows of one drive by each kind of force of a law.
Eigen::MatrixXd changesOf(const Law& law, const History& history, const Calibration& car, std::size_t drive) {
    const model::Disturbances& disturbing = car.uncertainty.disturbing[drive];
    Eigen::MatrixXd changes(disturbing.columns.rows(), std::ssize(law.kinds));
    for (std::size_t k = 0; k < law.kinds.size(); ++k) {
        const model::Hats& hats = disturbing.of(law.kinds[k]);
        const Eigen::VectorXd impulses =
            hats.correlation_factor.triangularView<Eigen::Lower>().solve(history.unit * history.of_drive[drive][k]);
        changes.col(static_cast<Eigen::Index>(k)) = disturbing.columns.middleCols(hats.first, hats.count()) * impulses;
    }
    return changes;
}

// Whitened columns of one drive: each kind of force of every law (D34).
Eigen::MatrixXd columnsOf(const std::vector<History>& histories, const Calibration& car, std::size_t drive) {
    Eigen::MatrixXd all(car.uncertainty.disturbing[drive].columns.rows(), 0);
    for (std::size_t l = 0; l < laws().size(); ++l) {
        const Eigen::MatrixXd changes = changesOf(laws()[l], histories[l], car, drive);
        all.conservativeResize(Eigen::NoChange, all.cols() + changes.cols());
        all.rightCols(changes.cols()) = changes;
    }
    return car.uncertainty.noise[drive].over(all);
}

// Columns of forces, then the residual of a fit, per drive.
std::vector<Eigen::MatrixXd> withResidual(const Calibration& car, const Fit& fit,
                                          const std::vector<Eigen::MatrixXd>& forces) {
    std::vector<Eigen::MatrixXd> all;
    for (std::size_t d = 0; d < forces.size(); ++d) {
        all.emplace_back(forces[d].rows(), forces[d].cols() + 1);
        all.back() << forces[d], model::residual(car.drives(), car.uncertainty, fit.rows, d);
    }
    return all;
}

// The quadratic model of a fit with such columns beside it and these sizes, about the fit and forces of 0.
inference::QuadraticModel quadraticBeside(const Calibration& car, const Fit& fit,
                                          const std::vector<DriveProducts>& products, const Sizes& sizes) {
    const model::NormalEquations sum =
        model::normalEquations(car.uncertainty, products, sizes, car.problem.replays.threads);
    Eigen::VectorXd at = Eigen::VectorXd::Zero(sum.products.cols() - 1);
    at.head(std::ssize(fit.free)) = fit.at(fit.free);
    return inference::quadraticModel(sum, std::move(at));
}

// Nats that the choice of a law and of its size costs.
double logChoices() {
    return std::log(static_cast<double>(laws().size() * kLawForces.size()));
}

double logEvidence(const inference::QuadraticModel& model, const Sizes& sizes) {
    return inference::logEvidence(model, inference::bestStep(model)) + model::logPrior(sizes, model::kWidePrior);
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

struct ForceLaws::Best {
    std::size_t law;
    double force;               // its prior standard deviation, usual sizes
    double gain;                // nats, beside the remainder of the fit
    Eigen::Index first_column;  // of its forces among those of all laws
};

ForceLaws::ForceLaws(const Calibration& car) : car_(car) {
    std::vector<History> histories;
    for (const Law& law : laws()) histories.push_back(historyOf(law, car)), units_.push_back(histories.back().unit);
    for (std::size_t d = 0; d < car.drives().size(); ++d) columns_.push_back(columnsOf(histories, car, d));
}

std::vector<Eigen::MatrixXd> changesBy(const FoundLaw& law, const Calibration& car) {
    const Law& found = laws()[law.place];
    const History history = historyOf(found, car);
    std::vector<Eigen::MatrixXd> changes;
    for (std::size_t d = 0; d < car.drives().size(); ++d) changes.push_back(changesOf(found, history, car, d));
    return changes;
}

FoundLaw ForceLaws::best(const Fit& fit) const {
    const Eigen::MatrixXd products = productsBeside(car_, fit, withResidual(car_, fit, columns_), fit.sizes);
    const Eigen::Index last = products.cols() - 1;
    std::optional<Best> best;
    Eigen::Index first = 0;
    for (std::size_t l = 0; l < laws().size(); ++l) {
        const Eigen::Index n = std::ssize(laws()[l].kinds);
        for (const double force : kLawForces) {
            const inference::QuadraticModel own{.information = force * force * products.block(first, first, n, n),
                                                .gradient = force * products.block(first, last, n, 1),
                                                .at = Eigen::VectorXd::Zero(n)};
            const double gain = inference::logEvidence(own, inference::bestStep(own)) - logChoices();
            if (units_[l] != 0 && gain > (best ? best->gain : 0)) best = {l, force, gain, first};
        }
        first += n;
    }
    return best ? besideItsRemainder(fit, *best) : FoundLaw{};
}

FoundLaw ForceLaws::besideItsRemainder(const Fit& fit, const Best& best) const {
    const Law& law = laws()[best.law];
    const Eigen::Index n = std::ssize(law.kinds);
    std::vector<Eigen::MatrixXd> forces;
    for (const Eigen::MatrixXd& columns : columns_)
        forces.emplace_back(best.force * columns.middleCols(best.first_column, n));
    const std::vector<Eigen::MatrixXd> further = withResidual(car_, fit, forces);
    std::vector<DriveProducts> with(further.size());
    inParallel(with.size(), car_.problem.replays.threads,
               [&](std::size_t d) { with[d] = productsBeside(fit, car_.uncertainty, d, further[d]); });
    const Sizes sizes = sizesWithAllFree(car_.problem, car_.uncertainty, with);
    const inference::QuadraticModel resized = quadraticBeside(car_, fit, with, sizes);
    const double before = logEvidence(quadraticAt(fit, car_.uncertainty), fit.sizes);
    const double gain = std::max(best.gain, logEvidence(resized, sizes) - before - logChoices());
    const Eigen::VectorXd units = best.force * inference::bestStep(resized).tail(n);
    return {lawOf(law, units, units_[best.law], gain, car_.problem.replays.nominal().vehicle), best.law, units};
}

double gainIfUnknown(const FoundLaw& law) {
    const double u = kSettings.unknown_cause, gain = std::max(0.0, law.told.gain);
    return gain + std::log((1 - u) * std::exp(-gain) + u * std::exp(std::min(0.0, law.told.gain)));
}

}  // namespace tread::diagnose::select
