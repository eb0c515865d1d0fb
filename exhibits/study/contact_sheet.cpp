#include "exhibits/study/contact_sheet.h"

#include "render/image/image_limits.h"

#include <algorithm>

namespace vitrine::study {
namespace {

constexpr int colors = 3;

/// Copies a picture into the sheet. Gray pictures go to all three channels.
void put(render::Image& into, const render::Image& picture, glm::ivec2 at, glm::ivec2 size)
{
    if (picture.width != size.x || picture.height != size.y) return;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            for (int c = 0; c < colors; ++c)
                into.at(at.x + x, at.y + y, c) = picture.at(x, y, picture.channels < colors ? 0 : c);
}

render::Image cut(const render::Image& from, glm::ivec2 at, glm::ivec2 size)
{
    render::Image picture(size.x, size.y, colors);
    for (int y = 0; y < size.y; ++y) {
        const auto row = from.pixels.begin() + static_cast<std::ptrdiff_t>(from.index(at.x, at.y + y));
        std::copy_n(row, size.x * colors, picture.pixels.begin() + static_cast<std::ptrdiff_t>(picture.index(0, y)));
    }
    return picture;
}

glm::ivec2 placeOf(const ContactSheet& sheet, std::size_t row, std::size_t view)
{
    return sheet.size * glm::ivec2(static_cast<int>(view), static_cast<int>(row));
}

}  // namespace

glm::ivec2 ContactSheet::extent() const
{
    return size * glm::ivec2(static_cast<int>(views), static_cast<int>(points + 1));
}

render::Image ContactSheet::reference(std::size_t view) const
{
    return cut(image, placeOf(*this, 0, view), size);
}

render::Image ContactSheet::picture(std::size_t point, std::size_t view) const
{
    return cut(image, placeOf(*this, point + 1, view), size);
}

ContactSheet contactSheet(const StudyResult& result)
{
    ContactSheet sheet;
    if (result.references.empty() || result.references.front().empty()) return sheet;
    sheet.size = {result.references.front().width, result.references.front().height};
    sheet.views = result.references.size();
    sheet.points = result.points.size();
    const glm::ivec2 extent = sheet.extent();
    const auto longest = static_cast<int>(render::ImageLimits().side);
    if (extent.x > longest || extent.y > longest) return {};
    sheet.image = render::Image(extent.x, extent.y, colors);
    for (std::size_t view = 0; view < sheet.views; ++view) {
        put(sheet.image, result.references[view], placeOf(sheet, 0, view), sheet.size);
        for (std::size_t point = 0; point < sheet.points; ++point)
            if (view < result.points[point].shots.size())
                put(sheet.image, result.points[point].shots[view].picture, placeOf(sheet, point + 1, view), sheet.size);
    }
    return sheet;
}

}  // namespace vitrine::study
