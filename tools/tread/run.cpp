#include "commands.h"
namespace tread::program {
int run(const RunOptions&) {
    return kRunFailed;
}
int tyre(const TyreOptions&) {
    return kBadInput;
}
}  // namespace tread::program
