#include "exhibits/printing/desk_preview.h"

#include <cassert>
#include <cmath>

namespace vitrine::printing {
namespace {

constexpr int eyeLines = 360;  // As many as a preview is high, on a large screen.

CodedPicture emptyPicture(const PrintLayout& layout, std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1)
{
    assert(x0 >= 0 && y0 >= 0 && x0 < x1 && y0 < y1 && x1 <= layout.width() && y1 <= layout.height());
    (void)layout;
    CodedPicture picture{static_cast<int>(x1 - x0), static_cast<int>(y1 - y0)};
    picture.rgb.resize(static_cast<std::size_t>(x1 - x0) * static_cast<std::size_t>(y1 - y0) * 3);
    return picture;
}

}  // namespace

LensGrid lensGrid(const PrintLayout& layout)
{
    LensGrid grid{layout.lensAt(0, 0), layout.lensesPerPixelX(), layout.lensesPerPixelY()};
    if (layout.settings().mirror) {
        grid.at0 += grid.perX * static_cast<double>(layout.width());
        grid.perX = -grid.perX;
    }
    return grid;
}

ViewsPreview::ViewsPreview(const PrintLayout& layout, std::shared_ptr<const DeskViews> views)
    : layout_(layout), views_(std::move(views)), interlacer_(layout_, views_->full())
{
}

LensGrid ViewsPreview::lenses() const
{
    return lensGrid(layout_);
}

CodedPicture ViewsPreview::raster(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) const
{
    CodedPicture picture = emptyPicture(layout_, x0, y0, x1, y1);
    interlacer_.fill({x0, y0, x1, y1}, picture.rgb.data());
    return picture;
}

CodedPicture ViewsPreview::seen(const PrintEye& eye, int side) const
{
    std::call_once(linesMade_, [this] {
        // Small views, so that rows between the lines are averaged and not left out.
        const Interlacer small(layout_, views_->small());
        lines_ = std::make_unique<EyeLines>(layout_, small, eyeLines);
    });
    const bool upright = std::abs(layout_.settings().direction) <= 45;
    const double distance = eye.distance * 1000;
    return lines_->seen(upright ? Eye{eye.angle, eye.angleAlong, distance} : Eye{-eye.angleAlong, eye.angle, distance}, side);
}

LensGrid ChartPreview::lenses() const
{
    return lensGrid(layout_);
}

CodedPicture ChartPreview::raster(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) const
{
    CodedPicture picture = emptyPicture(layout_, x0, y0, x1, y1);
    chart_.fill({x0, y0, x1, y1}, picture.rgb.data());
    return picture;
}

}  // namespace vitrine::printing
