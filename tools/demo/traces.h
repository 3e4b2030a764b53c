// What the tyres do, to be seen: arrows of slip and force at each wheel, skid marks behind it.
#pragma once

#include <array>
#include <deque>
#include <optional>

#include "mesh.h"

namespace tread::demo {

inline constexpr double kNewtonsPerMetre = 3000;  // of a force arrow
inline constexpr double kSpeedPerMetre = 2;       // m/s per m of a slip arrow

// Green: what the ground does to the tyre along itself; grey: the load; yellow: how the tyre slides.
void addArrows(Mesh& mesh, const Car& car);

class SkidMarks {
public:
    // After each step.
    void note(const Car& car);
    void clear();
    Mesh mesh() const;

private:
    struct Edge {
        btVector3 left, right;
    };
    struct Piece {
        Edge begin, end;
        float strength;
    };
    std::deque<Piece> pieces_;
    std::array<std::optional<Edge>, 4> last_;
};

}  // namespace tread::demo
