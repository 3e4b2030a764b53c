// What a recorded log must hold to be of use.
#pragma once

#include <string>
#include <vector>

namespace tread {

// What `tread run --log`, `compare` and `diagnose` need at least and these channels do not offer: one clause each, with
// what to do. A channel of a further instrument (chassis.vx@gps) counts.
std::vector<std::string> lackingEssentials(const std::vector<std::string>& channels);

}  // namespace tread
