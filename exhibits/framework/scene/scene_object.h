#pragma once

#include "exhibits/framework/table/parameters.h"
#include "render/scene/camera.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// A fixed situation that an accuracy study measures: the view from `camera` (in the subject's own space) at `time`,
/// with `values` instead of the study's initial ones: "spin of 120 degrees".
struct StudyView {
    std::string name;
    render::Camera camera;
    double time = 0;  ///< Seconds.
    ParameterValues values;
};

/// The building or an exhibit: everything that has parameters. Panels, presets, undo, command-line options and studies
/// work on subjects, whatever their kind.
class SceneObject {
public:
    virtual ~SceneObject() = default;

    [[nodiscard]] virtual std::string_view name() const = 0;         ///< Name of its folder, presets and options.
    [[nodiscard]] virtual std::string_view title() const = 0;        ///< Shown to visitors.
    [[nodiscard]] virtual std::string_view summary() const = 0;      ///< One sentence.
    [[nodiscard]] virtual const Parameters& parameters() const = 0;  ///< Its parameters with their initial values.

    /// Returns the space that it may fill, in its own space; used for culling, framing and collisions.
    [[nodiscard]] virtual render::Box bounds(const ParameterValues&) const = 0;
    /// Returns its best view, in its own space.
    [[nodiscard]] virtual render::Camera bestView(const ParameterValues&) const = 0;
    /// Returns the views of its accuracy studies, easy and hard ones, based on these values; at least one.
    [[nodiscard]] virtual std::vector<StudyView> studyViews(const ParameterValues& values) const
    {
        return {{"best view", bestView(values), 0, values}};
    }
};

/// All subjects of a museum, in its order.
using Subjects = std::span<const SceneObject* const>;

}  // namespace vitrine
