// What a truck carries: planks and boxes that lie loose on its bed, and a box that is tied to it.
#include "port.h"

namespace {

using namespace port;

// A flat bed over the wheels, whose floor is the top of the chassis' box: 0.25 m above the wheels' struts.
CarNumbers truckNumbers() {
    CarNumbers n;
    n.mass = 5000;
    n.half = vector(1.2, 0.25, 3);
    n.axles = {{2, 1, true}, {-2, 1, false}};
    n.radius = n.rest = 0.45;
    n.stiffness = 30;
    n.damping = 5;
    n.most_force = 1e6;
    return n;
}

struct Load {
    World world;
    CarNumbers numbers = truckNumbers();
    Car truck{world.dynamics, numbers};
    std::vector<btRigidBody*> pieces;
    double mass = 0;
    double bed = 0;  // m, height of the floor

    Load() {
        world.addPlane();
        truck.brake(1000);
        world.run(2);
        bed = truck.height() + 0.25;
    }
    void put(const btVector3& half, double piece_mass, double x, double y, double z) {
        pieces.push_back(&world.addBox(half, piece_mass, vector(x, bed + y, z)));
        pieces.back()->setFriction(scalar(0.8));
        mass += piece_mass;
    }
    // Where the pieces are on the truck.
    std::vector<btVector3> places() const {
        std::vector<btVector3> all;
        for (const btRigidBody* piece : pieces)
            all.push_back(truck.chassis.getWorldTransform().inverse() * piece->getCenterOfMassPosition());
        return all;
    }
    // Steps on. Largest speed of a piece seen from the truck, m/s: of places, since a chassis' velocity holds what
    // gravity takes back in the next step.
    double run(double seconds) {
        double most = 0;
        for (int i = 0; i < static_cast<int>(60 * seconds); ++i) {
            const std::vector<btVector3> before = places();
            world.step(60);
            const std::vector<btVector3> after = places();
            for (std::size_t k = 0; k < after.size(); ++k)
                most = std::max(most, 60 * static_cast<double>((after[k] - before[k]).length()));
        }
        return most;
    }
    // m, that the truck sinks by for a weight: each spring carries its part.
    double sinking() const { return mass * kGravity / (4 * numbers.stiffness * numbers.mass); }
};

// Lies down, stands, drives off with 1 m/s2, turns a little, and stops with 1 m/s2: a quarter of what friction holds.
void carry(Report& report, Load& load, const char* const (&names)[6]) {
    const double before = load.truck.height();
    load.run(1);  // to lie down
    const double lying = load.run(4);
    report.near(names[0], load.truck.height(), 0.02 * load.numbers.rest);
    report.within(names[1], before - load.truck.height() - load.sinking(), -0.02 * load.numbers.rest,
                  0.02 * load.numbers.rest);
    // What lies on a truck that stands stays there: it hops by half a millimetre at most, sqrt(2 g 0.5 mm).
    report.within(names[2], lying, 0, 0.1);

    const std::vector<btVector3> placed = load.places();
    const double total = load.mass + load.numbers.mass;
    load.truck.brake(0);
    load.truck.push(total);
    double fastest = load.run(3);
    load.truck.push(0);
    load.truck.steer(0.03);
    fastest = std::max(fastest, load.run(2));
    load.truck.steer(0);
    load.truck.brake(total / 4 / 60);
    fastest = std::max(fastest, load.run(5));
    // Bullet's friction creeps under load, on stock too. Nothing is thrown: none is as fast as what falls by 5 cm.
    report.within(names[3], fastest, 0, 1);
    double slid = 0;
    const std::vector<btVector3> places = load.places();
    for (std::size_t i = 0; i < places.size(); ++i)
        slid = std::max(slid, static_cast<double>((places[i] - placed[i]).length()));
    report.within(names[4], slid, 0, 0.8);  // the outer planks' way to the end of the bed
    report.like(names[5], load.truck.place().length(), 0.1);
}

}  // namespace

int main(int arguments, char** argument) {
    Report report(arguments, argument);
    {
        // Three planks across the whole bed, over the wheels, and two boxes on them.
        Load loose;
        for (double z : {-1.9, 0.0, 1.9}) loose.put(vector(1.1, 0.03, 0.3), 40, 0, 0.04, z);
        loose.put(vector(0.5, 0.3, 0.3), 300, 0.5, 0.38, -1.9);
        loose.put(vector(0.5, 0.3, 0.3), 300, -0.5, 0.38, 1.9);
        carry(report, loose,
              {"loose_height_m", "loose_sinking_off_m", "loose_lying_m_s", "loose_fastest_m_s", "loose_slid_m",
               "loose_way_m"});
    }
    {
        // A box of a ton, tied over the rear axle.
        Load tied;
        tied.put(vector(1.1, 0.5, 0.8), 1000, 0, 0.5, -2);
        btTransform on_truck = btTransform::getIdentity(), in_box = btTransform::getIdentity();
        on_truck.setOrigin(vector(0, 0.25, -2));
        in_box.setOrigin(vector(0, -0.5, 0));
        btFixedConstraint ropes(tied.truck.chassis, *tied.pieces[0], on_truck, in_box);
        tied.world.dynamics.addConstraint(&ropes, true);
        // The rear sinks by twice as much as the centre does, the front by nothing.
        carry(
            report, tied,
            {"tied_height_m", "tied_sinking_off_m", "tied_lying_m_s", "tied_fastest_m_s", "tied_slid_m", "tied_way_m"});
        tied.world.dynamics.removeConstraint(&ropes);
    }
    return report.status();
}
