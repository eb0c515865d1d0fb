#pragma once

#include "app/picture_options.h"

#include <string>

namespace vitrine::app {

/// Reads a preset of the subject, an exhibition, or the preset inside a PNG or OpenEXR picture into the look.
/// Throws Failure naming file, line and key; the look is then unchanged.
void applyPreset(const Museum&, const std::string& file, RequestedPicture&);

}  // namespace vitrine::app
