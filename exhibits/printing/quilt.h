#pragma once

#include "render/image/image.h"
#include "render/scene/camera.h"

#include <filesystem>
#include <optional>

namespace vitrine::printing {

/// Grid of a quilt: a picture of many views for light-field displays. The first view, seen from the left, is at the
/// bottom left; rows go upwards.
struct QuiltGrid {
    int columns = 8, rows = 6;
    double aspect = 0.75;  ///< Width of a view by its height, as it is shown.

    [[nodiscard]] int count() const { return columns * rows; }
    bool operator==(const QuiltGrid&) const = default;
};

/// Returns the grid that a file's name tells, as Looking Glass writes it: "cat_qs8x6a0.75.png". Returns nothing for
/// other names, and for numbers out of range (1 to 1000 columns and rows, an aspect ratio above 0).
[[nodiscard]] std::optional<QuiltGrid> quiltNamed(const std::filesystem::path&);

/// Returns the path whose name tells the grid: "cat.png" becomes "cat_qs8x6a0.75.png". A grid that the name tells
/// already is replaced. The aspect ratio has at most four digits behind the point.
[[nodiscard]] std::filesystem::path quiltPath(const std::filesystem::path&, const QuiltGrid&);

/// Returns the camera of view `k` (0 to `count` - 1, from the left). All cameras look in the same direction, on a line
/// through `middle`, with shifted frusta. So the plane through the target of `middle` is on the same pixels in all
/// views. Their directions from the target are evenly spaced over the angle `cone` (radians, below pi).
[[nodiscard]] render::Camera quiltCamera(const render::Camera& middle, int k, int count, double cone);

/// Copies view `k` into its place in the quilt. The quilt has `columns` times `rows` views of this size, with as many
/// channels.
void placeInQuilt(render::Image& quilt, const render::Image& view, const QuiltGrid&, int k);

}  // namespace vitrine::printing
