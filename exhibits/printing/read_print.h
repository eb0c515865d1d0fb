#pragma once

#include "exhibits/printing/print_raster.h"

#include <filesystem>

namespace vitrine::printing {

/// Opens a print made by `writePrint`: TIFF or PNG, with its description inside or beside it. For a print in tiles, any
/// of them or the name without a number may be given. Throws Failure naming the file.
[[nodiscard]] PrintRaster readPrint(const std::filesystem::path&);

}  // namespace vitrine::printing
