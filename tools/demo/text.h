// Text over the picture, in a TrueType font.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "gl.h"

namespace tread::demo {

class Text {
public:
    explicit Text(const std::filesystem::path& font);  // std::runtime_error when it cannot be read
    Text(const Text&) = delete;
    Text& operator=(const Text&) = delete;
    ~Text();

    // Pixels from the top left corner to the baseline's beginning; the size is a factor on 20 pixels.
    void add(float x, float y, std::string_view text, const Colour& colour, float size = 1);
    void addPanel(float left, float top, float right, float bottom);
    void addBar(float left, float top, float right, float bottom, const Colour& colour);
    float width(std::string_view text, float size = 1) const;
    // Draws what was added since.
    void draw(int width, int height);

private:
    struct Corner {
        float x, y, u, v, r, g, b, a;
    };
    void addQuad(const Corner& low, const Corner& high);

    Program program_;
    std::vector<Corner> corners_;
    Drawable quads_{{2, 2, 4}};
    GLuint texture_ = 0;
    struct Glyphs;
    std::unique_ptr<Glyphs> glyphs_;
};

}  // namespace tread::demo
