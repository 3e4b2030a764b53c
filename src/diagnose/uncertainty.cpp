#include "diagnose/noise.h"
#include "diagnose/study.h"
#include "identify/parallel.h"

namespace tread {

Uncertainty uncertaintyOf(Bench& bench, const Deviation& at, const Rows& rows) {
    const Subject subject = bench.subjectAt(at);
    Uncertainty uncertainty;
    uncertainty.sizes.fill(1);
    for (RowNoise& noise : rowNoise(bench.drives, rows)) {
        uncertainty.noise.push_back(std::move(noise.deviation));
        uncertainty.expected.push_back(noise.expected);
    }
    uncertainty.disturbing.resize(bench.drives.size());
    uncertainty.directions.resize(bench.drives.size());
    uncertainty.bare.resize(bench.drives.size());
    inParallel(bench.drives.size(), bench.threads, [&](std::size_t d) {
        const Eigen::VectorXd by_start_speed = startSpeedColumn(bench, d, subject, rows[d]);
        uncertainty.disturbing[d] = disturbances(bench, d, subject, by_start_speed);
        const Eigen::MatrixXd& columns = uncertainty.disturbing[d].columns;
        Eigen::MatrixXd& all = uncertainty.directions[d];
        all.resize(columns.rows(), columns.cols() + 1);
        all << columns, by_start_speed;
        all.array().colwise() /= uncertainty.noise[d].array();
        uncertainty.bare[d] = driveGram(Eigen::MatrixXd(all.rows(), 0), all);
    });
    return uncertainty;
}

}  // namespace tread
