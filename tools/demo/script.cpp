#include "script.h"

#include "base/yaml/read.h"

namespace tread::demo {

Script loadScript(const std::string& file_or_name, const std::filesystem::path& own_scripts) {
    const std::filesystem::path own = own_scripts / (file_or_name + ".yaml");
    const bool is_own = !std::filesystem::exists(file_or_name) && std::filesystem::exists(own);
    return readYaml<Script>(is_own ? own : std::filesystem::path(file_or_name));
}

Pedals pedalsAt(const Script& script, double time) {
    Pedals pedals;
    for (const Act& act : script.acts) {
        if (act.time <= time)
            pedals = {.throttle = act.throttle, .brake = act.brake, .handbrake = act.handbrake, .steer = act.steer};
    }
    return pedals;
}

}  // namespace tread::demo
