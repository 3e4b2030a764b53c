// A model car of 1.5 kg on wheels of 33 mm, at 60 and at 240 pictures a second.
#include "port.h"

namespace {

using namespace port;

struct Figures {
    double height, bounce, landed, speed, turn, stopping;
};

Figures drive(const CarNumbers& n, double rate) {
    World world;
    world.addPlane();
    Car car(world.dynamics, n);
    world.run(2, rate);
    Figures f{};
    f.height = car.height();
    f.bounce = watch(world, 1, rate, [&] { return car.height(); }).width();

    // Put down from 30 mm above: what it lands with is gone after a second.
    car.chassis.translate(vector(0, 0.03, 0));
    world.run(1, rate);
    f.landed = watch(world, 1, rate, [&] { return car.height(); }).width();

    car.push(2 * n.mass);
    world.run(2, rate);
    f.speed = car.speed();

    // A slow turn at 1.5 m/s.
    car.push(0);
    car.chassis.setLinearVelocity(vector(0, 0, 1.5));
    car.steer(0.1);
    world.run(1, rate);
    f.turn = car.yawRate() / (car.speed() * 0.1 / 0.26);

    // 4 m/s2 from 4 m/s.
    car.steer(0);
    world.run(0.5, rate);
    car.chassis.setLinearVelocity(4 * car.vehicle.getForwardVector());
    car.chassis.setAngularVelocity(vector(0, 0, 0));
    world.run(0.3, rate);
    const btVector3 from = car.place();
    const double speed = car.speed();
    car.brake(4 * n.mass / 4 / 60);
    world.run(3, rate);
    f.stopping = static_cast<double>((car.place() - from).length()) / (speed * speed / 8);
    return f;
}

}  // namespace

int main(int arguments, char** argument) {
    Report report(arguments, argument);
    CarNumbers n;
    n.mass = 1.5;
    n.half = vector(0.1, 0.025, 0.2);
    n.axles = {{0.13, 0.08, true}, {-0.13, 0.08, false}};
    n.radius = 0.033;
    n.rest = 0.04;
    n.stiffness = 200;  // sinks by 12 mm
    n.damping = 8.5;    // 0.3 of critical
    const Figures slow = drive(n, 60), fast = drive(n, 240);
    // The same on hard springs, which its weight compresses by 2.5 mm.
    CarNumbers hard = n;
    hard.stiffness = 1000;
    hard.damping = 19;
    const Figures hard_slow = drive(hard, 60), hard_fast = drive(hard, 240);

    report.near("height_60_m", slow.height, 0.02 * n.rest);
    report.near("height_240_m", fast.height, 0.02 * n.rest);
    report.near("hard_height_60_m", hard_slow.height, 0.02 * n.rest);
    report.near("hard_height_240_m", hard_fast.height, 0.02 * n.rest);
    // At rest nothing moves: 0.1 mm is a hundredth of what its weight compresses the springs by.
    report.within("bounce_60_m", slow.bounce, 0, 0.0001);
    report.within("bounce_240_m", fast.bounce, 0, 0.0001);
    report.within("hard_bounce_60_m", hard_slow.bounce, 0, 0.0001);
    report.within("hard_bounce_240_m", hard_fast.bounce, 0, 0.0001);
    report.within("landed_60_m", slow.landed, 0, 0.0001);
    report.within("landed_240_m", fast.landed, 0, 0.0001);
    report.within("hard_landed_60_m", hard_slow.landed, 0, 0.0001);
    report.within("hard_landed_240_m", hard_fast.landed, 0, 0.0001);
    // As in z_up.cpp: what rolls and spins takes up to 8 % of 2 m/s2.
    report.like("speed_60_m_s", slow.speed, 0.08);
    report.like("speed_240_m_s", fast.speed, 0.08);
    report.within("speed_60_over_240", slow.speed / fast.speed, 0.98, 1.02);
    // At 0.9 m/s2 aside the tyres slip by about a degree of six.
    report.within("turn_60_over_kinematic", slow.turn, 0.8, 1.05);
    report.within("turn_240_over_kinematic", fast.turn, 0.8, 1.05);
    // As in trucks.cpp. The unit of setBrake is 60 N at every rate; a frame at 60 Hz is 3 % of the way.
    report.within("stopping_60_over_v2_2a", slow.stopping, 0.9, 1.06);
    report.within("stopping_240_over_v2_2a", fast.stopping, 0.9, 1.04);
    return report.status();
}
