#pragma once

#include "render/image/image.h"
#include "render/image/stored_picture.h"

#include <memory>
#include <string>
#include <vector>

namespace vitrine::render {

/// Conversion of the samples of one picture to linear Rec. 709 (Little CMS, relative colorimetric, white stays white).
class ToRec709 {
public:
    /// For samples with so many channels: 1 or 2 for gray, 3 or 4 for red, green and blue, the last of 2 or 4 alpha.
    /// `encoded`: samples are codes of 0 to 1, else they are light (the gamma of `color` does not count then).
    ToRec709(const PictureColor&, int channels, bool encoded);
    ~ToRec709();
    ToRec709(const ToRec709&) = delete;
    ToRec709& operator=(const ToRec709&) = delete;

    /// False where the samples mean what they mean without any of this: sRGB codes, or light of Rec. 709. Also where
    /// the color cannot be used, and `problem` says why.
    [[nodiscard]] bool isNeeded() const { return transform_ != nullptr; }
    /// A full sentence without the file's name; empty when the color was understood.
    [[nodiscard]] const std::string& problem() const { return problem_; }
    /// Converts whole pixels in place. Results are not limited to 0 to 1. Alpha stays.
    void apply(std::vector<float>& samples) const;

private:
    std::shared_ptr<void> transform_;  ///< cmsHTRANSFORM.
    std::size_t channels_;
    std::string problem_;
};

/// Converts a picture whose values are sRGB-decoded codes of this ICC profile to linear Rec. 709. Leaves it where
/// the profile is empty, is sRGB or does not fit the picture.
void convertFromProfile(Image&, const std::string& profile);

/// Whether codes of this ICC profile are sRGB to less than two codes of 8 bits; no profile is.
[[nodiscard]] bool isSrgbProfile(const std::string& profile);

/// Whether an ICC profile describes red, green and blue (and not gray or inks), so that a file of such codes may carry
/// it.
[[nodiscard]] bool isRgbProfile(const std::string& profile);

}  // namespace vitrine::render
