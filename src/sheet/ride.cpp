#include "sheet/ride.h"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "metrics/channels.h"
#include "vehicle/tyre_load.h"

namespace tread::sheet {
namespace {

constexpr Mode kNone{kUndefined, kUndefined};

// M q'' + C q' + K q = 0
struct Oscillator {
    Eigen::MatrixXd mass, damping, stiffness;
    explicit Oscillator(Eigen::Index size) : mass(Eigen::MatrixXd::Zero(size, size)), damping(mass), stiffness(mass) {}
};

struct ShapedMode {
    Mode mode;
    Eigen::VectorXd shape;  // magnitudes of the coordinates
};

// Slowest first. Two real eigenvalues that follow each other count as one mode that is damped beyond the critical.
std::vector<ShapedMode> modesOf(const Oscillator& o) {
    const Eigen::Index n = o.mass.rows();
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    system.topRightCorner(n, n).setIdentity();
    const Eigen::MatrixXd inverse = o.mass.inverse();
    system.bottomLeftCorner(n, n) = -inverse * o.stiffness;
    system.bottomRightCorner(n, n) = -inverse * o.damping;
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(system);

    std::vector<Eigen::Index> order;
    for (Eigen::Index i = 0; i < 2 * n; ++i)
        if (solver.eigenvalues()(i).imag() >= 0) order.push_back(i);
    std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
        return std::abs(solver.eigenvalues()(a)) < std::abs(solver.eigenvalues()(b));
    });
    std::vector<ShapedMode> modes;
    double real = kUndefined;
    for (const Eigen::Index i : order) {
        const std::complex<double> value = solver.eigenvalues()(i);
        double size = std::abs(value), loss = -value.real();
        if (value.imag() == 0) {
            if (std::isnan(real)) {
                real = value.real();
                continue;
            }
            size = std::sqrt(real * value.real());
            loss = -0.5 * (real + value.real());
            real = kUndefined;
        }
        modes.push_back(
            {{size / (2 * std::numbers::pi), loss / size}, solver.eigenvectors().col(i).head(n).cwiseAbs()});
    }
    return modes;
}

// Both wheels of an axle together.
struct Axle {
    double spring, damping, tyre, tyre_damping, unsprung;
};

Axle axleAt(const AtRest& rest, std::size_t axle) {
    Axle sum{};
    for (std::size_t i = 2 * axle; i < 2 * axle + 2; ++i) {
        const TyreParams& tyre = rest.tyre[i];
        sum.spring += wheelRate(rest, i, 1);
        sum.damping += wheelDamping(rest, i);
        sum.tyre += radialStiffness(tyre);
        sum.tyre_damping += tyre.parameters.pz2 * tyre.lambda.Kz;
        sum.unsprung += rest.axle(axle).unsprung_mass;
    }
    return sum;
}

// Adds an axle whose wheels move by the coordinate `wheel`, the body above it by `body`.
void add(Oscillator& o, const Axle& axle, Eigen::Index wheel, const Eigen::VectorXd& body) {
    Eigen::VectorXd own = Eigen::VectorXd::Zero(body.size());
    own(wheel) = 1;
    const Eigen::VectorXd between = own - body;
    o.mass += axle.unsprung * own * own.transpose();
    o.stiffness += axle.spring * between * between.transpose() + axle.tyre * own * own.transpose();
    o.damping += axle.damping * between * between.transpose() + axle.tyre_damping * own * own.transpose();
}

// Coordinates: body, wheels.
std::vector<ShapedMode> quarterCar(const AtRest& rest, std::size_t axle) {
    const Axle a = axleAt(rest, axle);
    Oscillator o(2);
    o.mass(0, 0) = rest.axleLoad(axle) / kStandardGravity - a.unsprung;
    add(o, a, 1, Eigen::Vector2d(1, 0));
    return modesOf(o);
}

// Coordinates: heave, pitch, front wheels, rear wheels. The body's mass and inertia are those of the car less those of
// the wheels, which do not follow it. The weight tips the body over the wheel centres.
std::vector<ShapedMode> halfCar(const AtRest& rest) {
    Oscillator o(4);
    o.mass(0, 0) = rest.car().mass;
    o.mass(1, 1) = rest.car().inertia.pitch;
    for (std::size_t axle = 0; axle < kAxles; ++axle) {
        const Axle a = axleAt(rest, axle);
        Eigen::Vector4d body(1, axle == 0 ? -rest.car().front_axle_distance : rest.rearDistance(), 0, 0);
        add(o, a, static_cast<Eigen::Index>(2 + axle), body);
        o.mass -= a.unsprung * body * body.transpose();
        o.stiffness(1, 1) -= rest.axleLoad(axle) * (rest.height - rest.meanRadius(axle));
    }
    return modesOf(o);
}

}  // namespace

Ride ride(const AtRest& rest) {
    Ride ride{{kNone, kNone}, {kNone, kNone}, kNone, kNone};
    for (std::size_t axle = 0; axle < kAxles; ++axle) {
        const std::vector<ShapedMode> modes = quarterCar(rest, axle);
        if (modes.size() != 2) continue;
        ride.body[axle] = modes[0].mode;
        ride.wheel[axle] = modes[1].mode;
    }
    const std::vector<ShapedMode> modes = halfCar(rest);
    if (modes.size() != 4) return ride;
    // Heave is the slow mode in which more of the movement is up and down.
    const double gyration = std::sqrt(rest.car().inertia.pitch / rest.car().mass);
    const auto share = [&](const ShapedMode& m) { return m.shape(0) / (m.shape(0) + gyration * m.shape(1)); };
    const bool first = share(modes[0]) >= share(modes[1]);
    ride.heave = modes[first ? 0 : 1].mode;
    ride.pitch = modes[first ? 1 : 0].mode;
    return ride;
}

}  // namespace tread::sheet
