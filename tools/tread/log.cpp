#include "campaign.h"
#include "log/csv.h"
#include "output.h"
#include "terminal.h"

namespace tread::program {

int convertLog(const LogOptions& options) {
    const Log log = readLog(options.log);
    const Path target = options.output.empty() ? Path(options.log).replace_extension(".csv") : Path(options.output);
    writeLog(target, log);
    note("log: " + target.string());
    return kYes;
}

}  // namespace tread::program
