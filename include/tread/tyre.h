// A tyre after Delft Tyre 97: parameters, state, and the two things one can ask of it: the steady-state forces at a
// given slip, and the advance of contact patch (and wheel spin) over one time step.
//
// Source: H.B. Pacejka, I.J.M. Besselink, "Magic Formula Tyre Model with Transient Properties", Vehicle System Dynamics
// 27:S1 (1997) 234-249; numbers in brackets are its equations, names are its symbols.
//
// Everything in this header is in the paper's axes: x forward, y right, z down, forces oppose the slip velocity, and
// positive camber leans the top of the wheel to the right. The vehicle converts to ISO 8855 at its border with the
// tyre.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tread/api.h"
#include "tread/describe.h"

namespace tread {

// Structs that the formulas take are templates over the number type: double, or four doubles for four wheels at once.

// The rolling radius stays positive: the formulas see at most four times the nominal load.
inline constexpr Limits kRollingRadiusByLoad{-0.2, 0.2};

// The numbers p, q, r, s of the paper's appendix and of its transient part.
template <class T>
struct BasicTyreCoefficients {
    // Size and nominal state
    T Fzo = kRequired;
    T Ro = kRequired;
    T Re = kRequired;
    T pRe1 = 0;
    // Longitudinal force at pure slip (36)-(45)
    T pCx1 = kRequired;
    T pDx1 = kRequired;
    T pDx2 = 0;
    T pEx1 = 0;
    T pEx2 = 0;
    T pEx3 = 0;
    T pEx4 = 0;
    T pKx1 = kRequired;
    T pKx2 = 0;
    T pKx3 = 0;
    T pHx1 = 0;
    T pHx2 = 0;
    T pVx1 = 0;
    T pVx2 = 0;
    // Longitudinal force at combined slip (71)-(75)
    T rBx1 = 0;
    T rBx2 = 0;
    T rCx1 = 0;
    T rHx1 = 0;
    // Lateral force at pure slip (46)-(56)
    T pCy1 = kRequired;
    T pDy1 = kRequired;
    T pDy2 = 0;
    T pDy3 = 0;
    T pEy1 = 0;
    T pEy2 = 0;
    T pEy3 = 0;
    T pEy4 = 0;
    T pKy1 = kRequired;
    T pKy2 = kRequired;
    T pKy3 = 0;
    T pHy1 = 0;
    T pHy2 = 0;
    T pHy3 = 0;
    T pVy1 = 0;
    T pVy2 = 0;
    T pVy3 = 0;
    T pVy4 = 0;
    // Lateral force at combined slip (76)-(82)
    T rBy1 = 0;
    T rBy2 = 0;
    T rBy3 = 0;
    T rCy1 = 0;
    T rHy1 = 0;
    T rVy1 = 0;
    T rVy2 = 0;
    T rVy3 = 0;
    T rVy4 = 0;
    T rVy5 = 0;
    T rVy6 = 0;
    // Aligning torque (57)-(70), (86)-(92)
    T qBz1 = 0;
    T qBz2 = 0;
    T qBz3 = 0;
    T qBz4 = 0;
    T qBz5 = 0;
    T qBz9 = 0;
    T qBz10 = 0;
    T qCz1 = 0;
    T qDz1 = 0;
    T qDz2 = 0;
    T qDz3 = 0;
    T qDz4 = 0;
    T qDz6 = 0;
    T qDz7 = 0;
    T qDz8 = 0;
    T qDz9 = 0;
    T qEz1 = 0;
    T qEz2 = 0;
    T qEz3 = 0;
    T qEz4 = 0;
    T qEz5 = 0;
    T qHz1 = 0;
    T qHz2 = 0;
    T qHz3 = 0;
    T qHz4 = 0;
    T ssz1 = 0;
    T ssz2 = 0;
    T ssz3 = 0;
    T ssz4 = 0;
    // Overturning, rolling resistance, normal load (83)-(85)
    T qx1 = 0;
    T qx2 = 0;
    T qy1 = 0;
    T qy2 = 0;
    T pz1 = kRequired;
    T pz2 = 0;
    // Contact-patch mass, carcass and belt (17)-(28)
    T pTy8 = 0;
    T pTy9 = 0;
    T mc = kRequired;
    T kFx = 0;
    T kFy = 0;
    T cFx = kRequired;
    T cFy = kRequired;
    T mt = 0;
    T czgyr = 0;
    T cygyr = 0;
    T cpsigyr = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(Fzo), About{"N", "nominal load (29)", kPositive}.usually(2, 1e5));
        field(TREAD_FIELD(Ro), About{"m", "unloaded radius", kPositive}.usually(0.01, 0.9));
        field(TREAD_FIELD(Re),
              About{"m", "effective rolling radius at nominal load", kPositive, 0.003}.usually(0.01, 0.9));
        field(TREAD_FIELD(pRe1),
              About{"-", "variation of the effective rolling radius with load: Re (1 + pRe1 dfz); the paper has none",
                    kRollingRadiusByLoad}
                  .usually(-0.03, 0));
        field(TREAD_FIELD(pCx1), About{"-", "shape factor Cx (38)", kPositive}.unjudged());
        field(TREAD_FIELD(pDx1), About{"-", "peak friction mux at nominal load (40)", kPositive}.usually(0.1, 4));
        field(TREAD_FIELD(pDx2), About{"-", "variation of mux with load (40)"}.unjudged());
        field(TREAD_FIELD(pEx1), About{"-", "curvature Ex at nominal load (41)"}.unjudged());
        field(TREAD_FIELD(pEx2), About{"-", "variation of Ex with load (41)"}.unjudged());
        field(TREAD_FIELD(pEx3), About{"-", "variation of Ex with load squared (41)"}.unjudged());
        field(TREAD_FIELD(pEx4), About{"-", "difference of Ex between driving and braking (41)"}.unjudged());
        field(TREAD_FIELD(pKx1), About{"-", "slip stiffness Kx/Fz at nominal load (42)", kPositive}.unjudged());
        field(TREAD_FIELD(pKx2), About{"-", "variation of Kx/Fz with load (42)"}.unjudged());
        field(TREAD_FIELD(pKx3), About{"-", "exponent of Kx/Fz with load (42)"}.unjudged());
        field(TREAD_FIELD(pHx1), About{"-", "horizontal shift SHx at nominal load (44)"}.unjudged());
        field(TREAD_FIELD(pHx2), About{"-", "variation of SHx with load (44)"}.unjudged());
        field(TREAD_FIELD(pVx1), About{"-", "vertical shift SVx/Fz at nominal load (45)"}.unjudged());
        field(TREAD_FIELD(pVx2), About{"-", "variation of SVx/Fz with load (45)"}.unjudged());
        field(TREAD_FIELD(rBx1), About{"-", "slope factor of the weighting Bxa (72)"}.unjudged());
        field(TREAD_FIELD(rBx2), About{"-", "variation of Bxa with longitudinal slip (72)"}.unjudged());
        field(TREAD_FIELD(rCx1), About{"-", "shape factor Cxa (73)"}.unjudged());
        field(TREAD_FIELD(rHx1), About{"-", "shift SHxa (75)"}.unjudged());
        field(TREAD_FIELD(pCy1), About{"-", "shape factor Cy (49)", kPositive}.unjudged());
        field(TREAD_FIELD(pDy1), About{"-", "peak friction muy at nominal load (51)", kPositive}.usually(0.1, 4));
        field(TREAD_FIELD(pDy2), About{"-", "variation of muy with load (51)"}.unjudged());
        field(TREAD_FIELD(pDy3), About{"1/rad2", "variation of muy with camber squared (51)"}.unjudged());
        field(TREAD_FIELD(pEy1), About{"-", "curvature Ey at nominal load (52)"}.unjudged());
        field(TREAD_FIELD(pEy2), About{"-", "variation of Ey with load (52)"}.unjudged());
        field(TREAD_FIELD(pEy3), About{"-", "sign-dependent part of Ey (52)"}.unjudged());
        field(TREAD_FIELD(pEy4),
              About{"1/rad", "variation of the sign-dependent part of Ey with camber (52)"}.unjudged());
        field(TREAD_FIELD(pKy1),
              About{"-", "largest cornering stiffness over nominal load (53)", kPositive}.unjudged());
        field(TREAD_FIELD(pKy2),
              About{"-", "load at the largest cornering stiffness over nominal load (53)", kPositive}.unjudged());
        field(TREAD_FIELD(pKy3), About{"1/rad", "variation of the cornering stiffness with camber (53)"}.unjudged());
        field(TREAD_FIELD(pHy1), About{"-", "horizontal shift SHy at nominal load (55)"}.unjudged());
        field(TREAD_FIELD(pHy2), About{"-", "variation of SHy with load (55)"}.unjudged());
        field(TREAD_FIELD(pHy3), About{"1/rad", "variation of SHy with camber (55)"}.unjudged());
        field(TREAD_FIELD(pVy1), About{"-", "vertical shift SVy/Fz at nominal load (56)"}.unjudged());
        field(TREAD_FIELD(pVy2), About{"-", "variation of SVy/Fz with load (56)"}.unjudged());
        field(TREAD_FIELD(pVy3), About{"1/rad", "variation of SVy/Fz with camber (56)"}.unjudged());
        field(TREAD_FIELD(pVy4), About{"1/rad", "variation of SVy/Fz with camber and load (56)"}.unjudged());
        field(TREAD_FIELD(rBy1), About{"-", "slope factor of the weighting Byk (77)"}.unjudged());
        field(TREAD_FIELD(rBy2), About{"-", "variation of Byk with lateral slip (77)"}.unjudged());
        field(TREAD_FIELD(rBy3), About{"-", "lateral slip at the largest Byk (77)"}.unjudged());
        field(TREAD_FIELD(rCy1), About{"-", "shape factor Cyk (78)"}.unjudged());
        field(TREAD_FIELD(rHy1), About{"-", "shift SHyk (80)"}.unjudged());
        field(TREAD_FIELD(rVy1), About{"-", "slip-induced ply-steer at nominal load (82)"}.unjudged());
        field(TREAD_FIELD(rVy2), About{"-", "variation of the slip-induced ply-steer with load (82)"}.unjudged());
        field(TREAD_FIELD(rVy3), About{"1/rad", "variation of the slip-induced ply-steer with camber (82)"}.unjudged());
        field(TREAD_FIELD(rVy4),
              About{"-", "variation of the slip-induced ply-steer with lateral slip (82)"}.unjudged());
        field(TREAD_FIELD(rVy5), About{"-", "shape of the slip-induced ply-steer (81)"}.unjudged());
        field(TREAD_FIELD(rVy6), About{"-", "slope of the slip-induced ply-steer (81)"}.unjudged());
        field(TREAD_FIELD(qBz1), About{"-", "trail slope factor Bt at nominal load (64)"}.unjudged());
        field(TREAD_FIELD(qBz2), About{"-", "variation of Bt with load (64)"}.unjudged());
        field(TREAD_FIELD(qBz3), About{"-", "variation of Bt with load squared (64)"}.unjudged());
        field(TREAD_FIELD(qBz4), About{"1/rad", "variation of Bt with camber (64)"}.unjudged());
        field(TREAD_FIELD(qBz5), About{"1/rad", "variation of Bt with absolute camber (64)"}.unjudged());
        field(TREAD_FIELD(qBz9), About{"-", "slope factor Br of the residual torque (69)"}.unjudged());
        field(TREAD_FIELD(qBz10), About{"-", "part of Br that follows the lateral force (69)"}.unjudged());
        field(TREAD_FIELD(qCz1), About{"-", "trail shape factor Ct (65)"}.unjudged());
        field(TREAD_FIELD(qDz1), About{"-", "peak trail over Ro at nominal load (66)"}.unjudged());
        field(TREAD_FIELD(qDz2), About{"-", "variation of the peak trail with load (66)"}.unjudged());
        field(TREAD_FIELD(qDz3), About{"1/rad", "variation of the peak trail with camber (66)"}.unjudged());
        field(TREAD_FIELD(qDz4), About{"1/rad2", "variation of the peak trail with camber squared (66)"}.unjudged());
        field(TREAD_FIELD(qDz6), About{"-", "peak residual torque over Fz Ro at nominal load (70)"}.unjudged());
        field(TREAD_FIELD(qDz7), About{"-", "variation of the residual torque with load (70)"}.unjudged());
        field(TREAD_FIELD(qDz8), About{"1/rad", "variation of the residual torque with camber (70)"}.unjudged());
        field(TREAD_FIELD(qDz9),
              About{"1/rad", "variation of the residual torque with camber and load (70)"}.unjudged());
        field(TREAD_FIELD(qEz1), About{"-", "trail curvature Et at nominal load (67)"}.unjudged());
        field(TREAD_FIELD(qEz2), About{"-", "variation of Et with load (67)"}.unjudged());
        field(TREAD_FIELD(qEz3), About{"-", "variation of Et with load squared (67)"}.unjudged());
        field(TREAD_FIELD(qEz4), About{"-", "sign-dependent part of Et (67)"}.unjudged());
        field(TREAD_FIELD(qEz5),
              About{"1/rad", "variation of the sign-dependent part of Et with camber (67)"}.unjudged());
        field(TREAD_FIELD(qHz1), About{"-", "trail shift SHt at nominal load (68)"}.unjudged());
        field(TREAD_FIELD(qHz2), About{"-", "variation of SHt with load (68)"}.unjudged());
        field(TREAD_FIELD(qHz3), About{"1/rad", "variation of SHt with camber (68)"}.unjudged());
        field(TREAD_FIELD(qHz4), About{"1/rad", "variation of SHt with camber and load (68)"}.unjudged());
        field(TREAD_FIELD(ssz1), About{"-", "moment arm of Fx over Ro (90)"}.unjudged());
        field(TREAD_FIELD(ssz2), About{"-", "variation of that arm with Fy/Fzo (90)"}.unjudged());
        field(TREAD_FIELD(ssz3), About{"1/rad", "variation of that arm with camber (90)"}.unjudged());
        field(TREAD_FIELD(ssz4), About{"1/rad", "variation of that arm with camber and load (90)"}.unjudged());
        field(TREAD_FIELD(qx1), About{"m/N", "overturning couple over Fy Fz (84)"}.unjudged());
        field(TREAD_FIELD(qx2), About{"m/rad", "overturning couple over camber and Fz (84)"}.unjudged());
        field(TREAD_FIELD(qy1), About{"m", "rolling resistance torque over Fz (85)"}.usually(-0.05, 0.05));
        field(TREAD_FIELD(qy2), About{"m/N", "rolling resistance torque over Fx Fz (85)"}.unjudged());
        field(TREAD_FIELD(pz1), About{"N/m", "radial stiffness (83)", kPositive}.usually(500, 3e6));
        field(TREAD_FIELD(pz2), About{"N s/m", "radial damping (83)", kNonNegative}.usually(0, 1e4));
        field(TREAD_FIELD(pTy8), About{"1/rad", "non-lagging camber force over Fz at nominal load (24)"}.unjudged());
        field(TREAD_FIELD(pTy9), About{"1/rad", "variation of the non-lagging camber force with load (24)"}.unjudged());
        field(TREAD_FIELD(mc), About{"kg", "contact-patch mass (17), (18)", kPositive}.usually(1e-4, 20));
        field(TREAD_FIELD(kFx), About{"N s/m", "longitudinal carcass damping (17)", kNonNegative}.usually(0, 1e4));
        field(TREAD_FIELD(kFy), About{"N s/m", "lateral carcass damping (18)", kNonNegative}.usually(0, 1e4));
        field(TREAD_FIELD(cFx), About{"N/m", "longitudinal carcass stiffness (17)", kPositive, 0.1}.usually(100, 1e7));
        field(TREAD_FIELD(cFy), About{"N/m", "lateral carcass stiffness (18)", kPositive, 0.1}.usually(100, 1e7));
        field(TREAD_FIELD(mt), About{"kg", "tyre mass (25)", kNonNegative}.usually(0, 100));
        field(TREAD_FIELD(czgyr), About{"-", "gyroscopic couple about the vertical (25)"}.unjudged());
        field(TREAD_FIELD(cygyr), About{"-", "gyroscopic lateral force (26)"}.unjudged());
        field(TREAD_FIELD(cpsigyr), About{"-", "belt yaw by the gyroscopic couple (27)"}.unjudged());
    }
};
using TyreCoefficients = BasicTyreCoefficients<double>;
static_assert(describesEveryMember<TyreCoefficients>());

