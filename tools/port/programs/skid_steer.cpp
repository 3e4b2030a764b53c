// A robot of 20 kg that turns on the spot: left and right wheels push against each other, with 1 to 100 N for each kg.
#include "port.h"

namespace {

using namespace port;

CarNumbers robotNumbers() {
    CarNumbers n;
    n.mass = 20;
    n.half = vector(0.2, 0.08, 0.25);
    n.axles = {{0.15, 0.25, false}, {-0.15, 0.25, false}};
    n.radius = n.rest = 0.1;
    n.stiffness = 100;
    n.damping = 8;
    return n;
}

struct Figures {
    double yaw_rate;  // rad/s, at the end
    double least;     // rad/s, over the second half of the time
    double drift;     // m, of the centre
    double upright;   // least
};

// `force` in N for each kg of the robot: the sum of what its wheels push.
Figures turn(double friction, double force, double seconds) {
    World world;
    world.addPlane();
    CarNumbers n = robotNumbers();
    n.slip = friction;
    Car robot(world.dynamics, n);
    world.run(1);
    for (int i = 0; i < 4; ++i) robot.vehicle.applyEngineForce(scalar((i % 2 == 0 ? -1 : 1) * force * n.mass / 4), i);
    const double upright = watch(world, 0.5 * seconds, 60, [&] { return robot.upright(); }).lowest;
    const double least = watch(world, 0.5 * seconds, 60, [&] { return robot.yawRate(); }).lowest;
    const btVector3 place = robot.place();
    return {robot.yawRate(), least, std::hypot(place.x(), place.z()), upright};
}

// Yaw rate, rad/s, of a robot whose wheels slide by Coulomb's law from the start. Along the wheel goes what the motor
// gives, across it what is left of friction; more than all of it the motor cannot bring to the ground.
double coulomb(double friction, double force, double seconds) {
    const CarNumbers n = robotNumbers();
    const double most = friction * kGravity, along = std::min(force, most);
    const double across = std::sqrt(most * most - along * along);
    const double gyration_squared = (n.half.x() * n.half.x() + n.half.z() * n.half.z()) / 3;
    const double moment = along * n.axles[0].left - across * n.axles[0].forward;
    return std::max(moment, 0.0) / gyration_squared * seconds;
}

// Motors whose force falls to nothing at a speed, as real ones' does: of the ground under the wheel, or of the rim as
// the wheel info shows it. Range of the yaw rate, rad/s, over the third second.
constexpr double kNoLoad = 2;  // m/s
Range turnWithMotors(double friction, double force, bool by_rim) {
    World world;
    world.addPlane();
    CarNumbers n = robotNumbers();
    n.slip = friction;
    Car robot(world.dynamics, n);
    world.run(1);
    const auto seen = [&] {
        for (int i = 0; i < 4; ++i) {
            const double side = i % 2 == 0 ? -1 : 1;
            const double rim =
                side * static_cast<double>(robot.vehicle.getWheelInfo(i).m_deltaRotation) * 60 * n.radius;
            const double speed = by_rim ? rim : robot.yawRate() * n.axles[0].left;
            robot.vehicle.applyEngineForce(scalar(side * force * n.mass / 4 * (1 - speed / kNoLoad)), i);
        }
        return robot.yawRate();
    };
    watch(world, 2, 60, seen);
    return watch(world, 1, 60, seen);
}

}  // namespace

