#include "traces.h"

#include <algorithm>
#include <cmath>

namespace tread::demo {
namespace {

using scene::scalar;
using scene::vector;

constexpr double kSlides = 0.8;        // m/s: a tyre that slides faster leaves rubber
constexpr double kFull = 4;            // m/s: as much as can be
constexpr double kHalfWidth = 0.085;   // m
constexpr double kPieceLength = 0.15;  // m
constexpr double kLongestPiece = 4;    // m: farther apart, the car was put somewhere else
constexpr double kAbove = 0.012;       // m, over the ground
constexpr std::size_t kMost = 6000;    // pieces

}  // namespace

void addArrows(Mesh& mesh, const Car& car) {
    constexpr Colour kForce{0.15F, 0.85F, 0.25F}, kLoad{0.75F, 0.78F, 0.82F}, kSlip{1, 0.83F, 0.1F};
    for (int i = 0; i < 4; ++i) {
        const WheelSight sight = car.look(i);
        if (!sight.touches) continue;
        const btVector3 foot = sight.contact + scalar(0.02) * sight.normal;
        // The load beside the wheel, where the wheel does not hide it.
        const btVector3 beside = foot + sight.axle * scalar(i % 2 == 0 ? 0.2 : -0.2);
        addArrow(mesh, beside, beside + sight.normal * scalar(sight.load / kNewtonsPerMetre), 0.035, kLoad);
        if (sight.has_force) addArrow(mesh, foot, foot + sight.force / scalar(kNewtonsPerMetre), 0.06, kForce);
        addArrow(mesh, foot, foot + sight.slide / scalar(kSpeedPerMetre), 0.04, kSlip);
    }
}

void SkidMarks::note(const Car& car) {
    for (std::size_t i = 0; i < last_.size(); ++i) {
        const WheelSight sight = car.look(static_cast<int>(i));
        const double sliding = sight.touches ? static_cast<double>(sight.slide.length()) : 0;
        if (sliding < kSlides || car.ground(static_cast<int>(i)) == "ice") {
            last_[i].reset();
            continue;
        }
        const btVector3 middle = sight.contact + scalar(kAbove) * sight.normal;
        const btVector3 across = scalar(kHalfWidth) * sight.axle;
        const Edge edge{middle + across, middle - across};
        if (!last_[i]) last_[i] = edge;
        const double gone = static_cast<double>((middle - scalar(0.5) * (last_[i]->left + last_[i]->right)).length());
        if (gone < kPieceLength) continue;
        if (gone < kLongestPiece)
            pieces_.push_back({*last_[i], edge, static_cast<float>(std::min(sliding / kFull, 1.0))});
        last_[i] = edge;
        if (pieces_.size() > kMost) pieces_.pop_front();
    }
}

void SkidMarks::clear() {
    pieces_.clear();
    last_ = {};
}

Mesh SkidMarks::mesh() const {
    Mesh mesh;
    for (const Piece& p : pieces_) {
        const float grey = 0.24F - 0.18F * p.strength;
        addQuad(mesh, p.begin.left, p.begin.right, p.end.right, p.end.left, {grey, grey, grey});
    }
    return mesh;
}

}  // namespace tread::demo
