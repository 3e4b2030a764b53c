#include "command_words.h"

namespace tread::program {
namespace {

// CLI11 tells the kind of a value and what checks it as one text: "TEXT:{paper,iso}", "INT:INT in [0 - 8]".
void readType(OptionWords& words, const std::string& type) {
    words.value = type.substr(0, type.find(':'));
    const std::size_t begin = type.find(":{"), end = type.find('}');
    if (begin == std::string::npos || end == std::string::npos) return;
    words.choices = CLI::detail::split(type.substr(begin + 2, end - begin - 2), ',');
}

OptionWords wordsOf(const CLI::Option& option) {
    OptionWords words;
    for (const std::string& name : option.get_snames()) words.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) words.names.push_back("--" + name);
    words.meaning = option.get_description();
    words.required = option.get_required();
    words.repeated = option.get_items_expected_max() > 1;
    if (option.get_items_expected_max() > 0) readType(words, option.get_type_name());
    return words;
}

CommandWords commandOf(const CLI::App& app, const std::string& name) {
    CommandWords words{name, app.get_description(), {}, {}};
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_positional()) {
            OptionWords argument = wordsOf(*option);
            if (argument.names.empty()) argument.names = {option->get_name(true)};
            words.arguments.push_back(argument);
        } else {
            words.options.push_back(wordsOf(*option));
        }
    }
    return words;
}

void collect(std::vector<CommandWords>& found, const CLI::App& app, const std::string& before) {
    for (const CLI::App* command : app.get_subcommands({})) {
        const std::string name = before + command->get_name();
        found.push_back(commandOf(*command, name));
        collect(found, *command, name + " ");
    }
}

}  // namespace

std::vector<CommandWords> commandWords(const CLI::App& app) {
    std::vector<CommandWords> found;
    collect(found, app, "");
    return found;
}

std::vector<OptionWords> ownOptions(const CLI::App& app) {
    return commandOf(app, "").options;
}

}  // namespace tread::program
