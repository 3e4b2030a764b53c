#include "base/text/byte_limit.h"

#include <charconv>
#include <cstdlib>
#include <string_view>

#include "base/text/number_text.h"
#include "tread/problem.h"

namespace tread {

std::size_t byteLimit(const char* variable, std::size_t usual) {
    const char* const given = std::getenv(variable);
    if (!given) return usual;
    const std::string_view text(given);
    std::size_t bytes = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), bytes);
    if (error == std::errc() && end == text.data() + text.size()) return bytes;
    throw LoadError({{variable, 0, 0, "",
                      "found " + quote(text) +
                          ", expected a whole number of bytes, such as 2000000000; correct or unset this variable of "
                          "the environment"}});
}

}  // namespace tread
