// What the fuzzer and the replay of its corpus do with a text as a scenario.
#pragma once

#include <string_view>

#include "fuzz/yaml_entry.h"
#include "scenario/scenario.h"

namespace tread::fuzz {

inline bool readHostileScenario(std::string_view text) {
    return readAs<Scenario>(text);
}

}  // namespace tread::fuzz
