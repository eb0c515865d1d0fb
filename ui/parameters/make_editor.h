#pragma once

#include "ui/parameters/value_editor.h"

namespace vitrine::ui {

/// Makes the editor for the parameter's kind.
[[nodiscard]] ValueEditor* makeEditor(const ValueRef&, QWidget* parent);

}  // namespace vitrine::ui
