#include "commands.h"
namespace tread::program {
int run(const RunOptions&) {
    return kRunFailed;
}
int compare(const CompareOptions&) {
    return kBadInput;
}
int metrics(const MetricsOptions&) {
    return kBadInput;
}
int describe(const DescribeOptions&) {
    return kBadInput;
}
int check(const CheckOptions&) {
    return kBadInput;
}
int schema(const SchemaOptions&) {
    return kBadInput;
}
}  // namespace tread::program
