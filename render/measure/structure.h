#pragma once

#include "render/image/image.h"

namespace vitrine::render {

/// Returns the structural dissimilarity per pixel, (1 - SSIM) / 2: 0 for equal surroundings, up to 1. SSIM follows
/// Wang, Bovik, Sheikh and Simoncelli 2004 ("Image Quality Assessment: From Error Visibility to Structural
/// Similarity"): a Gaussian window of 11 x 11 pixels with a standard deviation of 1.5, K1 of 0.01, K2 of 0.03, and a
/// range of 1. What is compared is the luma of sRGB codes (weights of Rec. 709), of colors clamped to [0, 1] and
/// composited over black. At the border, the window is what lies inside of the picture.
[[nodiscard]] Image dissimilarityMap(const Image& reference, const Image& test);

/// Returns the mean of the map, as in the paper over the pixels whose whole window is inside; over all pixels if a side
/// is below 11.
[[nodiscard]] double dissimilarity(const Image& reference, const Image& test);

}  // namespace vitrine::render
