#pragma once

#include <QString>

#include <exception>

namespace vitrine::ui {

/// What the window says about something that was thrown: a Failure's own sentence, or what another exception means to
/// the visitor.
[[nodiscard]] QString messageOf(const std::exception&);

}  // namespace vitrine::ui
