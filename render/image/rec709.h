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
    /// `channels`: 1 or 2 for gray, 3 or 4 for red, green and blue; the last of 2 or 4 is alpha. `encoded`: samples are
    /// codes of 0 to 1. Otherwise they are linear light, and the gamma of `color` is ignored.
    ToRec709(const PictureColor&, int channels, bool encoded);
    ~ToRec709();
    ToRec709(const ToRec709&) = delete;
    ToRec709& operator=(const ToRec709&) = delete;

    /// False if no conversion is needed: sRGB codes, or linear light of Rec. 709. False also if the color space cannot
    /// be used; `problem` then says why.
    [[nodiscard]] bool isNeeded() const { return transform_ != nullptr; }
    /// A full sentence without the file's name; empty if the color space can be used.
    [[nodiscard]] const std::string& problem() const { return problem_; }
    /// Converts whole pixels in place. Results are not clamped to [0, 1]. Alpha is unchanged.
    void apply(std::vector<float>& samples) const;

private:
    std::shared_ptr<void> transform_;  ///< cmsHTRANSFORM.
    std::size_t channels_;
    std::string problem_;
};

/// Converts a picture whose values are sRGB-decoded codes of this ICC profile to linear Rec. 709. Leaves it unchanged
/// if the profile is empty, is sRGB or does not fit the picture.
void convertFromProfile(Image&, const std::string& profile);

/// Returns whether codes of this ICC profile differ from sRGB by less than two 8-bit codes; true for an empty profile.
[[nodiscard]] bool isSrgbProfile(const std::string& profile);

/// Returns whether an ICC profile describes red, green and blue (not gray or inks), so that it can be embedded in an
/// RGB file.
[[nodiscard]] bool isRgbProfile(const std::string& profile);

}  // namespace vitrine::render
