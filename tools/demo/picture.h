// What the demo shows: the track, the car, arrows and marks at its wheels, text.
#pragma once

#include <optional>
#include <string>

#include "gl.h"
#include "text.h"

namespace tread::demo {

struct Frame {
    const Track& track;
    const Car& car;
    CarPose pose;
    btVector3 eye, target;
    const Mesh& marks;   // on the ground
    const Mesh& arrows;  // over everything
    double rate;         // Hz, of the world's steps
    std::string headline;
    std::vector<std::string> lines;
    std::vector<std::string> help;
};

class Picture {
public:
    Picture(const Track& track, const std::filesystem::path& font);

    void draw(const Frame& frame, int width, int height);
    // Of what was drawn last.
    void show(GLuint framebuffer) const { plain_->copyTo(framebuffer); }
    void save(const std::filesystem::path& file) const { savePng(*plain_, file); }

private:
    void drawThings(const Program& program, const Frame& frame) const;
    void addSigns(const Frame& frame, const Matrix& view, int width, int height);
    void addRateSlider(double rate, int width);
    void drawText(const Frame& frame, const Matrix& view, int width, int height);

    Program depth_, scene_, sky_;
    ShadowMap shadow_;
    Text text_;
    std::optional<Canvas> smooth_, plain_;
    std::vector<std::unique_ptr<Drawable>> blocks_;
    Drawable ground_, wheel_, stock_body_, tread_body_, marks_, arrows_;
    GLuint nothing_ = 0;
};

}  // namespace tread::demo
