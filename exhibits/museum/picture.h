#pragma once

#include "exhibits/framework/files/picture_record.h"
#include "exhibits/museum/museum.h"
#include "render/image/image.h"
#include "render/plan/render_backend.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine {

/// Camera and time of one frame.
struct MotionSample {
    render::Camera camera;
    double time = 0;  ///< Seconds.
};

/// Request for a finished picture: any size, any number of samples, drawn by tiles if the size requires it.
struct PictureRequest {
    FrameRequest frame;  ///< `raster.tile`, `raster.jitter`, `sample`, `movingFrame`, `resetHistory` and `finished` are
                         ///< set here, not by the caller.
    int samples = 1;     ///< Supersamples per pixel, averaged.
    /// Earlier frames of a picture in motion, the first one first; such a picture has one sample. Empty: the picture is
    /// static.
    std::vector<MotionSample> motion = {};
    /// Adds the channel "depth.Z". Channels other than color hold the value at the pixel's center.
    bool depth = false;
    /// Adds "position.X" to "position.Z": world-space meters, 0 where nothing was hit.
    bool position = false;
    /// Adds the channels "CryptoObject00.R" to "CryptoObject00.A" of Cryptomatte: which exhibit is at the pixel's
    /// center
    /// (`exrMetadata`). Not for a picture in motion.
    bool objects = false;
    /// Adds the channels "backward.u" and "backward.v": where the surface at the pixel's center was in this frame's
    /// picture, minus the pixel. Pixels, to the right and up. Only the camera's motion counts: surfaces are taken to
    /// stand still. 0 where a surface was behind the camera. Unset: no such channels.
    std::optional<FrameBefore> before = {};
    /// Largest side of a tile in pixels, rounded down to a multiple of 8 and limited to RenderBackend::largestSide().
    int largestTile = 2048;
};

/// Makes a picture step by step, so that a window can show progress and cancel between steps.
class PictureMaker {
public:
    /// Copies scene state and request; museum and backend must outlive it. Throws Failure (ErrorKind::usage) for a size
    /// without pixels, or if the pixels do not fit into half of the machine's memory.
    PictureMaker(const Museum&, render::RenderBackend&, SceneState, PictureRequest);

    /// Returns the plan of the first step without drawing it. For a static picture, before the first step.
    [[nodiscard]] render::FramePlan firstPlan();
    /// Draws one sample of one tile; the first step also prepares the scene. Returns false if the picture was already
    /// finished.
    bool step();
    [[nodiscard]] double progress() const;  ///< 0 to 1.
    [[nodiscard]] bool finished() const;

    /// The finished picture: R, G, B, A, row 0 at the top, alpha not premultiplied. Color is display-referred linear
    /// light or radiance, by `frame.averageIn`. Further channels, if requested: "depth.Z" (meters along the view axis,
    /// infinity where nothing was hit), "normal.X" "normal.Y" "normal.Z" (world space), "evaluations", "albedo",
    /// "backward", "position" and "CryptoObject00" (as in the request).
    [[nodiscard]] const render::Image& picture() const { return picture_; }
    /// Report of the first sample of the first tile; of a picture in motion, that of its last frame.
    [[nodiscard]] const render::FrameReport& report() const { return report_; }

private:
    struct Tile {
        glm::ivec2 offset, size;            ///< Pixels, from the lower left corner of the picture.
        glm::ivec2 drawnOffset, drawnSize;  ///< The same with a margin around it, clipped to the picture.
    };
    /// Returns the number of samples of a tile, or of frames of a motion.
    [[nodiscard]] std::size_t stepsOfTile() const;
    /// Returns the number of steps in which all tiles are drawn. Steps after them find their objects.
    [[nodiscard]] std::size_t drawingSteps() const { return tiles_.size() * stepsOfTile(); }
    [[nodiscard]] std::size_t allSteps() const { return drawingSteps() + (request_.objects ? tiles_.size() : 0); }
    [[nodiscard]] FrameRequest frameOf(const Tile&, int step) const;
    void drawHalos();
    void drawStep();
    void takeChannels(const Tile&);
    void takePosition(const Tile&, const render::Image& depth, int to);
    void takeMotion(const Tile&, const render::Image& depth, int to);
    void takeObjects(const Tile&);
    void takeColor(const Tile&);
    void copyChannels(const render::Image&, const Tile&, int from, int count, int to);
    void finish();

    const Museum& museum_;
    render::RenderBackend& backend_;
    SceneState sceneState_;
    PictureRequest request_;
    std::optional<Prepared> prepared_;    ///< Set by the first step.
    std::shared_ptr<const Halos> halos_;  ///< For the tiles. Null: there are none.
    render::Image picture_;
    render::FrameReport report_;
    std::vector<Tile> tiles_;
    std::size_t stepsDone_ = 0;
};

}  // namespace vitrine
