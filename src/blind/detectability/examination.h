// Linearised response of a car in the drives of a case: what every column of the detectability formula
// (detectability.h) needs that does not depend on the fault.
//
// Columns are differences of simulated readings about the fault-free true car: a change is absorbed by what a car
// without a fault could show. (About the nominal car, once for all cases, they would cost a tenth. In seven cases that
// changed the evidence by 1 to 20 % in five, from 6.2 to 4.8 nats in one and from 194 to 310 in one: columns that are
// slightly misaligned absorb less of a large change.) Not modelled: noise of the recorded driver inputs, spikes. A
// rival may take a sign that its effect cannot have; separation is therefore a lower bound.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "blind/detectability/detectability.h"
#include "blind/detectability/hats.h"
#include "blind/drives/drives.h"
#include "blind/world/errors.h"
#include "diagnose/catalogue/effect.h"
#include "recording/subject.h"

namespace tread::blind::detectability {

// A training drive. All matrices have the rows of rowsOf().
struct ExaminedDrive {
    drives::Drive drive;
    std::vector<double> times;                       // s, of the readings
    std::vector<double> speed;                       // m/s, at these times
    Eigen::MatrixXd tolerances, rivals;              // J and R of detectability.h
    std::array<Eigen::MatrixXd, kHatForces> by_hat;  // response to each hat of kUnitPush, by generalised force
    Eigen::MatrixXd differences;     // drive-to-drive differences (world::DriveDifference), one standard deviation each
    Eigen::VectorXd by_start_speed;  // change per m/s of the speed at the start
};

struct Examination {
    std::vector<ExaminedDrive> drives;
    std::vector<diagnose::catalogue::Effect> effects;
    std::vector<Rival> rivals;  // effects that apply to this car
};

// About the car `about`; `open` are its uncertain numbers, `effects` is the catalogue. `threads`: 0 for all cores.
// Throws SimulationError when the car cannot be driven.
Examination examination(const recording::Subject& about, const std::vector<drives::Drive>& drives,
                        const std::vector<world::OpenNumber>& open,
                        const std::vector<diagnose::catalogue::Effect>& effects, int threads = 0);

}  // namespace tread::blind::detectability
