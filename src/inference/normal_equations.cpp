#include "inference/normal_equations.h"

#include <algorithm>
#include <numeric>

#include "inference/laplace.h"

namespace tread::inference {
namespace {

// Inverse of the lower triangular factor. Its columns are zero above the diagonal, which saves two thirds of the work.
Eigen::MatrixXd inverseOf(const Factor& factor) {
    constexpr Index kBlock = 64;  // columns solved at once
    const Eigen::MatrixXd lower = factor.matrixL();
    const Index n = lower.rows();
    Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(n, n);
    for (Index first = 0; first < n; first += kBlock) {
        const Index left = n - first;
        auto columns = inverse.block(first, first, left, std::min(kBlock, left));
        columns.setIdentity();
        lower.bottomRightCorner(left, left).triangularView<Eigen::Lower>().solveInPlace(columns);
    }
    return inverse;
}

}  // namespace

DriveProducts productsOf(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& disturbances) {
    return {columns.transpose() * columns, disturbances.transpose() * disturbances, disturbances.transpose() * columns};
}

DriveProducts extended(const DriveProducts& products, const Eigen::MatrixXd& columns,
                       const Eigen::MatrixXd& disturbances, const Eigen::MatrixXd& further) {
    const Index old = products.columns.cols(), all = old + further.cols();
    DriveProducts result{Eigen::MatrixXd(all, all), products.disturbances, Eigen::MatrixXd(products.mixed.rows(), all)};
    result.columns.topLeftCorner(old, old) = products.columns;
    result.columns.topRightCorner(old, further.cols()) = columns.transpose() * further;
    result.columns.bottomLeftCorner(further.cols(), old) =
        result.columns.topRightCorner(old, further.cols()).transpose();
    result.columns.bottomRightCorner(further.cols(), further.cols()) = further.transpose() * further;
    result.mixed.leftCols(old) = products.mixed;
    result.mixed.rightCols(further.cols()) = disturbances.transpose() * further;
    return result;
}

void updateByRankOne(DriveProducts& products, const Eigen::MatrixXd& columns, const Eigen::VectorXd& residual,
                     const Eigen::MatrixXd& disturbances, const Eigen::VectorXd& by, const Eigen::VectorXd& step) {
    const Index n = columns.cols();
    const Eigen::VectorXd across = columns.transpose() * by;
    auto squares = products.columns.topLeftCorner(n, n);
    squares += across * step.transpose() + step * across.transpose() + by.squaredNorm() * step * step.transpose();
    products.columns.topRightCorner(n, 1) += by.dot(residual) * step;
    products.columns.bottomLeftCorner(1, n) = products.columns.topRightCorner(n, 1).transpose();
    products.mixed.leftCols(n) += (disturbances.transpose() * by) * step.transpose();
}

void replaceLast(DriveProducts& products, const Eigen::MatrixXd& columns, const Eigen::VectorXd& residual,
                 const Eigen::MatrixXd& disturbances) {
    const Index n = columns.cols();
    products.columns.topRightCorner(n, 1) = columns.transpose() * residual;
    products.columns.bottomLeftCorner(1, n) = products.columns.topRightCorner(n, 1).transpose();
    products.columns(n, n) = residual.squaredNorm();
    products.mixed.col(n) = disturbances.transpose() * residual;
}

Metric metricOf(const Eigen::MatrixXd& disturbances, const Eigen::VectorXd& sizes) {
    // (I + D S S D')^-1 = I - D S (I + S D'D S)^-1 S D'
    const auto scale = sizes.asDiagonal();
    return {sizes, factorOfPriorAnd(scale * disturbances * scale)};
}

NormalEquations normalEquations(const DriveProducts& products, const Metric& metric) {
    const Eigen::MatrixXd half = metric.factor.matrixL().solve(metric.sizes.asDiagonal() * products.mixed);
    return {products.columns - half.transpose() * half, logDeterminant(metric.factor)};
}

NormalEquations normalEquations(const DriveProducts& products, const Eigen::VectorXd& sizes) {
    return normalEquations(products, metricOf(products.disturbances, sizes));
}

double squaresIn(const Metric& metric, const Eigen::VectorXd& residual, const Eigen::VectorXd& mixed) {
    const Eigen::VectorXd half = metric.factor.matrixL().solve(metric.sizes.cwiseProduct(mixed));
    return residual.squaredNorm() - half.squaredNorm();
}

DisturbedProducts disturbedProducts(const DriveProducts& products, const Eigen::VectorXd& sizes) {
    const auto scale = sizes.asDiagonal();
    const Factor factor = factorOfPriorAnd(scale * products.disturbances * scale);
    const Eigen::MatrixXd inverse = inverseOf(factor);
    const Eigen::MatrixXd half = inverse.triangularView<Eigen::Lower>() * (scale * products.mixed);
    return {products.columns - half.transpose() * half, inverse.transpose().triangularView<Eigen::Upper>() * half,
            inverse.colwise().squaredNorm()};
}

NormalEquations operator+(NormalEquations a, const NormalEquations& b) {
    if (a.products.size() == 0) return b;
    a.products += b.products;
    a.log_determinant += b.log_determinant;
    return a;
}

NormalEquations marginalised(const NormalEquations& equations, const std::vector<Index>& out) {
    if (out.empty()) return equations;
    const Factor factor = factorOfPriorAnd(equations.products(out, out));
    const Eigen::MatrixXd half = factor.matrixL().solve(equations.products(out, Eigen::all));
    NormalEquations left{equations.products - half.transpose() * half,
                         equations.log_determinant + logDeterminant(factor)};
    for (const Index i : out) {
        left.products.row(i).setZero();
        left.products.col(i).setZero();
    }
    return left;
}

NormalEquations withoutFirst(const NormalEquations& equations, Index count) {
    std::vector<Index> out(count);
    std::iota(out.begin(), out.end(), 0);
    NormalEquations left = marginalised(equations, out);
    const Index others = equations.products.cols() - count;
    left.products = left.products.bottomRightCorner(others, others).eval();
    return left;
}

}  // namespace tread::inference
