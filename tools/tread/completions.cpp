#include <fmt/format.h>

#include <algorithm>

#include "command_guide.h"
#include "command_words.h"

namespace tread::program {
namespace {

struct Words {
    std::vector<CommandWords> commands;
    std::vector<OptionWords> own;  // options of the program itself

    // Names of the commands that follow one: "" for the first word, "blind" for the second.
    std::vector<const CommandWords*> after(const std::string& name) const {
        const std::string before = name.empty() ? "" : name + " ";
        std::vector<const CommandWords*> found;
        for (const CommandWords& command : commands) {
            const bool within = command.name.starts_with(before) && command.name.size() > before.size();
            if (within && command.name.find(' ', before.size()) == std::string::npos) found.push_back(&command);
        }
        return found;
    }
    std::vector<OptionWords> optionsOf(const CommandWords& command) const {
        std::vector<OptionWords> all = command.options;
        for (const OptionWords& option : own) {
            const bool known =
                std::any_of(all.begin(), all.end(), [&](const auto& o) { return o.names == option.names; });
            if (!known && option.names.back() != "--version") all.push_back(option);
        }
        return all;
    }
};

std::string lastWord(const std::string& name) {
    return name.substr(name.rfind(' ') + 1);
}

std::string join(const std::vector<std::string>& words, const char* between = " ") {
    return fmt::format("{}", fmt::join(words, between));
}

std::string namesOf(const std::vector<const CommandWords*>& commands) {
    std::vector<std::string> names;
    for (const CommandWords* command : commands) names.push_back(lastWord(command->name));
    return join(names);
}

// Within single quotes of a shell.
std::string shellQuoted(std::string_view text) {
    std::string out = "'";
    for (const char c : text) {
        if (c == '\'') out += "'\\''";
        else out += c;
    }
    return out + "'";
}

std::vector<std::string> argumentChoices(const CommandWords& command) {
    return command.arguments.empty() ? std::vector<std::string>{} : command.arguments.front().choices;
}

// ---- bash ----

constexpr std::string_view kBashHead = R"(# bash completion of tread
_tread() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command= i
    for ((i = 1; i < COMP_CWORD; i++)); do
        case ${COMP_WORDS[i]} in
            -*) ;;
            *)
                command=${COMP_WORDS[i]}
                case $command in
)";
constexpr std::string_view kBashAfterCommand = R"(                esac
                break
                ;;
        esac
    done
    local options= choices= values=files
    case $command in
)";
constexpr std::string_view kBashTail = R"(    esac
    if [[ $values == files && $word == -* ]]; then
        COMPREPLY=($(compgen -W "$options" -- "$word"))
    elif [[ $values == folders ]]; then
        COMPREPLY=($(compgen -d -- "$word"))
    elif [[ $values == files ]]; then
        COMPREPLY=($(compgen -W "$choices" -- "$word") $(compgen -f -- "$word"))
    else
        COMPREPLY=($(compgen -W "$values" -- "$word"))
    fi
}
complete -o filenames -F _tread tread
)";

std::string bashValues(const OptionWords& option) {
    if (!option.choices.empty()) return join(option.choices);
    return option.isFolder() ? "folders" : "files";
}

std::string bashOfCommand(const Words& words, const CommandWords& command) {
    std::vector<std::string> names;
    std::string values;
    for (const OptionWords& option : words.optionsOf(command)) {
        names.insert(names.end(), option.names.begin(), option.names.end());
        if (option.value.empty()) continue;
        const std::string known = bashValues(option);
        if (known != "files")
            values += fmt::format("                {}) values={} ;;\n", join(option.names, "|"), shellQuoted(known));
    }
    std::string out =
        fmt::format("        {})\n            options={}\n", shellQuoted(command.name), shellQuoted(join(names)));
    const std::vector<std::string> choices = argumentChoices(command);
    if (!choices.empty()) out += fmt::format("            choices={}\n", shellQuoted(join(choices)));
    if (!values.empty()) out += "            case $before in\n" + values + "            esac\n";
    return out + "            ;;\n";
}

std::string bash(const Words& words) {
    std::string out(kBashHead), of_commands;
    for (const CommandWords* first : words.after("")) {
        const auto within = words.after(first->name);
        if (within.empty()) {
            of_commands += bashOfCommand(words, *first);
            continue;
        }
        out +=
            fmt::format("                    {0}) ((i + 1 < COMP_CWORD)) && command=\"{0} ${{COMP_WORDS[i+1]}}\" ;;\n",
                        first->name);
        of_commands += fmt::format("        {}) values={} ;;\n", first->name, shellQuoted(namesOf(within)));
        for (const CommandWords* second : within) of_commands += bashOfCommand(words, *second);
    }
    std::vector<std::string> first_words{namesOf(words.after(""))};
    for (const OptionWords& option : words.own) first_words.push_back(option.names.back());
    out += kBashAfterCommand;
    out += fmt::format("        '') values={} ;;\n", shellQuoted(join(first_words)));
    return out + of_commands + std::string(kBashTail);
}

// ---- zsh ----

