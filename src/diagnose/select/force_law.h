// Laws that a force of unknown cause may follow. A force that no effect of the catalogue explains may depend on the
// motion of the car. Such a law does not name the cause, but it separates an unknown cause from the most similar
// effect, and shows where to look.
#pragma once

#include <vector>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/select/calibration.h"

namespace tread::diagnose::select {

// A law beside a model.
struct FoundLaw {
    answer::ForceLaw told{.gain = -kInfinity};  // gain -infinity: none gains
    std::size_t place = 0;                      // among the laws
    Eigen::VectorXd forces = {};                // of each kind, in usual sizes: root mean square over all drives
};

// Changes of the rows of each drive by each force of a law, at one usual size.
std::vector<Eigen::MatrixXd> changesBy(const FoundLaw& law, const Calibration& car);

// Their forces are combined from the columns of the disturbances, so nothing is simulated. The car must outlive them.
class ForceLaws {
public:
    explicit ForceLaws(const Calibration& car);

    // The law that gains most beside a model, with the remainder that it leaves (D35).
    FoundLaw best(const Fit& fit) const;

private:
    struct Best;
    // A law beside the remainder that it leaves.
    FoundLaw besideItsRemainder(const Fit& fit, const Best& best) const;

    const Calibration& car_;
    std::vector<double> units_;             // of each law; 0 where its signal is 0 or missing
    std::vector<Eigen::MatrixXd> columns_;  // whitened, per drive: of each kind of force of every law
};

// Nats that a model gains because a force of unknown cause, which follows this law, may act beside it (D35a).
double gainIfUnknown(const FoundLaw& law);

}  // namespace tread::diagnose::select
