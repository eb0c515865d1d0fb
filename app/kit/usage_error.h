#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace vitrine::app {

/// Returns a sentence on a usage error, with the command and, if there is a similar one, the option or command that was
/// probably meant. `parser` is the parser that threw the error.
[[nodiscard]] std::string usageError(const CLI::App& parser, const CLI::ParseError&);

/// Throws the Failure of the word that stands first among `words`, the command line without the program's name: an
/// unknown word, or an option with a wrong value. To be called when parsing threw a Failure, since the parser checks
/// values in the order in which options are declared. Returns if no option of the command fails.
void throwFirstTyped(const CLI::App& parser, const std::vector<std::string>& words);

}  // namespace vitrine::app
