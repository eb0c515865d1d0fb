#pragma once

#include "exhibits/framework/parameters.h"
#include "render/scene/camera.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// A fixed situation in which an accuracy study measures: seen from `camera` (in the subject's own space) at
/// `time`, with `values` in place of what the study started from: "spin of 120 degrees".
struct StudyView {
    std::string name;
    render::Camera camera;
    double time = 0;  ///< Seconds.
    ParameterValues values;
};

/// What visitors set, look at and study: the building, or an exhibit in it. Panels, presets, undo, flags and studies
/// work on the tables of subjects, whatever stands behind them.
class Subject {
public:
    virtual ~Subject() = default;

    [[nodiscard]] virtual std::string_view name() const = 0;         ///< Of its folder, presets and flags.
    [[nodiscard]] virtual std::string_view title() const = 0;        ///< Shown to visitors.
    [[nodiscard]] virtual std::string_view summary() const = 0;      ///< One sentence.
    [[nodiscard]] virtual const Parameters& parameters() const = 0;  ///< The table of initial values.

    /// The space it may fill, in its own space: what is culled, framed and collided with.
    [[nodiscard]] virtual render::Box bounds(const ParameterValues&) const = 0;
    /// Its best view, in its own space.
    [[nodiscard]] virtual render::Camera bestView(const ParameterValues&) const = 0;
    /// The views of its accuracy studies, easy and hard ones, starting from these values; at least one.
    [[nodiscard]] virtual std::vector<StudyView> studyViews(const ParameterValues& values) const
    {
        return {{"best view", bestView(values), 0, values}};
    }
};

/// All subjects of a museum, in its order.
using Subjects = std::span<const Subject* const>;

}  // namespace vitrine
