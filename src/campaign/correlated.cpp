#include "campaign/correlated.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>
#include <nlohmann/json.hpp>

#include "log/csv.h"
#include "tread/problem.h"

namespace tread::campaign {
namespace {

constexpr double kRounding = 1e-9;  // of the largest element, and of the largest eigenvalue

}  // namespace

JointNormal jointNormal(const Correlated& group) {
    if (group.identified.empty()) return {group.paths, group.mean, group.covariance};
    const auto refuse = [&](const std::string& text) -> LoadError {
        return LoadError({{group.identified, 0, 0, "", text}});
    };
    nlohmann::json found;
    try {
        found = nlohmann::json::parse(readBytes(group.identified));
        JointNormal joint;
        joint.paths = found.at("paths").get<std::vector<std::string>>();
        const auto correlation = found.at("correlation").get<std::vector<std::vector<double>>>();
        std::vector<double> sd;
        for (const std::string& path : joint.paths) {
            joint.mean.push_back(found.at("numbers").at(path).at("value").get<double>());
            sd.push_back(found.at("numbers").at(path).at("sd").get<double>());
        }
        for (std::size_t i = 0; i < sd.size(); ++i) {
            joint.covariance.emplace_back();
            for (std::size_t j = 0; j < sd.size(); ++j)
                joint.covariance.back().push_back(correlation.at(i).at(j) * sd[i] * sd[j]);
        }
        return joint;
    } catch (const std::exception& error) {
        throw refuse(
            fmt::format("found no result of an identification ({}), expected identify.json of `tread "
                        "identify`",
                        error.what()));
    }
}

std::vector<std::vector<double>> rootOf(const std::vector<std::vector<double>>& covariance, std::string& fault) {
    const auto n = static_cast<Eigen::Index>(covariance.size());
    Eigen::MatrixXd matrix(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < n; ++j)
            matrix(i, j) = covariance[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    }
    if (!matrix.allFinite()) {
        fault = "found a value that is no number, expected a covariance";
        return {};
    }
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < i; ++j) {
            if (std::abs(matrix(i, j) - matrix(j, i)) <= kRounding * matrix.cwiseAbs().maxCoeff()) continue;
            fault = fmt::format(
                "found {:.6g} in row {}, column {}, but {:.6g} in row {}, column {}, expected a covariance, which is "
                "symmetric",
                matrix(i, j), i + 1, j + 1, matrix(j, i), j + 1, i + 1);
            return {};
        }
        if (matrix(i, i) < 0) {
            fault =
                fmt::format("found the negative variance {:.6g} in row {}, expected a covariance", matrix(i, i), i + 1);
            return {};
        }
        for (Eigen::Index j = 0; j < i; ++j) {
            const double most = std::sqrt(matrix(i, i) * matrix(j, j));
            if (std::abs(matrix(i, j)) <= most * (1 + kRounding)) continue;
            fault = fmt::format(
                "found the covariance {:.6g} in row {}, column {}, which means a correlation beyond 1; its two "
                "variances allow at most {:.6g}",
                matrix(i, j), i + 1, j + 1, most);
            return {};
        }
    }
    // Scaled to correlations: the numbers may differ by many orders of magnitude.
    const Eigen::VectorXd sd = matrix.diagonal().cwiseSqrt();
    Eigen::MatrixXd correlation = Eigen::MatrixXd::Identity(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < n; ++j)
            if (i != j && sd(i) > 0 && sd(j) > 0) correlation(i, j) = matrix(i, j) / (sd(i) * sd(j));
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(correlation);
    if (solver.eigenvalues().minCoeff() < -kRounding) {
        fault = fmt::format(
            "found a matrix that is no covariance: its correlations contradict each other (smallest eigenvalue {:.3g}, "
            "expected at least 0)",
            solver.eigenvalues().minCoeff());
        return {};
    }
    const Eigen::MatrixXd root = sd.asDiagonal() * solver.eigenvectors() *
                                 solver.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal() *
                                 solver.eigenvectors().transpose();
    std::vector<std::vector<double>> rows(covariance.size(), std::vector<double>(covariance.size()));
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < n; ++j)
            rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = root(i, j);
    }
    return rows;
}

}  // namespace tread::campaign
