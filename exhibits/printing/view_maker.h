#pragma once

#include "exhibits/museum/picture.h"
#include "exhibits/printing/view_rig.h"

#include <functional>
#include <optional>
#include <vector>

namespace vitrine::printing {

/// One view of a print to be rendered.
struct ViewShot {
    SceneState sceneState;
    PictureRequest request;
};

/// Returns a shot for every camera of the rig, otherwise as in `base`. Each has its own seed (`base`'s plus the number
/// of the view). Equal noise in both eyes would look like dirt on the sheet.
[[nodiscard]] std::vector<ViewShot> shotsOf(const ViewRig&, const ViewShot& base);

/// Rotates the exhibit that is shown (`request.frame.subject` or `alone`) about its own vertical axis. `angle` is that
/// of all views together, in radians: view k gets ((k + 1/2)/N - 1/2) angle. So a full turn closes without a repeated
/// view. Positive angles look like walking around the exhibit to the right, so it is seen in depth. Throws Failure
/// (ErrorKind::usage) if the shots show no single exhibit.
void turn(std::vector<ViewShot>&, double angle);

/// Interpolates every number, color and direction in which `from` and `to` differ, including both ends, on the
/// parameter's own scale if possible. A single shot gets the middle. Throws Failure (ErrorKind::usage) if nothing
/// differs, or if a parameter cannot be interpolated (a choice, a switch, a file).
void sweep(std::vector<ViewShot>&, const SceneState& from, const SceneState& to);

/// Renders shots one after the other. It works step by step, so a window can show progress and cancel between steps.
class ViewMaker {
public:
    /// Callback for each finished view: its number and the picture, of linear light for display.
    using Take = std::function<void(int, const render::Image&)>;

    /// Museum and backend must outlive it.
    ViewMaker(const Museum&, render::RenderBackend&, std::vector<ViewShot>, Take);

    /// Draws one sample of one tile of one view. Returns false if all are finished.
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

/// Returns the shot as a quick picture with one sample per pixel, `width` pixels wide, and the channel "depth.Z".
[[nodiscard]] ViewShot depthShot(ViewShot, int width = 240);

/// Returns the depth range of the shot's scene, measured in such a picture.
[[nodiscard]] DepthRange measuredDepth(const Museum&, render::RenderBackend&, const ViewShot&);

}  // namespace vitrine::printing
