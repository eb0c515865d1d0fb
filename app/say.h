#pragma once

#include <string>

namespace vitrine::app {

/// Prints "vitrine: ..." to standard error, the sentence in the language of the locale.
void say(const std::string& sentence);

}  // namespace vitrine::app
