#pragma once

#include "exhibits/museum/picture.h"
#include "exhibits/printing/view_rig.h"

#include <functional>
#include <optional>
#include <vector>

namespace vitrine::printing {

/// One view of a print, to be rendered.
struct ViewShot {
    SceneState sceneState;
    PictureRequest request;
};

/// A shot for every camera of the rig; all else as in `base`. Each has a seed of its own (`base`'s plus the number
/// of the view), so that noise does not stand still between the eyes, where it would look like dirt on the sheet.
[[nodiscard]] std::vector<ViewShot> shotsOf(const ViewRig&, const ViewShot& base);

/// Turns the exhibit that is shown (`request.frame.subject` or `alone`) about its own vertical axis, by `angle`
/// radians over all views: view k by ((k + 1/2)/N - 1/2) angle, so that a full turn meets itself without a double.
/// Positive: as if one walked around it to the right, so that it is seen in depth. Throws Failure (Blame::usage)
/// where the shots show no single exhibit.
void turn(std::vector<ViewShot>&, double angle);

/// Lets every number, color and direction in which `from` and `to` differ run from one to the other, the ends
/// included; on the row's own scale where both ends allow it. Throws Failure (Blame::usage) when nothing differs,
/// or something that has no values between (a choice, a switch, a file).
void sweep(std::vector<ViewShot>&, const SceneState& from, const SceneState& to);

/// Renders shots one after the other, step by step, so that a window can show progress and cancel between steps.
class ViewMaker {
public:
    /// Told each finished view: its number and the picture, of display-referred linear light.
    using Take = std::function<void(int, const render::Image&)>;

    /// Museum and painter must outlive it.
    ViewMaker(const Museum&, render::RenderBackend&, std::vector<ViewShot>, Take);

    /// Draws one sample of one tile of one view. Returns false when all were already finished.
    bool step();
    [[nodiscard]] double progress() const;  ///< 0 to 1.

private:
    const Museum& museum_;
    render::RenderBackend& backend_;
    std::vector<ViewShot> shots_;
    Take take_;
    std::size_t next_ = 0;
    std::optional<PictureMaker> maker_;
};

/// The same shot as a quick look with one sample per pixel, `width` pixels wide, and the channel "depth.Z".
[[nodiscard]] ViewShot depthShot(ViewShot, int width = 240);

/// How far the shot's scene reaches, by such a quick look.
[[nodiscard]] DepthRange measuredDepth(const Museum&, render::RenderBackend&, const ViewShot&);

}  // namespace vitrine::printing
