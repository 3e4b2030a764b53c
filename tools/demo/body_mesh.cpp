// The demo car's body: lofted from sections along its length.
#include <array>
#include <cmath>

#include "mesh.h"

namespace tread::demo {
namespace {

using scene::scalar;
using scene::vector;

// Half of a section across the car, from the bottom to the middle of the top: points (half width, height above the
// centre of gravity).
constexpr std::size_t kPoints = 5;
struct Section {
    double z;
    std::array<std::array<double, 2>, kPoints> points;
};

btVector3 corner(const Section& s, std::size_t i, double side) {
    return vector(side * s.points[i][0], s.points[i][1], s.z);
}

// Skin between two sections, the second in front; rows from `first` on are painted otherwise.
void addSkin(Mesh& mesh, const Section& rear, const Section& front, const Colour& colour, float gloss,
             std::size_t begin = 0, std::size_t end = kPoints - 1) {
    for (std::size_t i = begin; i < end; ++i) {
        addQuad(mesh, corner(rear, i, 1), corner(rear, i + 1, 1), corner(front, i + 1, 1), corner(front, i, 1), colour,
                gloss);
        addQuad(mesh, corner(front, i, -1), corner(front, i + 1, -1), corner(rear, i + 1, -1), corner(rear, i, -1),
                colour, gloss);
    }
}

void addEnd(Mesh& mesh, const Section& s, bool front, const Colour& colour, float gloss) {
    const double side = front ? 1 : -1;
    for (std::size_t i = 0; i + 1 < kPoints; ++i)
        addQuad(mesh, corner(s, i, side), corner(s, i + 1, side), corner(s, i + 1, -side), corner(s, i, -side), colour,
                gloss);
}

// z, half width, bottom, belt: bumpers, bonnet, doors, boot.
Section lower(double z, double width, double bottom, double belt) {
    return {z,
            {{{0.86 * width, bottom},
              {width, bottom + 0.13},
              {width, belt - 0.16},
              {0.95 * width, belt - 0.03},
              {0, belt + 0.02}}}};
}

// The cabin over the belt: z, half width at the belt, half width of the roof, heights of both.
Section upper(double z, double width, double roof_width, double belt, double roof) {
    const double w = roof_width;
    return {z,
            {{{width, belt},
              {w + 0.3 * (width - w), belt + 0.7 * (roof - belt)},
              {w, roof - 0.04},
              {0.8 * w, roof},
              {0, roof + 0.015}}}};
}

void addPlate(Mesh& mesh, double x, double y, double z, double half_width, double half_height, bool front,
              const Colour& colour, float gloss) {
    const btVector3 u = vector(half_width, 0, 0), v = vector(0, half_height, 0), c = vector(x, y, z);
    if (front) addQuad(mesh, c - u - v, c + u - v, c + u + v, c - u + v, colour, gloss);
    else addQuad(mesh, c + u - v, c - u - v, c - u + v, c + u + v, colour, gloss);
}

}  // namespace

Mesh bodyMesh(const Colour& paint) {
    constexpr Colour kGlass{0.06F, 0.08F, 0.10F}, kDark{0.05F, 0.05F, 0.055F};
    constexpr float kPaintGloss = 0.35F;
    Mesh mesh;

    // ---- Lower body ----
    const std::array<Section, 9> sections{
        lower(-2.12, 0.66, -0.12, 0.36), lower(-2.02, 0.80, -0.20, 0.47), lower(-1.60, 0.86, -0.24, 0.53),
        lower(-0.80, 0.88, -0.28, 0.52), lower(0.50, 0.88, -0.28, 0.50),  lower(0.95, 0.87, -0.27, 0.48),
        lower(1.70, 0.84, -0.25, 0.38),  lower(2.05, 0.76, -0.21, 0.28),  lower(2.16, 0.62, -0.15, 0.16)};
    for (std::size_t i = 0; i + 1 < sections.size(); ++i)
        addSkin(mesh, sections[i], sections[i + 1], paint, kPaintGloss);
    addEnd(mesh, sections.front(), false, paint, kPaintGloss);
    addEnd(mesh, sections.back(), true, paint, kPaintGloss);

    // ---- Cabin: glass up to the roof, pillars and roof painted ----
    const std::array<Section, 4> cabin{upper(-1.72, 0.76, 0.72, 0.52, 0.54), upper(-1.08, 0.80, 0.58, 0.52, 0.93),
                                       upper(0.10, 0.81, 0.58, 0.50, 0.95), upper(1.02, 0.76, 0.72, 0.46, 0.47)};
    for (std::size_t i = 0; i + 1 < cabin.size(); ++i) {
        addSkin(mesh, cabin[i], cabin[i + 1], kGlass, 1, 0, 2);
        addSkin(mesh, cabin[i], cabin[i + 1], i == 1 ? paint : kGlass, i == 1 ? kPaintGloss : 1, 2);
    }
    const Section before = upper(-0.52, 0.815, 0.59, 0.515, 0.945), after = upper(-0.42, 0.815, 0.59, 0.515, 0.947);
    addSkin(mesh, before, after, paint, kPaintGloss);  // middle pillars

    // ---- Wheel wells, lights, grille ----
    for (double z : {0.5 * Car::kWheelbase, -0.5 * Car::kWheelbase}) {
        Mesh wells;
        addDisc(wells, {0.885, Car::kRadius + 0.065}, true, kDark);
        addDisc(wells, {-0.885, Car::kRadius + 0.065}, false, kDark);
        for (Vertex& v : wells) {
            v.at[1] -= 0.19F;
            v.at[2] += static_cast<float>(z);
        }
        mesh.insert(mesh.end(), wells.begin(), wells.end());
    }
    for (double side : {-1.0, 1.0}) {
        addPlate(mesh, side * 0.44, 0.07, 2.168, 0.12, 0.045, true, {1, 0.97F, 0.85F}, 3);
        addPlate(mesh, side * 0.50, 0.24, -2.126, 0.13, 0.06, false, {0.75F, 0.05F, 0.04F}, 3);
    }
    addPlate(mesh, 0, -0.03, 2.166, 0.30, 0.07, true, kDark, 0);
    addPlate(mesh, 0, 0.08, -2.13, 0.26, 0.055, false, {0.85F, 0.85F, 0.80F}, 0);
    return mesh;
}

}  // namespace tread::demo
