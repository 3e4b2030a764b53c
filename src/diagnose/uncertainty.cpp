#include <algorithm>

#include "diagnose/noise.h"
#include "diagnose/sliding.h"
#include "diagnose/study.h"
#include "identify/parallel.h"

namespace tread {

Uncertainty uncertaintyOf(Bench& bench, const Deviation& at, const Rows& rows) {
    const Subject subject = bench.subjectAt(at);
    Uncertainty uncertainty;
    uncertainty.sizes.fill(1);
    for (std::size_t d = 0; d < bench.drives.size(); ++d) {
        RecordedDrive& drive = bench.drives[d];
        drive.until = std::min(drive.until, slideApart(drive, rows[d]));
    }
    uncertainty.noise = rowNoise(bench.drives, rows);
    uncertainty.disturbing.resize(bench.drives.size());
    uncertainty.directions.resize(bench.drives.size());
    uncertainty.bare.resize(bench.drives.size());
    inParallel(bench.drives.size(), bench.threads, [&](std::size_t d) {
        uncertainty.disturbing[d] = disturbances(bench, d, subject);
        const Disturbances& disturbing = uncertainty.disturbing[d];
        Eigen::MatrixXd all(disturbing.columns.rows(), disturbing.columns.cols() + 1);
        all << disturbing.columns, disturbing.by_start_speed;
        all = uncertainty.noise[d].over(all) * bench.drives[d].disturbed();
        uncertainty.bare[d] = driveGram(Eigen::MatrixXd(all.rows(), 0), all);
        uncertainty.directions[d] = std::move(all);
    });
    return uncertainty;
}

}  // namespace tread
