#include "app/kit/usage_error.h"

#include "render/failure.h"
#include "render/text/nearest_word.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <optional>

namespace vitrine::app {
namespace {

/// Returns the innermost command that was typed.
const CLI::App& typedCommand(const CLI::App& parser)
{
    const CLI::App* command = &parser;
    while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
    return *command;
}

/// Returns the command's full name: "vitrine scene check".
std::string commandName(const CLI::App& command)
{
    const CLI::App* above = command.get_parent();
    return above ? commandName(*above) + ' ' + command.get_name() : command.get_name();
}

std::vector<std::string> namesOfOptions(const CLI::App& command)
{
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        if (!option->get_group().empty())
            for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

std::vector<std::string> namesOfCommands(const CLI::App& command)
{
    std::vector<std::string> names;
    for (const CLI::App* below : command.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(below->get_name());
    return names;
}

std::string unexpected(const CLI::App& command, const std::string& word)
{
    const std::string name = commandName(command);
    if (word.starts_with('-')) {
        const std::string option = word.substr(0, word.find('='));
        return '`' + name + "` has no option " + option + didYouMean(option, namesOfOptions(command)) + " `" + name +
               " --help` lists what it has.";
    }
    const std::vector<std::string> commands = namesOfCommands(command);
    if (!commands.empty())
        return '`' + name + "` has no command \"" + word + '"' + didYouMean(word, commands) + " `" + name +
               " --help` lists what it has.";
    return '`' + name + "` takes no further argument, and \"" + word + "\" is one; `" + name +
           " --help` says what it takes.";
}

std::string missing(const CLI::App& command)
{
    const std::string name = commandName(command);
    for (const CLI::Option* option : command.get_options())
        if (option->get_required() && option->count() == 0)
            return '`' + name + "` needs " + option->get_name() + "; `" + name + " --help` says what it is.";
    return '`' + name + "` needs a command; `" + name + " --help` lists what it has.";
}

/// Returns a sentence on two options that exclude or require each other, if that is the error.
std::string together(const CLI::App& command)
{
    for (const CLI::Option* option : command.get_options()) {
        if (option->count() == 0) continue;
        for (const CLI::Option* other : option->get_needs())
            if (other->count() == 0)
                return option->get_name() + " belongs to " + other->get_name() + "; give that, too.";
        for (const CLI::Option* other : option->get_excludes())
            if (other->count() > 0)
                return option->get_name() + " and " + other->get_name() + " exclude each other; give one of them.";
    }
    return {};
}

/// A word that no command takes, and the command behind whose name it was typed.
struct UnknownWord {
    const CLI::App* command;
    std::string word;
};

std::optional<UnknownWord> firstUnknown(const CLI::App& parser)
{
    for (const CLI::App* app = &parser;; app = app->get_subcommands().front()) {
        for (const std::string& word : app->remaining())
            if (word != "--") return UnknownWord{app, word};
        if (app->get_subcommands().empty()) return std::nullopt;
    }
}

/// Returns whether the word gives the option, or is its first value if the option has no name.
bool gives(const std::string& word, const CLI::Option& option)
{
    for (const std::string& name : option.get_lnames())
        if (word == "--" + name || word.starts_with("--" + name + '=')) return true;
    for (const std::string& name : option.get_snames())
        if (word.starts_with('-' + name)) return true;
    return option.get_positional() && !option.results().empty() && word == option.results().front();
}

/// Returns the option with which the parser's message begins, or that follows `before`.
const CLI::Option* namedIn(const CLI::App& command, const std::string& message, const std::string& before = {})
{
    for (const CLI::Option* option : command.get_options())
        if (message.starts_with(before + option->get_name() + ':') ||
            message.starts_with(before + option->get_name() + " =") ||
            message.starts_with(before + option->get_name() + ' '))
            return option;
    return nullptr;
}

}  // namespace

std::string usageError(const CLI::App& parser, const CLI::ParseError& error)
{
    const CLI::App& command = typedCommand(parser);
    // A misspelled option often also causes a missing one. The unknown word is reported first, as typed.
    if (const auto unknown = firstUnknown(parser)) return unexpected(*unknown->command, unknown->word);
    if (dynamic_cast<const CLI::RequiredError*>(&error)) return missing(command);
    if (const std::string pair = together(command); !pair.empty()) return pair;
    const std::string message = error.what();
    const std::string name = commandName(command);
    if (dynamic_cast<const CLI::ConversionError*>(&error))
        if (const CLI::Option* flag = namedIn(command, message, "Could not convert: "))
            return flag->get_name() + " takes no value; leave out what stands behind it.";
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error))
        if (const CLI::Option* option = namedIn(command, message)) {
            if (option->get_items_expected_max() == 0)
                return option->get_name() + " takes no value; leave out what stands behind it.";
            if (option->count() > 1) return option->get_name() + " was given more than once; give it once.";
            return option->get_name() + " needs a value behind it; `" + name + " --help` says which.";
        }
    return '`' + name + "` cannot be run as it was typed; `" + name + " --help` says what it takes.";
}

void throwFirstTyped(const CLI::App& parser, const std::vector<std::string>& words)
{
    const auto unknown = firstUnknown(parser);
    const auto unknownAt = unknown ? std::find(words.begin(), words.end(), unknown->word) : words.end();
    for (CLI::Option* option : typedCommand(parser).parse_order()) {
        if (unknown &&
            std::none_of(words.begin(), unknownAt, [&](const std::string& word) { return gives(word, *option); }))
            break;
        try {
            option->run_callback();
        } catch (const CLI::ParseError& error) {
            throw Failure(ErrorKind::usage, usageError(parser, error));
        }
    }
    if (unknown) throw Failure(ErrorKind::usage, unexpected(*unknown->command, unknown->word));
}

}  // namespace vitrine::app
