#pragma once

#include "app/print/view_options.h"
#include "app/queue/shard.h"
#include "exhibits/printing/print_layout.h"
#include "render/image/picture_stream.h"

#include <string>

namespace CLI {
class App;
}

namespace vitrine::app {

/// What `print` can be told, as typed.
struct PrintOptions {
    ViewOptions views;
    PartOptions part;
    std::string chart;     ///< "pitch", "phase", "views", "rotation"; empty: a print of views.
    double chartSpan = 1;  ///< Of a pitch chart, in percent each way.
    std::string out, report;
    double lpi = 0, effectiveLpi = 0, dpi = 600, dpiY = 0;
    double widthMm = 0, heightMm = 0, bleedMm = 0;
    std::string distance = "inf";
    double visualLpi = 0, phase = 0;
    std::string direction = "vertical";
    std::string order = "normal";
    bool mirror = false;
    std::string method = "area";
    double guard = 0.25;
    double borderMm = 0, inkUm = 0;
    bool dither = false, compensate = false;
    std::string bits = "8";  ///< Or "16".
    std::string compression = "none";
    double tileMm = 0;
    std::string sheet;
    double radiusUm = 0, thicknessUm = 0, index = 1.56, conic = 0;
};

void addPrintOptions(CLI::App&, PrintOptions&);

/// Throws Failure (Blame::usage) naming an option that was given and changes nothing beside the others.
void refuseUselessOptions(const CLI::App&, const PrintOptions&);

/// The settings that the options ask for, for `views` views. Throws Failure (Blame::usage) naming the option.
[[nodiscard]] printing::PrintSettings printSettings(const PrintOptions&, int views);

[[nodiscard]] render::StreamCompression streamCompression(const std::string& name);

/// A length in millimeters, or "inf". Throws Failure (Blame::usage) naming the option.
[[nodiscard]] double distanceOf(const std::string& option, const std::string& text);

}  // namespace vitrine::app
