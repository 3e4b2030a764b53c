#include "mesh.h"

#include <cmath>
#include <map>

namespace tread::demo {
namespace {

using scene::scalar;
using scene::vector;

constexpr int kSides = 28;  // of what is round
constexpr float kGrid = 2;

std::array<float, 3> coordinates(const btVector3& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

btVector3 onRing(const Ring& ring, int side) {
    const double angle = 2 * M_PI * side / kSides;
    return vector(ring.x, ring.radius * std::cos(angle), ring.radius * std::sin(angle));
}

const Colour& colourOf(Paint paint) {
    static const std::map<Paint, Colour> kColours{{Paint::concrete, {0.44F, 0.46F, 0.42F}},
                                                  {Paint::kerb, {0.80F, 0.45F, 0.12F}},
                                                  {Paint::platform, {0.72F, 0.62F, 0.18F}},
                                                  {Paint::ramp, {0.28F, 0.42F, 0.56F}},
                                                  {Paint::crate, {0.55F, 0.38F, 0.20F}}};
    return kColours.at(paint);
}

}  // namespace

void addTriangle(Mesh& mesh, const btVector3& a, const btVector3& b, const btVector3& c, const Colour& colour,
                 float gloss) {
    const btVector3 across = (b - a).cross(c - a);
    if (across.length2() < scalar(1e-14)) return;
    const auto normal = coordinates(across.normalized());
    for (const btVector3& p : {a, b, c}) mesh.push_back({coordinates(p), normal, colour, gloss});
}

void addQuad(Mesh& mesh, const btVector3& a, const btVector3& b, const btVector3& c, const btVector3& d,
             const Colour& colour, float gloss) {
    addTriangle(mesh, a, b, c, colour, gloss);
    addTriangle(mesh, a, c, d, colour, gloss);
}

void addTube(Mesh& mesh, const Ring& left, const Ring& right, const Colour& colour, float gloss) {
    for (int i = 0; i < kSides; ++i)
        addQuad(mesh, onRing(left, i), onRing(right, i), onRing(right, i + 1), onRing(left, i + 1), colour, gloss);
}

void addDisc(Mesh& mesh, const Ring& ring, bool to_the_left, const Colour& colour, float gloss) {
    const btVector3 centre = vector(ring.x, 0, 0);
    for (int i = 0; i < kSides; ++i)
        addTriangle(mesh, centre, onRing(ring, to_the_left ? i : i + 1), onRing(ring, to_the_left ? i + 1 : i), colour,
                    gloss);
}

Mesh blockMesh(const Block& block) {
    Mesh mesh;
    const Colour& colour = colourOf(block.paint);
    const float gloss = block.paint == Paint::concrete || block.paint == Paint::ramp ? kGrid : 0;
    const std::size_t n = block.profile.size();
    const btVector3 left = vector(block.half_width, 0, 0);
    // Profiles run up at the near end and back down at the far one.
    for (std::size_t i = 0; i < n; ++i) {
        const btVector3 &a = block.profile[i], &b = block.profile[(i + 1) % n];
        addQuad(mesh, a - left, a + left, b + left, b - left, colour, gloss);
    }
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const btVector3 &a = block.profile[0], &b = block.profile[i], &c = block.profile[i + 1];
        addTriangle(mesh, a + left, c + left, b + left, colour);
        addTriangle(mesh, a - left, b - left, c - left, colour);
    }
    return mesh;
}

Mesh groundMesh() {
    constexpr double kFar = 600;
    Mesh mesh;
    addQuad(mesh, vector(-kFar, 0, -kFar), vector(-kFar, 0, kFar), vector(kFar, 0, kFar), vector(kFar, 0, -kFar),
            {0.33F, 0.34F, 0.35F}, kGrid);
    constexpr double kAbove = 0.004;
    addQuad(mesh, vector(kIce.right, kAbove, kIce.near), vector(kIce.right, kAbove, kIce.far),
            vector(kIce.left, kAbove, kIce.far), vector(kIce.left, kAbove, kIce.near), {0.66F, 0.80F, 0.90F}, kGrid);
    return mesh;
}

Mesh wheelMesh() {
    constexpr double kHalf = 0.11, kRim = 0.205;
    constexpr Colour kRubber{0.045F, 0.045F, 0.05F}, kMetal{0.62F, 0.64F, 0.67F}, kHub{0.20F, 0.21F, 0.22F};
    const double r = Car::kRadius;
    Mesh mesh;
    addTube(mesh, {kHalf - 0.025, r}, {-kHalf + 0.025, r}, kRubber);
    for (double side : {-1.0, 1.0}) {
        const bool left = side > 0;
        const Ring shoulder{side * (kHalf - 0.025), r}, wall{side * kHalf, r - 0.035}, rim{side * kHalf, kRim};
        const Ring deep{side * (kHalf - 0.03), kRim - 0.01};
        for (const auto& [outer, inner] : {std::pair{shoulder, wall}, std::pair{wall, rim}})
            left ? addTube(mesh, inner, outer, kRubber) : addTube(mesh, outer, inner, kRubber);
        left ? addTube(mesh, deep, rim, kMetal, 0.4F) : addTube(mesh, rim, deep, kMetal, 0.4F);
        addDisc(mesh, deep, left, kHub);
        addDisc(mesh, {side * (kHalf - 0.008), 0.055}, left, kMetal, 0.4F);
        // Five spokes, one of them marked so that turning can be counted.
        for (int i = 0; i < 5; ++i) {
            const btVector3 out = vector(0, std::cos(2 * M_PI * i / 5), std::sin(2 * M_PI * i / 5));
            const btVector3 wide = scalar(0.027) * vector(1, 0, 0).cross(out);
            const btVector3 face = vector(side * (kHalf - 0.012), 0, 0), end = face + scalar(kRim) * out;
            const Colour colour = i == 0 ? Colour{0.85F, 0.45F, 0.10F} : kMetal;
            if (left) addQuad(mesh, face - wide, end - wide, end + wide, face + wide, colour, 0.4F);
            else addQuad(mesh, face + wide, end + wide, end - wide, face - wide, colour, 0.4F);
        }
    }
    return mesh;
}

void addArrow(Mesh& mesh, const btVector3& from, const btVector3& to, double width, const Colour& colour) {
    const btVector3 along = to - from;
    const double length = along.length();
    if (length < 0.03) return;
    const btVector3 forward = along / scalar(length);
    const btVector3 some = std::abs(forward.y()) < scalar(0.9) ? vector(0, 1, 0) : vector(1, 0, 0);
    const btVector3 u = forward.cross(some).normalized(), v = forward.cross(u);
    const double head = std::min(4 * width, 0.5 * length);
    const btVector3 neck = to - scalar(head) * forward;
    constexpr int kEdges = 8;
    const auto at = [&](double radius, int i) {
        const double angle = 2 * M_PI * i / kEdges;
        return scalar(radius * std::cos(angle)) * u + scalar(radius * std::sin(angle)) * v;
    };
    constexpr float kOwnLight = 3;
    for (int i = 0; i < kEdges; ++i) {
        const btVector3 a = at(0.5 * width, i), b = at(0.5 * width, i + 1);
        addQuad(mesh, from + a, neck + a, neck + b, from + b, colour, kOwnLight);
        const btVector3 c = neck + at(1.5 * width, i), d = neck + at(1.5 * width, i + 1);
        addTriangle(mesh, c, to, d, colour, kOwnLight);
        addTriangle(mesh, d, neck, c, colour, kOwnLight);
    }
}

}  // namespace tread::demo
