#include "inference/products.h"

#include <algorithm>
#include <memory>
#include <new>

#include "inference/wide/product.h"

namespace tread::inference {

AddProduct widestProduct() {
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx512f")) return addProductByAvx512;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return addProductByAvx2;
#endif
    return nullptr;
}

namespace {

using Eigen::Index, Eigen::MatrixXd;
using Block = Eigen::Ref<MatrixXd>;
using Strided = Eigen::Map<const MatrixXd, 0, Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>>;

// Up to this many rows and columns a triangle is handled as a whole: large enough that the panels of a product pay.
constexpr Index kWhole = 32;
// From this many columns on, a product by panels pays.
constexpr Index kMany = 8;

constexpr std::align_val_t kLine{64};
struct FreeRoom {
    void operator()(double* room) const { operator delete(room, kLine); }
};

// Kept for the next product: most take less time than to fetch so much memory.
double* roomOfThread() {
    thread_local const std::unique_ptr<double, FreeRoom> room(
        static_cast<double*>(operator new(kRoomOfProduct * sizeof(double), kLine)));
    return room.get();
}

enum class Part { all, lower };

Operand asIs(const Eigen::Ref<const MatrixXd>& a) {
    return {a.data(), 1, a.outerStride()};
}

Operand transposed(const Eigen::Ref<const MatrixXd>& a) {
    return {a.data(), a.outerStride(), 1};
}

Strided view(const Operand& a, Index rows, Index columns) {
    return {a.data, rows, columns, {a.across, a.down}};
}

// C += factor A B; `inner`: columns of A.
void addProduct(Block c, double factor, const Operand& a, Index inner, const Operand& b, Part part = Part::all) {
    static const AddProduct wide = widestProduct();
    if (wide) {
        const Product product{a, b, c.data(), c.outerStride(), c.rows(), c.cols(), inner, factor, part == Part::lower};
        return wide(product, roomOfThread());
    }
    if (part == Part::all) {
        c.noalias() += factor * view(a, c.rows(), inner) * view(b, inner, c.cols());
    } else {
        c.triangularView<Eigen::Lower>() += factor * view(a, c.rows(), inner) * view(b, inner, c.cols());
    }
}

// Where a triangle is cut in two: both parts of whole blocks but for the last.
Index half(Index n) {
    return (n / 2 + kWhole - 1) / kWhole * kWhole;
}

void invert(const Eigen::Ref<const MatrixXd>& lower, Block inverse) {
    const Index n = lower.rows(), first = half(n), left = n - first;
    if (n <= kWhole) {
        inverse.setIdentity();
        lower.triangularView<Eigen::Lower>().solveInPlace(inverse);
        return;
    }
    Block upper_left = inverse.topLeftCorner(first, first), lower_right = inverse.bottomRightCorner(left, left);
    invert(lower.topLeftCorner(first, first), upper_left);
    invert(lower.bottomRightCorner(left, left), lower_right);
    MatrixXd between = MatrixXd::Zero(left, first);
    addProduct(between, 1, asIs(lower.bottomLeftCorner(left, first)), first, asIs(upper_left));
    addProduct(inverse.bottomLeftCorner(left, first), -1, asIs(lower_right), left, asIs(between));
}

// A small triangle is inverted: its inverse times many columns is a product. Well-conditioned where it is the factor of
// an information that the prior adds 1 to.
MatrixXd inverseOfSmall(const Eigen::Ref<const MatrixXd>& lower) {
    MatrixXd inverse(lower.rows(), lower.cols());
    invert(lower, inverse);
    return inverse;
}

void solve(const Eigen::Ref<const MatrixXd>& lower, Block b) {
    const Index n = lower.rows(), first = half(n), left = n - first;
    if (n <= kWhole) {
        const MatrixXd before = b, inverse = inverseOfSmall(lower);
        b.setZero();
        return addProduct(b, 1, asIs(inverse), n, asIs(before));
    }
    solve(lower.topLeftCorner(first, first), b.topRows(first));
    addProduct(b.bottomRows(left), -1, asIs(lower.bottomLeftCorner(left, first)), first, asIs(b.topRows(first)));
    solve(lower.bottomRightCorner(left, left), b.bottomRows(left));
}

void solveTransposed(const Eigen::Ref<const MatrixXd>& lower, Block b) {
    const Index n = lower.rows(), first = half(n), left = n - first;
    if (n <= kWhole) {
        const MatrixXd before = b, inverse = inverseOfSmall(lower);
        b.setZero();
        return addProduct(b, 1, transposed(inverse), n, asIs(before));
    }
    solveTransposed(lower.bottomRightCorner(left, left), b.bottomRows(left));
    addProduct(b.topRows(first), -1, transposed(lower.bottomLeftCorner(left, first)), left, asIs(b.bottomRows(left)));
    solveTransposed(lower.topLeftCorner(first, first), b.topRows(first));
}

// B L'^-1.
void solveFromRight(const Eigen::Ref<const MatrixXd>& lower, Block b) {
    const Index n = lower.rows(), first = half(n), left = n - first;
    if (n <= kWhole) {
        const MatrixXd before = b, inverse = inverseOfSmall(lower);
        b.setZero();
        return addProduct(b, 1, asIs(before), n, transposed(inverse));
    }
    solveFromRight(lower.topLeftCorner(first, first), b.leftCols(first));
    addProduct(b.rightCols(left), -1, asIs(b.leftCols(first)), first, transposed(lower.bottomLeftCorner(left, first)));
    solveFromRight(lower.bottomRightCorner(left, left), b.rightCols(left));
}

void factorise(Block a) {
    const Index n = a.rows(), first = half(n), left = n - first;
    if (n <= kWhole) {
        const Eigen::LLT<Block> in_place(a);
        return;
    }
    factorise(a.topLeftCorner(first, first));
    Block below = a.bottomLeftCorner(left, first);
    solveFromRight(a.topLeftCorner(first, first), below);
    addProduct(a.bottomRightCorner(left, left), -1, asIs(below), first, transposed(below), Part::lower);
    factorise(a.bottomRightCorner(left, left));
}

}  // namespace

MatrixXd squareOf(const MatrixXd& a) {
    MatrixXd square = MatrixXd::Zero(a.cols(), a.cols());
    addProduct(square, 1, transposed(a), a.rows(), asIs(a), Part::lower);
    square.triangularView<Eigen::StrictlyUpper>() = square.transpose();
    return square;
}

MatrixXd transposedTimes(const MatrixXd& a, const MatrixXd& b) {
    if (b.cols() < kMany) return a.transpose() * b;
    MatrixXd product = MatrixXd::Zero(a.cols(), b.cols());
    addProduct(product, 1, transposed(a), a.rows(), asIs(b));
    return product;
}

MatrixXd choleskyOf(MatrixXd symmetric) {
    factorise(symmetric);
    symmetric.triangularView<Eigen::StrictlyUpper>().setZero();
    return symmetric;
}

MatrixXd solvedBy(const MatrixXd& lower, MatrixXd b) {
    if (b.size() == 0) return b;
    if (b.cols() < kMany) lower.triangularView<Eigen::Lower>().solveInPlace(b);
    else solve(lower, b);
    return b;
}

MatrixXd solvedByTransposed(const MatrixXd& lower, MatrixXd b) {
    if (b.size() == 0) return b;
    if (b.cols() < kMany) lower.transpose().triangularView<Eigen::Upper>().solveInPlace(b);
    else solveTransposed(lower, b);
    return b;
}

MatrixXd inverseOf(const MatrixXd& lower) {
    MatrixXd inverse = MatrixXd::Zero(lower.rows(), lower.cols());
    invert(lower, inverse);
    return inverse;
}

}  // namespace tread::inference
