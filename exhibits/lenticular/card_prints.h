#pragma once

#include "exhibits/lenticular/lenticular_table.h"
#include "exhibits/printing/print_layout.h"
#include "render/files/asset_store.h"
#include "render/scene/mesh.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::lenticular {

using printing::PrintSettings;

/// Views of the card as its texture needs them: sRGB codes, red, green and blue; row 0 at the top. All have the same
/// height, but their widths may differ.
struct CardViews {
    struct View {
        int width = 0;
        std::vector<std::uint8_t> codes{};  ///< 3 * width * height.
    };
    int height = 0;
    std::vector<View> views{};

    [[nodiscard]] int count() const { return static_cast<int>(views.size()); }
};

/// Source of one print of the card: views, or the raster of a printed file with its description.
struct CardSource {
    double aspect = 1.5;  ///< Width over height.
    int available = 0;    ///< Number of views in the files; 0 for a raster, in which it is fixed.
    CardViews views{};
    std::shared_ptr<const render::Texture> raster{};  ///< Null for views.
    PrintSettings print{};                            ///< Description of the raster.
    glm::ivec2 rasterSize{0};                         ///< Pixels across the lenses and along them.
    double lenses = 0;                                ///< Number of lenses across the raster.
    bool lying = false;                               ///< Whether the raster's lenses are horizontal.
    std::string doubt{};                              ///< `PrintRaster::doubt`.
};

/// One of the card's two prints, as read from files.
struct CardPrint {
    std::shared_ptr<const CardSource> source;  ///< Null if not even the shipped set can be read.
    Message failure;  ///< Why it is not the print at the given path, one full sentence; empty if it is.
};

/// Reads `path`: a folder of views, a printed file with its JSON beside it or embedded, or a single picture. An empty
/// path means the shipped set of that face. `count` of the views are selected, evenly spaced. The shipped set replaces
/// what cannot be read or shown.
[[nodiscard]] CardPrint cardPrint(render::AssetStore&, CardFace, const std::string& path, int count);

/// Returns the views as an array of sRGB pictures; null if there is not enough memory. If `columns` is above 0 and
/// below the texels of the views across the lenses, each texel across is the mean over one lens. The center one of the
/// `columns` lenses is in the center of the picture, which `lenses` of them span. More detail is invisible, and less
/// filtering would alias.
[[nodiscard]] std::shared_ptr<const render::Texture>
viewTexture(render::AssetStore&, const std::shared_ptr<const CardSource>&, int columns, double lenses, bool lying);

/// Returns the name of the folder of a face's shipped views, under the assets.
[[nodiscard]] const char* shippedViews(CardFace);

}  // namespace vitrine::lenticular
