#include "base/text/number_text.h"
#include "campaign.h"
#include "log/csv.h"
#include "log/mcap_write.h"
#include "output.h"
#include "refuse.h"
#include "terminal.h"

namespace tread::program {
namespace {

bool isMcapName(const Path& file) {
    const std::string extension = file.extension().string();
    return extension == ".mcap" || extension == ".MCAP";
}

void writeMcapFile(const Path& target, const Log& log, const std::string& source) {
    WholeFile file(target);
    writeMcap(log, source, std::string(kMcapOfTread) + TREAD_VERSION,
              [&](std::string_view bytes) { file.write(bytes); });
    file.finish();
}

}  // namespace

int convertLog(const LogOptions& options) {
    const bool mcap = options.mcap || isMcapName(options.output);
    if (mcap && !options.output.empty() && !isMcapName(options.output))
        refuse("--mcap", "found the output " + quote(options.output) + ", expected a name that ends with .mcap");
    const char* const extension = mcap ? ".mcap" : ".csv";
    const Path target = options.output.empty() ? Path(options.log).replace_extension(extension) : Path(options.output);
    const Log log = readLog(options.log);
    mcap ? writeMcapFile(target, log, options.log) : writeLog(target, log);
    note("log: " + target.string());
    return kYes;
}

}  // namespace tread::program
