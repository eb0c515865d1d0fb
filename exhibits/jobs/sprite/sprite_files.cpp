#include "exhibits/jobs/sprite/sprite_files.h"

#include "exhibits/framework/files/preset.h"
#include "exhibits/pixel_art/palette.h"
#include "render/image/image_io.h"
#include "render/image/srgb.h"

namespace vitrine::jobs {
namespace {

constexpr std::int64_t longestSide = 16384;
constexpr std::int64_t mostPixels = std::int64_t{1} << 26U;  // Frames are kept as floats: 36 bytes a pixel.

/// Returns the path of a file beside the sheet: "hero.png" and "_normal" give "hero_normal.png".
std::filesystem::path besides(const std::filesystem::path& out, const std::string& suffix, const char* extension)
{
    return out.parent_path() / (out.stem().string() + suffix + extension);
}

std::string pngOf(const std::filesystem::path& file, const render::Image& image, const std::string& settings = {})
{
    return render::encodedPicture(file, image, render::PictureFormat::png8, {.preset = settings});
}

/// The same for numbers that are stored unchanged, without the sRGB curve of colors.
std::string codesOf(const std::filesystem::path& file, render::Image image)
{
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const bool alpha = image.channels == 4 && i % 4 == 3;
        if (!alpha) image.pixels[i] = static_cast<float>(render::linearFromSrgb(static_cast<double>(image.pixels[i])));
    }
    return pngOf(file, image);
}

std::vector<Rgb8> chosenPalette(const ParameterValues& values, const std::vector<Rgb8>& ofFile)
{
    const SpriteTable& t = spriteTable();
    if (values[t.palette] == SpritePalette::file) return ofFile;
    const std::string_view name =
        t.rows()[t.palette.row].choices[static_cast<std::size_t>(static_cast<int>(values[t.palette]))];
    static const pixel_art::PixelArtTable look;
    const auto& names = look.rows()[look.palette.row].choices;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name) {
            const auto colors = pixel_art::shippedPalette(static_cast<pixel_art::PaletteName>(i));
            return {colors.begin(), colors.end()};
        }
    return {};
}

/// A file of a sheet, and the function that makes its content.
struct SheetPart {
    std::filesystem::path file;
    const char* content;
    std::string (*bytesOf)(const SpriteSheet&, const std::filesystem::path&);
};

/// The palette as a file of its own.
template <PaletteFormat format> SheetPart savedPalette(const std::filesystem::path& out, const char* extension)
{
    return {besides(out, "", extension), "palette", [](const SpriteSheet& s, const std::filesystem::path& f) {
                return paletteText(format, s.palette, f.stem().string());
            }};
}

std::vector<SheetPart> sheetParts(const ParameterValues& values, const std::filesystem::path& out)
{
    const SpriteTable& t = spriteTable();
    using Path = std::filesystem::path;
    std::vector<SheetPart> parts{
        {out, "colors", [](const SpriteSheet& s, const Path& f) { return pngOf(f, s.color, s.settings); }}};
    if (values[t.normals])
        parts.push_back({besides(out, "_normal", ".png"), "normals",
                         [](const SpriteSheet& s, const Path& f) { return codesOf(f, s.normal); }});
    if (values[t.depth])
        parts.push_back({besides(out, "_depth", ".png"), "depth",
                         [](const SpriteSheet& s, const Path& f) { return codesOf(f, s.depth); }});
    if (values[t.description])
        parts.push_back({besides(out, "", ".json"), "description",
                         [](const SpriteSheet& s, const Path&) { return s.description; }});
    if (values[t.godot])
        parts.push_back(
            {besides(out, "", ".tres"), "Godot 4", [](const SpriteSheet& s, const Path&) { return s.godot; }});
    switch (values[t.savedPalette]) {
    case SpritePaletteFile::gpl: parts.push_back(savedPalette<PaletteFormat::gpl>(out, ".gpl")); break;
    case SpritePaletteFile::hex: parts.push_back(savedPalette<PaletteFormat::hex>(out, ".hex")); break;
    case SpritePaletteFile::pal: parts.push_back(savedPalette<PaletteFormat::pal>(out, ".pal")); break;
    case SpritePaletteFile::none: break;
    }
    return parts;
}

}  // namespace

SpriteRequest spriteRequest(const ParameterValues& values, const SpriteSubject& object)
{
    const SpriteTable& t = spriteTable();
    const int frames = values[t.frames] > 0 ? values[t.frames] : object.animated() ? 12 : 1;
    return {values[t.directions], frames, {values[t.width], values[t.height]}, values[t.animation], values[t.motion]};
}

std::string whyNoSheet(const SpriteRequest& request)
{
    const std::int64_t wide = std::int64_t{request.size.x} * request.frames;
    const std::int64_t high = std::int64_t{request.size.y} * request.directions;
    if (wide > longestSide || high > longestSide)
        return "The sheet would be more than 16384 pixels wide or high; ask for fewer or smaller frames.";
    if (wide * high > mostPixels)
        return "The sheet would have more than 67 million pixels; ask for fewer or smaller frames.";
    return {};
}

std::shared_ptr<const SpriteSubject> spriteSubject(const ParameterValues& values)
{
    const std::string& file = values[spriteTable().model];
    return file.empty() ? std::make_shared<const SpriteSubject>() : std::make_shared<const SpriteSubject>(file);
}

SpriteSheetOptions sheetOptions(const ParameterValues& values, const SpriteSubject& subject,
                                const std::vector<Rgb8>& palette, const std::string& imageName)
{
    const SpriteTable& t = spriteTable();
    SpriteSheetOptions options;
    options.colors = values[t.colors];
    options.palette = chosenPalette(values, palette);
    options.dither = values[t.dither];
    options.pivot = values[t.pivot];
    options.trimmed = values[t.trimmed];
    const double rate = values[t.framesPerSecond];
    const SpriteRequest request = spriteRequest(values, subject);
    options.frameSeconds = rate > 0 ? 1 / rate : subject.duration(request) / request.frames;
    options.imageName = imageName;
    if (values[t.normals]) options.normalName = besides(imageName, "_normal", ".png").string();
    if (values[t.depth]) options.depthName = besides(imageName, "_depth", ".png").string();
    options.directionNames = values[t.directionNames];
    options.normalY = values[t.normalY];
    options.json = values[t.form];
    return options;
}

std::filesystem::path animationFile(const ParameterValues& values, const std::filesystem::path& out)
{
    const SpriteAnimation kind = values[spriteTable().animated];
    if (kind == SpriteAnimation::none) return {};
    return besides(out, "", kind == SpriteAnimation::gif ? ".gif" : ".apng");
}

std::vector<jobs::PlannedFile> sheetFiles(const ParameterValues& values, const std::filesystem::path& out)
{
    std::vector<jobs::PlannedFile> files;
    for (const SheetPart& part : sheetParts(values, out)) files.push_back({part.file, part.content});
    return files;
}

std::string lookPreset(const ParameterValues& look)
{
    return presetText({std::string(spriteLookName), "Sprite sheet", look, std::nullopt});
}

std::vector<render::NamedBytes> sheetBytes(const SpriteSheet& sheet, const ParameterValues& values,
                                           const std::filesystem::path& out)
{
    std::vector<render::NamedBytes> files;
    for (const SheetPart& part : sheetParts(values, out)) files.push_back({part.file, part.bytesOf(sheet, part.file)});
    return files;
}

}  // namespace vitrine::jobs
