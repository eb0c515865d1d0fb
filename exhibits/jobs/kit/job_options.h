#pragma once

#include "exhibits/framework/table/parameters.h"

#include <string>
#include <string_view>
#include <vector>

namespace vitrine::jobs {

/// Command line option for one parameter of a table, or for the neighbors of a tuple.
struct JobOption {
    std::string name;                     ///< "--size", or "model" where it is positional.
    std::vector<std::size_t> parameters;  ///< One, or those of a tuple.
    bool positional = false;
    bool mustBeGiven = false;
    bool several = false;  ///< Takes any number of words.
    int words = 1;         ///< Words that it takes: 2 for a tuple with a file, "--quilt 8x6 quilt.png".
    bool isFlag = false;   ///< A toggle: takes no word; `name` turns it on and "--no-..." off.

    /// Key in documents: "size".
    std::string key;
};

/// Returns the options for all parameters, in the order of the table.
[[nodiscard]] std::vector<JobOption> optionsOf(const Parameters&);
/// Returns the option for the parameter, out of these.
[[nodiscard]] const JobOption& optionOf(const std::vector<JobOption>&, std::size_t parameter);

/// Returns the flag that switches off: "--no-normals" for "--normals".
[[nodiscard]] std::string withoutFlag(const JobOption&);

/// Returns the type of the option's value, as help texts show it: "1..64", "own|isle", "TEXT".
[[nodiscard]] std::string typeText(const Parameters&, const JobOption&);
/// Returns the option's initial value as it would be typed; empty if it has none.
[[nodiscard]] std::string initialText(const Parameters&, const JobOption&);
/// Returns an example of the option's words: "64x64". Where it takes several, the option begins it: "--quilt 8x6
/// quilt.png".
[[nodiscard]] std::string exampleText(const Parameters&, const JobOption&);
/// Returns the option's help text with the unit of a plain number.
[[nodiscard]] std::string helpText(const Parameters&, const JobOption&);

/// Returns the value of one parameter as it is typed. `readWord` reads the same bits from it.
[[nodiscard]] std::string typedText(const ParameterInfo&, const Value&);
/// Returns the words that follow the option's name to set these values. Not for flags.
[[nodiscard]] std::vector<std::string> typedWords(const JobOption&, const ParameterValues&);

/// Parses one parameter's value from a word. Throws Failure (ErrorKind::usage) that begins with `option` if the word is
/// no value or the number is out of range.
[[nodiscard]] Value readWord(const std::string& option, const ParameterInfo&, const std::string& word);

}  // namespace vitrine::jobs