// The paper's user scaling factors lambda; 1 leaves the tyre as it was measured.
template <class T>
struct BasicTyreScaling {
    T Fzo = 1;
    T Cx = 1;
    T mux = 1;
    T Ex = 1;
    T Kx = 1;
    T Hx = 1;
    T Vx = 1;
    T gy = 1;
    T Cy = 1;
    T muy = 1;
    T Ey = 1;
    T Ky = 1;
    T Hy = 1;
    T Vy = 1;
    T gz = 1;
    T t = 1;
    T Mr = 1;
    T xa = 1;
    T yk = 1;
    T Vyk = 1;
    T Cz = 1;
    T Kz = 1;
    T Mx = 1;
    T My = 1;
    T s = 1;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(Fzo), About{"-", "scales the nominal load (29)", kPositive}.usually(0.01, 10));
        field(TREAD_FIELD(Cx), About{"-", "scales the shape of Fx (38)", kPositive}.usually(0.01, 10));
        field(TREAD_FIELD(mux),
              About{"-", "scales the longitudinal friction (40)", kNonNegative, 0.03}.usually(0.01, 10));
        field(TREAD_FIELD(Ex), About{"-", "scales the curvature of Fx (41)", kAny, 0.2}.usually(-10, 10));
        field(TREAD_FIELD(Kx),
              About{"-", "scales the longitudinal slip stiffness (42)", kNonNegative, 0.08}.usually(0.01, 10));
        field(TREAD_FIELD(Hx), About{"-", "scales the horizontal shift of Fx (44)"}.usually(-10, 10));
        field(TREAD_FIELD(Vx), About{"-", "scales the vertical shift of Fx (45)"}.usually(-10, 10));
        field(TREAD_FIELD(gy), About{"-", "scales the camber in Fy (48)", kAny, 0.2}.usually(-10, 10));
        field(TREAD_FIELD(Cy), About{"-", "scales the shape of Fy (49)", kPositive}.usually(0.01, 10));
        field(TREAD_FIELD(muy), About{"-", "scales the lateral friction (51)", kNonNegative, 0.03}.usually(0.01, 10));
        field(TREAD_FIELD(Ey), About{"-", "scales the curvature of Fy (52)", kAny, 0.2}.usually(-10, 10));
        field(TREAD_FIELD(Ky), About{"-", "scales the cornering stiffness (53)", kNonNegative, 0.03}.usually(0.01, 10));
        field(TREAD_FIELD(Hy), About{"-", "scales the horizontal shift of Fy (55)"}.usually(-10, 10));
        field(TREAD_FIELD(Vy), About{"-", "scales the vertical shift of Fy (56)"}.usually(-10, 10));
        field(TREAD_FIELD(gz), About{"-", "scales the camber in Mz (63)"}.usually(-10, 10));
        field(TREAD_FIELD(t), About{"-", "scales the pneumatic trail (66)", kAny, 0.2}.usually(-10, 10));
        field(TREAD_FIELD(Mr), About{"-", "scales the residual torque (70)", kAny, 0.3}.usually(-10, 10));
        field(TREAD_FIELD(xa),
              About{"-", "scales the influence of lateral slip on Fx (72)", kAny, 0.1}.usually(-10, 10));
        field(TREAD_FIELD(yk),
              About{"-", "scales the influence of longitudinal slip on Fy (77)", kAny, 0.1}.usually(-10, 10));
        field(TREAD_FIELD(Vyk), About{"-", "scales the slip-induced ply-steer (81)"}.usually(-10, 10));
        field(TREAD_FIELD(Cz), About{"-", "scales the radial stiffness (83)", kNonNegative, 0.1}.usually(0.01, 10));
        field(TREAD_FIELD(Kz), About{"-", "scales the radial damping (83)", kNonNegative, 0.3}.usually(0.01, 10));
        field(TREAD_FIELD(Mx), About{"-", "scales the overturning couple (84)"}.usually(-10, 10));
        field(TREAD_FIELD(My), About{"-", "scales the rolling resistance (85)", kAny, 0.1}.usually(-10, 10));
        field(TREAD_FIELD(s), About{"-", "scales the moment arm of Fx (90)"}.usually(-10, 10));
    }
};
using TyreScaling = BasicTyreScaling<double>;
static_assert(describesEveryMember<TyreScaling>());

