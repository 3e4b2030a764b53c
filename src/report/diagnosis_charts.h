// Time histories: measured, nominal, calibrated and with the effect.
#pragma once

#include "diagnose/answer/diagnosis.h"
#include "report/html.h"

namespace tread {

// `extended`: name of the last stage of the model.
void addOverlays(HtmlPage& page, const diagnose::answer::Diagnosis& diagnosis,
                 const char* extended = "with the effect");

}  // namespace tread
