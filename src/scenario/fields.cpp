#include "base/fields/implausible.h"
#include "base/fields/numbers.h"
#include "base/yaml/setting.h"
#include "base/yaml/write.h"
#include "scenario/scenario.h"

namespace tread {

template struct detail::FieldsOf<Scenario>;

}  // namespace tread