// The side of the car on which the coefficients were measured; on the other side the tyre is mounted as a mirror image.
enum class TyreSide { left, right };
constexpr auto enumNames(TyreSide) {
    return std::array<std::string_view, 2>{"left", "right"};
}

// A tyre file.
struct TyreParams {
    static constexpr bool kIncludable = true;  // a file may name another file in its place

    std::string name;
    TyreSide side = TyreSide::left;
    TyreCoefficients parameters;
    TyreScaling lambda;
    std::vector<std::string> notes;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(name), About{"", "name of the tyre"});
        field(TREAD_FIELD(side), About{"", "side of the car that the coefficients describe"});
        field(TREAD_FIELD(parameters), About{"", "coefficients of the model"});
        field(TREAD_FIELD(lambda), About{"", "scaling factors"});
        field(TREAD_FIELD(notes),
              About{"", "what was dropped, derived or guessed when the tyre was read from a .tir file"});
    }
};
static_assert(describesEveryMember<TyreParams>());

// Takes the file in place of the YAML reader when its name ends in .tir.
struct Problem;
TREAD_API bool readForeign(TyreParams& tyre, const std::filesystem::path& file, std::vector<Problem>& problems);

// ---- Steady state ----

// Motion of a wheel over the road. Vs = (Vsx, Vsy) is the slip velocity of the point that is attached to the rim the
// effective rolling radius below the wheel centre; the wheel rolls at Vr = Vx - Vsx = Re Omega.
struct TyreSlip {
    double Fz = 0;
    double gamma = 0;
    double Vx = 0;
    double Vsx = 0;
    double Vsy = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(Fz), About{"N", "normal load; negative counts as zero"});
        field(TREAD_FIELD(gamma), About{"rad", "camber"});
        field(TREAD_FIELD(Vx), About{"m/s", "forward speed of the contact centre"});
        field(TREAD_FIELD(Vsx), About{"m/s", "longitudinal slip velocity"});
        field(TREAD_FIELD(Vsy), About{"m/s", "lateral slip velocity"});
    }
};
static_assert(describesEveryMember<TyreSlip>());

