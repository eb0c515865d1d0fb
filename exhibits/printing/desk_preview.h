#pragma once

#include "exhibits/printing/chart.h"
#include "exhibits/printing/eye_lines.h"
#include "exhibits/printing/lenticular_desk.h"

#include <mutex>

namespace vitrine::printing {

/// A print of views, made where it is looked at.
class ViewsPreview final : public PrintPreview {
public:
    ViewsPreview(const PrintLayout&, std::shared_ptr<const DeskViews>);

    [[nodiscard]] std::int64_t width() const override { return layout_.width(); }
    [[nodiscard]] std::int64_t height() const override { return layout_.height(); }
    [[nodiscard]] LensGrid lenses() const override;
    [[nodiscard]] CodedPicture raster(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) const override;
    [[nodiscard]] CodedPicture seen(const PrintEye&, int side) const override;

private:
    PrintLayout layout_;
    std::shared_ptr<const DeskViews> views_;
    Interlacer interlacer_;
    mutable std::once_flag linesMade_;
    mutable std::unique_ptr<const EyeLines> lines_;  ///< Made when first looked through.
};

/// A chart.
class ChartPreview final : public PrintPreview {
public:
    ChartPreview(const PrintLayout& layout, ChartKind kind, double span) : layout_(layout), chart_(layout, kind, span) {}

    [[nodiscard]] std::int64_t width() const override { return layout_.width(); }
    [[nodiscard]] std::int64_t height() const override { return layout_.height(); }
    [[nodiscard]] LensGrid lenses() const override;
    [[nodiscard]] CodedPicture raster(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) const override;
    [[nodiscard]] CodedPicture seen(const PrintEye&, int) const override { return {}; }

private:
    PrintLayout layout_;
    Chart chart_;
};

/// Where the lenses lie on the raster of this print as it is written, mirrored or not.
[[nodiscard]] LensGrid lensGrid(const PrintLayout&);

}  // namespace vitrine::printing
