#include "text.h"

#include <array>
#include <fstream>
#include <iterator>
#include <stdexcept>

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_truetype.h>
#pragma GCC diagnostic pop

namespace tread::demo {
namespace {

constexpr int kAtlas = 512;    // pixels
constexpr float kPixels = 20;  // height of the font
constexpr int kFirst = 32, kCount = 95;

constexpr const char* kVertex = R"(#version 330 core
layout(location = 0) in vec2 at;
layout(location = 1) in vec2 glyph;
layout(location = 2) in vec4 colour;
uniform vec3 size;
out vec2 texel;
out vec4 tint;
void main() {
    texel = glyph;
    tint = colour;
    gl_Position = vec4(2.0 * at.x / size.x - 1.0, 1.0 - 2.0 * at.y / size.y, 0.0, 1.0);
})";
constexpr const char* kFragment = R"(#version 330 core
in vec2 texel;
in vec4 tint;
uniform sampler2D glyphs;
out vec4 result;
void main() {
    float cover = texel.x < 0.0 ? 1.0 : texture(glyphs, texel).r;
    result = vec4(tint.rgb, tint.a * cover);
})";

}  // namespace

struct Text::Glyphs {
    std::array<stbtt_bakedchar, kCount> baked;
};

Text::Text(const std::filesystem::path& font) : program_(kVertex, kFragment), glyphs_(std::make_unique<Glyphs>()) {
    std::ifstream file(font, std::ios::binary);
    const std::vector<unsigned char> bytes{std::istreambuf_iterator<char>(file), {}};
    std::vector<unsigned char> pixels(kAtlas * kAtlas);
    if (bytes.empty() || stbtt_BakeFontBitmap(bytes.data(), 0, kPixels, pixels.data(), kAtlas, kAtlas, kFirst, kCount,
                                              glyphs_->baked.data()) <= 0)
        throw std::runtime_error("tread_demo: " + font.string() + " is no font (Debian has it in fonts-dejavu-core)");
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, kAtlas, kAtlas, 0, GL_RED, GL_UNSIGNED_BYTE, pixels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

Text::~Text() {
    glDeleteTextures(1, &texture_);
}

void Text::addQuad(const Corner& low, const Corner& high) {
    Corner right = low, left = high;
    right.x = high.x;
    right.u = high.u;
    left.x = low.x;
    left.u = low.u;
    for (const Corner& c : {low, right, high, low, high, left}) corners_.push_back(c);
}

void Text::add(float x, float y, std::string_view text, const Colour& colour, float size) {
    const auto [r, g, b] = colour;
    for (const char letter : text) {
        if (letter < kFirst || letter >= kFirst + kCount) continue;
        const stbtt_bakedchar& c = glyphs_->baked[static_cast<std::size_t>(letter - kFirst)];
        const float left = x + size * c.xoff, top = y + size * c.yoff;
        const auto across = static_cast<float>(c.x1 - c.x0), down = static_cast<float>(c.y1 - c.y0);
        addQuad({left, top, static_cast<float>(c.x0) / kAtlas, static_cast<float>(c.y0) / kAtlas, r, g, b, 1},
                {left + size * across, top + size * down, static_cast<float>(c.x1) / kAtlas,
                 static_cast<float>(c.y1) / kAtlas, r, g, b, 1});
        x += size * c.xadvance;
    }
}

void Text::addPanel(float left, float top, float right, float bottom) {
    addQuad({left, top, -1, -1, 0.03F, 0.04F, 0.06F, 0.62F}, {right, bottom, -1, -1, 0.03F, 0.04F, 0.06F, 0.62F});
}

void Text::addBar(float left, float top, float right, float bottom, const Colour& colour) {
    const auto [r, g, b] = colour;
    addQuad({left, top, -1, -1, r, g, b, 1}, {right, bottom, -1, -1, r, g, b, 1});
}

float Text::width(std::string_view text, float size) const {
    float width = 0;
    for (const char letter : text) {
        if (letter >= kFirst && letter < kFirst + kCount)
            width += size * glyphs_->baked[static_cast<std::size_t>(letter - kFirst)].xadvance;
    }
    return width;
}

void Text::draw(int width, int height) {
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    program_.use();
    program_.set("size", Eigen::Vector3f(static_cast<float>(width), static_cast<float>(height), 0));
    program_.set("glyphs", 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture_);
    quads_.load(corners_);
    quads_.draw();
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    corners_.clear();
}

}  // namespace tread::demo
