#pragma once

#include <lcms2.h>

#include <algorithm>
#include <memory>
#include <string>

namespace vitrine::test {

/// Makes the ICC profile of a printer with ideal inks on white paper: codes of inks become sRGB by (1 - ink) (1 -
/// black). Tables of 16 bits with Lab, version 2.1 (ICC.1:2001-04, 6.5.8).
class InkProfile {
public:
    [[nodiscard]] static std::string bytes()
    {
        const InkProfile tables;
        const std::unique_ptr<void, decltype(&cmsCloseProfile)> profile(cmsCreateProfilePlaceholder(nullptr),
                                                                        cmsCloseProfile);
        cmsSetProfileVersion(profile.get(), 2.1);
        cmsSetDeviceClass(profile.get(), cmsSigOutputClass);
        cmsSetColorSpace(profile.get(), cmsSigCmykData);
        cmsSetPCS(profile.get(), cmsSigLabData);
        cmsMLU* name = cmsMLUalloc(nullptr, 1);
        cmsMLUsetASCII(name, "en", "US", "Ideal inks");
        cmsWriteTag(profile.get(), cmsSigProfileDescriptionTag, name);
        cmsWriteTag(profile.get(), cmsSigMediaWhitePointTag, cmsD50_XYZ());
        tables.write(profile.get(), cmsSigAToB0Tag, 4, 3, 9, &InkProfile::labOfInks);
        tables.write(profile.get(), cmsSigBToA0Tag, 3, 4, 33, &InkProfile::inksOfLab);
        cmsMLUfree(name);
        cmsUInt32Number size = 0;
        cmsSaveProfileToMem(profile.get(), nullptr, &size);
        std::string bytes(size, '\0');
        cmsSaveProfileToMem(profile.get(), bytes.data(), &size);
        return bytes;
    }

private:
    using Transform = std::unique_ptr<void, decltype(&cmsDeleteTransform)>;

    InkProfile()
    {
        cmsHPROFILE rgb = cmsCreate_sRGBProfile();
        cmsHPROFILE lab = cmsCreateLab4Profile(nullptr);
        toLab_.reset(cmsCreateTransform(rgb, TYPE_RGB_DBL, lab, TYPE_Lab_DBL, INTENT_RELATIVE_COLORIMETRIC, 0));
        toRgb_.reset(cmsCreateTransform(lab, TYPE_Lab_DBL, rgb, TYPE_RGB_DBL, INTENT_RELATIVE_COLORIMETRIC, 0));
        cmsCloseProfile(rgb);
        cmsCloseProfile(lab);
    }

    void write(cmsHPROFILE profile, cmsTagSignature tag, unsigned in, unsigned out, unsigned grid,
               cmsSAMPLER16 sampler) const
    {
        cmsPipeline* pipeline = cmsPipelineAlloc(nullptr, in, out);
        cmsPipelineInsertStage(pipeline, cmsAT_BEGIN, cmsStageAllocToneCurves(nullptr, in, nullptr));
        cmsStage* table = cmsStageAllocCLut16bit(nullptr, grid, in, out, nullptr);
        cmsStageSampleCLut16bit(table, sampler, const_cast<InkProfile*>(this), 0);
        cmsPipelineInsertStage(pipeline, cmsAT_END, table);
        cmsPipelineInsertStage(pipeline, cmsAT_END, cmsStageAllocToneCurves(nullptr, out, nullptr));
        cmsWriteTag(profile, tag, pipeline);
        cmsPipelineFree(pipeline);
    }

    static cmsInt32Number labOfInks(const cmsUInt16Number inks[], cmsUInt16Number lab[], void* self)
    {
        double rgb[3];
        for (int c = 0; c < 3; ++c) rgb[c] = (1 - inks[c] / 65535.0) * (1 - inks[3] / 65535.0);
        cmsCIELab color;
        cmsDoTransform(static_cast<InkProfile*>(self)->toLab_.get(), rgb, &color, 1);
        cmsFloat2LabEncodedV2(lab, &color);
        return 1;
    }
    static cmsInt32Number inksOfLab(const cmsUInt16Number lab[], cmsUInt16Number inks[], void* self)
    {
        cmsCIELab color;
        cmsLabEncoded2FloatV2(&color, lab);
        double rgb[3];
        cmsDoTransform(static_cast<InkProfile*>(self)->toRgb_.get(), &color, rgb, 1);
        for (double& x : rgb) x = std::clamp(x, 0.0, 1.0);
        const double most = std::max({rgb[0], rgb[1], rgb[2]});
        for (int c = 0; c < 3; ++c)
            inks[c] = static_cast<cmsUInt16Number>(most > 0 ? (1 - rgb[c] / most) * 65535 + 0.5 : 0);
        inks[3] = static_cast<cmsUInt16Number>((1 - most) * 65535 + 0.5);
        return 1;
    }

    Transform toLab_{nullptr, cmsDeleteTransform};
    Transform toRgb_{nullptr, cmsDeleteTransform};
};

}  // namespace vitrine::test
