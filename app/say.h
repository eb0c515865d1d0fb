#pragma once

#include <string_view>

namespace vitrine::app {

/// Prints "vitrine: ..." to standard error, the sentence in the language of the locale; in English where there is no
/// memory left to translate it.
void say(std::string_view sentence) noexcept;

/// The same in English; allocates nothing.
void sayInEnglish(std::string_view sentence) noexcept;

/// The error message when memory cannot be allocated.
inline constexpr std::string_view noMemory =
    "There was not enough memory for this; ask for a smaller size, or fewer samples or views.";

}  // namespace vitrine::app
