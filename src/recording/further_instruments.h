// Further instruments of quantities that other instruments of the same car measure too.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "log/log.h"
#include "recording/instruments.h"

namespace tread::recording {

// Adds the further instruments of the logs and their mountings that are not described yet; they are taken as ideal.
void addFurtherInstruments(Instruments& instruments, const std::vector<Log>& logs);

// Path of the number that plays the same part in the first instrument of the quantity:
// "instruments.yaw_rate.delay" for "instruments.further.chassis.yaw_rate@can.delay", "instruments.inertial_unit.x" for
// "instruments.mountings.can.x". Empty for a number that is not of a further instrument.
std::string pathInFirst(std::string_view path);

// Source of the further instrument to which the number at a path belongs: "can". Empty for other numbers.
std::string_view sourceOfPath(std::string_view path);

// Error text for the name of a channel of a further instrument; empty when it is right.
std::string furtherChannelFault(const std::string& channel);

}  // namespace tread::recording
