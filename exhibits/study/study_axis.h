#pragma once

#include "exhibits/framework/subject.h"
#include "exhibits/museum/scene_state.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace vitrine {

/// One parameter that a study varies, and the values it tries: numbers as `ParameterValues` stores them, ascending.
struct StudyAxis {
    std::size_t subject = 0;  ///< Whose: that of the study, or the hall, which all pictures share.
    std::size_t row = 0;
    std::vector<double> values;

    bool operator==(const StudyAxis&) const = default;
};

/// Which value of each axis.
using Setting = std::vector<std::size_t>;

/// The row that an axis varies, in the table that the look's values have; the look must outlive it.
[[nodiscard]] const ParameterInfo& rowOf(const SceneState&, const StudyAxis&);

/// "stepLimit", or "hall.shadowMapSize" where the hall is not the subject.
[[nodiscard]] std::string axisName(Subjects, const SceneState&, std::size_t subject, const StudyAxis&);

/// Name of the axis's parameter as the interface shows it: "Step limit"; of the hall's, "The hall: Shadow map size".
[[nodiscard]] std::string axisLabel(Subjects, const SceneState&, std::size_t subject, const StudyAxis&);

/// The value of an axis for people: "64", "none", "on".
[[nodiscard]] std::string axisValueText(const SceneState&, const StudyAxis&, double value);

/// An axis over the comfortable range of a quality row, about `points` values by the row's scale, with the initial
/// value and the exact one; of a choice or a toggle, all. Nothing for a row that is not marked as quality.
[[nodiscard]] std::optional<StudyAxis> studyAxis(const SceneState&, std::size_t subject, std::size_t row, int points);

/// How many values each axis is given where nobody says: few of a surface, many of a curve, and most where a search
/// among three axes or more measures only those that matter.
[[nodiscard]] constexpr int usualPoints(std::size_t axes)
{
    return axes == 1 ? 8 : axes == 2 ? 5 : 17;
}

/// One axis for every quality row of the subject; of `usualPoints` values where `points` is 0.
[[nodiscard]] std::vector<StudyAxis> qualityAxes(const SceneState&, std::size_t subject, int points = 0);

/// The values at which everything that the table marks as quality counts as exact.
[[nodiscard]] ParameterValues atReference(ParameterValues);

/// Where a row counts as exact, and what tells how sure that is.
struct Exactness {
    double exact = 0;
    /// Values whose pictures the exact one's is checked against: half or double on a logarithmic scale, one less or
    /// more of a count; towards the initial value, or both ways from a value that is the initial one. Empty for a row
    /// that is exact by its meaning, and for one that nothing can check: a choice, a number on a linear scale.
    std::vector<double> neighbors;
    bool byMeaning = false;        ///< Its row says so: nothing is approximated there.
    std::optional<double> beyond;  ///< As far away from the initial value, while legal.
};
/// `doublings` moves the exact value that many times away from the initial one, on a logarithmic scale, while legal.
[[nodiscard]] Exactness exactness(const ParameterInfo&, int doublings = 0);

/// The settings, none to two, whose pictures a reference of all these axes is checked against: every axis at its first
/// neighbor, then every one at its last.
[[nodiscard]] std::vector<std::vector<double>> neighborsOf(const SceneState&, const std::vector<StudyAxis>&,
                                                           int doublings = 0);

}  // namespace vitrine
