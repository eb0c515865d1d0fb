#pragma once

#include <QString>

#include <exception>

namespace vitrine::ui {

/// Returns the sentence that the window shows for an exception: a Failure's own, or an explanation of another
/// exception.
[[nodiscard]] QString messageOf(const std::exception&);

}  // namespace vitrine::ui
