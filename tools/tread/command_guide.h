// What tells a user of the commands outside of the program: its man page, and the completions of the shells. All of it
// is made of the command line's own description.
#pragma once

#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace tread::program {

// In the language of man(1), section 1.
std::string manPage(const CLI::App& app);

// For "bash", "zsh" or "fish".
std::string completions(const CLI::App& app, std::string_view shell);

}  // namespace tread::program
