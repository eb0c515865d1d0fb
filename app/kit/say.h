#pragma once

#include <string_view>

namespace vitrine {
class Failure;
}

namespace vitrine::app {

/// Prints "vitrine: ..." to standard error, translated to the locale's language. In English if there is no memory for
/// translating.
void say(std::string_view sentence) noexcept;
void say(const Failure&) noexcept;

/// Prints the same in English. Allocates nothing.
void sayInEnglish(std::string_view sentence) noexcept;

/// Error message for a failed allocation.
inline constexpr std::string_view noMemory =
    "There was not enough memory for this; ask for a smaller size, or fewer samples or views.";

}  // namespace vitrine::app
