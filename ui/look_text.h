#pragma once

#include "ui/gallery.h"

#include <string>
#include <vector>

namespace vitrine::ui {

/// The look as the text of an exhibition: everything in one file.
[[nodiscard]] std::string textOf(const Gallery&, const Look&, const std::string& name);

/// The look in the text of an exhibition. What reading changed or did not know goes to `notes`. Throws
/// Failure naming file, line and key; `fileName` is for messages.
[[nodiscard]] Look lookFrom(const Gallery&, std::string text, std::string fileName, std::vector<std::string>& notes);

}  // namespace vitrine::ui
