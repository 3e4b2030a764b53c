#include "scenario/cones.h"

namespace tread {

std::vector<Point> conesOf(const std::vector<Lane>& course) {
    std::vector<Point> cones;
    for (const Lane& lane : course) {
        for (int i = 0; i < lane.cones; ++i) {
            const double x = lane.from + (lane.to - lane.from) * i / (lane.cones - 1);
            cones.push_back({x, lane.left});
            cones.push_back({x, lane.right});
        }
    }
    return cones;
}

}  // namespace tread
