// Trucks on six and on eight wheels.
#include "port.h"

namespace {

using namespace port;

// `wheelbase`: from the middle of the steered axles to that of the others, m.
void drive(Report& report, const char* const (&names)[6], const CarNumbers& n, double wheelbase) {
    World world;
    world.addPlane();
    Car truck(world.dynamics, n);
    world.run(3);
    report.near(names[0], truck.height(), 0.02 * n.rest);

    // 1.5 m/s2 for 4 s. As in z_up.cpp, what rolls and spins takes up to 8 %, here 10 % since less is given.
    truck.push(1.5 * n.mass);
    world.run(4);
    report.like(names[1], truck.speed(), 0.1);

    // 3 m/s2 of setBrake: 60 N for each unit at each wheel, at the radius of addWheel. At the ground it is more by what
    // the tyre gives way, up to 8 % of its radius, and by 0.1 m/s2 of rolling; wheels that stop too take 3 % of it.
    truck.push(0);
    truck.chassis.setLinearVelocity(vector(0, 0, 15));
    world.run(1);
    truck.brake(3 * n.mass / truck.vehicle.getNumWheels() / 60);
    const double from = truck.place().z(), speed = truck.speed();
    world.run(8);
    report.within(names[2], (static_cast<double>(truck.place().z()) - from) / (speed * speed / 6), 0.9, 1.03);
    report.within(names[3], truck.speed(), -0.01, 0.01);

    // A slow turn, 5 degrees: axles that cannot turn are dragged aside and take some of it.
    truck.brake(0);
    truck.steer(5 * std::acos(-1.0) / 180);
    truck.chassis.setLinearVelocity(5 * truck.vehicle.getForwardVector());
    world.run(3);
    report.within(names[4], truck.yawRate() / (truck.speed() * 5 * std::acos(-1.0) / 180 / wheelbase), 0.7, 1.05);
    report.within(names[5], truck.upright(), 0.999, 1);
}

}  // namespace

int main(int arguments, char** argument) {
    Report report(arguments, argument);
    CarNumbers six;
    six.mass = 12000;
    six.half = vector(1.2, 0.5, 3.5);
    six.axles = {{2.6, 1, true}, {-1.2, 1, false}, {-2.5, 1, false}};
    six.radius = six.rest = 0.5;
    six.stiffness = 20;
    six.most_force = 1e6;
    drive(report,
          {"six_height_m", "six_speed_m_s", "six_stopping_over_v2_2a", "six_stopped_m_s", "six_turn_over_kinematic",
           "six_upright"},
          six, 2.6 + 1.85);

    CarNumbers eight = six;
    eight.mass = 24000;
    eight.axles = {{2.9, 1, true}, {1.4, 1, true}, {-1.4, 1, false}, {-2.9, 1, false}};
    drive(report,
          {"eight_height_m", "eight_speed_m_s", "eight_stopping_over_v2_2a", "eight_stopped_m_s",
           "eight_turn_over_kinematic", "eight_upright"},
          eight, 2.15 + 2.15);
    return report.status();
}
