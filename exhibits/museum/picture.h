#pragma once

#include "exhibits/museum/museum.h"
#include "render/image/image.h"
#include "render/plan/render_backend.h"

#include <optional>
#include <string>
#include <vector>

namespace vitrine {

/// From where one looks, and when.
struct Moment {
    render::Camera camera;
    double time = 0;  ///< Seconds.
};

/// A finished picture to make: any size, any number of samples, by tiles where the size asks for it.
struct PictureRequest {
    FrameRequest frame;  ///< `raster.tile`, `raster.jitter`, `sample`, `movingFrame`, `cut` and `finished` are set
                         ///< here, not by the caller.
    int samples = 1;     ///< Supersamples per pixel, averaged.
    /// The frames before, the first one first, of a picture in motion, which is then of one sample. Empty: it rests.
    std::vector<Moment> motion = {};
    bool depth = false;  ///< Add the channel "depth.Z". Channels other than color are of the pixel's center.
    int largestTile =
        2048;  ///< Side in pixels, rounded down to a multiple of 8; never above what the painter can draw.
};

/// Makes a picture step by step, so that a window can show progress and cancel between steps.
class PictureMaker {
public:
    /// SceneState and request are copied; museum and painter must outlive it. Throws Failure (Blame::usage) for a size
    /// without pixels, or whose pixels do not fit into half of the machine's memory.
    PictureMaker(const Museum&, render::RenderBackend&, SceneState, PictureRequest);

    /// What the first step would do: nothing is drawn. Of a picture at rest that was not begun.
    [[nodiscard]] render::FramePlan firstPlan();
    /// Draws one sample of one tile; the first one prepares the picture. Returns false when it was already finished.
    bool step();
    [[nodiscard]] double progress() const;  ///< 0 to 1.
    [[nodiscard]] bool finished() const;

    /// R, G, B, A, row 0 at the top, alpha not premultiplied: display-referred linear light or radiance, as
    /// `frame.averageIn` asks; then "depth.Z" (meters along the view axis, infinity where nothing was hit),
    /// "normal.X" "normal.Y" "normal.Z" (world space) and "evaluations", as asked. Only when finished.
    [[nodiscard]] const render::Image& picture() const { return picture_; }
    /// Of the first sample of the first tile; of a motion, of its last frame.
    [[nodiscard]] const render::FrameReport& report() const { return report_; }

private:
    struct Tile {
        glm::ivec2 offset, size;            ///< Pixels, from the lower left corner of the picture.
        glm::ivec2 drawnOffset, drawnSize;  ///< The same with an apron around it, as far as the picture goes.
    };
    /// Of a tile: so many samples, or frames of a motion.
    [[nodiscard]] std::size_t stepsOfTile() const;
    [[nodiscard]] FrameRequest frameOf(const Tile&, int step) const;
    void takeChannels(const Tile&);
    void takeColor(const Tile&);
    void copyChannels(const render::Image&, const Tile&, int from, int count, int to);
    void finish();

    const Museum& museum_;
    render::RenderBackend& backend_;
    SceneState sceneState_;
    PictureRequest request_;
    std::optional<Prepared> prepared_;  ///< Since the first step.
    render::Image picture_;
    render::FrameReport report_;
    std::vector<Tile> tiles_;
    std::size_t stepsDone_ = 0;
};

}  // namespace vitrine
