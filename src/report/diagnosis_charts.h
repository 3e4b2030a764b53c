// Measured, nominal, calibrated and with the effect, over time.
#pragma once

#include "diagnose/diagnosis.h"
#include "report/html.h"

namespace tread {

void addOverlays(HtmlPage& page, const Diagnosis& diagnosis);

}  // namespace tread
