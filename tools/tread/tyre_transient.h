// `tread tyre --transient`: forces of the contact-patch mass under a prescribed motion of the rim.
#pragma once

#include <cstddef>

#include "commands.h"
#include "tread/tyre.h"
#include "tyre_axes.h"

namespace tread::program {

struct TransientOptions {
    Axes axes = Axes::iso;
    bool linear = false;  // motion between two rows; otherwise the earlier row holds
    int substeps = 1;     // integration steps between two rows
    Standstill standstill = Standstill::paper;
};

// Reads columns t and the fields of TyreMotion at a fixed interval; writes them as given, followed by deflection and
// velocity of the contact patch at that time and the forces (21)-(23), (84), (85) that they and the motion of the same
// row make. The patch starts at rest and undeflected. Returns the number of rows. An empty output is standard output.
std::size_t writeTransientTable(const TyreParams& tyre, const Path& input, const TransientOptions& options,
                                const std::string& output);

}  // namespace tread::program
