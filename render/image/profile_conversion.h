#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace vitrine::render {

/// Treatment of colors that the target cannot show, and of white (ICC.1:2022, 4 intents).
enum class RenderingIntent : std::uint8_t {
    perceptual,  ///< All colors move closer together, as the profile's maker chose.
    relative,    ///< Colors that fit are kept relative to white, the others become the nearest ones.
    saturation,  ///< As perceptual, with vividness before hue.
    absolute,    ///< As relative, but white of the source keeps its tint.
};

/// Returns an ICC profile of sRGB, the same bytes at each call.
[[nodiscard]] const std::string& srgbProfile();

/// Returns the channels of the colors that an ICC profile describes: 3 for red, green and blue, 4 for cyan, magenta,
/// yellow and black. 0 for other colors, and for bytes that are no ICC profile.
[[nodiscard]] int profileChannels(const std::string& profile);

/// Settings of a conversion between color spaces.
struct ConversionSettings {
    RenderingIntent intent = RenderingIntent::relative;
    bool blackPoint = true;  ///< Scales lightness so that the darkest colors of both match.
    int bits = 8;            ///< 8 or 16, of both sides.
};

/// Conversion of codes from one ICC profile to another (Little CMS). Thread-safe.
class ProfileConversion {
public:
    /// Empty profiles are sRGB. Throws Failure (ErrorKind::usage), without a file's name, if there is no conversion.
    ProfileConversion(const std::string& from, const std::string& to, const ConversionSettings&);

    /// Channels of the result, 3 or 4. Codes of inks are 0 for none.
    [[nodiscard]] int channels() const { return channels_; }
    /// Converts pixels; the result must not overlap the source.
    void apply(const void* from, void* to, std::size_t pixels) const;

private:
    std::shared_ptr<void> transform_;  ///< cmsHTRANSFORM.
    int channels_ = 3;
};

}  // namespace vitrine::render
