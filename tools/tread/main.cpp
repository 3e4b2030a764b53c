// The program `tread`: reads the command line, runs one command, and turns every failure into one message and an exit
// status.

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "base/threads/keep_memory.h"
#include "command_line.h"
#include "commands.h"
#include "output.h"
#include "tread/problem.h"

namespace tread::program {
namespace {

// ---- Messages for an invalid command line ----

std::vector<std::string_view> commandNames(const CLI::App& app) {
    std::vector<std::string_view> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    return names;
}

// For a mistyped command CLI11 2.1 only reports that a command is required.
bool isCommand(const CLI::App& app, std::string_view word) {
    for (const std::string_view name : commandNames(app)) {
        if (name == word) return true;
    }
    return false;
}

std::string unknownCommand(const CLI::App& app, std::string_view word) {
    const std::vector<std::string_view> names = commandNames(app);
    return "there is no command " + quote(word) + ", only " + listed(names) + didYouMean(word, names);
}

// The first option that the command does not have, with a suggestion; empty when it has all of them.
std::string unknownOption(const CLI::App& command, const std::vector<std::string>& remaining) {
    std::vector<std::string> options;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
    }
    const std::vector<std::string_view> names(options.begin(), options.end());
    for (const std::string& word : remaining) {
        const std::string option = word.substr(0, word.find('='));
        if (word.size() > 1 && word.front() == '-')
            return "there is no option " + quote(option) + didYouMean(option, names);
    }
    return {};
}

int refuse(const CLI::App& app, const CLI::ParseError& error) {
    const std::vector<const CLI::App*> called =
        app.get_subcommands([](const CLI::App* command) { return command->parsed(); });
    const CLI::App& command = called.empty() ? app : *called.front();
    const std::string name = called.empty() ? "tread" : "tread " + command.get_name();
    const std::vector<std::string> remaining = app.remaining(true);
    std::string fault = unknownOption(command, remaining);
    if (fault.empty() && !remaining.empty()) fault = "unexpected argument " + quote(remaining.front());
    if (fault.empty()) fault = error.what();
    std::fprintf(stderr, "%s: %s (`%s --help` shows its usage)\n", name.c_str(), fault.c_str(), name.c_str());
    return kBadInput;
}

int dispatch(int argc, char** argv) {
    CLI::App app{"full-vehicle simulator on Delft Tyre 97 tyres and Bullet, driven by YAML files", "tread"};
    app.set_version_flag("--version", std::string("tread ") + TREAD_VERSION);
    app.require_subcommand(1);

    int status = kYes;
    addCommands(app, status);

    if (argc < 2) {
        std::fputs(app.help().c_str(), stderr);
        return kBadInput;
    }
    if (argv[1][0] != '-' && !isCommand(app, argv[1])) {
        std::fprintf(stderr, "tread: %s\n", unknownCommand(app, argv[1]).c_str());
        return kBadInput;
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help_or_version) {
        std::ostringstream out;
        app.exit(help_or_version, out);
        print(out.str());
    } catch (const CLI::ParseError& error) {
        return refuse(app, error);
    }
    return status;
}

}  // namespace
}  // namespace tread::program

int main(int argc, char** argv) {
    tread::keepMemory();
    std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is then reported by the write that fails
    try {
        return tread::program::dispatch(argc, argv);
    } catch (const tread::LoadError& error) {
        std::fprintf(stderr, "%s\n", error.what());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "tread: %s\n", error.what());
    }
    return tread::program::kBadInput;
}
