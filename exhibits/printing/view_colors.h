#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vitrine::printing {

/// In which color space the views of a print are read.
struct ViewColors {
    bool keep = true;       ///< Codes stay as they are; the print carries `profile`. Otherwise all become sRGB.
    std::string profile{};  ///< ICC profile for the print; empty where it is sRGB.
    std::string note{};     ///< A full sentence where views of different color spaces are brought to one; else empty.
};

/// Looks into the files: one profile for all is kept, different ones are converted.
/// Throws Failure naming the file that cannot be read.
[[nodiscard]] ViewColors viewColors(const std::vector<std::filesystem::path>&);

}  // namespace vitrine::printing
