// Detectability of faults: the evidence that drives are expected to give for a fault, and the part of it that remains
// when another effect imitates the fault as well as it can. Pure linear algebra: the caller supplies, for each drive,
// the changes of the readings by the faults, the covariance of the noise, and the columns that can absorb changes.
//
// Let delta be the change of all readings (means over blocks of 50 ms) by a fault: readings of the true car less those
// of the same car without the fault, with the same recorded driver inputs. With
//   N  covariance of the noise of the instruments, block diagonal by channel,
//   B  responses to random pushes and to the uncertain initial speed, columns of unit standard deviation,
//   J  responses to numbers that are known within a tolerance, columns of one standard deviation each,
//   R  responses to the knobs of a rival effect, columns of kRivalSizes typical sizes each,
//   P  responses to the effects planted beside the fault, whose sizes are unknown, too: to their knobs, as of a rival,
//      and the change that each of them causes, kRivalSizes times,
//   Sigma = N + B B', for each drive separately,
// the detectability is
//   nats       = 1/2 delta' (Sigma + J J' + P P')^-1 delta,
//   separation = 1/2 delta' (Sigma + J J' + P P' + R R')^-1 delta, the minimum over all rivals.
// Both follow from the products G = A' Sigma^-1 A of A = [J R delta], summed over the drives: with the free columns F =
// [J P] or [J P R], delta' (Sigma + F F')^-1 delta = G_dd - G_dF (I + G_FF)^-1 G_Fd (Woodbury); Sigma^-1 is applied in
// the same way. No matrix of the size rows x rows over all drives is formed.
#pragma once

#include <Eigen/Dense>
#include <map>
#include <string>
#include <vector>

#include "blind/key/key.h"

namespace tread::blind::detectability {

inline constexpr double kRivalSizes = 3;  // typical sizes, standard deviation of the free size of a rival

// Matrices of one training drive. Rows: block means, channel by channel.
struct DriveColumns {
    std::vector<Eigen::MatrixXd> noise;  // covariance of the rows of each channel
    Eigen::MatrixXd pushes;              // B
    Eigen::MatrixXd tolerances;          // J; same columns in every drive
    Eigen::MatrixXd rivals;              // R of all rivals, one typical size per column; same columns in every drive
    Eigen::MatrixXd changes;             // delta of each fault
    // Weight of the drive: the number of its repeats. Half of that with references: the difference of two recordings
    // has twice the variance.
    double times = 1;
};

// A = [tolerances rivals changes]: A' (N + B B')^-1 A, times `times`.
Eigen::MatrixXd products(const DriveColumns& drive);

struct Rival {
    std::string name;
    std::vector<Eigen::Index> columns;  // of DriveColumns::rivals
};

struct Fault {
    std::string name;
    std::vector<std::string> beside;           // effects that are planted as well
    std::vector<std::string> excluded_rivals;  // these, and effects that move the same numbers
};
// An effect or outsider of a case in which these effects are planted.
Fault faultAmong(const std::vector<std::string>& planted, const std::string& name);

// Detectability by name of the fault; `faults` in the order of DriveColumns::changes. Without rivals, separation is
// nats.
std::map<std::string, key::Detectability> detectabilities(const std::vector<DriveColumns>& drives,
                                                          const std::vector<Rival>& rivals,
                                                          const std::vector<Fault>& faults);

// The same from the sum of products() over all drives; `tolerances`: number of columns of J.
std::map<std::string, key::Detectability> detectabilities(const Eigen::MatrixXd& products, Eigen::Index tolerances,
                                                          const std::vector<Rival>& rivals,
                                                          const std::vector<Fault>& faults);

}  // namespace tread::blind::detectability
