#include "exhibits/printing/print_preview.h"

#include <cassert>
#include <cmath>

namespace vitrine::printing {
namespace {

constexpr int eyeLines = 360;  // The height of a preview on a large screen.

}  // namespace

PrintPreview::PrintPreview(const PrintLayout& layout, std::shared_ptr<const PrintViews> views,
                           std::shared_ptr<const SoftProof> proof)
    : layout_(layout), views_(std::move(views)), proof_(std::move(proof)), marks_(layout)
{
    interlacer_.emplace(layout_, views_->full());
}

PrintPreview::PrintPreview(const PrintLayout& layout, Chart chart)
    : layout_(layout), marks_(layout), chart_(std::move(chart))
{
}

LensGrid PrintPreview::lenses() const
{
    LensGrid grid{layout_.lensAt(0, 0), layout_.lensesPerPixelX(), layout_.lensesPerPixelY()};
    if (layout_.settings().mirror) {
        grid.at0 += grid.perX * static_cast<double>(layout_.width());
        grid.perX = -grid.perX;
    }
    return grid;
}

CodedPicture PrintPreview::raster(const Region& region) const
{
    assert(region.x0 >= 0 && region.y0 >= 0 && region.x0 < region.x1 && region.y0 < region.y1 && region.x1 <= width() &&
           region.y1 <= height());
    CodedPicture picture{static_cast<int>(region.x1 - region.x0), static_cast<int>(region.y1 - region.y0)};
    picture.rgb.resize(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height) * 3);
    if (chart_)
        chart_->fill(region, picture.rgb.data());
    else
        interlacer_->fill(region, picture.rgb.data());
    marks_.draw(region, picture.rgb.data());
    if (proof_) proof_->apply(picture.rgb);
    return picture;
}

Eye PrintPreview::eyeAt(double right, double above, double distance) const
{
    return std::abs(layout_.settings().direction) <= 45 ? Eye{right, above, distance} : Eye{-above, right, distance};
}

CodedPicture PrintPreview::seen(const Eye& eye, int side) const
{
    if (chart_) return {};
    std::call_once(linesMade_, [this] {
        // Small views are used, so rows between the lines are averaged and not skipped.
        const Interlacer small(layout_, views_->small());
        lines_ = std::make_unique<EyeLines>(layout_, small, eyeLines);
    });
    CodedPicture seen = lines_->seen(eye, side);
    if (proof_) proof_->apply(seen.rgb);
    return seen;
}

}  // namespace vitrine::printing
