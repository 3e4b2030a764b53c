// The page of a blind check: how good the diagnosis is on cars whose fault was sealed.
#pragma once

#include <string>

#include "blind/score.h"

namespace tread {

struct BlindReport {
    std::string made_of;     // cases, seed and car, in words
    std::string key_sha256;  // of the key that was opened
    std::string version;     // of the program
    BlindScore score;
};

std::string blindReport(const BlindReport& report);

}  // namespace tread
