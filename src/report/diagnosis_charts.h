// Measured, nominal, calibrated and with the effect, over time.
#pragma once

#include "diagnose/answer/diagnosis.h"
#include "report/html.h"

namespace tread {

// `extended`: what the last stage of the model is called.
void addOverlays(HtmlPage& page, const diagnose::answer::Diagnosis& diagnosis,
                 const char* extended = "with the effect");

}  // namespace tread
