#include "exhibits/jobs/sprite/sprite_animation.h"

#include "render/image/srgb.h"

#include <algorithm>

namespace vitrine::jobs {
namespace {

constexpr int smallestSide = 256;  ///< Least side of the animated picture, in pixels: smaller frames are enlarged.
constexpr double slowestTurn = 4;  ///< Directions of one frame each, per second.
constexpr double grayCode = 0.5;   ///< sRGB code of the background where nothing can be transparent.

}  // namespace

render::VideoSpec animationSpec(const ParameterValues& values, int framesPerDirection, double frameSeconds)
{
    const SpriteTable& t = spriteTable();
    const bool isGif = values[t.animated] == SpriteAnimation::gif;
    const int longest = std::max(values[t.width], values[t.height]);
    const int scale = (smallestSide + longest - 1) / longest;
    const double rate = 1 / std::max(frameSeconds, 1e-3);
    return {.format = isGif ? render::VideoFormat::gif : render::VideoFormat::apng,
            .width = scale * values[t.width],
            .height = scale * values[t.height],
            .framesPerSecond =
                std::clamp(framesPerDirection > 1 ? rate : std::min(rate, slowestTurn), 0.1, isGif ? 50.0 : 240.0),
            .transparent = !isGif};
}

render::Image animationFrame(const SpriteSheet& sheet, std::size_t i, glm::ivec2 frameSize,
                             const render::VideoSpec& spec)
{
    const SpriteCell& cell = sheet.cells[i];
    const auto gray = static_cast<float>(render::linearFromSrgb(grayCode));
    const int scale = spec.width / frameSize.x;
    render::Image picture(spec.width, spec.height, 4);
    for (int y = 0; y < spec.height; ++y)
        for (int x = 0; x < spec.width; ++x) {
            const glm::ivec2 inCell = glm::ivec2(x, y) / scale - cell.cutOff;
            const bool inside = inCell.x >= 0 && inCell.y >= 0 && inCell.x < cell.size.x && inCell.y < cell.size.y;
            const glm::ivec2 from = inCell + cell.place;
            const float opacity = inside ? sheet.color.at(from.x, from.y, 3) : 0;
            for (int k = 0; k < 3; ++k) {
                const float color = inside ? sheet.color.at(from.x, from.y, k) : 0;
                picture.at(x, y, k) = spec.transparent ? color : opacity * color + (1 - opacity) * gray;
            }
            picture.at(x, y, 3) = spec.transparent ? opacity : 1;
        }
    return picture;
}

std::unique_ptr<render::PartFile> stagedAnimation(const SpriteSheet& sheet, const ParameterValues& values,
                                                  const render::VideoSpec& spec, const std::filesystem::path& file)
{
    const SpriteTable& t = spriteTable();
    render::VideoFile video(file, spec);
    for (std::size_t i = 0; i < sheet.cells.size(); ++i)
        video.add(animationFrame(sheet, i, {values[t.width], values[t.height]}, spec));
    return video.staged();
}

}  // namespace vitrine::jobs
