#pragma once

#include "render/text/message.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace vitrine::guest {

/// Returns the value of an input, or nothing for an unknown name.
using InputValue = std::function<std::optional<double>(std::string_view name)>;

/// Size of a pass in pixels, or the reason why there is none; a sentence part without its full stop.
struct PassSize {
    int pixels = 0;
    Message problem;
};

/// Evaluates the width or height of an ISF pass: numbers, + - * /, parentheses, floor, min, max and other
/// functions of expressions, `$WIDTH`, `$HEIGHT`, and `$name` of an input. The result is rounded down and at least 1.
/// An empty text gives `whole`, the size of the picture in this direction.
[[nodiscard]] PassSize passSize(std::string_view text, int width, int height, int whole, const InputValue&);

}  // namespace vitrine::guest
