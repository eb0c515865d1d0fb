#pragma once

#include "ui/viewport/render_thread.h"

namespace vitrine::ui {

/// Picture on the screen: the last whole picture, and a region over it that was drawn later.
class ShownPicture {
public:
    /// Shows a whole picture. A first sample is newer than the region, which is dropped. Later samples show the time of
    /// the first one, so the region stays over them.
    void show(const DrawnPicture&);
    /// Draws a region over the picture, which must have the size that the region was ordered for.
    void showRegion(const DrawnPicture&);

    /// Returns the picture, in device pixels; null before the first one.
    [[nodiscard]] const QImage& image() const { return image_; }
    /// Returns the request and the order of the last whole picture.
    [[nodiscard]] const FrameRequest& request() const { return request_; }
    [[nodiscard]] const DrawOrder& order() const { return order_; }
    /// Returns whether a region that is newer than the rest lies over the picture.
    [[nodiscard]] bool hasRegion() const { return !region_.isNull(); }
    /// Returns the numbers of whole pictures and of regions shown since the start.
    [[nodiscard]] long long pictures() const { return pictures_; }
    [[nodiscard]] long long regions() const { return regions_; }

private:
    void layRegionOver();

    QImage image_;
    FrameRequest request_;
    DrawOrder order_;
    QImage region_;        ///< Null: no region is newer than the picture.
    PictureRegion place_;  ///< Part of the picture that `region_` covers.
    long long pictures_ = 0, regions_ = 0;
};

}  // namespace vitrine::ui
