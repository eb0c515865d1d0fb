#include "render/image/rec709.h"

#include "render/image/srgb.h"

#include <lcms2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace vitrine::render {
namespace {

/// Chromaticities of Rec. 709: red, green, blue and white (D65).
constexpr std::array<double, 8> rec709 = {0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290};
/// Tolerance for sRGB profiles, which differ among each other. Their rounded colorants are amplified 13 times in dark
/// colors.
constexpr double unseen = 2.0 / 255;

using Profile = std::unique_ptr<void, decltype(&cmsCloseProfile)>;

Profile rgbProfile(const std::array<double, 8>& c, double gamma)
{
    const cmsCIExyY white{c[6], c[7], 1};
    const cmsCIExyYTRIPLE primaries{{c[0], c[1], 1}, {c[2], c[3], 1}, {c[4], c[5], 1}};
    cmsToneCurve* curve = cmsBuildGamma(nullptr, gamma);
    const std::array<cmsToneCurve*, 3> curves = {curve, curve, curve};
    Profile profile(curve ? cmsCreateRGBProfile(&white, &primaries, curves.data()) : nullptr, cmsCloseProfile);
    if (curve) cmsFreeToneCurve(curve);
    return profile;
}

Profile grayProfile(double gamma)
{
    cmsToneCurve* curve = cmsBuildGamma(nullptr, gamma);
    Profile profile(curve ? cmsCreateGrayProfile(cmsD50_xyY(), curve) : nullptr, cmsCloseProfile);
    if (curve) cmsFreeToneCurve(curve);
    return profile;
}

Profile opened(const std::string& bytes)
{
    return {cmsOpenProfileFromMem(bytes.data(), static_cast<cmsUInt32Number>(bytes.size())), cmsCloseProfile};
}

cmsUInt32Number formatOf(bool gray, bool alpha)
{
    return FLOAT_SH(1U) | COLORSPACE_SH(gray ? cmsUInt32Number{PT_GRAY} : cmsUInt32Number{PT_RGB}) |
           EXTRA_SH(alpha ? 1U : 0U) | CHANNELS_SH(gray ? 1U : 3U) | BYTES_SH(4U);
}

std::shared_ptr<void> transformFrom(const Profile& from, bool gray, bool alpha)
{
    const Profile to = gray ? grayProfile(1) : rgbProfile(rec709, 1);
    if (!from || !to) return nullptr;
    const cmsUInt32Number format = formatOf(gray, alpha);
    // Not optimized: a table would clamp values to [0, 1].
    cmsHTRANSFORM transform = cmsCreateTransform(from.get(), format, to.get(), format, INTENT_RELATIVE_COLORIMETRIC,
                                                 cmsFLAGS_NOOPTIMIZE | cmsFLAGS_NOCACHE);
    if (!transform) return nullptr;
    return {transform, cmsDeleteTransform};
}

/// Returns whether the effect of the transform is below the visible threshold, tested on a grid of 9 x 9 x 9 values.
bool changesNothing(void* transform, bool gray, bool alpha, bool encoded)
{
    constexpr int steps = 9;
    const int colors = gray ? 1 : 3;
    const int count = gray ? 256 : steps * steps * steps;
    const int channels = colors + (alpha ? 1 : 0);
    std::vector<float> values;
    for (int i = 0; i < count; ++i) {
        for (int c = 0, rest = i; c < colors; ++c, rest /= steps)
            values.push_back(gray ? static_cast<float>(i) / 255 : static_cast<float>(rest % steps) / (steps - 1));
        if (alpha) values.push_back(1);
    }
    const std::vector<float> before = values;
    cmsDoTransform(transform, values.data(), values.data(), static_cast<cmsUInt32Number>(count));
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (alpha && static_cast<int>(i) % channels == colors) continue;
        const double is = srgbFromLinear(static_cast<double>(values[i]));
        const double was = static_cast<double>(before[i]);
        if (!(std::abs(is - (encoded ? was : srgbFromLinear(was))) < unseen)) return false;
    }
    return true;
}

