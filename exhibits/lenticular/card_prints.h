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

/// The card's views as its texture needs them: sRGB codes, red, green and blue; row 0 at the top. All have the same
/// height; widths differ.
struct CardViews {
    struct View {
        int width = 0;
        std::vector<std::uint8_t> codes{};  ///< 3 * width * height.
    };
    int height = 0;
    std::vector<View> views{};

    [[nodiscard]] int count() const { return static_cast<int>(views.size()); }
};

/// What lies in the card: views, or the raster of a printed file with its description.
struct CardSource {
    double aspect = 1.5;  ///< Width over height.
    int available = 0;    ///< Views in the files; 0 for a raster, where their number is settled.
    CardViews views{};
    std::shared_ptr<const render::Texture> raster{};  ///< Null for views.
    PrintSettings print{};                            ///< Of the raster.
    glm::ivec2 rasterSize{0};                         ///< Pixels across the lenses and along them.
    double lenses = 0;                                ///< Across the raster.
    bool lying = false;                               ///< The raster's lenses are horizontal.
    std::string doubt{};                              ///< `PrintRaster::doubt`.
};

/// One of the card's two prints, as read from files.
struct CardPrint {
    std::shared_ptr<const CardSource> source;  ///< Null where not even the shipped set can be read.
    std::string failure;  ///< Why it is not what was asked for, one full sentence; empty when it is.
};

/// Reads `path`: a folder of views, a printed file with its JSON beside it or inside, or a single picture; empty for
/// the shipped set of that face. Of the views `count` are taken, evenly. What cannot be read or shown is replaced by
/// the shipped set.
[[nodiscard]] CardPrint cardPrint(render::AssetStore&, CardFace, const std::string& path, int count);

/// The views as an array of sRGB pictures. With `columns` > 0 and fewer than the views have texels across the lenses,
/// each texel across is the mean over one of `columns` lenses, the middle one in the middle of the picture, `lenses` of
/// which span it: no more can be seen, and less would alias. Null where memory does not hold them.
[[nodiscard]] std::shared_ptr<const render::Texture>
viewTexture(render::AssetStore&, const std::shared_ptr<const CardSource>&, int columns, double lenses, bool lying);

/// The name of the folder, under the assets, of the shipped views of a face.
[[nodiscard]] const char* shippedViews(CardFace);

}  // namespace vitrine::lenticular
