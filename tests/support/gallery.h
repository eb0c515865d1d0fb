#pragma once

#include "exhibits/exhibits.h"
#include "exhibits/museum/museum.h"
#include "exhibits/museum/picture.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"
#include "tests/support/tables.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <string>

namespace vitrine::test {

/// One context, one museum and one renderer for all tests of the program: they take a second to open.
struct Gallery {
    render::gl::HeadlessContext context{true};
    render::gl::DebugLog log;
    Museum museum{allExhibits()};
    render::gl::Renderer renderer;
};
[[nodiscard]] Gallery& gallery();

/// Skips where the driver asked for (GALLIUM_DRIVER=zink) is not here; fails a test during which the
/// driver reported an error or a message of high severity.
class GlTest : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

private:
    std::size_t errorsBefore_ = 0;
};

/// Shadow map and probe small, so that a picture of the hall takes less time.
void useSmallMaps(ParameterValues& hall, int shadowMapSize);
/// One exhibit alone on nothing: linear light, depth and normals.
void seeAlone(PictureRequest&, std::size_t subject);

/// A finished picture and what it shows where. Pixels from the top left.
struct Picture {
    render::Image image;
    render::View view;

    [[nodiscard]] int width() const { return image.width; }
    [[nodiscard]] int height() const { return image.height; }
    [[nodiscard]] glm::dvec3 color(int x, int y) const
    {
        return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
    }
    [[nodiscard]] double luminance(int x, int y) const
    {
        return glm::dot(color(x, y), glm::dvec3(0.2126, 0.7152, 0.0722));
    }
    [[nodiscard]] double alpha(int x, int y) const { return image.at(x, y, 3); }
    /// Meters along the view axis; infinite where nothing was hit.
    [[nodiscard]] double depth(int x, int y) const { return image.at(x, y, 4); }
    [[nodiscard]] bool hit(int x, int y) const { return std::isfinite(image.at(x, y, 4)); }
    [[nodiscard]] glm::dvec3 normal(int x, int y) const
    {
        return {image.at(x, y, 5), image.at(x, y, 6), image.at(x, y, 7)};
    }
    [[nodiscard]] int hits() const;
    /// Mean over all pixels of the luminance.
    [[nodiscard]] double mean() const;
    /// Calls `visit(x, y)` for every pixel.
    template <typename Visit> void each(const Visit& visit) const
    {
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) visit(x, y);
    }
};

/// A picture to take: by default of the torus-mug alone, transparent, linear, with depth and normals, from
/// its best view, small. Shadow map and probe are small, so that changing the light costs little.
struct Shot {
    Shot();

    SceneState sceneState;
    PictureRequest request;
    std::size_t sdf = 0;

    [[nodiscard]] ParameterValues& hall() { return sceneState.hall(); }
    [[nodiscard]] ParameterValues& object() { return sceneState.values[sdf]; }
    /// In the hall, from the exhibit's best view there.
    Shot& inHall();
    Shot& size(int width, int height);
    Shot& see(const glm::dvec3& eye, const glm::dvec3& target);
    /// Scale, rotation and shift about the exhibit's own place.
    Shot& transform(const glm::dmat4&);
    /// Where the exhibit stands: world from its own space.
    [[nodiscard]] glm::dmat4 worldFromExhibit() const;
    [[nodiscard]] Picture take() const;
};

/// Largest difference over all channels of two pictures of one size; infinite when only one is finite somewhere.
[[nodiscard]] double largestDifference(const render::Image&, const render::Image&);
/// Root of the mean squared difference of the colors.
[[nodiscard]] double colorDifference(const Picture&, const Picture&);
/// Writes a small panorama (Radiance HDR) in which direction `d` of the world sends `radiance(d)`, each
/// component 0 to 3.9 in steps of 1/64.
void writePanorama(const std::filesystem::path&, const std::function<glm::dvec3(const glm::dvec3& d)>& radiance);
/// Empty, or the first pixel and channel among the first `channels` that is NaN or infinite.
[[nodiscard]] std::string notFinite(const render::Image&, int channels);

}  // namespace vitrine::test