int main(int arguments, char** argument) {
    Report report(arguments, argument);
    {
        World world;
        world.addPlane();
        Car robot(world.dynamics, robotNumbers());
        world.run(2);
        report.near("height_m", robot.height(), 0.02 * robotNumbers().rest);
    }

    // Hard wheels on a smooth floor. 1 N/kg does not overcome what drags the wheels aside (stock gives way to any
    // force, as if it were oil); 2 N/kg does. Beyond what the floor holds, 2.45 N/kg, more force only spins the wheels.
    const double seconds = 2;
    const Figures one = turn(0.25, 1, seconds), two = turn(0.25, 2, seconds);
    report.within("smooth_1_rad_s", one.yaw_rate, -0.05, 0.05);
    // Rubber that slides holds between half of its peak and all of it. Dragged by half, it turns 1.4 times as fast.
    report.within("smooth_2_over_coulomb", two.yaw_rate / coulomb(0.25, 2, seconds), 0.5, 1.4);
    const char* const smooth[] = {"smooth_5_over_2", "smooth_10_over_2", "smooth_20_over_2", "smooth_50_over_2",
                                  "smooth_100_over_2"};
    const double forces[] = {5, 10, 20, 50, 100};
    double drift = 0, upright = 1, steady = 1;
    for (int i = 0; i < 5; ++i) {
        const Figures f = turn(0.25, forces[i], seconds);
        // Coulomb's law gives 2.1.
        report.within(smooth[i], f.yaw_rate / two.yaw_rate, 1, 3);
        drift = std::max(drift, f.drift);
        upright = std::min(upright, f.upright);
        steady = std::min(steady, f.least / f.yaw_rate);
    }
    // It turns about its middle and upright, and ever faster: in the second half from half the rate on.
    report.within("smooth_drift_m", drift, 0, 0.03);
    report.within("smooth_upright", upright, 0.999, 1);
    report.within("smooth_steady", steady, 0.4, 1);

    // Rubber on concrete: no turn below 4 N/kg; from 8 N/kg on wheels spin, and half a second makes 25 rad/s.
    const char* const rough[] = {"rough_10_over_coulomb", "rough_20_over_coulomb", "rough_50_over_coulomb",
                                 "rough_100_over_coulomb"};
    report.within("rough_2_rad_s", turn(0.8, 2, seconds).yaw_rate, -0.05, 0.05);
    drift = 0, upright = 1, steady = 1;
    for (int i = 0; i < 4; ++i) {
        const Figures f = turn(0.8, forces[i + 1], 0.5);
        // As above: half of the peak and more.
        report.within(rough[i], f.yaw_rate / coulomb(0.8, forces[i + 1], 0.5), 0.5, 1.1);
        drift = std::max(drift, f.drift);
        upright = std::min(upright, f.upright);
        steady = std::min(steady, f.least / f.yaw_rate);
    }
    report.within("rough_drift_m", drift, 0, 0.03);
    report.within("rough_upright", upright, 0.999, 1);
    report.within("rough_steady", steady, 0.4, 1);

    // With motors it turns steadily. They give what drags the wheels aside, 4 N/kg by Coulomb's law, and the speed of
    // the ground under the wheels follows: the more, the less sliding rubber holds, down to half of its peak.
    const CarNumbers n = robotNumbers();
    const double arm = n.axles[0].left;
    const double drag = 0.8 * kGravity * n.axles[0].forward / std::hypot(arm, n.axles[0].forward);
    const Range ten = turnWithMotors(0.8, 10, false), twenty = turnWithMotors(0.8, 20, false);
    report.within("motor_10_over_coulomb", ten.highest / (kNoLoad * (1 - drag / 10) / arm), 0.95, 1.35);
    report.within("motor_20_over_coulomb", twenty.highest / (kNoLoad * (1 - drag / 20) / arm), 0.95, 1.35);
    report.within("motor_10_steady", ten.lowest / ten.highest, 0.98, 1);
    report.within("motor_20_steady", twenty.lowest / twenty.highest, 0.98, 1);
    // A motor that looks at its rim turns nothing faster than it turns without load.
    const Range rim_ten = turnWithMotors(0.8, 10, true), rim_twenty = turnWithMotors(0.8, 20, true);
    report.within("rim_motor_10_rad_s", rim_ten.highest, 0.2 * kNoLoad / arm, kNoLoad / arm);
    report.within("rim_motor_20_rad_s", rim_twenty.highest, 0.2 * kNoLoad / arm, kNoLoad / arm);
    return report.status();
}
