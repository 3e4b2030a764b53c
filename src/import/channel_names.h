// Names of channels that a mapping gives: which are tread's own, which are free, and which were mistyped.
#pragma once

#include <string>
#include <string_view>

namespace tread {

// Small letters, digits, _ and dots, with the word for a further source behind @.
bool isChannelName(std::string_view name);

// Why the name cannot be meant: it is nearly that of a channel of tread, or lies where tread has another set of names.
// Empty for the channels of tread, for names of one's own and for what is no name of a channel at all.
std::string misspelling(const std::string& name);

}  // namespace tread