struct TyreSteadyState {
    double Fx = 0;
    double Fy = 0;
    double Mx = 0;
    double My = 0;
    double Mz = 0;
    double Fx0 = 0;
    double Fy0 = 0;
    double t = 0;
    double Mzr = 0;
    double s = 0;
    double Kx = 0;
    double Ky = 0;
    double mux = 0;
    double muy = 0;
    double SVyk = 0;
    double kappa = 0;
    double alpha = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(Fx), About{"N", "longitudinal force (71)"});
        field(TREAD_FIELD(Fy), About{"N", "lateral force (76)"});
        field(TREAD_FIELD(Mx), About{"N m", "overturning couple (84)"});
        field(TREAD_FIELD(My), About{"N m", "rolling resistance torque (85)"});
        field(TREAD_FIELD(Mz), About{"N m", "aligning torque (86)"});
        field(TREAD_FIELD(Fx0), About{"N", "longitudinal force at pure slip (36)"});
        field(TREAD_FIELD(Fy0), About{"N", "lateral force at pure slip (46)"});
        field(TREAD_FIELD(t), About{"m", "pneumatic trail (87)"});
        field(TREAD_FIELD(Mzr), About{"N m", "residual torque (89)"});
        field(TREAD_FIELD(s), About{"m", "moment arm of the longitudinal force (90)"});
        field(TREAD_FIELD(Kx), About{"N", "longitudinal slip stiffness (42)"});
        field(TREAD_FIELD(Ky), About{"N", "cornering stiffness (53)"});
        field(TREAD_FIELD(mux), About{"-", "longitudinal friction (40)"});
        field(TREAD_FIELD(muy), About{"-", "lateral friction (51)"});
        field(TREAD_FIELD(SVyk), About{"N", "slip-induced ply-steer (81)"});
        field(TREAD_FIELD(kappa), About{"-", "longitudinal slip (32)"});
        field(TREAD_FIELD(alpha), About{"-", "lateral slip (33), tangent of the slip angle"});
    }
};
static_assert(describesEveryMember<TyreSteadyState>());

