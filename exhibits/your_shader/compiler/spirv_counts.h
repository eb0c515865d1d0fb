#pragma once

#include "exhibits/your_shader/compiler/protocol.h"

#include <cstdint>
#include <span>

namespace vitrine::guest {

/// Counts what one stage costs at most. Functions that are never called do not count.
[[nodiscard]] ProgramCounts spirvCounts(std::span<const std::uint32_t> words);

}  // namespace vitrine::guest
