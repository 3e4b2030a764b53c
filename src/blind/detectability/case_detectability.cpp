#include "blind/detectability/case_detectability.h"

#include <algorithm>

#include "base/threads/parallel.h"
#include "blind/detectability/drive_replay.h"
#include "blind/detectability/noise_and_pushes.h"
#include "diagnose/catalogue/effect.h"

namespace tread::blind::detectability {
namespace {

using diagnose::catalogue::Effect;
using faults::DrawnCase;
using faults::sharePaths;
using key::Detectability;

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd productsOf(const ExaminedDrive& drive, const DrawnCase& drawn, const std::vector<Fault>& faults) {
    const DriveReplay replay(drive.drive, drawn.truth);
    const Log readings = replay.readings(drawn.truth);
    const VectorXd here = rowsOf(readings);
    DriveColumns columns = noiseAndPushes(drive, drawn.truth, readings);
    columns.tolerances = drive.tolerances;
    columns.rivals = drive.rivals;
    columns.changes.resize(here.size(), static_cast<Index>(faults.size()));
    for (std::size_t i = 0; i < faults.size(); ++i)
        columns.changes.col(static_cast<Index>(i)) = here - replay.rows(drawn.without.at(faults[i].name));
    return products(columns);
}

// Excluded as rivals: all planted effects, and effects that move a number of the same fault.
std::vector<Fault> faultsOf(const Examination& examination, const DrawnCase& drawn) {
    const std::vector<Effect>& effects = examination.effects;
    std::vector<Fault> faults;
    for (const auto& [name, truth] : drawn.without) {
        Fault& one = faults.emplace_back(faultAmong(drawn.key.effects, name));
        const auto planted = std::find_if(effects.begin(), effects.end(),
                                          [&, &wanted = name](const Effect& e) { return e.name == wanted; });
        if (planted == effects.end()) continue;
        for (const Effect& other : effects)
            if (sharePaths(other, *planted)) one.excluded_rivals.push_back(other.name);
    }
    return faults;
}

}  // namespace

std::map<std::string, Detectability> detectabilities(const Examination& examination, const DrawnCase& drawn,
                                                     int threads) {
    if (drawn.without.empty()) return {};
    const std::vector<Fault> faults = faultsOf(examination, drawn);
    std::vector<MatrixXd> all(examination.drives.size());
    inParallel(all.size(), threads, [&](std::size_t d) { all[d] = productsOf(examination.drives[d], drawn, faults); });
    MatrixXd sum = all.front();
    for (std::size_t d = 1; d < all.size(); ++d) sum += all[d];
    return detectabilities(sum, examination.drives.front().tolerances.cols(), examination.rivals, faults);
}

}  // namespace tread::blind::detectability
