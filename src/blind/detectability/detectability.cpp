#include "blind/detectability/detectability.h"

#include <algorithm>
#include <stdexcept>

namespace tread::blind::detectability {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using key::Detectability;

// Whitens the rows of each channel by the inverse of the lower Cholesky factor of its covariance.
void whiten(const std::vector<MatrixXd>& noise, MatrixXd& columns) {
    Index first = 0;
    for (const MatrixXd& covariance : noise) {
        const Eigen::LLT<MatrixXd> factor(covariance);
        if (factor.info() != Eigen::Success)
            throw std::invalid_argument("found noise whose covariance is not positive definite");
        auto rows = columns.middleRows(first, covariance.rows());
        factor.matrixL().solveInPlace(rows);
        first += covariance.rows();
    }
    if (first != columns.rows()) throw std::invalid_argument("expected noise for every row");
}

// From the products of the columns [F X], with `free` columns F of unit standard deviation: X' (I + F F')^-1 X, the
// products of X after F has absorbed what it can.
MatrixXd absorbed(const MatrixXd& all, Index free) {
    const Index others = all.cols() - free;
    const MatrixXd inner = MatrixXd::Identity(free, free) + all.topLeftCorner(free, free);
    const MatrixXd beside = all.topRightCorner(free, others);
    return all.bottomRightCorner(others, others) - beside.transpose() * inner.llt().solve(beside);
}

// Evidence for a change after other columns have absorbed what they can, kRivalSizes standard deviations each. `left`:
// products of [rivals changes].
double besides(const MatrixXd& left, std::vector<Index> columns, Index change) {
    const auto count = static_cast<Index>(columns.size());
    columns.push_back(change);
    MatrixXd both = left(columns, columns);
    both.topRows(count) *= kRivalSizes;
    both.leftCols(count) *= kRivalSizes;
    return std::max(0.0, 0.5 * absorbed(both, count)(0, 0));
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

// Columns of the effects planted beside a fault: of their knobs, and of the changes that they cause. `first`: column of
// the change by the first fault.
std::vector<Index> columnsBeside(const Fault& fault, const std::vector<Fault>& faults, const std::vector<Rival>& rivals,
                                 Index first) {
    std::vector<Index> columns;
    for (const Rival& rival : rivals)
        if (contains(fault.beside, rival.name))
            columns.insert(columns.end(), rival.columns.begin(), rival.columns.end());
    for (std::size_t i = 0; i < faults.size(); ++i)
        if (contains(fault.beside, faults[i].name)) columns.push_back(first + static_cast<Index>(i));
    return columns;
}

}  // namespace

Fault faultAmong(const std::vector<std::string>& planted, const std::string& name) {
    Fault fault{name, planted, planted};
    std::erase(fault.beside, name);
    return fault;
}

MatrixXd products(const DriveColumns& drive) {
    const Index rows = drive.changes.rows(), pushes = drive.pushes.cols();
    MatrixXd all(rows, pushes + drive.tolerances.cols() + drive.rivals.cols() + drive.changes.cols());
    all << drive.pushes, drive.tolerances, drive.rivals, drive.changes;
    whiten(drive.noise, all);
    return drive.times * absorbed(all.transpose() * all, pushes);
}

std::map<std::string, Detectability> detectabilities(const MatrixXd& products, Index tolerances,
                                                     const std::vector<Rival>& rivals,
                                                     const std::vector<Fault>& faults) {
    const MatrixXd left = absorbed(products, tolerances);
    const Index first = left.cols() - static_cast<Index>(faults.size());
    std::map<std::string, Detectability> found;
    for (std::size_t i = 0; i < faults.size(); ++i) {
        const Index change = first + static_cast<Index>(i);
        const std::vector<Index> beside = columnsBeside(faults[i], faults, rivals, first);
        const double nats = besides(left, beside, change);
        Detectability& shown = found[faults[i].name] = {.nats = nats, .rival = {}, .separation = nats};
        for (const Rival& rival : rivals) {
            if (contains(faults[i].excluded_rivals, rival.name)) continue;
            std::vector<Index> columns = beside;
            columns.insert(columns.end(), rival.columns.begin(), rival.columns.end());
            const double rest = besides(left, std::move(columns), change);
            if (!shown.rival.empty() && rest >= shown.separation) continue;
            shown.rival = rival.name;
            shown.separation = rest;
        }
    }
    return found;
}

std::map<std::string, Detectability> detectabilities(const std::vector<DriveColumns>& drives,
                                                     const std::vector<Rival>& rivals,
                                                     const std::vector<Fault>& faults) {
    if (drives.empty()) throw std::invalid_argument("expected at least one drive from which to learn");
    MatrixXd sum = products(drives.front());
    for (std::size_t i = 1; i < drives.size(); ++i) sum += products(drives[i]);
    return detectabilities(sum, drives.front().tolerances.cols(), rivals, faults);
}

}  // namespace tread::blind::detectability
