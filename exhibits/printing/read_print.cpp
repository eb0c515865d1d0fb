#include "exhibits/printing/read_print.h"

#include "exhibits/printing/print_description.h"
#include "exhibits/printing/print_json.h"
#include "render/image/picture_rows.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::printing {

namespace fs = std::filesystem;

namespace {

/// Splits "name-3.tif" into "name" and its number. Returns false if it has no number.
bool splitTile(const fs::path& path, std::string& stem)
{
    stem = path.stem().string();
    const std::size_t dash = stem.find_last_of('-');
    if (dash == std::string::npos || dash + 1 == stem.size() ||
        stem.find_first_not_of("0123456789", dash + 1) != std::string::npos)
        return false;
    stem.resize(dash);
    return true;
}

fs::path tileOf(const fs::path& path, const std::string& stem, std::size_t number)
{
    fs::path tile = path;
    tile.replace_filename(stem + "-" + std::to_string(number) + path.extension().string());
    return tile;
}

/// Returns how many columns each tile repeats of the one at its left, as the description says; empty: none does.
std::vector<std::int64_t> repeatedColumns(const render::JsonDocument& document)
{
    std::vector<std::int64_t> repeated;
    const render::Json report = document.root().value("report", render::Json());
    const render::Json tiles = report.is_object() ? report.value("tiles", render::Json()) : render::Json();
    if (!tiles.is_array()) return repeated;
    for (const render::Json& tile : tiles) {
        const render::Json columns = tile.is_object() ? tile.value("repeatedColumns", render::Json()) : render::Json();
        if (!columns.is_number_integer())
            throw document.failure("report.tiles", "a tile has no number of repeatedColumns; correct it there.");
        repeated.push_back(columns.get<std::int64_t>());
    }
    return repeated;
}

}  // namespace

PrintRaster readPrint(const fs::path& path)
{
    std::error_code error;
    const fs::path first = fs::exists(path, error) ? path : tileOf(path, path.stem().string(), 1);
    const fs::path named = fs::exists(first, error) ? first : path;
    PrintDescription description = printDescription(named);
    const PrintLayout layout(settingsFromJson(description.document));
    std::vector<std::int64_t> repeated;
    std::vector<fs::path> tiles{named};
    std::string stem;
    if (render::PictureRows(named).width() < layout.width() && splitTile(named, stem)) {
        tiles.clear();
        repeated = repeatedColumns(description.document);
        std::int64_t width = 0;
        for (std::size_t number = 1; width < layout.width() && fs::exists(tileOf(named, stem, number), error);
             ++number) {
            tiles.push_back(tileOf(named, stem, number));
            width += render::PictureRows(tiles.back()).width();
            if (number <= repeated.size()) width -= repeated[number - 1];
        }
        if (tiles.empty()) tiles.push_back(named);
    }
    PrintRaster raster(layout, tiles, std::move(repeated));
    raster.setDoubt(std::move(description.doubt));
    return raster;
}

}  // namespace vitrine::printing
