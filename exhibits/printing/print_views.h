#pragma once

#include "exhibits/printing/print_table.h"
#include "exhibits/printing/view_maker.h"
#include "exhibits/printing/view_set.h"
#include "render/files/strict_json.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::printing {

/// Use that views are read for.
enum class ViewUse : std::uint8_t {
    setup,  ///< Small ones are made for previews, too. A number of views above that of the pictures means all of them.
    print,  ///< Refuses such a number, and places of pictures that do not exist.
};

/// Views of a print, from left to right: full size for the print, small ones for previews.
class PrintViews {
public:
    explicit PrintViews(ViewUse use = ViewUse::setup) : use_(use) {}

    /// Adds a picture of linear light, row 0 at the top, as the new rightmost view. `picture` is its number among all
    /// given pictures, from 1; 0 for a rendered view. `source` describes where it comes from. Throws Failure if the
    /// picture is empty.
    void add(const render::Image&, int picture = 0, std::string source = {});
    /// Sets the ICC profile of the pictures, which is stored in the print.
    void setProfile(std::string profile) { profile_ = std::move(profile); }
    /// Adds a full sentence on what was left out or changed while reading, unless it is empty or a repetition.
    void addNote(const std::string&);
    /// Sets the JSON text of the rendered scene state, which is stored in the print.
    void setScenePreset(std::string preset) { scenePreset_ = std::move(preset); }
    /// Sets the numbers of the cameras of rendered views, for the description of the print.
    void setRig(render::Json rig) { rig_ = std::move(rig); }

    [[nodiscard]] int count() const { return full_.count(); }
    [[nodiscard]] const ViewSet& full() const { return full_; }
    /// Returns the numbers of the pictures of the views, as given to `add`.
    [[nodiscard]] const std::vector<int>& pictures() const { return pictures_; }
    /// Returns the descriptions of the views' sources, such as "a.png, placed by 1:0,25,0".
    [[nodiscard]] const std::vector<std::string>& sources() const { return sources_; }
    /// Empty for `ViewUse::print`.
    [[nodiscard]] const ViewSet& small() const { return small_; }
    [[nodiscard]] const std::string& profile() const { return profile_; }
    [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
    [[nodiscard]] const std::string& scenePreset() const { return scenePreset_; }
    [[nodiscard]] const render::Json& rig() const { return rig_; }

private:
    ViewUse use_;
    ViewSet full_, small_;
    std::vector<int> pictures_;
    std::vector<std::string> sources_;
    std::string profile_, scenePreset_;
    render::Json rig_ = nullptr;
    std::vector<std::string> notes_;
};

/// Callback for the finished share, 0 to 1. If it returns false, the work stops and throws Failure.
using Progress = std::function<bool(double)>;

/// Reads the pictures of the values, in their order, or the views of a quilt. Throws Failure naming the file or option,
/// also if stopped.
[[nodiscard]] std::shared_ptr<const PrintViews> readViews(const ParameterValues&, const Progress&,
                                                          ViewUse = ViewUse::setup);

/// Returns the pixels of a rendered view: as given, else in the shape of the print. Throws Failure (ErrorKind::usage)
/// for a height without a width.
[[nodiscard]] glm::ivec2 viewSize(const PrintLayout&, const ParameterValues&);

/// Museum and subject whose parameters the views sweep.
struct SweptScene {
    const Museum* museum = nullptr;  ///< Null: nothing is swept.
    std::size_t subject = 0;
    std::vector<std::string> notes = {};  ///< Sentences on values that were brought into their range.
};

/// Rig and views of a print that are rendered from `base`, whose size, samples, turn and sweeps follow the values.
class RenderedViews {
public:
    /// `base` gives everything but the size. Throws Failure (ErrorKind::usage) if the print is impossible, nothing can
    /// turn, or a sweep is malformed.
    RenderedViews(const ParameterValues&, const PrintLayout&, ViewShot base, SweptScene&);

    [[nodiscard]] const ViewRig& rig() const { return rig_; }
    [[nodiscard]] const ViewShot& base() const { return base_; }
    /// Returns the views to render, from left to right, with the camera of `base` in the middle.
    [[nodiscard]] const std::vector<ViewShot>& shots() const { return shots_; }
    /// Whether the distance of the cameras awaits `fit`.
    [[nodiscard]] bool waitsForDepth() const { return !strength_; }
    /// Brings the cameras as close together as the depth of the scene asks for, if the values say so.
    void fit(const DepthRange&);

private:
    [[nodiscard]] ViewRig rigOf(double strength) const;

    PrintLayout layout_;
    ViewShot base_;
    double convergence_;
    std::optional<double> strength_;
    ViewRig rig_;
    std::vector<ViewShot> shots_;
};

/// Returns the views to render for the window's scene state. `draft` makes them small and quick, for setting up.
/// `frame` gives everything except camera, size and seed. Throws Failure like `RenderedViews`.
[[nodiscard]] RenderedViews printShots(const ParameterValues&, const SceneState&, const FrameRequest& frame, bool draft,
                                       SweptScene&& = {});

/// Depth range of the scene from the camera, and the range that the print can show.
struct SceneDepth {
    DepthRange scene, held;
    double strengthThatHolds = 1;  ///< RigSettings::strength at which the print can show all of it, at most 1.
    std::vector<std::string> warnings{};
};
/// Returns the depth from a picture of the scene state with the channel "depth.Z". Throws Failure if the print is
/// impossible.
[[nodiscard]] SceneDepth sceneDepth(const ParameterValues&, const SceneState&, const render::Image&);

}  // namespace vitrine::printing
