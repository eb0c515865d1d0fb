#pragma once

#include "exhibits/printing/print_table.h"
#include "exhibits/printing/view_maker.h"
#include "exhibits/printing/view_set.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::printing {

/// Views of a print during setup, from left to right: full size for the print, small ones for previews.
class PrintViews {
public:
    /// Adds a picture of linear light, row 0 at the top, as the new rightmost view. `picture` is its number among all
    /// given pictures, from 1; 0 for a rendered view. Throws Failure if the picture is empty.
    void add(const render::Image&, int picture = 0);
    /// Sets the ICC profile of the pictures, which is stored in the print.
    void setProfile(std::string profile) { profile_ = std::move(profile); }
    /// Adds a full sentence on what was left out or changed while reading, unless it is empty or a repetition.
    void addNote(const std::string&);
    /// Sets the JSON text of the rendered scene state, which is stored in the print.
    void setScenePreset(std::string preset) { scenePreset_ = std::move(preset); }

    [[nodiscard]] int count() const { return full_.count(); }
    [[nodiscard]] const ViewSet& full() const { return full_; }
    /// Returns the numbers of the pictures of the views, as given to `add`.
    [[nodiscard]] const std::vector<int>& pictures() const { return pictures_; }
    [[nodiscard]] const ViewSet& small() const { return small_; }
    [[nodiscard]] const std::string& profile() const { return profile_; }
    [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
    [[nodiscard]] const std::string& scenePreset() const { return scenePreset_; }

private:
    ViewSet full_, small_;
    std::vector<int> pictures_;
    std::string profile_, scenePreset_;
    std::vector<std::string> notes_;
};

/// Callback for the finished share, 0 to 1. If it returns false, the work stops and throws Failure.
using Progress = std::function<bool(double)>;

/// Reads the pictures of the values, evenly spaced, or the views of a quilt. Throws Failure naming the file, also if
/// stopped.
[[nodiscard]] std::shared_ptr<const PrintViews> readViews(const ParameterValues&, const std::vector<std::string>& files,
                                                          const Progress&);

/// Returns the views to render, from left to right, with the scene state's camera in the middle. `draft` makes them
/// small and quick, for setting up. `frame` gives everything except camera, size and seed. Throws Failure if the print
/// is impossible.
[[nodiscard]] std::vector<ViewShot> printShots(const ParameterValues&, const SceneState&, const FrameRequest& frame,
                                               bool draft);

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
