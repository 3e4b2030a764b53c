// The slider for the world's steps per second in the upper right corner, in pixels from the top left one. No drawing.
#pragma once

namespace tread::demo {

struct RateSlider {
    static constexpr double kLowest = 20, kHighest = 240;  // Hz
    static constexpr float kTop = 14, kBottom = 82, kMiddle = 60, kHalfHandle = 6, kHalfHeight = 10;

    explicit RateSlider(int picture_width) : picture(static_cast<float>(picture_width)) {}

    float left() const { return picture - 300; }
    float right() const { return picture - 36; }
    // Where the handle is at a rate: as far from one to its double everywhere.
    float placeOf(double rate) const;
    // The rate, in whole steps per second, where the handle is held.
    double rateAt(double x) const;
    // Whether the slider is taken there, a little beside it too.
    bool holds(double x, double y) const;

    float picture;
};

}  // namespace tread::demo
