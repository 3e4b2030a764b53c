#include "log/direction.h"

#include <cmath>
#include <numbers>

#include "log/log_columns.h"

namespace tread {

bool isDirection(std::string_view channel) {
    const std::string_view quantity = quantityOf(channel);
    return quantity == "chassis.yaw" || quantity == "position.heading";
}

std::vector<double> continuous(std::vector<double> angles) {
    constexpr double kTurn = 2 * std::numbers::pi;
    double last = std::nan(""), turns = 0;
    for (double& angle : angles) {
        if (!std::isfinite(angle)) continue;
        if (std::isfinite(last)) turns -= std::round((angle + turns * kTurn - last) / kTurn);
        angle += turns * kTurn;
        last = angle;
    }
    return angles;
}

}  // namespace tread
