#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace vitrine::app {

/// Returns a sentence on a usage error, with the command and, if there is a similar one, the option or command that was
/// probably meant. `parser` is the parser that threw the error.
[[nodiscard]] std::string usageError(const CLI::App& parser, const CLI::ParseError&);

}  // namespace vitrine::app
