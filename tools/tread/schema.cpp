#include "commands.h"
#include "describable.h"
#include "output.h"

namespace tread::program {

int schema(const SchemaOptions& options) {
    const std::string text = describable(options.what, true).schema();
    if (options.output.empty()) {
        print(text);
    } else {
        writeFile(options.output, text);
    }
    return kYes;
}

}  // namespace tread::program
