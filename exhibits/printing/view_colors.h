#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vitrine::printing {

/// Color space in which the views of a print are read.
struct ViewColors {
    bool keep = true;       ///< Whether codes are unchanged and the print has `profile`. Otherwise all become sRGB.
    std::string profile{};  ///< ICC profile for the print; empty for sRGB.
    std::string note{};  ///< A full sentence if views of different color spaces are converted to one; otherwise empty.
};

/// Examines the files: one profile for all is kept, different ones are converted. Throws Failure naming a file that
/// cannot be read.
[[nodiscard]] ViewColors viewColors(const std::vector<std::filesystem::path>&);

}  // namespace vitrine::printing
