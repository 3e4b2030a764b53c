// A random surface after ISO 8608.
//
// Along x, three profiles A, B and C without common frequencies; across the road
//     z(x, y) = A(x) + B(x) cos(pi y / w) + C(x) sin(pi y / w),   w: distance of the wheel paths.
// With PSDs G (1 + g) / 2 of A and G (1 - g) / 2 of B and C each, every path along x has the PSD G, and two paths at
// the distance w have the real cross-spectrum g G. For a surface that looks the same in every direction and has G ~
// n^-2v (C. J. Dodds, J. D. Robson, The description of road surface roughness, Journal of Sound and Vibration 31, 1973;
// K. M. A. Kamash, J. D. Robson, Implications of isotropy in random surfaces, JSV 54, 1977) the integral over the
// lateral wave numbers gives
//     g(n) = 2 (x / 2)^v K_v(x) / Gamma(v),   x = 2 pi n w,
// near 1 for long waves and 0 for waves shorter than the car is wide. Between and beside the two paths this surface is
// smooth and as rough as on them, and repeats itself after 2 w.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "tread/road_params.h"

namespace tread {

// Gd(n) in m3, n in cycles/m, as described (without the limits of the wavelengths).
double displacementPsd(const RoughnessParams& params, double wave_number);

// Real part of the cross-spectrum of both wheel paths over their PSD.
double wheelPathCoherence(const RoughnessParams& params, double wave_number);

bool isRough(const RoughnessParams& params);

class Roughness {
public:
    // `contact_length`: m, over which averaged() averages.
    Roughness(const RoughnessParams& params, double contact_length);

    SurfacePoint at(double x, double y) const { return evaluate(itself_, x, y); }
    SurfacePoint averaged(double x, double y) const { return evaluate(averaged_, x, y); }

private:
    using Node = std::array<double, 4>;  // spline coefficients of A, B and C; the fourth keeps nodes aligned
    using Profile = std::vector<Node>;

    SurfacePoint evaluate(const Profile& profile, double x, double y) const;

    double wave_across_;  // rad/m
    double begin_;        // m
    Profile itself_;
    Profile averaged_;
};

}  // namespace tread
