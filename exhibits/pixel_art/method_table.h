#pragma once

#include "exhibits/framework/table/measured_table.h"
#include "exhibits/pixel_art/palette.h"
#include "exhibits/pixel_art/small_world.h"

#include <map>
#include <string>
#include <vector>

namespace vitrine::pixel_art {

/// Errors of normals from depth relative to the drawn ones (degrees, and percent of the visible texels), and the cost
/// of passes.
struct NormalErrors {
    double mean = 0, p99 = 0, beyond5 = 0, beyond20 = 0;
    std::map<std::string, double> milliseconds;  ///< Median of each pass; negative if the backend times no steps.
};

/// Draws a picture with these values once to warm up, and `runs` times to measure it.
[[nodiscard]] NormalErrors measureNormals(render::RenderBackend&, const ParameterValues&, const std::vector<WorldPart>&,
                                          const PaletteTextures*, int runs);

/// Comparison of all methods over scenes, sizes and depth buffers, in perspective.
class MethodTable final : public TableMeasurement {
public:
    struct Scene {
        std::string name;
        std::vector<WorldPart> parts;
    };
    struct Picture {
        PixelResolution resolution;
        DepthBits bits;
    };
    MethodTable(std::vector<Scene>, std::vector<Picture>, int runs);
    /// Returns the table for the test scene, thin bars, the isle, and the model of these values if they name one.
    /// Widths are 240 to 1920 texels with 32-bit depth, and 480 with 24 and 16 bits. Throws Failure if the model cannot
    /// be read.
    [[nodiscard]] static MethodTable all(const ParameterValues&);

    bool step(render::RenderBackend&) override;
    /// Returns the share of the texels that are drawn.
    [[nodiscard]] double progress() const override;
    [[nodiscard]] const std::vector<std::vector<std::string>>& lines() const override { return lines_; }
    [[nodiscard]] std::size_t expectedLines() const override { return scenes_.size() * eachScene(); }

private:
    [[nodiscard]] std::size_t eachScene() const;  ///< Number of lines of each scene.
    /// Returns the work of the first lines of a scene; 1: that of a picture of a million texels.
    [[nodiscard]] double work(std::size_t lines) const;

    std::vector<Scene> scenes_;
    std::vector<Picture> pictures_;
    int runs_;
    std::size_t done_ = 0;
    std::vector<std::vector<std::string>> lines_;
};

}  // namespace vitrine::pixel_art
