#pragma once

#include "exhibits/framework/scene/exhibit.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace vitrine {

struct Halos;

/// Space in which supersamples are averaged: tone-mapped light for display, radiance for files with linear light.
enum class AverageIn : std::uint8_t { display, radiance };

/// Request for one frame.
struct FrameRequest {
    render::Camera camera;
    render::Raster raster;
    double time = 0;  ///< Time of the frame in seconds.
    std::uint32_t seed = 1;
    int sample = 0;   ///< Index of this supersample, from 0.
    int samples = 1;  ///< Number of supersamples.
    /// Above 0: number of the frame, from 1, in a picture in motion, whose pixels are averaged with those of earlier
    /// frames as the hall's parameters say. 0: static picture. Requires `samples` of 1.
    int movingFrame = 0;
    AverageIn averageIn = AverageIn::display;
    Channels channels;
    bool transparent = false;  ///< No sky or environment in the background: alpha 0 there.
    /// Draws only this exhibit (by its index in Museum::subjects()), in the environment's light.
    std::optional<std::size_t> alone;
    /// Draws only this exhibit, at its place, in the hall's light: alpha 0 around it.
    std::optional<std::size_t> cutOut;
    glm::dmat4 exhibitTransform{1};  ///< For `alone` or `subject`: scale and rotation around its own origin.
    std::optional<std::size_t> subject;
    bool runEverything = false;
    bool resetHistory = false;  ///< Discards all histories, because the camera jumped.
    /// The frame is not drawn again: completes sliced passes in this frame, and waits for programs instead of using
    /// fallbacks.
    bool finished = false;
    /// True: Museum::prepare throws Failure if a named file cannot be read. False: the plan only contains a warning.
    bool needsFiles = false;
    /// The values have not changed for a while, so that specialized programs may be built (ShaderKey::specialized).
    bool idle = false;
    /// Limits the visible exhibits to this number, the nearest ones first: at startup a picture appears soon and is
    /// extended later.
    int mostExhibits = std::numeric_limits<int>::max();
    bool nonBlocking = false;  ///< Prepared on a thread that must not block: leaves out assets that are not loaded yet.
    /// Halos of the whole picture, for a part of it (`raster.tile`). Null: a part has none.
    std::shared_ptr<const Halos> halos = {};
    /// Seconds since the last press of each exhibit's button, in the order of Museum::subjects(); may be shorter.
    std::vector<double> sincePressed;
};

/// Quality of a picture: parameters of the hall that do not change its content.
struct PictureQuality {
    int supersamples = 16;
    double resolutionScale = 1;
    int historyFrames = 1;  ///< Number of frames over which a picture in motion is averaged; 1: no averaging.
};
inline constexpr std::string_view supersamplesParameter = "supersamples";
inline constexpr std::string_view resolutionScaleParameter = "resolutionScale";
inline constexpr std::string_view temporalAntialiasingParameter = "temporalAntialiasing";
inline constexpr std::string_view historyFramesParameter = "historyFrames";

/// Returns the quality from the hall's values; the defaults if the hall has no such parameters.
[[nodiscard]] PictureQuality pictureQuality(const ParameterValues& hall);

}  // namespace vitrine
