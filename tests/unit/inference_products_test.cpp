// Products by wide instructions, factors and solutions are those of Eigen.
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "inference/products.h"
#include "inference/wide/product.h"

namespace tread::inference_products_test {
namespace {

using Eigen::Index, Eigen::MatrixXd;
using namespace inference;

constexpr double kRounding = 1e-13;  // of norms, after some hundred sums of numbers of order 1

// Smaller than a tile, at its edges, at those of the panels, and beyond.
const std::vector<Index> kSizes{1, 3, 8, 24, 25, 31, 33, 64, 96, 97, 130, 257, 300};

double error(const MatrixXd& found, const MatrixXd& expected) {
    return (found - expected).norm() / expected.norm();
}

MatrixXd positive(Index n) {
    const MatrixXd a = MatrixXd::Random(2 * n, n);
    return MatrixXd::Identity(n, n) + a.transpose() * a;
}

TEST(Products, EveryKindOfInstructionsAddsTheProductAndNothingBesideIt) {
    std::vector<AddProduct> kinds;
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) kinds.push_back(addProductByAvx2);
    if (__builtin_cpu_supports("avx512f")) kinds.push_back(addProductByAvx512);
#endif
    if (kinds.empty()) GTEST_SKIP() << "this processor has no wide instructions";
    const auto room = std::make_unique<double[]>(kRoomOfProduct + 8);
    double* const line = room.get() + (64 - reinterpret_cast<std::uintptr_t>(room.get()) % 64) / sizeof(double);
    for (const AddProduct kind : kinds) {
        for (const Index n : kSizes) {
            const Index m = 300 - n + 1, inner = n + 7;
            const MatrixXd a = MatrixXd::Random(inner, m), b = MatrixXd::Random(n, inner);
            const MatrixXd before = MatrixXd::Random(m + 2, n + 2);
            MatrixXd c = before, expected = before;
            kind({{a.data(), inner, 1}, {b.data(), n, 1}, &c(1, 1), m + 2, m, n, inner, -0.5, false}, line);
            expected.block(1, 1, m, n) -= 0.5 * a.transpose() * b.transpose();
            EXPECT_LT(error(c, expected), kRounding) << n;
            EXPECT_EQ(c.row(0), before.row(0));
            EXPECT_EQ(c.row(m + 1), before.row(m + 1));
            EXPECT_EQ(c.col(0), before.col(0));
            EXPECT_EQ(c.col(n + 1), before.col(n + 1));
        }
    }
}

TEST(Products, AreThoseOfEigen) {
    for (const Index n : kSizes) {
        const MatrixXd a = MatrixXd::Random(301, n), b = MatrixXd::Random(301, n / 2 + 1);
        EXPECT_LT(error(squareOf(a), a.transpose() * a), kRounding) << n;
        EXPECT_EQ(squareOf(a), MatrixXd(squareOf(a).transpose())) << n;
        EXPECT_LT(error(transposedTimes(a, b), a.transpose() * b), kRounding) << n;
    }
    EXPECT_EQ(transposedTimes(MatrixXd(5, 3), MatrixXd(5, 0)).size(), 0);
    EXPECT_EQ(squareOf(MatrixXd(0, 2)), MatrixXd(MatrixXd::Zero(2, 2)));
    EXPECT_EQ(squareOf(MatrixXd(2, 0)).size(), 0);
}

TEST(Factor, AndItsSolutionsAreThoseOfEigen) {
    for (const Index n : kSizes) {
        const MatrixXd a = positive(n), b = MatrixXd::Random(n, n + 1);
        const Eigen::LLT<MatrixXd> known(a);
        const Factor factor(a);
        EXPECT_LT(error(factor.lower(), known.matrixL()), kRounding) << n;
        EXPECT_LT(error(factor.half(b), known.matrixL().solve(b)), kRounding) << n;
        EXPECT_LT(error(factor.solve(b), known.solve(b)), kRounding) << n;
        EXPECT_LT(error(factor.solve(b.col(0)), known.solve(b.col(0))), kRounding) << n;
        EXPECT_LT(error(inverseOf(factor.lower()), known.matrixL().solve(MatrixXd::Identity(n, n))), kRounding) << n;
    }
    EXPECT_EQ(Factor(MatrixXd(0, 0)).solve(Eigen::VectorXd(0)).size(), 0);
}

}  // namespace
}  // namespace tread::inference_products_test
