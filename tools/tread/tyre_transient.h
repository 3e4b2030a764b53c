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

// What is added to a row.
struct TransientRow {
    double u = 0;
    double v = 0;
    double du = 0;
    double dv = 0;
    double Fx = 0;
    double Fy = 0;
    double Mx = 0;
    double My = 0;
    double Mz = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(u), About{"m", "longitudinal deflection of the contact patch against the rim (17)"});
        field(TREAD_FIELD(v), About{"m", "lateral deflection (18)"});
        field(TREAD_FIELD(du), About{"m/s", "rate of u"});
        field(TREAD_FIELD(dv), About{"m/s", "rate of v"});
        field(TREAD_FIELD(Fx), About{"N", "longitudinal force on the rim (21)"});
        field(TREAD_FIELD(Fy), About{"N", "lateral force on the rim (22)"});
        field(TREAD_FIELD(Mx), About{"N m", "overturning couple (84)"});
        field(TREAD_FIELD(My), About{"N m", "rolling resistance torque (85)"});
        field(TREAD_FIELD(Mz), About{"N m", "aligning torque (23)"});
    }
};
static_assert(describesEveryMember<TransientRow>() && hasAxisSigns<TransientRow>());

// Reads columns t and the fields of TyreMotion at a fixed interval; writes them as given, followed by deflection and
// velocity of the contact patch at that time and the forces (21)-(23), (84), (85) that they and the motion of the same
// row make. The patch starts at rest and undeflected. Returns the number of rows. An empty output is standard output.
std::size_t writeTransientTable(const TyreParams& tyre, const Path& input, const TransientOptions& options,
                                const std::string& output);

}  // namespace tread::program
