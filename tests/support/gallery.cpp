#include "tests/support/gallery.h"

#include "tests/support/driver.h"
#include "tests/support/image_bytes.h"
#include "tests/support/temporary_folder.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace vitrine::test {

Gallery& gallery()
{
    static auto* opened = new Gallery;  // Never closed: the driver is unloaded before statics are destroyed.
    return *opened;
}

void GlTest::SetUp()
{
    static const std::string why = whyNotTested(gallery);
    if (!why.empty()) GTEST_SKIP() << why;
    errorsBefore_ = gallery().log.errors().size();
}

void GlTest::TearDown()
{
    if (IsSkipped()) return;
    EXPECT_EQ(gallery().log.errors().substr(errorsBefore_), "");
}

int Picture::hits() const
{
    int count = 0;
    each([&](int x, int y) { count += hit(x, y); });
    return count;
}

double Picture::mean() const
{
    double sum = 0;
    each([&](int x, int y) { sum += luminance(x, y); });
    return sum / (width() * height());
}

void useSmallMaps(ParameterValues& hall, int shadowMapSize)
{
    hall.set(hallTable().shadowMapSize, shadowMapSize);
    hall.set(hallTable().probeSize, 32);
    hall.set(hallTable().probeSamples, 16);
}

void seeAlone(PictureRequest& request, std::size_t subject)
{
    FrameRequest& frame = request.frame;
    frame.alone = subject;
    frame.transparent = true;
    frame.averageIn = AverageIn::radiance;
    frame.channels.normal = true;
    request.depth = true;
}

Shot::Shot(std::string_view name, const Museum& in)
    : museum(in), sceneState(in.initialSceneState()), exhibit(in.find(name).value())
{
    useSmallMaps(hall(), 512);
    // Without haze, so that colors of surfaces are exact.
    if (const auto rays = in.find("crepuscular_rays"))
        sceneState.values[*rays].set(raysTable().technique, crepuscular_rays::RayTechnique::none);
    seeAlone(request, exhibit);
    request.frame.raster.size = {96, 54};
    request.frame.camera = in.subject(exhibit).bestView(values());
}

Shot& Shot::inHall()
{
    request.frame.alone.reset();
    request.frame.subject = exhibit;
    request.frame.transparent = false;
    request.frame.camera = museum.get().bestView(exhibit, values());
    return *this;
}

Shot& Shot::size(int width, int height)
{
    request.frame.raster.size = {width, height};
    return *this;
}

Shot& Shot::see(const glm::dvec3& eye, const glm::dvec3& target)
{
    request.frame.camera.eye = eye;
    request.frame.camera.target = target;
    return *this;
}

Shot& Shot::transform(const glm::dmat4& m)
{
    request.frame.exhibitTransform = m;
    return *this;
}

glm::dmat4 Shot::worldFromExhibit() const
{
    return (request.frame.alone ? glm::dmat4(1) : museum.get().worldFromExhibit(exhibit)) *
           request.frame.exhibitTransform;
}

Picture Shot::take() const
{
    PictureMaker maker(museum, gallery().renderer, sceneState, request);
    while (maker.step()) {
    }
    return {maker.picture(), render::makeView(request.frame.camera, request.frame.raster), maker.report()};
}

double largestDifference(const render::Image& a, const render::Image& b)
{
    if (a.pixels.size() != b.pixels.size()) return std::numeric_limits<double>::infinity();
    double largest = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        if (a.pixels[i] == b.pixels[i]) continue;  // Also equal if both are infinite, where nothing was hit.
        const double difference = std::abs(static_cast<double>(a.pixels[i]) - static_cast<double>(b.pixels[i]));
        largest = std::isfinite(difference) ? std::max(largest, difference) : std::numeric_limits<double>::infinity();
    }
    return largest;
}

double colorDifference(const Picture& a, const Picture& b)
{
    double sum = 0;
    a.each([&](int x, int y) {
        const glm::dvec3 d = a.color(x, y) - b.color(x, y);
        sum += glm::dot(d, d);
    });
    return std::sqrt(sum / (3.0 * a.width() * a.height()));
}

void writePanorama(const std::filesystem::path& file, const std::function<glm::dvec3(const glm::dvec3& d)>& radiance)
{
    constexpr int height = 64;
    constexpr double pi = std::numbers::pi;
    std::string rgbe;
    for (int y = 0; y < height; ++y) {
        const double down = pi * (y + 0.5) / height;
        for (int x = 0; x < 2 * height; ++x) {
            // The center of the picture is straight ahead, -z; its right is +x.
            const double right = 2 * pi * ((x + 0.5) / (2 * height) - 0.5);
            const glm::dvec3 c =
                radiance({std::sin(right) * std::sin(down), std::cos(down), -std::cos(right) * std::sin(down)});
            for (int i = 0; i < 3; ++i)
                rgbe += static_cast<char>(static_cast<unsigned char>(std::clamp(c[i] * 64, 0.0, 255.0)));
            rgbe += static_cast<char>(130);  // Exponent: factor 2^(130 - 128) / 256.
        }
    }
    writeBytes(file, hdrClaiming(2 * height, height, rgbe));
}

std::string notFinite(const render::Image& image, int channels)
{
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < channels; ++c)
                if (!std::isfinite(image.at(x, y, c)))
                    return "pixel " + std::to_string(x) + ',' + std::to_string(y) + " channel " + std::to_string(c);
    return {};
}

}  // namespace vitrine::test
