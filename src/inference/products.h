// Products, factors and solutions of large matrices by the widest instructions of the processor, Eigen where there are
// none. The same processor gets the same result bit for bit on any number of threads.
#pragma once

#include <Eigen/Dense>
#include <utility>

namespace tread::inference {

// A'A: symmetric, so that half of it need not be computed.
Eigen::MatrixXd squareOf(const Eigen::MatrixXd& a);

// A'B.
Eigen::MatrixXd transposedTimes(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

// The lower triangle L of LL', with zeros above. Only the lower triangle of `symmetric` is read.
Eigen::MatrixXd choleskyOf(Eigen::MatrixXd symmetric);

// L^-1 B, of a lower triangle.
Eigen::MatrixXd solvedBy(const Eigen::MatrixXd& lower, Eigen::MatrixXd b);

// L'^-1 B.
Eigen::MatrixXd solvedByTransposed(const Eigen::MatrixXd& lower, Eigen::MatrixXd b);

// L^-1.
Eigen::MatrixXd inverseOf(const Eigen::MatrixXd& lower);

// Cholesky factor L of a symmetric matrix LL', of which only the lower triangle is read.
class Factor {
public:
    explicit Factor(Eigen::MatrixXd symmetric) : lower_(choleskyOf(std::move(symmetric))) {}

    const Eigen::MatrixXd& lower() const { return lower_; }

    // (LL')^-1 b, and L^-1 b.
    template <class Matrix>
    typename Matrix::PlainObject solve(const Eigen::MatrixBase<Matrix>& b) const {
        return solvedByTransposed(lower_, solvedBy(lower_, b));
    }
    template <class Matrix>
    typename Matrix::PlainObject half(const Eigen::MatrixBase<Matrix>& b) const {
        return solvedBy(lower_, b);
    }

private:
    Eigen::MatrixXd lower_;
};

}  // namespace tread::inference
