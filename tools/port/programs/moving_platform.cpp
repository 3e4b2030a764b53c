// A lift and a ferry: kinematic bodies that the game moves, with a braked car on them.
#include "port.h"

namespace {

using namespace port;

// Smooth from 0 to 1 over `time`.
double smooth(double t, double time) {
    const double x = std::clamp(t / time, 0.0, 1.0);
    return x * x * (3 - 2 * x);
}

struct Ride {
    World world;
    btRigidBody& deck = world.addBox(vector(4, 0.25, 6), 0, vector(0, -0.25, 0));
    CarNumbers numbers;
    Car car{world.dynamics, numbers};
    double time = 0;

    Ride() {
        deck.setCollisionFlags(deck.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
        deck.setActivationState(DISABLE_DEACTIVATION);
        car.brake(100);
        world.run(2);
    }
    // Moves the deck to `to` within `seconds`; `seen()` after each step.
    template <class Seen>
    void move(const btVector3& to, double seconds, const Seen& seen) {
        const btVector3 from = deck.getWorldTransform().getOrigin();
        for (int i = 1; i <= static_cast<int>(60 * seconds); ++i) {
            deck.getWorldTransform().setOrigin(from + scalar(smooth(i / 60.0, seconds)) * (to - from));
            world.step(60);
            seen();
        }
    }
    double heightOnDeck() const {
        return car.height() - static_cast<double>(deck.getWorldTransform().getOrigin().y()) - 0.25;
    }
};

}  // namespace

int main(int arguments, char** argument) {
    Report report(arguments, argument);
    {
        // Up by 4 m in 4 s: most 1.5 m/s2 and 1.5 m/s. Weight is up to 15 % more or less, of 61 mm of spring; the deck
        // is a frame ahead of what the vehicle has seen of it, 25 mm at most.
        Ride lift;
        const double before = lift.heightOnDeck();
        report.near("lift_height_m", before, 0.02 * lift.numbers.rest);
        Range on_deck{before, before};
        lift.move(vector(0, 3.75, 0), 4, [&] {
            on_deck = {std::min(on_deck.lowest, lift.heightOnDeck()), std::max(on_deck.highest, lift.heightOnDeck())};
        });
        report.within("lift_lowest_m", on_deck.lowest - before, -0.036, 0);
        report.within("lift_highest_m", on_deck.highest - before, 0, 0.036);
        lift.world.run(2);
        report.within("lift_after_m", lift.heightOnDeck() - before, -0.02 * lift.numbers.rest,
                      0.02 * lift.numbers.rest);
        report.within("lift_aside_m", std::hypot(lift.car.place().x(), lift.car.place().z()), 0, 0.005);
    }
    // Over 10 m in 8 s, along and across the car: 0.94 m/s2, which tyres hold by a tenth of their grip. Stock takes no
    // part in it: its friction takes every ground for standing. Tread goes along, but for what tyres and springs give.
    for (const bool across : {false, true}) {
        Ride ferry;
        const btVector3 way = across ? vector(10, 0, 0) : vector(0, 0, 10), from = ferry.car.place();
        Range behind{0, 0};
        ferry.move(ferry.deck.getWorldTransform().getOrigin() + way, 8, [&] {
            const double off = static_cast<double>(
                (ferry.car.place() - from - ferry.deck.getWorldTransform().getOrigin()).dot(way.normalized()));
            behind = {std::min(behind.lowest, off), std::max(behind.highest, off)};
        });
        ferry.world.run(2);
        // A frame of 1.9 m/s, and a few mm of rubber; the centre of gravity sways over the springs.
        report.within(across ? "ferry_across_behind_m" : "ferry_behind_m", behind.width(), 0, 0.06);
        report.within(across ? "ferry_across_way_m" : "ferry_way_m",
                      static_cast<double>((ferry.car.place() - from).dot(way.normalized())), 9.95, 10.05);
        report.within(across ? "ferry_across_upright" : "ferry_upright", ferry.car.upright(), 0.999, 1);
    }
    return report.status();
}