// Forces and moments at a given slip, equations (29)-(92). Finite for every finite input.
TREAD_API TyreSteadyState steadyState(const TyreParams& tyre, const TyreSlip& slip);

// ---- Transients ----

// What survives from step to step.
template <class T>
struct BasicTyreState {
    T u = 0;      // m, longitudinal deflection of the contact patch against the rim (17)
    T v = 0;      // m, lateral deflection (18)
    T du = 0;     // m/s
    T dv = 0;     // m/s
    T kappa = 0;  // slip of the contact patch; a state of its own only near standstill
    T alpha = 0;

    bool operator==(const BasicTyreState&) const = default;
};
using TyreState = BasicTyreState<double>;

// Motion of a wheel at one instant; as TyreSlip, with what the transient part needs besides. When the wheel spins
// freely (TyreSpin), Omega and Vsx are results and ignored on input.
template <class T>
struct BasicTyreMotion {
    T Vsx = 0;
    T Vsy = 0;
    T Vx = 0;
    T Omega = 0;
    T psidot = 0;
    T gamma = 0;
    T Fz = 0;

    bool operator==(const BasicTyreMotion&) const = default;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(Vsx), About{"m/s", "longitudinal slip velocity of the rim"});
        field(TREAD_FIELD(Vsy), About{"m/s", "lateral slip velocity of the rim"});
        field(TREAD_FIELD(Vx), About{"m/s", "forward speed of the contact centre"});
        field(TREAD_FIELD(Omega), About{"rad/s", "wheel spin, positive forward"});
        field(TREAD_FIELD(psidot), About{"rad/s", "yaw rate of the wheel"});
        field(TREAD_FIELD(gamma), About{"rad", "camber"});
        field(TREAD_FIELD(Fz), About{"N", "normal load"});
    }
};
using TyreMotion = BasicTyreMotion<double>;
static_assert(describesEveryMember<TyreMotion>());

