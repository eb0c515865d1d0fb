#pragma once

#include "render/image/profile_conversion.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vitrine::printing {

/// Colors that a printer makes of a print: its profile is applied and taken back.
class SoftProof {
public:
    /// `views`: ICC profile of the codes before; empty: sRGB. Throws Failure like `render::ProfileConversion`.
    SoftProof(const std::string& views, const std::string& printer, render::ConversionSettings settings)
        : to_(views, printer, {settings.intent, settings.blackPoint, 8}),
          back_(printer, views, {render::RenderingIntent::relative, settings.blackPoint, 8})
    {
    }

    /// Changes 8-bit codes of red, green and blue.
    void apply(std::vector<std::uint8_t>& rgb) const
    {
        std::vector<std::uint8_t> printed(rgb.size() / 3 * static_cast<std::size_t>(to_.channels()));
        to_.apply(rgb.data(), printed.data(), rgb.size() / 3);
        back_.apply(printed.data(), rgb.data(), rgb.size() / 3);
    }

private:
    render::ProfileConversion to_, back_;
};

}  // namespace vitrine::printing
