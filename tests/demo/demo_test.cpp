// The demo drives its scripts and shows what happened. Each picture is taken on a screen of its own, in memory.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <set>

#include "places/places.h"
#include "shared/scratch.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace tread {
namespace {

constexpr int kWidth = 640, kHeight = 360;

struct Answer {
    int status;
    std::string text;
};
Answer demo(const Scratch& scratch, const std::string& words) {
    const std::string out = scratch.path("words.txt");
    const int status = std::system((TREAD_DEMO " " + words + " > '" + out + "' 2>&1 < /dev/null").c_str());
    std::ifstream file(out);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, {std::istreambuf_iterator<char>(file), {}}};
}

// Red, green and blue of each pixel, rows from the top.
using Colour = std::array<int, 3>;
std::vector<Colour> pixels(const std::string& file) {
    int width = 0, height = 0, channels = 0;
    unsigned char* data = stbi_load(file.c_str(), &width, &height, &channels, 3);
    std::vector<Colour> found;
    if (data && width == kWidth && height == kHeight) {
        for (int i = 0; i < width * height; ++i) found.push_back({data[3 * i], data[3 * i + 1], data[3 * i + 2]});
    }
    stbi_image_free(data);
    return found;
}

// Where the demo says that the car is.
std::array<double, 3> placeIn(const std::string& text) {
    std::array<double, 3> place{};
    const std::size_t at = text.find(" at ");
    if (at == std::string::npos ||
        std::sscanf(text.c_str() + at, " at %lf %lf %lf", &place[0], &place[1], &place[2]) != 3)
        ADD_FAILURE() << "no place in: " << text;
    return place;
}

struct Drive {
    Answer answer;
    std::vector<Colour> picture;
};
Drive drive(const std::string& script, const std::string& vehicle) {
    const Scratch scratch;
    const std::string png = scratch.path("picture.png");
    const Answer answer =
        demo(scratch, "--script " + script + " --vehicle " + vehicle + " --screenshot '" + png + "' --width " +
                          std::to_string(kWidth) + " --height " + std::to_string(kHeight));
    EXPECT_EQ(answer.status, 0) << answer.text;
    return {answer, pixels(png)};
}

// Share of the middle of the picture (a fifth of its width and a third of its height) where `is` holds.
double shareInTheMiddle(const std::vector<Colour>& picture, const auto& is) {
    int all = 0, found = 0;
    for (int y = kHeight / 3; y < 2 * kHeight / 3; ++y) {
        for (int x = 2 * kWidth / 5; x < 3 * kWidth / 5; ++x) {
            ++all;
            found += is(picture[static_cast<std::size_t>(y * kWidth + x)]);
        }
    }
    return static_cast<double>(found) / all;
}

TEST(Demo, EveryScriptEndsWithTheCarInTheMiddleOfThePicture) {
    const auto red = [](const Colour& c) { return c[0] > 60 && c[0] > 3 * c[1] && c[0] > 3 * c[2]; };
    const auto blue = [](const Colour& c) { return c[2] > 50 && 2 * c[2] > 3 * c[1] && c[2] > 2 * c[0]; };
    for (const char* script : {"plane", "slope", "kerbs", "ice", "platform", "jump", "drift"}) {
        for (const char* vehicle : {"stock", "tread"}) {
            SCOPED_TRACE(std::string(script) + " on " + vehicle);
            const Drive shown = drive(script, vehicle);
            ASSERT_EQ(shown.picture.size(), static_cast<std::size_t>(kWidth * kHeight));
            EXPECT_GT(std::set<Colour>(shown.picture.begin(), shown.picture.end()).size(), 500u) << "colours";
            const bool stock = vehicle == std::string("stock");
            EXPECT_GT(shareInTheMiddle(shown.picture, stock ? blue : red), 0.04);
            EXPECT_LT(shareInTheMiddle(shown.picture, stock ? red : blue), 0.01);
        }
    }
}

TEST(Demo, OnTheSlopeStockCreepsAndTreadStays) {
    const Drive stock = drive("slope --seconds 20", "stock"), tread = drive("slope --seconds 20", "tread");
    const Drive begins = drive("slope --seconds 1", "tread");
    const auto at = placeIn(begins.answer.text), by_stock = placeIn(stock.answer.text),
               by_tread = placeIn(tread.answer.text);
    EXPECT_NEAR(by_tread[2], at[2], 0.001);
    EXPECT_LT(by_stock[2], at[2] - 0.3);

    // It shows: the lines on the hill lie elsewhere under a car that has moved. Below the car nothing else differs.
    int below = 0;
    ASSERT_EQ(stock.picture.size(), tread.picture.size());
    for (std::size_t i = stock.picture.size() * 4 / 5; i < stock.picture.size(); ++i)
        below += std::abs(stock.picture[i][0] - tread.picture[i][0]) > 8;
    EXPECT_GT(below, 200) << "pixels";
}

TEST(Demo, PlatformTakesTreadAlong) {
    const auto by_stock = placeIn(drive("platform", "stock").answer.text),
               by_tread = placeIn(drive("platform", "tread").answer.text);
    EXPECT_NEAR(by_tread[0], -54 + 6 * std::sin(2 * M_PI * 6 / 9), 1) << "it slides while the platform catches it";
    EXPECT_NEAR(by_stock[0], -54, 1);
}

TEST(Demo, WrongScriptIsAnErrorWithItsLine) {
    const Scratch scratch;
    const std::string file = scratch.file("wrong.yaml", "place: plane\nacts:\n  - {time: 0, throtle: 1}\n");
    const Answer answer = demo(scratch, "--script '" + file + "' --screenshot '" + scratch.path("no.png") + "'");
    EXPECT_EQ(answer.status, 2);
    EXPECT_NE(answer.text.find("wrong.yaml:3"), std::string::npos) << answer.text;
    EXPECT_NE(answer.text.find("throttle"), std::string::npos) << answer.text;
    EXPECT_EQ(demo(scratch, "--script nowhere --screenshot x.png").status, 2);
}

}  // namespace
}  // namespace tread
