// Whatever a player does, on whatever ground and at whatever rate: nothing breaks, and nothing is gained for nothing.

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>

#include "bullet/random_drive.h"

namespace tread::raycast_random_test {
namespace {

using namespace scene;
using random_drive::Ground;

TEST(RaycastVehicleRandom, DrivesStayFiniteAboveTheGroundAndWithinTheGrip) {
    unsigned seed = 0;
    for (Ground ground : {Ground::plane, Ground::box, Ground::height_field, Ground::mesh}) {
        random_drive::Worst worst;
        for (double rate : {20.0, 60.0, 240.0, 1000.0}) {
            for (int i = 0; i < 2; ++i) worst.add(random_drive::drive(++seed, ground, rate, 8));
        }
        const int name = static_cast<int>(ground);
        EXPECT_TRUE(worst.finite) << "ground " << name;
        EXPECT_GT(worst.lowest_centre, 0) << "ground " << name;
        EXPECT_LT(worst.fastest, 100) << "ground " << name;
        EXPECT_GT(worst.wheel_steps, 80000);
        EXPECT_LE(worst.beyond_grip, 0.001 * static_cast<double>(worst.wheel_steps)) << "ground " << name;
    }
}

// The same for a minute each, on grounds and rates in turn: TREAD_RANDOM_SEEDS drives (24 unless set). Prints the
// worst.
TEST(RaycastVehicleRandomLong, MinutesStayFiniteAboveTheGroundAndWithinTheGrip) {
    const char* asked = std::getenv("TREAD_RANDOM_SEEDS");
    const unsigned seeds = asked ? static_cast<unsigned>(std::strtoul(asked, nullptr, 10)) : 24;
    constexpr std::array kRates{20.0, 30.0, 60.0, 120.0, 240.0, 1000.0};
    random_drive::Worst worst;
    for (unsigned seed = 0; seed < seeds; ++seed) {
        const double rate = kRates[seed / 4 % kRates.size()];
        const random_drive::Worst one = random_drive::drive(1000 + seed, static_cast<Ground>(seed % 4), rate, 60);
        worst.add(one);
        EXPECT_TRUE(one.finite) << "seed " << seed;
        EXPECT_GT(one.lowest_centre, 0) << "seed " << seed;
        EXPECT_LT(one.fastest, 150) << "seed " << seed;
    }
    EXPECT_LE(worst.beyond_grip, 0.001 * static_cast<double>(worst.wheel_steps));
    std::printf(
        "%u drives of a minute: %s, lowest wheel centre %.3f m, fastest %.1f m/s, %ld of %ld wheel-steps beyond "
        "1.05 of the grip\n",
        seeds, worst.finite ? "finite" : "NOT FINITE", worst.lowest_centre, worst.fastest, worst.beyond_grip,
        worst.wheel_steps);
}

// Without an engine the car's energy only falls, whatever is steered and braked.
TEST(RaycastVehicleRandom, TyresGiveNoEnergy) {
    for (double rate : {20.0, 60.0, 1000.0}) {
        World world;
        world.addPlane();
        Car<RaycastVehicle> car(world, {.roll_influence = 0.5, .speed = 40});
        std::mt19937 random(11);
        std::uniform_real_distribution<double> unit(0, 1);
        run(world, 1, rate);
        const auto energy = [&] {
            const btVector3 inverse = car.chassis->getInvInertiaDiagLocal();
            const btMatrix3x3& basis = car.chassis->getWorldTransform().getBasis();
            const btVector3 v = car.vehicle->velocity(), w = car.vehicle->angularVelocity();
            const btVector3 w_B = w * basis;
            double sum =
                0.5 * 1500 * static_cast<double>(v.length2()) + 1500 * kGravity * static_cast<double>(car.place().y());
            for (int k = 0; k < 3; ++k) sum += 0.5 * static_cast<double>(w_B[k] * w_B[k] / inverse[k]);
            return sum;
        };
        // Springs store up to this much of it for a while: travel of a few centimetres on four springs of 60 kN/m.
        constexpr double kStored = 1000;  // J, of 1.2 MJ
        double least = energy();
        const double start = least;
        for (int i = 0; i < 100; ++i) {
            car.steer(unit(random) - 0.5);
            car.brake(unit(random) < 0.8 ? 0 : 20 * unit(random));
            run(world, 0.2, rate);
            EXPECT_LT(energy(), least + kStored) << rate << " Hz, " << 0.2 * i << " s";
            least = std::min(least, energy());
        }
        EXPECT_LT(least, 0.7 * start);
    }
}

}  // namespace
}  // namespace tread::raycast_random_test
