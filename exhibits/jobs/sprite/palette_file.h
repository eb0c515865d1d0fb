#pragma once

#include "exhibits/pixel_art/palette.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::jobs {

/// Forms of a palette's file. `gpl`: GIMP. `hex`: Lospec, a color per line. `pal`: Paint Shop Pro (JASC).
enum class PaletteFormat { gpl, hex, pal };

/// Returns "gpl hex pal" and the endings of all readable pictures.
[[nodiscard]] std::string_view paletteEndings();

/// Reads the colors of a palette's file or of a picture, in the order of the file. Of a picture: its different colors
/// by first appearance, without fully transparent pixels, or its 256 main colors if it has more. Throws Failure
/// (ErrorKind::file) naming file and line if it is not of its form, or has no color or more than 256.
[[nodiscard]] std::vector<pixel_art::Rgb8> readPalette(const std::filesystem::path&);

/// Returns the text of a palette's file. `name` is the title in a .gpl.
[[nodiscard]] std::string paletteText(PaletteFormat, const std::vector<pixel_art::Rgb8>&, const std::string& name);

}  // namespace vitrine::jobs