// Forces and moments that the tyre exerts on the rim, at the contact centre.
template <class T>
struct BasicTyreForces {
    T Fx = 0;  // N (21)
    T Fy = 0;  // N (22)
    T Mx = 0;  // N m (84)
    T My = 0;  // N m (85)
    T Mz = 0;  // N m (23)
};
using TyreForces = BasicTyreForces<double>;

// Whether the contact patch follows the paper at every speed, or is helped near standstill. The paper's slip divides by
// max(|Vx|, 0.01 m/s): a held wheel creeps. The extension gives the contact patch the relaxation of Pacejka's later
// books below walking speed; above 2 m/s the paper's equations hold exactly.
enum class Standstill { paper, hold };

// The torques on a wheel that spins freely.
template <class T>
struct BasicTyreSpin {
    T inertia;       // kg m2, about the spin axis
    T radius;        // m, from the wheel centre to the road
    T drive_torque;  // N m, from the driveline, positive forward
    T brake_torque;  // N m, capacity of the brake, not negative: Coulomb friction against the spin
};
using TyreSpin = BasicTyreSpin<double>;

// Advances the contact patch by dt with the wheel's motion given at both ends of the step (give the same motion twice
// to hold it) and returns the forces at its end. Second order, L-stable (SDIRK2 with a damped Newton).
TREAD_API TyreForces advance(TyreState& state, const TyreParams& tyre, const TyreMotion& begin, const TyreMotion& end,
                             double dt, Standstill standstill);

// The same with the wheel's spin Omega as one more unknown, so that a braked wheel locks and a driven one spins.
TREAD_API TyreForces advance(TyreState& state, double& Omega, const TyreParams& tyre, const TyreMotion& begin,
                             const TyreMotion& end, const TyreSpin& spin, double dt, Standstill standstill);

// The forces of a known state under a given motion, equations (21)-(23), (84), (85): what `advance` returns when the
// motion is that at the end of its step; and what jumps with the motion while the state cannot.
TREAD_API TyreForces rimForces(const TyreState& state, const TyreParams& tyre, const TyreMotion& motion,
                               Standstill standstill);

// The same tyre mounted on the other side of the car.
TREAD_API TyreParams mirrored(const TyreParams& tyre);

// A car tyre in the size of any wheel: the shape of a measured 205/60R15, friction 1, its lengths in proportion to the
// radius and its forces to the load.
TREAD_API TyreParams similarTyre(double load, double radius);

}  // namespace tread
