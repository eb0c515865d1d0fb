#pragma once

#include "exhibits/framework/scene/scene_object.h"
#include "exhibits/museum/scene_state.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::study {

/// One parameter that a study varies, and the values that it tries: numbers as in `ParameterValues`, ascending.
struct StudyAxis {
    std::size_t subject = 0;  ///< Subject of the study, or the hall, which all pictures share.
    std::size_t row = 0;
    std::vector<double> values;

    bool operator==(const StudyAxis&) const = default;
};

/// Index of the value of each axis.
using Setting = std::vector<std::size_t>;

/// Returns the parameter that an axis varies, from the table of the scene state's values. The scene state must outlive
/// it.
[[nodiscard]] const ParameterInfo& parameterOf(const SceneState&, const StudyAxis&);

/// Returns "stepLimit", or "hall.shadowMapSize" if the hall is not the subject.
[[nodiscard]] std::string axisName(Subjects, const SceneState&, std::size_t subject, const StudyAxis&);

/// Returns the label of the parameter in the interface: "Step limit"; with the hall's, "The hall: Shadow map size".
[[nodiscard]] std::string axisLabel(Subjects, const SceneState&, std::size_t subject, const StudyAxis&);

/// Returns a value of an axis as displayed: "64", "none", "on".
[[nodiscard]] std::string axisValueText(const SceneState&, const StudyAxis&, double value);

/// Returns an axis over the soft range of a quality parameter: about `points` values on the parameter's scale, with the
/// initial and the exact one. A choice or toggle gets all its values. Nothing if the parameter is not marked as
/// quality.
[[nodiscard]] std::optional<StudyAxis> studyAxis(const SceneState&, std::size_t subject, std::size_t row, int points);

/// Returns the default number of values per axis: few for a surface, more for a curve. It is largest for a search among
/// three axes or more, which measures only the settings that matter.
[[nodiscard]] constexpr int usualPoints(std::size_t axes)
{
    return axes == 1 ? 8 : axes == 2 ? 5 : 17;
}

/// Returns one axis for every quality parameter of the subject, with `points` values each, or `usualPoints` if 0.
[[nodiscard]] std::vector<StudyAxis> qualityAxes(const SceneState&, std::size_t subject, int points = 0);

/// Returns the values with all quality parameters at the values that count as exact.
[[nodiscard]] ParameterValues atReference(ParameterValues);

/// Exact value of a parameter, and how it can be verified.
struct Exactness {
    double exact = 0;
    /// Values whose pictures are compared with the exact one's: half or double on a logarithmic scale, one less or more
    /// of a count. They lie towards the initial value, or on both sides if the exact value is the initial one. Empty
    /// for a parameter that is exact by its meaning, a choice, or a number on a linear scale, which nothing can verify.
    std::vector<double> neighbors;
    bool byMeaning = false;        ///< The parameter is declared to approximate nothing there.
    std::optional<double> beyond;  ///< Next value away from the initial one, if legal; only on a logarithmic scale.
};
/// Returns the exactness. `doublings` moves the exact value that many times away from the initial one, on a logarithmic
/// scale, while legal.
[[nodiscard]] Exactness exactness(const ParameterInfo&, int doublings = 0);

/// Returns up to two settings whose pictures are compared with a reference of all these axes: every axis at its first
/// neighbor, then every axis at its last.
[[nodiscard]] std::vector<std::vector<double>> neighborsOf(const SceneState&, const std::vector<StudyAxis>&,
                                                           int doublings = 0);

}  // namespace vitrine::study
