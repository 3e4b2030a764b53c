// What drives show of something that is wrong with a car, as the examiner finds it from the truth: expected evidence,
// and how much of it is left when the best imitation by another effect is free. It needs no simulator: whoever drove
// the cars hands over changes of the readings, their noise, and columns of what can absorb the changes.
//
// Let delta be the change of all readings that are compared (means over blocks of 50 ms) which a wrong thing makes in
// the true car: with it, less without it, all else as it is and the driver's inputs as they were recorded. With
//   N  covariance of the instruments' noise, block by channel,
//   B  what surroundings push and an uncertain speed at the start do, columns of standard deviation 1,
//   J  what numbers do that are known within a tolerance only, columns of one standard deviation each,
//   R  what the knobs of a rival do, columns of kRivalSizes typical sizes each,
//   Sigma = N + B B', of each drive by itself,
// the wrong thing shows with
//   nats       = 1/2 delta' (Sigma + J J')^-1 delta,
//   separation = 1/2 delta' (Sigma + J J' + R R')^-1 delta, the least of all rivals.
// Both need only the products G = A' Sigma^-1 A of A = [J R delta], summed over the drives: with the free columns F = J
// or [J R], delta' (Sigma + F F')^-1 delta = G_dd - G_dF (I + G_FF)^-1 G_Fd (Woodbury), and Sigma^-1 in the same way
// from N and B. No matrix of all rows is made.
#pragma once

#include <Eigen/Dense>
#include <map>
#include <string>
#include <vector>

#include "blind/key.h"

namespace tread {

inline constexpr double kRivalSizes = 3;  // typical sizes: standard deviation with which a rival may absorb

// A drive from which to learn. All columns have its rows: the blocks of one channel after the other.
struct ShownDrive {
    std::vector<Eigen::MatrixXd> noise;  // of each channel in turn: covariance of its rows
    Eigen::MatrixXd pushes;              // B
    Eigen::MatrixXd tolerances;          // J; the same columns in every drive
    Eigen::MatrixXd rivals;              // R of all rivals, one typical size each; the same columns in every drive
    Eigen::MatrixXd changes;             // delta of each wrong thing
    // How often this is measured: repeats of a drive, over recordings that are compared. A recording whose reference is
    // taken off counts 1/2: noise and pushes are those of two.
    double times = 1;
};

// A = [tolerances rivals changes]: A' (N + B B')^-1 A, times `times`.
Eigen::MatrixXd products(const ShownDrive& drive);

struct Rival {
    std::string name;
    std::vector<Eigen::Index> columns;  // of ShownDrive::rivals
};

// Something that is wrong, and who cannot be its rival: what is wrong, too, and what moves the same numbers.
struct WrongThing {
    std::string name;
    std::vector<std::string> no_rivals;
};

// By the names of the wrong things; `wrong` in the order of their changes. Without a rival separation is nats.
std::map<std::string, Shows> shows(const std::vector<ShownDrive>& drives, const std::vector<Rival>& rivals,
                                   const std::vector<WrongThing>& wrong);

// The same from the sum of the products of all drives.
std::map<std::string, Shows> shows(const Eigen::MatrixXd& products, Eigen::Index tolerances,
                                   const std::vector<Rival>& rivals, const std::vector<WrongThing>& wrong);

}  // namespace tread
