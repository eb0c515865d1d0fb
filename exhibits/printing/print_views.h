#pragma once

#include "exhibits/printing/print_table.h"
#include "exhibits/printing/view_maker.h"
#include "exhibits/printing/view_set.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::printing {

/// The views of a print that is being set up, from left to right: in full for the print, small ones for looking at it.
class PrintViews {
public:
    /// Adds a picture of linear light, row 0 at the top, as the new rightmost view. `picture`: its number among all
    /// pictures given, from 1; 0 for a rendered view. Throws Failure when it is empty.
    void add(const render::Image&, int picture = 0);
    /// ICC profile of the pictures, for the print to carry.
    void setProfile(std::string profile) { profile_ = std::move(profile); }
    /// Adds a full sentence on what was left out or changed while reading, unless it is empty or there already.
    void addNote(const std::string&);
    /// The JSON text of the look that was rendered, for the print to carry.
    void setScenePreset(std::string preset) { scenePreset_ = std::move(preset); }

    [[nodiscard]] int count() const { return full_.count(); }
    [[nodiscard]] const ViewSet& full() const { return full_; }
    /// Numbers of the pictures that the views were made from, as given to `add`.
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

/// Called with the part that is done, 0 to 1; false stops the work, which then throws Failure.
using Progress = std::function<bool(double)>;

/// Reads what the values ask for: pictures, spread evenly, or the views of a quilt. Throws Failure naming the file,
/// also when it was stopped.
[[nodiscard]] std::shared_ptr<const PrintViews> readViews(const ParameterValues&, const std::vector<std::string>& files,
                                                          const Progress&);

/// What to render, from left to right, with the look's camera in the middle. `draft`: small and quick, to look at while
/// setting up. `frame` gives all but camera, size and seed. Throws Failure where no such print can be made.
[[nodiscard]] std::vector<ViewShot> printShots(const ParameterValues&, const SceneState&, const FrameRequest& frame,
                                               bool draft);

/// How far the scene reaches from the camera, and from where to where the print holds it.
struct SceneDepth {
    DepthRange scene, held;
    double strengthThatHolds = 1;  ///< RigSettings::strength at which the print holds all of it, at most 1.
    std::vector<std::string> warnings{};
};
/// From a picture of the look with the channel "depth.Z". Throws Failure where no such print can be made.
[[nodiscard]] SceneDepth sceneDepth(const ParameterValues&, const SceneState&, const render::Image&);

}  // namespace vitrine::printing
