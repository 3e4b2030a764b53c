// What acts on a tyre besides load, slip and road: its inflation pressure, its temperature, and the small asymmetries
// that its making leaves: ply-steer and conicity.
//
// Sources: I.J.M. Besselink, A.J.C. Schmeitz, H.B. Pacejka, "An improved Magic Formula/Swift tyre model that can handle
// inflation pressure changes", Vehicle System Dynamics 48:S1 (2010) 337-352, for how stiffnesses follow the pressure;
// H.B. Pacejka, "Tire and Vehicle Dynamics", for ply-steer as an equivalent slip angle and conicity as an equivalent
// camber angle. The temperature is one lumped number, its influence a polynomial about where the tyre was measured.
#pragma once

#include "tread/api.h"
#include "tread/describe.h"
#include "tread/tyre.h"

namespace tread {

// With p = (inflation - nominal) / nominal: radial stiffness (1 + radial_stiffness p); slip stiffness
// (1 + slip_stiffness p); largest cornering stiffness (1 + cornering_stiffness p), reached at a load of
// (1 + cornering_peak_load p) times the tyre file's. The defaults are guesses of the order of Besselink et al. (2010).
struct TyrePressureParams {
    double inflation = 220000;
    double nominal = 220000;
    double radial_stiffness = 0.7;
    double slip_stiffness = -0.3;
    double cornering_stiffness = 0.3;
    double cornering_peak_load = 0.5;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(inflation), About{"Pa", "inflation pressure", kPositive, 0.05}.usually(2e4, 1.2e6));
        field(TREAD_FIELD(nominal),
              About{"Pa", "pressure at which the tyre was measured", kPositive}.usually(2e4, 1.2e6));
        field(TREAD_FIELD(radial_stiffness),
              About{"-", "relative change of the radial stiffness over that of the pressure", {-1, 1}});
        field(TREAD_FIELD(slip_stiffness),
              About{"-", "relative change of the longitudinal slip stiffness over that of the pressure", {-1, 1}});
        field(TREAD_FIELD(cornering_stiffness),
              About{"-", "relative change of the largest cornering stiffness over that of the pressure", {-1, 1}});
        field(TREAD_FIELD(cornering_peak_load),
              About{"-",
                    "relative change of the load at the largest cornering stiffness over that of the pressure",
                    {-1, 1}});
    }

    static void check(const auto& self, auto&& complain) {
        if (self.inflation >= 2 * self.nominal) {
            complain("inflation",
                     "found a pressure of twice the nominal one or more, expected less: the influence of the pressure "
                     "is linear about the nominal one");
        }
    }
};
static_assert(describesEveryMember<TyrePressureParams>());

// heat_capacity dT/dt = slip_share (slip power) - (cooling + cooling_by_speed |V|) (T - air); friction and slip
// stiffnesses are multiplied by polynomials in T - nominal. The default capacity is that of 4 kg of rubber, a guess.
template <class T>
struct BasicTyreTemperatureParams {
    T nominal = 293.15;
    T start = 293.15;
    T air = 293.15;
    T heat_capacity = 8000;
    T slip_share = 1;
    T cooling = 5;
    T cooling_by_speed = 1;
    T friction = 0;
    T friction_squared = 0;
    T stiffness = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(nominal),
              About{"K", "temperature at which the tyre was measured", kPositive}.usually(230, 420));
        field(TREAD_FIELD(start), About{"K", "temperature at the start", kPositive}.usually(230, 420));
        field(TREAD_FIELD(air), About{"K", "temperature of the air", kPositive}.usually(230, 340));
        field(TREAD_FIELD(heat_capacity),
              About{"J/K", "heat capacity of the tread; 0: the tyre keeps its temperature", kNonNegative, 0.3}.usually(
                  1, 1e6));
        field(TREAD_FIELD(slip_share), About{"-", "share of the slip power that heats the tyre", kFraction, 0.3});
        field(TREAD_FIELD(cooling),
              About{"W/K", "heat given to the air and the road at rest", kNonNegative, 0.3}.usually(0, 500));
        field(TREAD_FIELD(cooling_by_speed),
              About{"W s/(K m)", "increase of the cooling with speed", kNonNegative, 0.3}.usually(0, 100));
        field(TREAD_FIELD(friction),
              About{"1/K", "relative change of the friction over temperature"}.usually(-0.05, 0.05));
        field(TREAD_FIELD(friction_squared),
              About{"1/K2", "relative change of the friction over temperature squared; negative: a best temperature"}
                  .usually(-0.005, 0.005));
        field(TREAD_FIELD(stiffness),
              About{"1/K", "relative change of the slip stiffnesses over temperature"}.usually(-0.05, 0.05));
    }
};
using TyreTemperatureParams = BasicTyreTemperatureParams<double>;
static_assert(describesEveryMember<TyreTemperatureParams>());

struct TyreSurroundingsParams {
    TyrePressureParams pressure{};
    TyreTemperatureParams temperature{};
    double ply_steer = 0;
    double conicity = 0;
    double grip_difference = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(pressure), About{"", "inflation pressure"});
        field(TREAD_FIELD(temperature), About{"", "temperature"});
        field(TREAD_FIELD(ply_steer), About{"rad",
                                            "slip angle to which ply-steer is equal: positive pulls to the left, on "
                                            "whichever side the tyre is mounted",
                                            {-0.1, 0.1}});
        field(TREAD_FIELD(conicity), About{"rad",
                                           "camber to which conicity is equal: positive as if the top leant outwards; "
                                           "its pull changes sides with the tyre",
                                           {-0.1, 0.1}});
        field(TREAD_FIELD(grip_difference),
              About{"-", "friction of a left tyre minus that of a right one, over their mean", {-1, 1}});
    }
};
static_assert(describesEveryMember<TyreSurroundingsParams>());

// The tyre as it is at its inflation pressure.
TREAD_API TyreParams inflated(TyreParams tyre, const TyrePressureParams& pressure);

// Whether the temperature can be another than the nominal one.
TREAD_API bool warms(const TyreTemperatureParams& params);
// Whether that changes the tyre's forces.
TREAD_API bool feelsWarmth(const TyreTemperatureParams& params);

// `warming` is the temperature less that at the start, K; `slip_power` in W, `speed` in m/s. Returns it after dt.
TREAD_API double advanceWarming(double warming, const TyreTemperatureParams& params, double slip_power, double speed,
                                double dt);

// What the temperature makes of the tyre: factors on its friction and on its slip stiffnesses.
struct TyreWarmth {
    double friction;
    double stiffness;
};
TREAD_API TyreWarmth warmth(const TyreTemperatureParams& params, double warming);

// Ply-steer and conicity as shifts of the motion under which the tyre's formulas are asked, paper axes.
struct TyreShift {
    double slip = 0;    // -, lateral slip velocity over forward speed
    double camber = 0;  // rad

    bool none() const { return slip == 0 && camber == 0; }
};
TREAD_API TyreShift shiftOf(const TyreSurroundingsParams& params, bool left);

inline TyreMotion shifted(TyreMotion motion, const TyreShift& shift) {
    motion.Vsy += shift.slip * motion.Vx;
    motion.gamma += shift.camber;
    return motion;
}

}  // namespace tread