/// Returns whether the chromaticities can be those of a display.
bool areUsable(const std::array<double, 8>& c)
{
    for (std::size_t i = 0; i < c.size(); ++i)
        if (!std::isfinite(c[i]) || std::abs(c[i]) > 10 || (i % 2 == 1 && i > 5 && !(c[i] > 1e-3))) return false;
    const double area = (c[2] - c[0]) * (c[5] - c[1]) - (c[4] - c[0]) * (c[3] - c[1]);
    return std::abs(area) > 1e-4;
}

/// Exponent from code to light. 2.2 if the file gives none: programs that write 2.2 mean sRGB's curve.
double gammaOf(const PictureColor& color)
{
    return color.gamma > 0 ? color.gamma : 2.2;
}

/// Returns whether chromaticities and gamma equal the defaults.
bool meansUsual(const PictureColor& color, bool gray, bool encoded)
{
    const bool usualCurve = !encoded || std::abs(gammaOf(color) - 2.2) < 0.03;
    double farthest = 0;
    for (std::size_t i = 0; i < rec709.size(); ++i)
        farthest = std::max(farthest, std::abs(color.chromaticities.at(i) - rec709.at(i)));
    return usualCurve && (gray || color.chromaticities[0] <= 0 || farthest < 0.002);
}

/// Makes a profile from chromaticities and gamma; null if they describe no color space.
Profile describedProfile(const PictureColor& color, bool gray, bool encoded)
{
    const double gamma = encoded ? gammaOf(color) : 1;
    if (gray) return grayProfile(gamma);
    const bool said = color.chromaticities[0] > 0;
    if (said && !areUsable(color.chromaticities)) return {nullptr, cmsCloseProfile};
    return rgbProfile(said ? color.chromaticities : rec709, gamma);
}

}  // namespace

ToRec709::ToRec709(const PictureColor& color, int channels, bool encoded)
    : channels_(static_cast<std::size_t>(channels))
{
    if (!color.isSaid() || channels < 1 || channels > 4) return;
    const bool gray = channels < 3;
    const bool alpha = channels % 2 == 0;
    const bool byProfile = !color.profile.empty() && encoded;
    if (!byProfile && meansUsual(color, gray, encoded)) return;
    const Profile from = byProfile ? opened(color.profile) : describedProfile(color, gray, encoded);
    if (byProfile) {
        const auto space = from ? cmsGetColorSpace(from.get()) : cmsSigNamedData;
        // CMYK inks were converted to red, green and blue when the file was decoded.
        if (space == cmsSigCmykData) return;
        if (space != (gray ? cmsSigGrayData : cmsSigRgbData)) {
            problem_ = "Its color profile does not fit its pixels and is ignored; they are taken as sRGB.";
            return;
        }
    }
    transform_ = transformFrom(from, gray, alpha);
    if (!transform_) problem_ = "Its color profile cannot be used and is ignored; its pixels are taken as sRGB.";
    if (transform_ && changesNothing(transform_.get(), gray, alpha, encoded)) transform_.reset();
}

ToRec709::~ToRec709() = default;

void ToRec709::apply(std::vector<float>& samples) const
{
    if (!transform_) return;
    cmsDoTransform(transform_.get(), samples.data(), samples.data(),
                   static_cast<cmsUInt32Number>(samples.size() / channels_));
    // An untrusted profile can divide by zero.
    for (float& x : samples)
        if (!std::isfinite(x)) x = 0;
}

void convertFromProfile(Image& image, const std::string& profile)
{
    if (profile.empty()) return;
    const ToRec709 conversion({.profile = profile}, image.channels, true);
    if (!conversion.isNeeded()) return;
    const auto channels = static_cast<std::size_t>(image.channels);
    const std::size_t colors = channels < 3 ? 1 : 3;
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        if (i % channels < colors)
            image.pixels[i] = static_cast<float>(srgbFromLinear(static_cast<double>(image.pixels[i])));
    conversion.apply(image.pixels);
}

bool isSrgbProfile(const std::string& profile)
{
    return profile.empty() || (isRgbProfile(profile) && !ToRec709({.profile = profile}, 3, true).isNeeded());
}

bool isRgbProfile(const std::string& profile)
{
    return profile.size() > 20 && profile.compare(16, 4, "RGB ") == 0;
}

}  // namespace vitrine::render
