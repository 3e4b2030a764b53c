#include <fmt/format.h>

#include "command_guide.h"
#include "command_words.h"

namespace tread::program {
namespace {

// Text that troff takes as it is: a hyphen is one that can be copied, and no line begins with a command.
std::string plain(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '\\') out += "\\e";
        else if (c == '-') out += "\\-";
        else out += c;
    }
    return !out.empty() && (out[0] == '.' || out[0] == '\'') ? "\\&" + out : out;
}

std::string callOf(const OptionWords& option) {
    std::string names;
    for (const std::string& name : option.names) names += (names.empty() ? "\\fB" : ", \\fB") + plain(name) + "\\fR";
    return option.value.empty() ? names : names + " \\fI" + plain(option.value) + "\\fR";
}

std::string entry(const OptionWords& option) {
    return fmt::format(".TP\n{}\n{}\n", callOf(option), plain(option.meaning));
}

std::string usageOf(const CommandWords& command) {
    std::string usage = fmt::format("\\fBtread {}\\fR [\\fIoptions\\fR]", plain(command.name));
    for (const OptionWords& argument : command.arguments) {
        const std::string name = "\\fI" + plain(argument.names.front()) + "\\fR" + (argument.repeated ? " ..." : "");
        usage += argument.required ? " " + name : " [" + name + "]";
    }
    return usage;
}

constexpr std::string_view kStatus =
    ".SH EXIT STATUS\n"
    ".TP\n0\nsuccess\n"
    ".TP\n1\na negative result: logs differ, a condition is not met, a diagnosis without an answer\n"
    ".TP\n2\ninvalid input: a file or an option\n"
    ".TP\n3\nthe simulation failed\n";

constexpr std::string_view kEnvironment =
    ".SH ENVIRONMENT\n.TP\n\\fBNO_COLOR\\fR\nno colours on a terminal\n.TP\n\\fBCOLUMNS\\fR\nline width when the "
    "output is not a terminal (default: 100)\n";

}  // namespace

std::string manPage(const CLI::App& app) {
    std::string page = fmt::format(".TH TREAD 1 \"\" \"tread {}\" \"User commands\"\n", TREAD_VERSION);
    page += ".SH NAME\n" + std::string("tread \\- ") + plain(app.get_description()) + "\n.SH SYNOPSIS\n";
    page += "\\fBtread\\fR \\fIcommand\\fR [\\fIoptions\\fR] [\\fIarguments\\fR]\n";
    page += ".SH OPTIONS OF ALL COMMANDS\n";
    for (const OptionWords& option : ownOptions(app)) page += entry(option);
    page += ".SH COMMANDS\n";
    for (const CommandWords& command : commandWords(app)) {
        page +=
            fmt::format(".SS tread {}\n{}\n.PP\n{}\n", plain(command.name), usageOf(command), plain(command.meaning));
        for (const OptionWords& argument : command.arguments) page += entry(argument);
        for (const OptionWords& option : command.options) page += entry(option);
    }
    return page + std::string(kStatus) + std::string(kEnvironment);
}

}  // namespace tread::program
