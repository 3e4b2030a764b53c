// Coloured triangles of the demo's things, in their own axes: y up, z forward, x to the left.
#pragma once

#include <array>
#include <vector>

#include "car.h"

namespace tread::demo {

using Colour = std::array<float, 3>;

struct Vertex {
    std::array<float, 3> at;
    std::array<float, 3> normal;
    Colour colour;
    float gloss;  // 0 dull to 1 like glass; 2: the ground with its grid; 3: shines by itself
};
using Mesh = std::vector<Vertex>;

// Corners anticlockwise as seen from outside.
void addTriangle(Mesh& mesh, const btVector3& a, const btVector3& b, const btVector3& c, const Colour& colour,
                 float gloss = 0);
void addQuad(Mesh& mesh, const btVector3& a, const btVector3& b, const btVector3& c, const btVector3& d,
             const Colour& colour, float gloss = 0);
// A tube about the x axis between two x, open at its ends unless closed.
struct Ring {
    double x, radius;
};
void addTube(Mesh& mesh, const Ring& left, const Ring& right, const Colour& colour, float gloss = 0);
void addDisc(Mesh& mesh, const Ring& ring, bool to_the_left, const Colour& colour, float gloss = 0);

Mesh blockMesh(const Block& block);
Mesh groundMesh();
Mesh bodyMesh(const Colour& paint);
Mesh wheelMesh();
// An arrow from one point to another.
void addArrow(Mesh& mesh, const btVector3& from, const btVector3& to, double width, const Colour& colour);

}  // namespace tread::demo