// In a description of _arguments: within single quotes and brackets.
std::string zshText(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
        out += c == '\n' ? ' ' : c;
    }
    return out;
}

std::string zshValue(const OptionWords& option) {
    if (!option.choices.empty()) return fmt::format(":{}:({})", option.value, join(option.choices));
    return fmt::format(":{}:{}", option.value, option.isFolder() ? "_directories" : "_files");
}

std::string zshOption(const OptionWords& option) {
    const std::string value = option.value.empty() ? "" : zshValue(option);
    const std::string many = option.repeated ? "*" : "";
    std::string out;
    for (const std::string& name : option.names)
        out += " \\\n                " + shellQuoted(many + name + "[" + zshText(option.meaning) + "]" + value);
    return out;
}

std::string zshOfCommand(const Words& words, const CommandWords& command, const std::string& name) {
    std::string out = fmt::format("            {})\n                _arguments", name);
    for (const OptionWords& option : words.optionsOf(command)) out += zshOption(option);
    for (const OptionWords& argument : command.arguments) {
        const std::string many = argument.repeated ? "*" : "";
        const std::string choices =
            argument.choices.empty()
                ? "_files"
                : fmt::format("{{_values {} {}; _files}}", argument.names.front(), join(argument.choices));
        out += " \\\n                " + shellQuoted(many + ":" + zshText(argument.names.front()) + ":" + choices);
    }
    return out + "\n                ;;\n";
}

std::string zshChoice(const std::vector<const CommandWords*>& commands) {
    std::string out;
    for (const CommandWords* command : commands)
        out += "\n        " + shellQuoted(lastWord(command->name) + ":" + zshText(command->meaning));
    return out;
}

std::string zsh(const Words& words) {
    std::string out =
        "#compdef tread\n# zsh completion of tread\n\n_tread() {\n    local state line\n    local -a commands\n";
    out += "    commands=(" + zshChoice(words.after("")) + "\n    )\n";
    out += "    _arguments -C '1:command:->command' '*::argument:->argument'\n    case $state in\n";
    out += "        command) _describe command commands ;;\n        argument)\n            case $line[1] in\n";
    for (const CommandWords* first : words.after("")) {
        const auto within = words.after(first->name);
        if (within.empty()) {
            out += zshOfCommand(words, *first, first->name);
            continue;
        }
        out += fmt::format(
            "            {})\n                if ((CURRENT == 2)); then\n                    commands=({}\n"
            "                    )\n                    _describe command commands\n"
            "                else\n                    shift words; ((CURRENT--))\n"
            "                    case $words[1] in\n",
            first->name, zshChoice(within));
        for (const CommandWords* second : within) out += zshOfCommand(words, *second, lastWord(second->name));
        out += "                    esac\n                fi\n                ;;\n";
    }
    return out + "            esac\n            ;;\n    esac\n}\n\n_tread \"$@\"\n";
}

// ---- fish ----

std::string fishOption(const std::string& condition, const OptionWords& option) {
    std::string out = fmt::format("complete -c tread -n {}", shellQuoted(condition));
    for (const std::string& name : option.names)
        out += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    if (!option.choices.empty()) out += " -x -a " + shellQuoted(join(option.choices));
    else if (option.isFolder()) out += " -x -a '(__fish_complete_directories)'";
    else if (!option.value.empty()) out += " -r";
    return out + " -d " + shellQuoted(option.meaning) + "\n";
}

std::string fishOfCommand(const Words& words, const CommandWords& command) {
    const std::string name = lastWord(command.name);
    const std::string condition = "__fish_seen_subcommand_from " + name;
    std::string out;
    for (const OptionWords& option : words.optionsOf(command)) out += fishOption(condition, option);
    const std::vector<std::string> choices = argumentChoices(command);
    if (!choices.empty())
        out += fmt::format("complete -c tread -n {} -a {}\n", shellQuoted(condition), shellQuoted(join(choices)));
    return out;
}

std::string fish(const Words& words) {
    std::string out = "# fish completion of tread\n";
    const auto offer = [&](const std::string& condition, const std::vector<const CommandWords*>& commands) {
        for (const CommandWords* command : commands)
            out += fmt::format("complete -c tread -f -n {} -a {} -d {}\n", shellQuoted(condition),
                               lastWord(command->name), shellQuoted(command->meaning));
    };
    offer("__fish_use_subcommand", words.after(""));
    for (const CommandWords* first : words.after("")) {
        const auto within = words.after(first->name);
        if (within.empty()) {
            out += fishOfCommand(words, *first);
            continue;
        }
        offer(fmt::format("__fish_seen_subcommand_from {}; and not __fish_seen_subcommand_from {}", first->name,
                          namesOf(within)),
              within);
        for (const CommandWords* second : within) out += fishOfCommand(words, *second);
    }
    return out;
}

}  // namespace

std::string completions(const CLI::App& app, std::string_view shell) {
    const Words words{commandWords(app), ownOptions(app)};
    if (shell == "bash") return bash(words);
    if (shell == "zsh") return zsh(words);
    return fish(words);
}

}  // namespace tread::program
