#pragma once

#include "exhibits/framework/measured_table.h"
#include "exhibits/pixel_art/palette.h"
#include "exhibits/pixel_art/small_world.h"

#include <map>
#include <string>
#include <vector>

namespace vitrine {

/// What normals from depth err by against the drawn ones, degrees and percent of the seen texels, and what passes cost.
struct NormalErrors {
    double mean = 0, p99 = 0, beyond5 = 0, beyond20 = 0;
    std::map<std::string, double> milliseconds;  ///< Of each pass, median; negative where the backend times no steps.
};

/// Draws a picture once to warm up and `runs` times to be timed, by these values.
[[nodiscard]] NormalErrors measureNormals(render::RenderBackend&, const ParameterValues&, const std::vector<WorldPart>&,
                                          const PaletteTextures*, int runs);

/// Every method on scenes, at sizes and with depth buffers, in perspective.
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
    /// The test scene, thin bars, the isle, and the model of these values where they name one; 240 to 1920 texels wide
    /// with 32-bit depth, 480 with 24 and 16 bits. Throws Failure where the model cannot be read.
    [[nodiscard]] static MethodTable all(const ParameterValues&);

    bool step(render::RenderBackend&) override;
    [[nodiscard]] double progress() const override;
    [[nodiscard]] std::string csv() const override { return csv_; }

private:
    std::vector<Scene> scenes_;
    std::vector<Picture> pictures_;
    int runs_;
    std::size_t done_ = 0;
    std::string csv_;
};

}  // namespace vitrine
