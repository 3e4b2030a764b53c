#include "identify/gram.h"

#include <numeric>

namespace tread {
namespace {

double logDeterminant(const Eigen::LLT<Eigen::MatrixXd>& factor) {
    return 2 * factor.matrixLLT().diagonal().array().log().sum();
}

Eigen::MatrixXd priorAnd(const Eigen::MatrixXd& information) {
    return Eigen::MatrixXd::Identity(information.rows(), information.cols()) + information;
}

}  // namespace

DriveGram driveGram(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& disturbances) {
    return {columns.transpose() * columns, disturbances.transpose() * disturbances, disturbances.transpose() * columns,
            columns.rows()};
}

DriveGram extended(const DriveGram& gram, const Eigen::MatrixXd& columns, const Eigen::MatrixXd& disturbances,
                   const Eigen::MatrixXd& further) {
    const Eigen::Index old = gram.columns.cols(), all = old + further.cols();
    DriveGram result{Eigen::MatrixXd(all, all), gram.disturbances, Eigen::MatrixXd(gram.mixed.rows(), all), gram.rows};
    result.columns.topLeftCorner(old, old) = gram.columns;
    result.columns.topRightCorner(old, further.cols()) = columns.transpose() * further;
    result.columns.bottomLeftCorner(further.cols(), old) =
        result.columns.topRightCorner(old, further.cols()).transpose();
    result.columns.bottomRightCorner(further.cols(), further.cols()) = further.transpose() * further;
    result.mixed.leftCols(old) = gram.mixed;
    result.mixed.rightCols(further.cols()) = disturbances.transpose() * further;
    return result;
}

Gram whitened(const DriveGram& gram, const Eigen::VectorXd& sizes) {
    // (I + D S S D')^-1 = I - D S (I + S D'D S)^-1 S D'
    const auto scale = sizes.asDiagonal();
    const Eigen::LLT<Eigen::MatrixXd> factor(priorAnd(scale * gram.disturbances * scale));
    const Eigen::MatrixXd half = factor.matrixL().solve(scale * gram.mixed);
    return {gram.columns - half.transpose() * half, logDeterminant(factor)};
}

Gram operator+(Gram a, const Gram& b) {
    if (a.products.size() == 0) return b;
    a.products += b.products;
    a.log_determinant += b.log_determinant;
    return a;
}

double logEvidence(const Gram& gram, Eigen::Index residual, const std::vector<Eigen::Index>& free) {
    const Gram left = marginalised(gram, free);
    return -0.5 * left.products(residual, residual) - 0.5 * left.log_determinant;
}

Gram marginalised(const Gram& gram, const std::vector<Eigen::Index>& out) {
    if (out.empty()) return gram;
    std::vector<Eigen::Index> all(static_cast<std::size_t>(gram.products.cols()));
    std::iota(all.begin(), all.end(), 0);
    const Eigen::LLT<Eigen::MatrixXd> factor(priorAnd(gram.products(out, out)));
    const Eigen::MatrixXd half = factor.matrixL().solve(gram.products(out, all));
    Gram left{gram.products - half.transpose() * half, gram.log_determinant + logDeterminant(factor)};
    for (const Eigen::Index i : out) {
        left.products.row(i).setZero();
        left.products.col(i).setZero();
    }
    return left;
}

}  // namespace tread
