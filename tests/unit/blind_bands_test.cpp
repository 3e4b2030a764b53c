// Bands of detectability: closed forms and limits.
#include "blind/score/bands.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/math/random.h"
#include "tread/problem.h"

namespace tread::blind_bands_test {
namespace {

using blind::key::CaseKey;
using blind::key::Detectability;
using blind::score::anyDetectable;
using blind::score::Band;
using blind::score::bandOf;
using blind::score::chanceToGain;
using blind::score::kDetectable;
using blind::score::kTestable;
using blind::score::strongest;
using blind::score::toldApart;
using blind::score::weakest;

CaseKey keyWith(std::vector<std::string> effects, std::map<std::string, Detectability> shows) {
    CaseKey key;
    key.name = "case_001";
    key.effects = std::move(effects);
    key.shows = std::move(shows);
    return key;
}

TEST(BlindBands, LowerEndBelongsToTheBand) {
    EXPECT_EQ(bandOf(0), Band::hidden);
    EXPECT_EQ(bandOf(std::nextafter(6, 0)), Band::hidden);
    EXPECT_EQ(bandOf(6), Band::faint);
    EXPECT_EQ(bandOf(std::nextafter(22, 0)), Band::faint);
    EXPECT_EQ(bandOf(22), Band::testable);
    EXPECT_EQ(bandOf(std::nextafter(100, 0)), Band::testable);
    EXPECT_EQ(bandOf(100), Band::strong);
    EXPECT_EQ(nameOf(Band::testable), "22 to 100");
}

TEST(BlindBands, ChanceToGainIsThatOfDrawnSignals) {
    // With 0 nats expected, the gain is half a chi-square variable of one degree of freedom: P(chi^2 > 3.841) = 0.05.
    EXPECT_NEAR(chanceToGain(3.841458820694124 / 2, 0), 0.05, 1e-9);
    // The figures that bands.h states.
    EXPECT_NEAR(chanceToGain(5, kDetectable), 0.619, 0.001);
    EXPECT_NEAR(chanceToGain(5, kTestable), 0.9997, 0.0001);
    // A signal of ten readings in white noise of one, fitted by its size.
    Random random(5);
    constexpr int kDraws = 20000;
    constexpr double kExpected = 8;
    const double reading = std::sqrt(2 * kExpected / 10);  // half the sum of squares is kExpected
    int gained = 0;
    for (int i = 0; i < kDraws; ++i) {
        double projection = 0;
        for (int j = 0; j < 10; ++j) projection += (reading + random.normal()) * reading;
        gained += projection * projection / (2 * 2 * kExpected) >= 5 ? 1 : 0;
    }
    const double chance = chanceToGain(5, kExpected);
    EXPECT_NEAR(static_cast<double>(gained) / kDraws, chance, 4 * std::sqrt(chance * (1 - chance) / kDraws));
}

TEST(BlindBands, WeakerAndStrongerAreThoseOfTheKey) {
    const CaseKey key = keyWith({"drag", "mass"}, {{"drag", {.nats = 7, .rival = "", .separation = 6}},
                                                   {"mass", {.nats = 130, .rival = "", .separation = 5.9}}});
    EXPECT_EQ(weakest(key, key.effects), 7);
    EXPECT_EQ(strongest(key, key.effects), 130);
    EXPECT_TRUE(toldApart(key, {"drag"}));
    EXPECT_FALSE(toldApart(key, key.effects));
    EXPECT_TRUE(anyDetectable(key));
}

TEST(BlindBands, NothingShowsBelowSixNats) {
    EXPECT_TRUE(anyDetectable(keyWith({"drag"}, {{"drag", {.nats = 6, .rival = "", .separation = 0}}})));
    EXPECT_FALSE(anyDetectable(keyWith({"drag"}, {{"drag", {.nats = 5.99, .rival = "", .separation = 5}}})));
    EXPECT_FALSE(anyDetectable(keyWith({}, {})));
    CaseKey outside = keyWith({}, {{"flutter", {.nats = 9, .rival = "", .separation = 9}}});
    outside.outsider = "flutter";
    EXPECT_TRUE(anyDetectable(outside));
}

TEST(BlindBands, KeyThatDoesNotSayWhatShowsIsRefusedByName) {
    for (const CaseKey& key :
         {keyWith({"drag"}, {}), keyWith({"drag"}, {{"drag", {.nats = std::nan(""), .rival = ""}}})}) {
        try {
            weakest(key, key.effects);
            ADD_FAILURE() << "no fault";
        } catch (const LoadError& error) {
            EXPECT_NE(std::string(error.what()).find("case_001"), std::string::npos) << error.what();
            EXPECT_NE(std::string(error.what()).find("drag"), std::string::npos) << error.what();
        }
    }
}

}  // namespace
}  // namespace tread::blind_bands_test
