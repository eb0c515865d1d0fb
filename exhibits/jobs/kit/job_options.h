#pragma once

#include "exhibits/framework/table/parameters.h"

#include <string>
#include <string_view>
#include <vector>

namespace vitrine::jobs {

/// Option of the command line that gives one parameter of a table, or the neighbors of a tuple.
struct JobOption {
    std::string name;                     ///< "--size", or "model" where it is positional.
    std::vector<std::size_t> parameters;  ///< One, or those of a tuple.
    bool positional = false;
    bool mustBeGiven = false;
    bool several = false;  ///< Takes any number of words.
    bool isFlag = false;   ///< A toggle: takes no word; `name` turns it on and "--no-..." off.

    /// "size": its key in documents.
    std::string key;
};

/// Returns the options that give all parameters, in the order of the table.
[[nodiscard]] std::vector<JobOption> optionsOf(const Parameters&);
/// Returns the option among these that gives the parameter.
[[nodiscard]] const JobOption& optionOf(const std::vector<JobOption>&, std::size_t parameter);

/// "--no-normals" for "--normals".
[[nodiscard]] std::string withoutFlag(const JobOption&);

/// Returns the type of the option's value, as help texts show it: "1..64", "own|isle", "TEXT".
[[nodiscard]] std::string typeText(const Parameters&, const JobOption&);
/// Returns the option's initial value as it would be typed; empty if it has none.
[[nodiscard]] std::string initialText(const Parameters&, const JobOption&);
/// Returns the option's help text with the unit of a plain number.
[[nodiscard]] std::string helpText(const Parameters&, const JobOption&);

/// Returns the value of one parameter as it is typed. `readWord` reads the same bits from it.
[[nodiscard]] std::string typedText(const ParameterInfo&, const Value&);
/// Returns the words after the option name that give its parameters these values. Not for flags.
[[nodiscard]] std::vector<std::string> typedWords(const JobOption&, const ParameterValues&);

/// Reads one parameter's value from a word. Throws Failure (Blame::usage) that begins with `option`: for what is no
/// value, and for a number out of range.
[[nodiscard]] Value readWord(const std::string& option, const ParameterInfo&, const std::string& word);

}  // namespace vitrine::jobs
