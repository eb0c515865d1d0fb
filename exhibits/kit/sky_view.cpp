#include "exhibits/kit/sky_view.h"

#include "exhibits/kit/clear_sky.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <list>
#include <mutex>
#include <numbers>

namespace vitrine {
namespace sky_view {
namespace {

constexpr int side = 32;           ///< Texels along either axis of the table.
constexpr double cirrus = 8;       ///< Kilometers.
constexpr double aroundTop = 0.3;  ///< Upper edge of the ring `around`, as a sine.
constexpr std::size_t mostKept = 8;
/// Factor of the saturation. Photographs and memories of skies are more vivid than their colorimetry.
constexpr double vividness = 1.22;

/// Linear Rec. 709 from the light at the three wavelengths of ClearSky. Two fifths of it are a fit to skies at nine
/// wavelengths, weighted with the solar spectrum and the color matching functions of CIE 1931. The rest, which takes
/// the wavelengths for the channels, keeps the violet that photographs of dusk show. Columns.
const glm::dmat3 rec709FromWavelengths(0.7648, 0.002856, 0.000252, 0.3777, 0.9616, 0.01428, -0.1124, 0.01974, 0.9629);

/// Returns light at the three wavelengths as a color, vivid and with no channel below 0.
glm::dvec3 colorOf(const glm::dvec3& wavelengths)
{
    const glm::dvec3 color = rec709FromWavelengths * wavelengths;
    const double luminance = glm::dot(color, glm::dvec3(0.2126, 0.7152, 0.0722));
    return glm::max(luminance + (color - luminance) * vividness, glm::dvec3(0));
}

/// Sine of the elevation of a row, and sine of half the azimuth from the sun of a column: as in
/// shaders/lib/sky_view.glsl, the squares of the coordinates.
double squareAt(int i)
{
    const double share = static_cast<double>(i) / (side - 1);
    return share * share;
}

std::shared_ptr<const SkyView> made(const SkySource& source)
{
    const ClearSky sky(source.sunElevation, source.haze);
    auto view = std::make_shared<SkyView>();
    view->sun = colorOf(sky.sunlight()) * source.sun;
    view->sunOnClouds = colorOf(sky.sunlight(cirrus)) * source.sun;
    auto table = std::make_shared<render::Texture>();
    table->name = skyTableName;
    table->width = table->height = side;
    table->channels = 3;
    table->repeat = table->mipmaps = false;
    double weights = 0, ring = 0;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const double up = squareAt(row), half = std::asin(squareAt(column));
            const glm::dvec3 radiance = colorOf(sky.radiance(std::asin(up), 2 * half)) * source.sun + source.night;
            for (int i = 0; i < 3; ++i) table->floats.push_back(static_cast<float>(radiance[i]));
            view->brightest = std::max({view->brightest, radiance.x, radiance.y, radiance.z});
            // The solid angle of a texel, up to a factor: by the derivatives of sine and azimuth.
            const double across = static_cast<double>(column) / (side - 1) / std::max(std::cos(half), 0.1);
            const double weight = std::sqrt(up) * across;
            view->above += radiance * (up * weight);
            weights += up * weight;
            if (up > aroundTop) continue;
            view->around += radiance * weight;
            ring += weight;
        }
    view->above /= weights;
    view->around /= ring;
    view->radiance = std::move(table);
    return view;
}

/// Returns a color in 32 bits: three mantissas of nine bits, and an exponent of five that they share (the format
/// RGB9_E5 of OpenGL).
std::uint32_t sharedExponent(const glm::vec3& color)
{
    const float most = std::max({color.x, color.y, color.z, 1e-9F});
    const int exponent = std::clamp(static_cast<int>(std::floor(std::log2(most))) + 1, -15, 16);
    const auto mantissa = [exponent](float x) {
        return static_cast<std::uint32_t>(std::clamp(std::lround(std::ldexp(x, 9 - exponent)), 0L, 511L));
    };
    return mantissa(color.x) | mantissa(color.y) << 9U | mantissa(color.z) << 18U |
           static_cast<std::uint32_t>(exponent + 15) << 27U;
}

}  // namespace
}  // namespace sky_view

std::string skyArrayGlsl(const render::Texture& table)
{
    const std::string side = std::to_string(table.width), last = std::to_string(table.width - 1);
    std::string text = "// The clear sky as a table over direction: mantissas of nine bits, and an exponent.\n"
                       "#include \"lib/sky_view_place.glsl\"\n\nconst uint skyTable[" +
                       side + " * " + side + "] = uint[" + side + " * " + side + "](";
    for (std::size_t i = 0; 3 * i < table.floats.size(); ++i) {
        text += (i == 0 ? "\n    " : i % 8 == 0 ? ",\n    " : ", ");
        text += std::to_string(
                    sky_view::sharedExponent({table.floats[3 * i], table.floats[3 * i + 1], table.floats[3 * i + 2]})) +
                'u';
    }
    return text +
           ");\n\nvec3 skyTexel(int i)\n{\n    uint bits = skyTable[i];\n"
           "    return vec3(float(bits & 511u), float((bits >> 9u) & 511u), float((bits >> 18u) & 511u)) * "
           "exp2(float(bits >> 27u) - 24.0);\n}\n\n"
           "vec3 skyViewRadiance(vec3 d, vec3 sunDirection)\n{\n    vec2 at = skyViewPlace(d, sunDirection) * " +
           last + ".0;\n    ivec2 texel = ivec2(min(floor(at), " + last +
           ".0 - 1.0));\n    vec2 share = at - vec2(texel);\n" + "    int i = texel.y * " + side +
           " + texel.x;\n    return mix(mix(skyTexel(i), skyTexel(i + 1), share.x), " + "mix(skyTexel(i + " + side +
           "), skyTexel(i + " + side + " + 1), share.x), share.y);\n}\n";
}

std::shared_ptr<const SkyView> skyView(const SkySource& source)
{
    using Kept = std::pair<SkySource, std::shared_ptr<const SkyView>>;
    static std::mutex mutex;
    static std::list<Kept> last;
    const std::lock_guard lock(mutex);
    const auto found = std::find_if(last.begin(), last.end(), [&](const Kept& kept) { return kept.first == source; });
    if (found != last.end()) {
        last.splice(last.begin(), last, found);
    } else {
        last.emplace_front(source, sky_view::made(source));
        if (last.size() > sky_view::mostKept) last.pop_back();
    }
    return last.front().second;
}

}  // namespace vitrine
