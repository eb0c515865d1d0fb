#include "exhibits/lenticular/card_prints.h"

#include "exhibits/printing/read_print.h"
#include "exhibits/printing/sheet.h"
#include "exhibits/printing/view_files.h"
#include "exhibits/printing/view_set.h"
#include "render/failure.h"
#include "render/files/assets.h"
#include "render/image/image_io.h"
#include "render/image/picture_stream.h"
#include "render/image/srgb.h"
#include "render/scene/held_bytes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <filesystem>
#include <future>

namespace vitrine::lenticular {
namespace {

namespace fs = std::filesystem;

constexpr double mostTexels = 40e6;  ///< Limit for all views together: 160 MB, and a third more for mip levels.
constexpr int mostAcross = 16384;    ///< Limit for pixels of a raster, which every OpenGL 4.5 supports.
constexpr int mostRows = 4096;       ///< Limit for rows; a raster with its smaller levels has twice as many.

/// Returns the means of blocks of `factor` x `factor` pixels.
render::Image shrunk(const render::Image& image, int factor)
{
    if (factor <= 1) return image;
    render::Image small(std::max(image.width / factor, 1), std::max(image.height / factor, 1), image.channels);
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x)
            for (int c = 0; c < image.channels; ++c) {
                float sum = 0;
                int count = 0;
                for (int j = y * factor; j < std::min((y + 1) * factor, image.height); ++j)
                    for (int i = x * factor; i < std::min((x + 1) * factor, image.width); ++i, ++count)
                        sum += image.at(i, j, c);
                small.at(x, y, c) = sum / static_cast<float>(std::max(count, 1));
            }
    return small;
}

std::uint8_t srgb8FromLinear16(std::uint16_t linear)
{
    static const std::vector<std::uint8_t> codes = [] {
        std::vector<std::uint8_t> table(65536);
        for (std::size_t i = 0; i < table.size(); ++i)
            table[i] = render::srgb8FromLinear(static_cast<float>(i) / 65535);
        return table;
    }();
    return codes[linear];
}

/// Converts views to 8-bit codes. The interlacer's 16 bits of linear light are more than the texture can show.
CardViews codesOf(const printing::ViewSet& set)
{
    CardViews out;
    out.height = set.height();
    for (int k = 0; k < set.count(); ++k) {
        CardViews::View view{set.view(k).width};
        view.codes.reserve(3 * static_cast<std::size_t>(view.width) * static_cast<std::size_t>(out.height));
        for (int y = 0; y < out.height; ++y) {
            const std::uint16_t* row = set.row(k, y);
            for (int x = 0; x < view.width; ++x)
                for (int c = 0; c < 3; ++c) view.codes.push_back(srgb8FromLinear16(row[3 * x + c]));
        }
        out.views.push_back(std::move(view));
    }
    return out;
}

void readInto(CardSource& source, const std::vector<fs::path>& files, int count)
{
    const int available = static_cast<int>(files.size());
    const int taken = std::clamp(count, 1, available);
    printing::ViewSet views;
    // Takes the centers of equal parts of the sequence. The next view is read while one is resampled.
    const auto reading = [&](int i) {
        const auto at = static_cast<std::size_t>((i + 0.5) * available / taken);
        return std::async(std::launch::async, [file = files[at]] { return render::readColor(file); });
    };
    std::future<render::Image> next = reading(0);
    for (int i = 0; i < taken; ++i) {
        const render::Image image = next.get();
        if (i + 1 < taken) next = reading(i + 1);
        const double texels = static_cast<double>(image.width) * image.height * taken;
        views.add(shrunk(image, static_cast<int>(std::ceil(std::sqrt(texels / mostTexels)))));
        if (i == 0) source.aspect = static_cast<double>(image.width) / image.height;
    }
    source.views = codesOf(views);
}

/// Returns whether a file is a picture without a description by vitrine print, and therefore a view.
bool isPlainPicture(const fs::path& file)
{
    std::error_code error;
    return fs::is_regular_file(file, error) && !fs::exists(file.string() + ".json", error) &&
           !render::embeddedPrint(file);
}

[[noreturn]] void refuse(const fs::path& file, const std::string& why)
{
    throw Failure(ErrorKind::file, "The card cannot show " + file.string() + ": " + why);
}

/// Returns the raster as the shader reads it: columns across the lenses, rows along them. Below it are its smaller
/// levels, halved only along the lenses, so no column mixes with its neighbor.
std::shared_ptr<const render::Texture> stacked(const render::Image& raster, glm::ivec2 size, bool lying, bool mirror)
{
    auto texture = std::make_shared<render::Texture>();
    texture->name = "lenticular raster";
    texture->width = size.x;
    texture->sRgb = true;
    texture->repeat = false;
    texture->mipmaps = false;
    const auto gray = raster.channels < 3;
    std::vector<float> level(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * 3);
    const int rows = lying ? raster.width : raster.height;
    for (int y = 0; y < size.y; ++y) {
        const int first = static_cast<int>(static_cast<std::int64_t>(y) * rows / size.y);
        const int last = std::max(first + 1, static_cast<int>(static_cast<std::int64_t>(y + 1) * rows / size.y));
        for (int x = 0; x < size.x; ++x) {
            for (int c = 0; c < 3; ++c) {
                float sum = 0;
                for (int r = first; r < last; ++r) {
                    int column = lying ? raster.width - 1 - r : x;
                    if (mirror) column = raster.width - 1 - column;
                    sum += raster.at(column, lying ? x : r, gray ? 0 : c);
                }
                level[(static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x)) *
                          3 +
                      static_cast<std::size_t>(c)] = sum / static_cast<float>(last - first);
            }
        }
    }
    for (int height = size.y;; height = (height + 1) / 2) {
        for (std::size_t i = 0; i < level.size(); i += 3) {
            for (std::size_t c = 0; c < 3; ++c) texture->bytes.push_back(render::srgb8FromLinear(level[i + c]));
            texture->bytes.push_back(255);
        }
        texture->height += height;
        if (height == 1) break;
        const std::size_t row = static_cast<std::size_t>(size.x) * 3;
        std::vector<float> half(row * static_cast<std::size_t>((height + 1) / 2));
        for (std::size_t y = 0; y < static_cast<std::size_t>((height + 1) / 2); ++y) {
            const std::size_t next = std::min(2 * y + 1, static_cast<std::size_t>(height - 1));
            for (std::size_t i = 0; i < row; ++i)
                half[y * row + i] = 0.5F * (level[2 * y * row + i] + level[next * row + i]);
        }
        level = std::move(half);
    }
    return texture;
}

