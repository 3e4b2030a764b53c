#include "run_scenario.h"

#include <algorithm>

#include "run_series.h"
#include "scenario/load.h"

namespace tread::program {

Driven driveScenario(const RunRecord& record, const Path& folder, const std::vector<Problem>& implausible,
                     const TellShare& tell) {
    const RunRecord ready = tunedRecord(record);
    const double longest = longestDuration(ready.scenario);
    const Tell tell_time = [&](double time) { tell(std::min(1.0, time / longest)); };
    const bool several = ready.scenario.series.vary || ready.scenario.series.highest;
    return several ? driveSeries(ready, folder, implausible, tell_time) : driveInto(ready, folder, tell_time);
}

}  // namespace tread::program
