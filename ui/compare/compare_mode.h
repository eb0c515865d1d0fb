#pragma once

#include <array>
#include <cstdint>

namespace vitrine::ui {

/// Mode of showing A and B together. In every mode, and in `off`, B is shown alone while its key is held down.
enum class CompareMode : std::uint8_t { off, wipe, sideBySide, flicker, flip, signedDifference };
inline constexpr std::array compareModes{CompareMode::wipe, CompareMode::sideBySide, CompareMode::flicker,
                                         CompareMode::flip, CompareMode::signedDifference};

[[nodiscard]] constexpr bool isDifference(CompareMode mode)
{
    return mode == CompareMode::flip || mode == CompareMode::signedDifference;
}

}  // namespace vitrine::ui
