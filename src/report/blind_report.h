// HTML report of a blind check.
#pragma once

#include <string>

#include "blind/score/score.h"

namespace tread {

struct BlindReport {
    std::string made_of;     // number of cases, seed and car, in words
    std::string key_sha256;  // of the key file
    std::string version;     // of the program
    blind::score::BlindScore score;
};

std::string blindReport(const BlindReport& report);

}  // namespace tread
