#include "exhibits/jobs/sprite/sprite_sheet.h"

#include "exhibits/jobs/sprite/sprite_colors.h"
#include "exhibits/jobs/sprite/sprite_description.h"
#include "exhibits/pixel_art/palette.h"
#include "render/failure.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace vitrine::jobs {
namespace {

using render::Image;

constexpr int fewestPixels = 12;  ///< Fewest visible pixels of a frame that shows something.

/// Returns the number of visible pixels in the frame that has most of them.
int mostSeen(const std::vector<SpriteFrame>& frames)
{
    int most = 0;
    for (const SpriteFrame& frame : frames) most = std::max(most, seenPixels(frame));
    return most;
}

/// Returns whether directions have several frames, and all frames of each direction are equal.
bool framesRepeat(const std::vector<SpriteFrame>& frames)
{
    std::map<int, const SpriteFrame*> first;
    for (const SpriteFrame& frame : frames) {
        const SpriteFrame& before = *first.try_emplace(frame.direction, &frame).first->second;
        if (before.color.pixels != frame.color.pixels || before.depth.pixels != frame.depth.pixels) return false;
    }
    return frames.size() > first.size();
}

/// Returns the part of a frame that is not empty; one texel for an empty frame.
SpriteCell cellOf(const Image& color, bool trimmed)
{
    SpriteCell cell;
    cell.size = {color.width, color.height};
    if (!trimmed) return cell;
    glm::ivec2 low(color.width, color.height), high(-1);
    for (int y = 0; y < color.height; ++y)
        for (int x = 0; x < color.width; ++x)
            if (isSeen(color, x, y)) {
                low = glm::min(low, glm::ivec2(x, y));
                high = glm::max(high, glm::ivec2(x, y));
            }
    cell.cutOff = high.x < 0 ? glm::ivec2(0) : low;
    cell.size = high.x < 0 ? glm::ivec2(1) : high - low + 1;
    return cell;
}

/// Places the cells in rows, one for each direction and as high as its highest frame. Returns the size of the sheet.
glm::ivec2 place(std::vector<SpriteCell>& cells, const std::vector<SpriteFrame>& frames)
{
    glm::ivec2 at(0), size(0);
    int high = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (i > 0 && frames[i].direction != frames[i - 1].direction) {
            at = {0, at.y + high};
            high = 0;
        }
        cells[i].place = at;
        at.x += cells[i].size.x;
        high = std::max(high, cells[i].size.y);
        size = glm::max(size, glm::ivec2(at.x, at.y + high));
    }
    return size;
}

std::vector<Rgb8> paletteOf(const std::vector<SpriteFrame>& frames, const SpriteSheetOptions& options)
{
    if (!options.palette.empty()) return options.palette;
    std::vector<glm::vec3> pixels;
    for (const SpriteFrame& frame : frames)
        for (int y = 0; y < frame.color.height; ++y)
            for (int x = 0; x < frame.color.width; ++x)
                if (isSeen(frame.color, x, y))
                    pixels.emplace_back(frame.color.at(x, y, 0), frame.color.at(x, y, 1), frame.color.at(x, y, 2));
    // An evenly chosen part of the pixels is sufficient.
    const std::size_t stride = pixels.size() / 65536 + 1;
    std::vector<glm::vec3> some;
    for (std::size_t i = 0; i < pixels.size(); i += stride) some.push_back(pixels[i]);
    std::vector<Rgb8> palette = pixel_art::mainColors(some, options.colors);
    if (palette.empty()) palette.emplace_back(0, 0, 0);
    return palette;
}

/// `signs` of the components of normals.
void copyFrame(const SpriteFrame& frame, const Image& color, const SpriteCell& cell, const glm::vec3& signs,
               SpriteSheet& sheet)
{
    for (int y = 0; y < cell.size.y; ++y)
        for (int x = 0; x < cell.size.x; ++x) {
            const int fromX = x + cell.cutOff.x, fromY = y + cell.cutOff.y;
            const int toX = x + cell.place.x, toY = y + cell.place.y;
            if (!isSeen(frame.color, fromX, fromY)) continue;
            for (int k = 0; k < 3; ++k) {
                sheet.color.at(toX, toY, k) = color.at(fromX, fromY, k);
                sheet.normal.at(toX, toY, k) = 0.5F + 0.5F * signs[k] * frame.normal.at(fromX, fromY, k);
            }
            sheet.color.at(toX, toY, 3) = frame.color.at(fromX, fromY, 3);
            sheet.normal.at(toX, toY, 3) = 1;
            sheet.depth.at(toX, toY) = frame.depth.at(fromX, fromY);
        }
}

glm::ivec2 pivotOf(const SpriteFrame& frame, SpritePivot pivot)
{
    const glm::ivec2 size(frame.color.width, frame.color.height);
    switch (pivot) {
    case SpritePivot::center: return size / 2;
    case SpritePivot::bottom: return {size.x / 2, size.y};
    case SpritePivot::origin: break;
    }
    return glm::ivec2(glm::floor(frame.pivot + 0.5));
}

}  // namespace

int seenPixels(const SpriteFrame& frame)
{
    int seen = 0;
    for (int y = 0; y < frame.color.height; ++y)
        for (int x = 0; x < frame.color.width; ++x) seen += isSeen(frame.color, x, y);
    return seen;
}

SpriteSheet spriteSheet(const std::vector<SpriteFrame>& frames, const SpriteSheetOptions& options)
{
    if (frames.empty()) throw Failure(ErrorKind::usage, "A sprite sheet takes at least one frame.");
    SpriteSheet sheet;
    for (const SpriteFrame& frame : frames) {
        sheet.cells.push_back(cellOf(frame.color, options.trimmed));
        sheet.pivots.push_back(pivotOf(frame, options.pivot));
    }
    sheet.frameSeconds = options.frameSeconds;
    const glm::ivec2 size = place(sheet.cells, frames);
    sheet.color = sheet.normal = Image(size.x, size.y, 4);
    sheet.depth = Image(size.x, size.y, 1);
    sheet.palette = paletteOf(frames, options);
    SpriteColors colors(sheet.palette, options.dither);
    const glm::vec3 signs(1, options.normalY == SpriteNormalY::down ? -1 : 1, 1);
    for (std::size_t i = 0; i < frames.size(); ++i)
        copyFrame(frames[i], colors.of(frames[i].color), sheet.cells[i], signs, sheet);
    sheet.description = describe(frames, sheet, options);
    sheet.godot = godotResource(frames, sheet, options);
    if (const int most = mostSeen(frames); most < fewestPixels)
        sheet.warnings.push_back("The object covers at most " + std::to_string(most) +
                                 " pixels of a frame: it moves far in its animation, or a frame is small. Take its "
                                 "motion out of the frames, or make them larger.");
    if (framesRepeat(frames))
        sheet.warnings.push_back("All frames of each direction are equal: the object has no animation, or none that "
                                 "these frames show. One frame per direction is enough.");
    return sheet;
}

}  // namespace vitrine::jobs
