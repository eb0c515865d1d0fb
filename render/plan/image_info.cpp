#include "render/plan/image_info.h"

#include <algorithm>

namespace vitrine::render {

bool sameStorage(const ImageInfo& a, const ImageInfo& b)
{
    return a.format == b.format && a.type == b.type && a.layers == b.layers && a.levels == b.levels &&
           a.comparison == b.comparison && a.repeat == b.repeat && a.nearest == b.nearest &&
           a.hasOwnPixels() == b.hasOwnPixels();
}

glm::ivec2 sizeOf(const ImageInfo& info, const Raster& picture)
{
    if (info.size.x > 0 && info.size.y > 0) return info.size;
    if (info.divisor > 0) return glm::max((picture.size + info.divisor - 1) / info.divisor, glm::ivec2(1));
    const glm::ivec2 scaled(glm::ceil(glm::dvec2(picture.drawn()) * info.scale));
    return glm::max(scaled, glm::ivec2(1));
}

View viewOfOwnPixels(const View& picture, const ImageInfo& info)
{
    View view = picture;
    Raster raster;
    raster.size = sizeOf(info, picture.raster);
    if (info.divisor > 0 && info.size == glm::ivec2(0)) {
        const glm::dvec2 covered =
            glm::dvec2(raster.size * info.divisor) / glm::dvec2(glm::max(picture.raster.size, glm::ivec2(1)));
        view.tanHalfFov = picture.tanHalfFov * covered;
        view.tanShift = picture.tanShift - picture.tanHalfFov + view.tanHalfFov;
    }
    return withRaster(view, raster);
}

}  // namespace vitrine::render
