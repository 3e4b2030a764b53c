#include "inference/normal_equations.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "inference/laplace.h"

namespace tread::inference {
namespace {

// Products of columns that change by v step', but for the last. `with`: their products with v.
void addToSquares(Eigen::MatrixXd& products, const Eigen::VectorXd& with, double square, const Eigen::VectorXd& step) {
    const Index n = step.size();
    const Eigen::VectorXd across = with.head(n) + 0.5 * square * step;
    products.topLeftCorner(n, n) += across * step.transpose() + step * across.transpose();
    products.topRightCorner(n, 1) += with(n) * step;
    products.bottomLeftCorner(1, n) = products.topRightCorner(n, 1).transpose();
}

// Products of columns beside the same disturbances as others have.
DriveProducts productsOf(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& disturbances,
                         const DriveProducts& others) {
    return {squareOf(columns), others.disturbances, transposedTimes(disturbances, columns)};
}

// Products of some columns and those behind them. `across`: of the ones with the others.
DriveProducts joined(const DriveProducts& first, const Eigen::MatrixXd& across, const DriveProducts& second) {
    const Index front = first.columns.cols(), back = second.columns.cols();
    DriveProducts result{Eigen::MatrixXd(front + back, front + back), first.disturbances,
                         Eigen::MatrixXd(first.mixed.rows(), front + back)};
    result.columns << first.columns, across, across.transpose(), second.columns;
    result.mixed << first.mixed, second.mixed;
    return result;
}

void setLast(Eigen::MatrixXd& products, const Eigen::VectorXd& with) {
    products.rightCols(1) = with;
    products.bottomRows(1) = with.transpose();
}

}  // namespace

DriveProducts productsOf(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& disturbances) {
    return {squareOf(columns), squareOf(disturbances), transposedTimes(disturbances, columns)};
}

DriveProducts extended(const DriveProducts& products, const Eigen::MatrixXd& columns,
                       const Eigen::MatrixXd& disturbances, const Eigen::MatrixXd& further) {
    return joined(products, transposedTimes(columns, further), productsOf(further, disturbances, products));
}

DriveProducts extendedInFront(const Eigen::MatrixXd& further, const DriveProducts& products,
                              const Eigen::MatrixXd& columns, const Eigen::MatrixXd& disturbances) {
    return joined(productsOf(further, disturbances, products), transposedTimes(further, columns), products);
}

DriveProducts firstColumns(const DriveProducts& products, Index count) {
    return {products.columns.topLeftCorner(count, count), products.disturbances, products.mixed.leftCols(count)};
}

DriveProducts lastColumns(const DriveProducts& products, Index count) {
    return {products.columns.bottomRightCorner(count, count), products.disturbances, products.mixed.rightCols(count)};
}

DriveProducts selected(const DriveProducts& products, const std::vector<Index>& columns,
                       const Eigen::VectorXd& factors) {
    DriveProducts result{products.columns(columns, columns), products.disturbances,
                         products.mixed(Eigen::all, columns)};
    scaleColumns(result, factors);
    return result;
}

void scaleColumns(DriveProducts& products, const Eigen::VectorXd& factors) {
    const auto by = factors.asDiagonal();
    products.columns = (by * products.columns * by).eval();
    products.mixed = (products.mixed * by).eval();
}

ColumnProducts productsOfColumn(const Eigen::VectorXd& column, const Eigen::MatrixXd& columns,
                                const Eigen::VectorXd& last, const Eigen::MatrixXd& disturbances) {
    ColumnProducts products{Eigen::VectorXd(columns.cols() + 1), column.squaredNorm(),
                            disturbances.transpose() * column};
    products.with << columns.transpose() * column, last.dot(column);
    return products;
}

void replaceColumns(DriveProducts& products, const Eigen::MatrixXd& columns, const Eigen::VectorXd& last,
                    const std::vector<Index>& changed, const Eigen::MatrixXd& disturbances) {
    const Eigen::MatrixXd some = columns(Eigen::all, changed);
    Eigen::MatrixXd with(columns.cols() + 1, some.cols());
    with << transposedTimes(columns, some), last.transpose() * some;
    products.columns(Eigen::all, changed) = with;
    products.columns(changed, Eigen::all) = with.transpose();
    products.mixed(Eigen::all, changed) = transposedTimes(disturbances, some);
}

void updateByRankOne(DriveProducts& products, const ColumnProducts& by, const Eigen::VectorXd& step) {
    addToSquares(products.columns, by.with, by.square, step);
    products.mixed.leftCols(step.size()) += by.mixed * step.transpose();
}

void replaceLast(DriveProducts& products, const ColumnProducts& last) {
    setLast(products.columns, last.with);
    products.mixed.rightCols(1) = last.mixed;
}

Metric metricOf(const Eigen::MatrixXd& disturbances, const Eigen::VectorXd& sizes) {
    // (I + D S S D')^-1 = I - D S (I + S D'D S)^-1 S D'
    const auto scale = sizes.asDiagonal();
    return {sizes, factorOfPriorAnd(scale * disturbances * scale)};
}

NormalEquations normalEquations(const DriveProducts& products, const Eigen::VectorXd& sizes) {
    return MarginalProducts(products, metricOf(products.disturbances, sizes)).equations();
}

MarginalProducts::MarginalProducts(const DriveProducts& products, Metric metric) : metric_(std::move(metric)) {
    half_ = metric_.factor.half(metric_.sizes.asDiagonal() * products.mixed);
    equations_ = {products.columns - squareOf(half_), logDeterminant(metric_.factor)};
}

Eigen::VectorXd MarginalProducts::halfOf(const Eigen::VectorXd& mixed) const {
    return metric_.factor.half(metric_.sizes.cwiseProduct(mixed));
}

void MarginalProducts::replaceColumns(const DriveProducts& products, const std::vector<Index>& changed) {
    const Eigen::MatrixXd half = metric_.factor.half(metric_.sizes.asDiagonal() * products.mixed(Eigen::all, changed));
    half_(Eigen::all, changed) = half;
    const Eigen::MatrixXd with = products.columns(Eigen::all, changed) - half_.transpose() * half;
    equations_.products(Eigen::all, changed) = with;
    equations_.products(changed, Eigen::all) = with.transpose();
}

void MarginalProducts::updateByRankOne(const ColumnProducts& by, const Eigen::VectorXd& step) {
    const Eigen::VectorXd half = halfOf(by.mixed);
    addToSquares(equations_.products, by.with - half_.transpose() * half, by.square - half.squaredNorm(), step);
    half_.leftCols(step.size()) += half * step.transpose();
}

void MarginalProducts::replaceLast(const ColumnProducts& last) {
    half_.rightCols(1) = halfOf(last.mixed);
    setLast(equations_.products, last.with - half_.transpose() * half_.rightCols(1));
}

void MarginalProducts::scaleColumns(const Eigen::VectorXd& factors) {
    const auto by = factors.asDiagonal();
    half_ = (half_ * by).eval();
    equations_.products = (by * equations_.products * by).eval();
}

double squaresIn(const Metric& metric, const Eigen::VectorXd& residual, const Eigen::VectorXd& mixed) {
    const Eigen::VectorXd half = metric.factor.half(metric.sizes.cwiseProduct(mixed));
    return residual.squaredNorm() - half.squaredNorm();
}

Eigen::VectorXd inMetric(const Metric& metric, const Eigen::VectorXd& residual, const Eigen::MatrixXd& disturbances) {
    const Eigen::VectorXd scaled = metric.sizes.cwiseProduct(disturbances.transpose() * residual);
    return residual - disturbances * metric.sizes.cwiseProduct(metric.factor.solve(scaled));
}

DisturbedProducts MarginalProducts::disturbed() const {
    const Eigen::MatrixXd& root = metric_.factor.lower();
    return {equations_.products, solvedByTransposed(root, half_), inverseOf(root).colwise().squaredNorm()};
}

DisturbedProducts disturbedProducts(const DriveProducts& products, const Eigen::VectorXd& sizes) {
    return MarginalProducts(products, metricOf(products.disturbances, sizes)).disturbed();
}

NormalEquations operator+(NormalEquations a, const NormalEquations& b) {
    if (a.products.size() == 0) return b;
    a.products += b.products;
    a.log_determinant += b.log_determinant;
    return a;
}

NormalEquations sumOf(const std::vector<NormalEquations>& all) {
    NormalEquations sum;
    for (const NormalEquations& one : all) sum = std::move(sum) + one;
    return sum;
}

NormalEquations marginalised(const NormalEquations& equations, const std::vector<Index>& out) {
    if (out.empty()) return equations;
    const Factor factor = factorOfPriorAnd(equations.products(out, out));
    const Eigen::MatrixXd half = factor.half(equations.products(out, Eigen::all));
    NormalEquations left{equations.products - squareOf(half), equations.log_determinant + logDeterminant(factor)};
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
