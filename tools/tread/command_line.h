// Which commands the command line knows, and the options of each.
#pragma once

namespace CLI {
class App;
}

namespace tread::program {

// Once the command line is read, the command that it names runs and leaves its exit status.
void addCommands(CLI::App& app, int& status);

}  // namespace tread::program
