#include "output.h"

#include <nlohmann/json.hpp>

namespace tread::program {

void print(std::string_view text) {
    writeFile({}, text);
}

void say(std::string_view text, Tone tone) {
    if (!isQuiet()) print(coloured(text, tone, stdout));
}

void printJson(const nlohmann::json& value) {
    print(jsonText(value));
}

// Names in a foreign file may have any encoding; JSON is UTF-8.
std::string jsonText(const nlohmann::json& value) {
    return value.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace tread::program
