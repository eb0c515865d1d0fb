#include "app/jobs/typed_parameters.h"

#include <CLI/CLI.hpp>

namespace vitrine::app {

void TypedParameters::addTo(CLI::App& command, const Parameters& table)
{
    const std::vector<jobs::JobOption> options = jobs::optionsOf(table);
    words_.resize(options.size());
    for (std::size_t i = 0; i < options.size(); ++i) {
        const jobs::JobOption& option = options[i];
        const ParameterInfo& first = table.rows()[option.parameters.front()];
        const std::string help = jobs::helpText(table, option);
        if (option.isFlag) {
            // Both flags exist, because a document may have either value. The help shows only the one that changes the
            // initial value.
            const bool on = std::get<double>(first.initial) != 0;
            command.add_flag(option.name, help)->group(on ? "" : "Options");
            const std::string off = "Disable (on by default): " + help;
            command.add_flag(jobs::withoutFlag(option), off)->group(on ? "Options" : "");
            continue;
        }
        CLI::Option* added = command.add_option(option.name, words_[i], help);
        added->type_name(jobs::typeText(table, option))->default_str(jobs::initialText(table, option));
        if (option.several)
            added->take_all()->allow_extra_args(true);
        else
            // Otherwise, CLI11 would take the words of positional arguments that follow, too.
            added->expected(option.words)->allow_extra_args(false)->multi_option_policy(CLI::MultiOptionPolicy::Throw);
        // A wrong value is refused while the words are parsed, so that the first wrong word is named.
        if (!option.several && option.words == 1)
            added->each([&table, option](const std::string& word) { jobs::GivenValues(table).type(option, {word}); });
    }
}

void TypedParameters::read(const CLI::App& command, jobs::GivenValues& given) const
{
    const std::vector<jobs::JobOption>& options = given.options();
    for (std::size_t i = 0; i < options.size(); ++i) {
        const jobs::JobOption& option = options[i];
        if (!option.isFlag) {
            if (!words_[i].empty()) given.type(option, words_[i]);
            continue;
        }
        for (const bool on : {true, false}) {
            const CLI::Option* flag = command.get_option_no_throw(on ? option.name : jobs::withoutFlag(option));
            if (flag && flag->count() > 0) given.turn(option, on);
        }
    }
}

}  // namespace vitrine::app
