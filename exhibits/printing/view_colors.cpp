#include "exhibits/printing/view_colors.h"

#include "render/image/picture_stream.h"
#include "render/image/rec709.h"

#include <optional>

namespace vitrine::printing {

ViewColors viewColors(const std::vector<std::filesystem::path>& files)
{
    ViewColors colors;
    std::optional<std::string> first;
    bool differ = false;
    for (const std::filesystem::path& file : files) {
        const std::string profile = render::embeddedProfile(file);
        if (!first) {
            first = profile;
            continue;
        }
        differ = differ || (profile != *first && !(render::isSrgbProfile(profile) && render::isSrgbProfile(*first)));
    }
    if (differ) {
        colors.keep = false;
        colors.note = "The pictures have different color profiles; all are converted to sRGB.";
    } else if (first && render::isRgbProfile(*first)) {
        colors.profile = *first;
    } else {
        colors.keep = false;  // Gray profiles, PNG's gamma, or no profile: the print is sRGB.
    }
    return colors;
}

}  // namespace vitrine::printing
