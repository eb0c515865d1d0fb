#include "exhibits/sprites/sprite_files.h"

#include "exhibits/pixel_art/palette.h"
#include "render/files/atomic_write.h"
#include "render/image/image_io.h"
#include "render/image/srgb.h"

#include <system_error>

namespace vitrine {
namespace {

/// "hero.png", "_normal" -> "hero_normal.png".
std::filesystem::path besides(const std::filesystem::path& out, const std::string& suffix, const char* extension)
{
    return out.parent_path() / (out.stem().string() + suffix + extension);
}

/// Writes numbers as they are, past the curve that colors are written with.
void writeCodes(const std::filesystem::path& file, render::Image image)
{
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const bool alpha = image.channels == 4 && i % 4 == 3;
        if (!alpha) image.pixels[i] = static_cast<float>(render::linearFromSrgb(static_cast<double>(image.pixels[i])));
    }
    render::writePicture(file.string(), image, render::PictureFormat::png8);
}

std::vector<Rgb8> chosenPalette(const ParameterValues& values)
{
    const SpriteTable& t = spriteTable();
    const std::string_view name =
        t.rows()[t.palette.row].choices[static_cast<std::size_t>(static_cast<int>(values[t.palette]))];
    static const PixelArtTable look;
    const auto& names = look.rows()[look.palette.row].choices;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name) {
            const auto colors = shippedPalette(static_cast<PaletteName>(i));
            return {colors.begin(), colors.end()};
        }
    return {};
}

}  // namespace

SpriteRequest spriteRequest(const ParameterValues& values, const std::string& animation)
{
    const SpriteTable& t = spriteTable();
    return {values[t.directions], values[t.frames], {values[t.width], values[t.height]}, animation};
}

std::shared_ptr<const SpriteSubject> spriteSubject(const ParameterValues& values)
{
    const std::string& file = values[spriteTable().model];
    return file.empty() ? std::make_shared<const SpriteSubject>() : std::make_shared<const SpriteSubject>(file);
}

SpriteSheet sheetOf(const std::vector<SpriteFrame>& frames, const ParameterValues& values, const std::string& animation,
                    const SpriteSubject& subject, const std::string& imageName)
{
    const SpriteTable& t = spriteTable();
    SpriteSheetOptions options;
    options.colors = values[t.colors];
    options.palette = chosenPalette(values);
    options.dither = values[t.dither];
    options.pivot = values[t.pivot];
    options.trimmed = values[t.trimmed];
    const double rate = values[t.framesPerSecond];
    options.frameSeconds = rate > 0 ? 1 / rate : subject.duration(spriteRequest(values, animation)) / values[t.frames];
    options.imageName = imageName;
    return spriteSheet(frames, options);
}

std::vector<std::filesystem::path> sheetFiles(const ParameterValues& values, const std::filesystem::path& out)
{
    const SpriteTable& t = spriteTable();
    std::vector<std::filesystem::path> files{out};
    if (values[t.normals]) files.push_back(besides(out, "_normal", ".png"));
    if (values[t.depth]) files.push_back(besides(out, "_depth", ".png"));
    if (values[t.description]) files.push_back(besides(out, "", ".json"));
    return files;
}

void writeSheet(const SpriteSheet& sheet, const ParameterValues& values, const std::filesystem::path& out)
{
    const SpriteTable& t = spriteTable();
    std::vector<std::filesystem::path> written;
    const auto write = [&](bool wanted, const std::filesystem::path& file, const auto& writing) {
        if (!wanted) return;
        writing(file);
        written.push_back(file);
    };
    try {
        write(true, out,
              [&](const auto& f) { render::writePicture(f.string(), sheet.color, render::PictureFormat::png8); });
        write(values[t.normals], besides(out, "_normal", ".png"), [&](const auto& f) { writeCodes(f, sheet.normal); });
        write(values[t.depth], besides(out, "_depth", ".png"), [&](const auto& f) { writeCodes(f, sheet.depth); });
        write(values[t.description], besides(out, "", ".json"),
              [&](const auto& f) { render::atomicWrite(f.string(), sheet.description); });
    } catch (...) {
        std::error_code ignored;
        for (const auto& file : written) std::filesystem::remove(file, ignored);
        throw;
    }
}

}  // namespace vitrine
