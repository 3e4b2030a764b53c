// A car tyre in any size, for vehicles of which only wheel radius and load are known.
//
// Shape factors: 205/60R15 91V of H.B. Pacejka, "Tyre and Vehicle Dynamics", 2006, Table A3.1 (as in
// vehicles/tyres/car_205_60R15.yaml, where each figure names its source), less all that tells left from right, with
// peak friction 1 in both directions, and with a Cx of 1.45 that lets a locked wheel keep 0.8 of it, as on a dry road
// ([guess]; the table's 1.685 leaves half). Stiffnesses and masses are those of that tyre over Fzo and Ro.
#include "tread/tyre.h"

namespace tread {

TyreParams similarTyre(double load, double radius) {
    TyreParams tyre;
    tyre.name = "similar to 205/60R15";
    TyreCoefficients& p = tyre.parameters;
    p.Fzo = load;
    p.Ro = radius;
    p.Re = 0.976 * radius;
    p.pCx1 = 1.45;
    p.pDx1 = 1;
    p.pDx2 = -0.037;
    p.pEx1 = 0.344;
    p.pEx2 = 0.095;
    p.pEx3 = -0.020;
    p.pKx1 = 21.51;
    p.pKx2 = -0.163;
    p.pKx3 = -0.245;
    p.rBx1 = 12.35;
    p.rBx2 = -10.77;
    p.rCx1 = 1.092;
    p.pCy1 = 1.193;
    p.pDy1 = 1;
    p.pDy2 = -0.145;
    p.pEy1 = -1.003;
    p.pEy2 = -0.537;
    p.pKy1 = 14.95;
    p.pKy2 = 2.130;
    p.rBy1 = 6.461;
    p.rBy2 = 4.196;
    p.rCy1 = 1.081;
    p.qBz1 = 8.964;
    p.qBz2 = -1.106;
    p.qBz3 = -0.842;
    p.qBz9 = 18.47;
    p.qCz1 = 1.180;
    p.qDz1 = 0.100;
    p.qDz2 = -0.001;
    p.qEz1 = -1.609;
    p.qEz2 = -0.359;
    p.qy1 = 0.01 * radius;
    constexpr double kReferenceLoad = 4000;     // N
    constexpr double kReferenceRadius = 0.313;  // m
    const double force = load / kReferenceLoad;
    const double per_length = force * kReferenceRadius / radius;
    p.pz1 = 183600 * per_length;
    p.pz2 = 50 * per_length;
    p.mc = 1.0 * force;
    p.cFx = 474500 * per_length;
    p.cFy = 141800 * per_length;
    p.kFx = 280 * force;
    p.kFy = 150 * force;
    return tyre;
}

}  // namespace tread
