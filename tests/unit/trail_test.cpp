// Which car a thread steps next, foretold from the last round.
#include <gtest/gtest.h>

#include <array>

#include "bullet/drop_in/fetch_ahead.h"

namespace tread::trail_test {
namespace {

struct Cars {
    Trail trail;
    std::array<char, 8> cars{};
    std::array<std::size_t, 8> places{};

    // The car that is expected after this one, -1: none of them.
    int after(std::size_t i) {
        const Address next = trail.after({.car = addressOf(&cars[i])}, places[i]).car;
        for (int k = 0; k < 8; ++k)
            if (next == addressOf(&cars[static_cast<std::size_t>(k)])) return k;
        return -1;
    }
};

TEST(Trail, ForetellsTheOrderOfTheLastRound) {
    Cars c;
    for (std::size_t i : {3u, 1u, 4u}) c.after(i);
    for (int round = 0; round < 3; ++round) {
        EXPECT_EQ(c.after(3), 1);
        EXPECT_EQ(c.after(1), 4);
        EXPECT_EQ(c.after(4), 3) << "and the first again";
    }
}

TEST(Trail, ForgetsCarsThatComeNoMore) {
    Cars c;
    for (std::size_t i : {0u, 1u, 2u, 3u}) c.after(i);
    for (int round = 0; round < 3; ++round) {  // 1 and 3 are gone
        c.after(0);
        c.after(2);
    }
    EXPECT_EQ(c.after(0), 2);
    EXPECT_EQ(c.after(2), 0);
}

TEST(Trail, KeepsAnOrderOfTwoWorldsInTurn) {
    Cars c;
    for (int round = 0; round < 3; ++round)
        for (std::size_t i : {0u, 1u, 5u, 6u}) c.after(i);
    EXPECT_EQ(c.after(0), 1);
    EXPECT_EQ(c.after(1), 5);
    EXPECT_EQ(c.after(5), 6);
    EXPECT_EQ(c.after(6), 0);
}

TEST(Trail, OfOneCarIsThatCar) {
    Cars c;
    for (std::size_t i : {0u, 1u, 2u}) c.after(i);
    c.after(7);  // another world's, alone from now on
    c.after(7);
    EXPECT_EQ(c.after(7), 7);
}

// A game that makes new cars all the time.
TEST(Trail, GenerationsOfCarsAreForetoldToo) {
    std::array<char, 3000> cars{};
    Trail trail;
    for (std::size_t first = 0; first + 10 <= cars.size(); first += 10) {
        std::array<std::size_t, 10> places{};
        Address next = 0;
        for (int round = 0; round < 4; ++round)
            for (std::size_t i = 0; i < 10; ++i)
                next = trail.after({.car = addressOf(&cars[first + i])}, places[i]).car;
        EXPECT_EQ(next, addressOf(&cars[first]));
        EXPECT_LT(places[9], 100u);
    }
}

}  // namespace
}  // namespace tread::trail_test
