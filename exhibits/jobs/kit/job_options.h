#pragma once

#include "exhibits/framework/parameters.h"

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

/// The options that give all parameters, in the order of the table.
[[nodiscard]] std::vector<JobOption> optionsOf(const Parameters&);
/// The option among these that gives the parameter.
[[nodiscard]] const JobOption& optionOf(const std::vector<JobOption>&, std::size_t parameter);

/// "--no-normals" for "--normals".
[[nodiscard]] std::string withoutFlag(const JobOption&);

/// What the option takes, as help texts show it: "1..64", "own|isle", "TEXT".
[[nodiscard]] std::string typeText(const Parameters&, const JobOption&);
/// Its initial value, as it would be typed; empty: none.
[[nodiscard]] std::string initialText(const Parameters&, const JobOption&);
/// Its help text, and the units of what is typed.
[[nodiscard]] std::string helpText(const Parameters&, const JobOption&);

/// The value of one parameter as it is typed; reads back as the same bits.
[[nodiscard]] std::string typedText(const ParameterInfo&, const Value&);
/// The words behind (or, positional, in place of) the option that give its parameters these values; not for flags.
[[nodiscard]] std::vector<std::string> typedWords(const JobOption&, const ParameterValues&);

/// Reads one parameter's value from a word. Throws Failure (Blame::usage) that begins with `option`: for what is no
/// value, and for a number out of range.
[[nodiscard]] Value readWord(const std::string& option, const ParameterInfo&, const std::string& word);

}  // namespace vitrine::jobs
