#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace vitrine::app {

/// Sentence on what was typed wrongly, with the command and, where one is near, the option or command that was meant.
/// `parser` is the one that threw the error, with what it has read.
[[nodiscard]] std::string usageError(const CLI::App& parser, const CLI::ParseError&);

}  // namespace vitrine::app