void readRaster(CardSource& source, const fs::path& file)
{
    printing::PrintRaster print = printing::readPrint(file);
    const printing::PrintLayout& layout = print.layout();
    source.print = layout.settings();
    source.doubt = print.doubt();
    source.lying = layout.lensesPerPixelX() == 0;
    if (!source.lying && !layout.vertical())
        refuse(file, "its lenses are slanted, and the card's are upright or level; look at it with vitrine proof.");
    const render::Image raster = print.image();
    const int acrossPixels = source.lying ? raster.height : raster.width;
    if (acrossPixels > mostAcross)
        refuse(file, "it is " + std::to_string(acrossPixels) + " pixels wide across its lenses, and at most " +
                         std::to_string(mostAcross) + " are possible.");
    source.rasterSize = {acrossPixels, std::min(source.lying ? raster.width : raster.height, mostRows)};
    source.lenses = acrossPixels / (source.lying ? source.print.dpiY : source.print.dpiX) * printing::mmPerInch /
                    source.print.sheet.pitch();
    source.aspect = (raster.width / source.print.dpiX) / (raster.height / source.print.dpiY);
    source.raster = stacked(raster, source.rasterSize, source.lying, source.print.mirror);
}

/// Files of the views at a path; none if the path is a printed raster.
struct CardFiles {
    std::vector<fs::path> views;
};

render::AssetStore::Made<CardFiles> listFiles(const std::string& name)
{
    auto found = std::make_shared<CardFiles>();
    std::error_code error;
    if (fs::is_directory(name, error) || isPlainPicture(name)) found->views = printing::viewFiles({name});
    const std::uint64_t bytes = found->views.size() * 128;
    return {std::move(found), bytes};
}

render::AssetStore::Made<CardSource> readSource(const std::string& name, const std::vector<fs::path>& views, int count)
{
    auto source = std::make_shared<CardSource>();
    source->available = static_cast<int>(views.size());
    if (views.empty())
        readRaster(*source, name);
    else
        readInto(*source, views, count);
    std::uint64_t bytes = source->raster ? heldBytes(*source->raster) : 0;
    for (const CardViews::View& view : source->views.views) bytes += view.codes.size();
    return {std::move(source), bytes};
}

/// Returns the source at a path. For a raster, or if there are fewer views than `count`, all counts share one source.
render::Asset<CardSource> sourceOf(render::AssetStore& assets, const std::string& use, const std::string& name,
                                   int count)
{
    const render::Asset<CardFiles> files = assets.get<CardFiles>(use + ", files", name, listFiles);
    if (!files.value) return {nullptr, files.failure};
    const std::vector<fs::path>& views = files.value->views;
    const int taken = views.empty() ? 0 : std::clamp(count, 1, static_cast<int>(views.size()));
    return assets.get<CardSource>(
        use, name, [&](const std::string& file) { return readSource(file, views, taken); },
        static_cast<std::uint64_t>(taken));
}

