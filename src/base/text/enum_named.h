// Values of an enumeration by name, as written on a command line or in a file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "tread/problem.h"

namespace tread {

// Throws LoadError that lists the valid names. `what`: meaning of the value, for the message.
template <class Enum>
Enum enumNamed(std::string_view name, const std::string& what) {
    constexpr auto kNames = enumNames(Enum{});
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        if (kNames[i] == name) return static_cast<Enum>(i);
    }
    const std::vector<std::string_view> known(kNames.begin(), kNames.end());
    throw LoadError(
        {{"", 0, 0, "",
          "found " + what + " " + quote(name) + ", expected one of " + listed(known) + didYouMean(name, known)}});
}

}  // namespace tread
