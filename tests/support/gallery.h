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
#include <string_view>

namespace vitrine::test {

/// Context, museum and renderer, shared by all tests of the program because opening them takes a second.
struct Gallery {
    render::gl::HeadlessContext context{true};
    render::gl::DebugLog log;
    Museum museum{allExhibits()};
    render::gl::Renderer renderer;
};
[[nodiscard]] Gallery& gallery();

/// Base class of tests with OpenGL. Skips if the selected driver (GALLIUM_DRIVER=zink) is missing. Fails a test during
/// which the driver reported an error or a message of high severity.
class GlTest : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

private:
    std::size_t errorsBefore_ = 0;
};

/// Sets small sizes of shadow map and probe, so that pictures of the hall take less time.
void useSmallMaps(ParameterValues& hall, int shadowMapSize);
/// Shows one exhibit alone without a background: linear light, depth and normals.
void seeAlone(PictureRequest&, std::size_t subject);

/// Finished picture with its view and its frame report. Pixels count from the top left.
struct Picture {
    render::Image image;
    render::View view;
    render::FrameReport report;

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
    /// Returns the depth along the view axis in meters; infinite where nothing was hit.
    [[nodiscard]] double depth(int x, int y) const { return image.at(x, y, 4); }
    [[nodiscard]] bool hit(int x, int y) const { return std::isfinite(image.at(x, y, 4)); }
    [[nodiscard]] glm::dvec3 normal(int x, int y) const
    {
        return {image.at(x, y, 5), image.at(x, y, 6), image.at(x, y, 7)};
    }
    /// Returns the ray through the center of a pixel, with length 1 along the view axis.
    [[nodiscard]] glm::dvec3 ray(int x, int y) const
    {
        const glm::dvec2 size(width(), height());
        return view.direction(glm::dvec2(x + 0.5, size.y - y - 0.5) / size * 2.0 - 1.0);
    }
    [[nodiscard]] int hits() const;
    /// Returns the mean luminance of all pixels.
    [[nodiscard]] double mean() const;
    /// Calls `visit(x, y)` for every pixel.
    template <typename Visit> void each(const Visit& visit) const
    {
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) visit(x, y);
    }
};

/// Picture to take. By default an exhibit alone from its best view: transparent, linear, with depth and normals, small.
/// Shadow map and probe are small, so that changing the light costs little.
struct Shot {
    Shot() : Shot("sdf_morph") {}
    explicit Shot(std::string_view name, const Museum& in = gallery().museum);

    std::reference_wrapper<const Museum> museum;
    SceneState sceneState;
    PictureRequest request;
    std::size_t exhibit;

    [[nodiscard]] ParameterValues& hall() { return sceneState.hall(); }
    [[nodiscard]] ParameterValues& values() { return sceneState.values[exhibit]; }
    /// Shows the exhibit in the hall, from its best view there.
    Shot& inHall();
    Shot& size(int width, int height);
    Shot& see(const glm::dvec3& eye, const glm::dvec3& target);
    /// Sets the exhibit's transform (scale, rotation, shift) about its own place.
    Shot& transform(const glm::dmat4&);
    /// Returns the transform from the exhibit's own space to the world.
    [[nodiscard]] glm::dmat4 worldFromExhibit() const;
    [[nodiscard]] Picture take() const;
};

/// Shot of the exhibit that has this table.
template <typename Table> struct ExhibitShot : Shot {
    explicit ExhibitShot(std::string_view name) : Shot(name) {}
    template <typename Row, typename Value> ExhibitShot& set(Row row, const Value& value)
    {
        values().set(row, value);
        return *this;
    }
    [[nodiscard]] static const Table& table()
    {
        static const Table made;
        return made;
    }
};

/// Returns the largest difference over all channels of two pictures of equal size; infinite if only one of them is
/// finite somewhere.
[[nodiscard]] double largestDifference(const render::Image&, const render::Image&);
/// Returns the root of the mean squared difference of the colors.
[[nodiscard]] double colorDifference(const Picture&, const Picture&);
/// Writes a small panorama (Radiance HDR) whose radiance in direction `d` of the world is `radiance(d)`. Components are
/// 0 to 3.9 in steps of 1/64.
void writePanorama(const std::filesystem::path&, const std::function<glm::dvec3(const glm::dvec3& d)>& radiance);
/// Returns the first pixel and channel, among the first `channels`, that is NaN or infinite; empty if there is none.
[[nodiscard]] std::string notFinite(const render::Image&, int channels);

}  // namespace vitrine::test