/// Returns the extent of column `column` of `columns` in a picture of `texels` across, which `lenses` span.
std::pair<double, double> spanOf(int column, int columns, double lenses, int texels)
{
    const double lens = column - (columns - 1) / 2;
    const double from = ((lens - 0.5) / lenses + 0.5) * texels;
    const double to = ((lens + 0.5) / lenses + 0.5) * texels;
    const double low = std::clamp(from, 0.0, texels - 1e-3);
    return {low, std::clamp(to, low + 1e-3, static_cast<double>(texels))};
}

int widest(const CardViews& views)
{
    int width = 1;
    for (const CardViews::View& view : views.views) width = std::max(width, view.width);
    return width;
}

std::shared_ptr<const render::Texture> viewsAsTexture(const CardViews& views, int columns, double lenses, bool lying)
{
    const int width = widest(views);
    std::array<double, 256> linear{};
    for (std::size_t code = 0; code < linear.size(); ++code)
        linear[code] = render::linearFromSrgb(static_cast<double>(code) / 255);
    auto texture = std::make_shared<render::Texture>();
    texture->name = "lenticular views";
    texture->width = lying || columns == 0 ? width : columns;
    texture->height = lying && columns > 0 ? columns : views.height;
    // The shader needs an array, which a single layer would not be.
    texture->layers = std::max(views.count(), 2);
    texture->sRgb = true;
    texture->repeat = false;
    texture->bytes.reserve(static_cast<std::size_t>(texture->width) * static_cast<std::size_t>(texture->height) * 4 *
                           static_cast<std::size_t>(texture->layers));
    for (int layer = 0; layer < texture->layers; ++layer) {
        const int k = std::min(layer, views.count() - 1);
        const auto& [ownWidth, codes] = views.views[static_cast<std::size_t>(k)];
        for (int y = 0; y < texture->height; ++y) {
            const auto [top, bottom] =
                lying && columns > 0 ? spanOf(y, columns, lenses, views.height) : std::pair<double, double>(y, y + 1);
            for (int x = 0; x < texture->width; ++x) {
                const auto [left, right] = !lying && columns > 0
                                               ? spanOf(x, columns, lenses, ownWidth)
                                               : std::pair<double, double>(static_cast<double>(x) * ownWidth / width,
                                                                           (x + 1.0) * ownWidth / width);
                double sum[3] = {0, 0, 0};
                for (int j = static_cast<int>(top); j < bottom; ++j) {
                    const double high = std::min<double>(bottom, j + 1) - std::max<double>(top, j);
                    const std::uint8_t* row =
                        codes.data() + 3 * static_cast<std::size_t>(j) * static_cast<std::size_t>(ownWidth);
                    for (int i = static_cast<int>(left); i < right; ++i) {
                        const double share = high * (std::min<double>(right, i + 1) - std::max<double>(left, i));
                        for (int c = 0; c < 3; ++c) sum[c] += share * linear[row[3 * i + c]];
                    }
                }
                const double area = (bottom - top) * (right - left);
                for (const double channel : sum)
                    texture->bytes.push_back(render::srgb8FromLinear(static_cast<float>(channel / area)));
                texture->bytes.push_back(255);
            }
        }
    }
    return texture;
}

}  // namespace

const char* shippedViews(CardFace face)
{
    return face == CardFace::front ? "turning_mug" : "melting_torus";
}

CardPrint cardPrint(render::AssetStore& assets, CardFace face, const std::string& path, int count)
{
    const std::string use = face == CardFace::front ? "lenticular.frontPrint" : "lenticular.backPrint";
    CardPrint print;
    if (!path.empty()) {
        render::Asset<CardSource> found = sourceOf(assets, use, path, count);
        print = {std::move(found.value), std::move(found.failure)};
        if (print.source) return print;
    }
    render::Asset<CardSource> shipped =
        sourceOf(assets, use + ", shipped", render::asset("frames").append(shippedViews(face)).string(), count);
    print.source = std::move(shipped.value);
    if (!print.source) print.failure = std::move(shipped.failure);
    return print;
}

std::shared_ptr<const render::Texture> viewTexture(render::AssetStore& assets,
                                                   const std::shared_ptr<const CardSource>& source, int columns,
                                                   double lenses, bool lying)
{
    const int texels = lying ? source->views.height : widest(source->views);
    if (columns >= texels) columns = 0;
    if (columns == 0) lenses = 0;
    const std::string key =
        std::to_string(columns) + ' ' + std::to_string(std::bit_cast<std::uint64_t>(lenses)) + (lying ? " lying" : "");
    return assets
        .made<render::Texture>(
            "lenticular.views", key,
            [&] {
                auto texture = viewsAsTexture(source->views, columns, lenses, lying);
                const std::uint64_t bytes = heldBytes(*texture);
                return render::AssetStore::Made<render::Texture>{std::move(texture), bytes};
            },
            source)
        .value;
}

}  // namespace vitrine::lenticular
