#include "render/image/profile_conversion.h"

#include "render/failure.h"

#include <lcms2.h>

#include <algorithm>

namespace vitrine::render {
namespace profiles {
namespace {

using Profile = std::unique_ptr<void, decltype(&cmsCloseProfile)>;

Profile opened(const std::string& bytes)
{
    const std::string& profile = bytes.empty() ? srgbProfile() : bytes;
    return {cmsOpenProfileFromMem(profile.data(), static_cast<cmsUInt32Number>(profile.size())), cmsCloseProfile};
}

std::string bytesOfSrgb()
{
    const Profile profile(cmsCreate_sRGBProfile(), cmsCloseProfile);
    cmsSetProfileVersion(profile.get(), 2.1);  // Older programs of print shops do not read version 4.
    cmsUInt32Number size = 0;
    cmsSaveProfileToMem(profile.get(), nullptr, &size);
    std::string bytes(size, '\0');
    cmsSaveProfileToMem(profile.get(), bytes.data(), &size);
    // The header's date is that of the call, but the same print must give the same bytes: 1 January 2000.
    constexpr std::size_t date = 24;
    const std::string timeless{"\x07\xd0\0\1\0\1\0\0\0\0\0\0", 12};
    bytes.replace(date, timeless.size(), timeless);
    return bytes;
}

cmsUInt32Number formatFor(int channels, int bits)
{
    const auto bytes = static_cast<cmsUInt32Number>(bits / 8);
    const auto count = static_cast<cmsUInt32Number>(channels);
    const cmsUInt32Number space = channels == 4 ? PT_CMYK : PT_RGB;
    return COLORSPACE_SH(space) | CHANNELS_SH(count) | BYTES_SH(bytes);
}

cmsUInt32Number numberOf(RenderingIntent intent)
{
    switch (intent) {
    case RenderingIntent::perceptual: return INTENT_PERCEPTUAL;
    case RenderingIntent::relative: return INTENT_RELATIVE_COLORIMETRIC;
    case RenderingIntent::saturation: return INTENT_SATURATION;
    case RenderingIntent::absolute: return INTENT_ABSOLUTE_COLORIMETRIC;
    }
    return INTENT_RELATIVE_COLORIMETRIC;
}

}  // namespace
}  // namespace profiles

const std::string& srgbProfile()
{
    static const std::string bytes = profiles::bytesOfSrgb();
    return bytes;
}

int profileChannels(const std::string& profile)
{
    if (profile.empty()) return 3;
    const profiles::Profile opened = profiles::opened(profile);
    if (!opened) return 0;
    const cmsColorSpaceSignature space = cmsGetColorSpace(opened.get());
    return space == cmsSigRgbData ? 3 : space == cmsSigCmykData ? 4 : 0;
}

ProfileConversion::ProfileConversion(const std::string& from, const std::string& to, const ConversionSettings& settings)
    : channels_(profileChannels(to))
{
    const int channels = profileChannels(from);
    const profiles::Profile source = profiles::opened(from), target = profiles::opened(to);
    if (channels > 0 && channels_ > 0) {
        const cmsUInt32Number flags = cmsFLAGS_NOCACHE | (settings.blackPoint ? cmsFLAGS_BLACKPOINTCOMPENSATION : 0U);
        if (cmsHTRANSFORM transform = cmsCreateTransform(source.get(), profiles::formatFor(channels, settings.bits),
                                                         target.get(), profiles::formatFor(channels_, settings.bits),
                                                         profiles::numberOf(settings.intent), flags))
            transform_ = {transform, cmsDeleteTransform};
    }
    if (!transform_)
        throw Failure(ErrorKind::usage, "No colors can be converted into this ICC profile; give one of a printer, a "
                                        "display or a color space, with red, green and blue or with four inks.");
}

void ProfileConversion::apply(const void* from, void* to, std::size_t pixels) const
{
    constexpr std::size_t most = 1U << 20U;  // Little CMS counts with 32 bits.
    const auto* in = static_cast<const char*>(from);
    auto* out = static_cast<char*>(to);
    const std::size_t inBytes = T_CHANNELS(cmsGetTransformInputFormat(transform_.get())) *
                                T_BYTES(cmsGetTransformInputFormat(transform_.get()));
    const std::size_t outBytes = T_CHANNELS(cmsGetTransformOutputFormat(transform_.get())) *
                                 T_BYTES(cmsGetTransformOutputFormat(transform_.get()));
    for (std::size_t done = 0; done < pixels; done += most) {
        const std::size_t count = std::min(most, pixels - done);
        cmsDoTransform(transform_.get(), in + done * inBytes, out + done * outBytes,
                       static_cast<cmsUInt32Number>(count));
    }
}

}  // namespace vitrine::render
