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

    // It turns about as fast as stock, within a factor of 2.2 either way; and never faster than Coulomb's law lets it,
    // since friction can give no more.
    const auto turns = [&](const char* name, double yaw_rate, double by_coulomb) {
        const double stock = report.ofStock(name, yaw_rate);
        report.within(name, yaw_rate, std::min(stock, by_coulomb) / 2.2, std::min(2.2 * stock, 1.1 * by_coulomb));
    };
    const double forces[] = {5, 10, 20, 50, 100};
    double drift = 0, upright = 1, steady = 1;
    const auto gather = [&](const Figures& f) {
        drift = std::max(drift, f.drift);
        upright = std::min(upright, f.upright);
        steady = std::min(steady, f.least / f.yaw_rate);
    };

    // Hard wheels on a smooth floor. 1 N/kg does not overcome what drags the wheels aside (stock gives way to any
    // force, as if it were oil). From what the floor holds on, 2.45 N/kg, the wheels spin: as fast as motors let them.
    const double seconds = 2;
    report.within("smooth_1_rad_s", turn(0.25, 1, seconds).yaw_rate, -0.05, 0.05);
    const char* const smooth[] = {"smooth_5_rad_s", "smooth_10_rad_s", "smooth_20_rad_s", "smooth_50_rad_s",
                                  "smooth_100_rad_s"};
    for (int i = 0; i < 5; ++i) {
        const Figures f = turn(0.25, forces[i], seconds);
        turns(smooth[i], f.yaw_rate, coulomb(0.25, forces[i], seconds));
        gather(f);
    }

    // Rubber on concrete: no turn below 4 N/kg; from 8 N/kg on wheels spin.
    const char* const rough[] = {"rough_10_rad_s", "rough_20_rad_s", "rough_50_rad_s", "rough_100_rad_s"};
    report.within("rough_2_rad_s", turn(0.8, 2, seconds).yaw_rate, -0.05, 0.05);
    for (int i = 1; i < 5; ++i) {
        const Figures f = turn(0.8, forces[i], 0.5);
        turns(rough[i - 1], f.yaw_rate, coulomb(0.8, forces[i], 0.5));
        gather(f);
    }
    // It turns about its middle, upright, and without a break: in the second half of the time it is never slower than
    // a robot that turns ever faster is at its beginning.
    report.within("drift_m", drift, 0, 0.03);
    report.within("upright", upright, 0.999, 1);
    report.within("steady", steady, 0.4, 1);

    // With motors it turns steadily. They give what drags the wheels aside, 4 N/kg by Coulomb's law, and the speed of
    // the ground under the wheels follows: the more, the less sliding rubber holds, down to half of its peak.
    const CarNumbers n = robotNumbers();
    const double arm = n.axles[0].left;
    const double drag = 0.8 * kGravity * n.axles[0].forward / std::hypot(arm, n.axles[0].forward);
    const auto motors = [&](const char* name, const char* name_steady, double force) {
        const Range range = turnWithMotors(0.8, force, false);
        report.within(name, range.highest, 0.5 * report.ofStock(name, range.highest),
                      kNoLoad * (1 - 0.5 * drag / force) / arm);
        report.within(name_steady, range.lowest / range.highest, 0.98, 1);
    };
    motors("motor_10_rad_s", "motor_10_steady", 10);
    motors("motor_20_rad_s", "motor_20_steady", 20);
    // A motor that looks at its rim turns nothing faster than it turns without load.
    const Range rim_ten = turnWithMotors(0.8, 10, true), rim_twenty = turnWithMotors(0.8, 20, true);
    report.within("rim_motor_10_rad_s", rim_ten.highest, 0.2 * kNoLoad / arm, kNoLoad / arm);
    report.within("rim_motor_20_rad_s", rim_twenty.highest, 0.2 * kNoLoad / arm, kNoLoad / arm);
    return report.status();
}
