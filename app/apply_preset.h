#pragma once

#include "app/picture_options.h"

#include <string>

namespace vitrine::app {

/// Reads a preset of the subject, an exhibition, or the preset inside a PNG or OpenEXR picture into the look.
/// Throws Failure naming file, line and key; the look is then unchanged.
/// A shipped preset of the subject may be given by its name: "old-gold".
void applyPreset(const Museum&, const std::string& given, RequestedPicture&);

}  // namespace vitrine::app
