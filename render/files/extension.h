#pragma once

#include <filesystem>
#include <string>

namespace vitrine::render {

/// ".png" for "Picture.PNG"; empty when there is none. ASCII letters only.
[[nodiscard]] inline std::string lowerExtension(const std::filesystem::path& file)
{
    std::string extension = file.extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
}

}  // namespace vitrine::render
