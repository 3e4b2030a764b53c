// Time histories: measured and simulated, and below them what each stage of the model leaves.
#pragma once

#include <string>

#include "diagnose/answer/diagnosis.h"
#include "report/html.h"

namespace tread {

// Names of the stages of the model after the nominal car; a stage without a name is not drawn.
struct StageNames {
    std::string calibrated, extended;
};

void addOverlays(HtmlPage& page, const diagnose::answer::Diagnosis& diagnosis, const StageNames& names);

}  // namespace tread
