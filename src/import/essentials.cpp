#include "import/essentials.h"

#include <algorithm>
#include <string_view>

#include "log/log_columns.h"

namespace tread {
namespace {

struct Essential {
    std::string_view name;
    std::vector<std::string_view> channels;  // one of them is enough
    std::string_view use;                    // what is impossible without
    std::string_view remedy;
};

const std::vector<Essential>& essentials() {
    static const std::vector<Essential> list = {
        {"time",
         {"time"},
         "without it, the sampling rate is only an assumption",
         "name the column of the time (time.from), or confirm the rate (time.rate)"},
        {"speed",
         {"chassis.vx"},
         "tread run --log and diagnose cannot follow the speed",
         "map a column to chassis.vx, or give it as a constant"},
        {"steering",
         {"driver.steering_wheel_angle"},
         "tread run --log and diagnose cannot repeat the steering",
         "map a column to driver.steering_wheel_angle; the angle of the road wheels times the steering ratio (scale) "
         "can be used instead"},
        {"yaw rate or lateral acceleration",
         {"chassis.yaw_rate", "chassis.ay"},
         "compare and diagnose have no response of the car to evaluate",
         "map a column to chassis.yaw_rate or chassis.ay"}};
    return list;
}

}  // namespace

std::vector<std::string> lackingEssentials(const std::vector<std::string>& channels) {
    std::vector<std::string> lacking;
    for (const Essential& essential : essentials()) {
        const bool there = std::any_of(channels.begin(), channels.end(), [&](const std::string& channel) {
            return std::find(essential.channels.begin(), essential.channels.end(), quantityOf(channel)) !=
                   essential.channels.end();
        });
        if (there) continue;
        std::string text = "no " + std::string(essential.name) + ": ";
        text += std::string(essential.use) + "; " + std::string(essential.remedy);
        lacking.push_back(std::move(text));
    }
    return lacking;
}

}  // namespace tread
