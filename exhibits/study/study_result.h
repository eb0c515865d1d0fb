#pragma once

#include "exhibits/museum/museum.h"
#include "exhibits/study/study_axis.h"
#include "render/image/image.h"
#include "render/measure/metrics.h"
#include "render/measure/statistics.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::study {

/// Index of a parameter of a subject.
struct StudyParameter {
    std::size_t subject = 0, row = 0;

    bool operator==(const StudyParameter&) const = default;
};

/// Setting that a study changed, so one of its parameters has an effect.
struct StudyChange {
    enum class Why : std::uint8_t {
        acts,   ///< The parameter acts only with this value.
        shows,  ///< The table declares that the parameter is visible only with this value.
        limits  ///< Any other value caps or overrides the parameter.
    };
    StudyParameter row;
    double from = 0, to = 0;
    std::size_t axis = 0;  ///< Index of the affected parameter's axis.
    Why why = Why::acts;

    bool operator==(const StudyChange&) const = default;
};

/// Input of a study.
struct StudyRequest {
    std::size_t subject = 1;
    SceneState sceneState;        ///< Settings of everything that is not varied.
    std::vector<StudyAxis> axes;  ///< One: a curve. Two: a surface. More: the front is searched for.
    glm::ivec2 size{320, 180};
    int views = 3;  ///< Largest number of views, spread over those of the exhibit.
    int runs = 7;   ///< Most timed frames per setting and view, after one that is not timed.
    render::Metric metric = render::Metric::rmse;  ///< For fronts and choices; never psnr, which is rmse in decibels.
    double pixelsPerDegree = 67;                   ///< For FLIP.
    bool alone = false;       ///< Without the hall, in the environment's light; not for the hall itself.
    bool needsFiles = false;  ///< As in FrameRequest.
    bool modelError = true;   ///< Measure relative to everything exact, too.
    bool asSet = false;       ///< Change no setting, even if a parameter has no effect.
    std::vector<StudyParameter> pinned = {};  ///< Parameters whose values the user named, so no study changes them.
    int largestTile = 2048;                   ///< Side in pixels; smaller tiles make shorter steps.
    int settings = 60;                        ///< Largest number of settings in a search over three axes or more.
    /// Limit of a choice. With `maxError`, it is the cheapest setting with at most this error in every view. With
    /// `maxMilliseconds`, it is the most exact setting whose frame takes no longer. At most one may be set.
    std::optional<double> maxError, maxMilliseconds;
};

/// Returns whether errors are those of colors, not of normals or depths.
[[nodiscard]] bool goesByColor(const StudyRequest&);

/// Errors of a picture by every metric that the pictures allow.
using Errors = std::map<render::Metric, double>;

/// One setting in one view.
struct StudyShot {
    /// As made by PictureMaker; empty until drawn. A finished study keeps color only, unless the metric uses more.
    render::Image picture;
    Errors errors;                     ///< Relative to the same model with the studied parameters exact.
    std::optional<double> modelError;  ///< By the request's metric, relative to everything exact; unset until measured.
    std::map<std::string, std::int64_t> counters;  ///< Work of one picture, and "pixels": samples drawn.
    double firstMilliseconds = 0;                  ///< Time of the picture that was not timed: a first estimate.
    std::vector<double> milliseconds;              ///< Times of one picture, one per run.
};

/// One setting.
struct StudyPoint {
    Setting setting;
    std::vector<StudyShot> shots;  ///< By view.

    // The following numbers are over all views; errors are by the request's metric.
    double error = 0;  ///< Root mean square of the views' RMS errors, largest of maxima, else the mean.
    double lowestError = 0, worstError = 0;
    std::optional<double> modelError;              ///< Unset until every view is measured relative to everything exact.
    std::map<std::string, std::int64_t> counters;  ///< Sum over the views.
    std::optional<render::Summary> time;           ///< Milliseconds of one picture, the mean of the views in each run.
    double cost = 0;                               ///< In the unit StudyResult::costName.
    bool dominated = false;
    bool uncertain = false;  ///< Whether its error is below four times the uncertainty of the reference.
};

/// Returns whether its pictures of all views exist, so its errors are known.
[[nodiscard]] bool isDrawn(const StudyPoint&);

/// Chosen setting, and whether it keeps the limit in views for which it was not chosen.
struct StudyChoice {
    std::size_t point = 0;
    double heldOutError = 0;         ///< Worst error over the held-out views.
    double heldOutMilliseconds = 0;  ///< Slowest held-out view; measured if a time is the limit.
    std::vector<std::string> heldOutViews;
    bool holds = false;  ///< Whether the limit is kept in all of them.
};

/// Result of a study so far; complete once the study is finished.
struct StudyResult {
    std::vector<std::string> views;
    std::vector<StudyChange> changes;              ///< Settings that differ from the request, in every view.
    std::vector<StudyParameter> exactInReference;  ///< Parameters with their most exact value in the references only.
    std::vector<render::Image> references;         ///< By view.
    std::vector<double> exact;                     ///< Exact value of each axis in the reference.
    double uncertainty = 0;                        ///< Difference of the reference from one half (or twice) as exact.
    bool converged = true;    ///< Whether every error except 0 is at least four times the uncertainty.
    std::string convergence;  ///< `converged` as a sentence.
    std::vector<StudyPoint> points;
    /// Counter that distinguishes the settings' work. It is chosen once all of them are drawn, and then kept. Empty
    /// before, and if no counter differs.
    std::string workName;
    std::string costName;                 ///< `workName` or "ms": the cost for searches and choices.
    std::vector<std::size_t> front;       ///< Points by increasing cost.
    std::optional<std::size_t> knee;      ///< Index of a point.
    std::optional<std::size_t> present;   ///< Point with the values of the request.
    std::optional<render::PowerLaw> law;  ///< Cost over error along the front of one or two axes, one numeric.
    std::optional<StudyChoice> choice;    ///< Set if a choice was requested and a setting keeps the limit.
    bool complete = false;                ///< Whether everything requested was measured.
    std::string clock;
    bool clockTrusted = false;
    double overheadMilliseconds = 0;  ///< Time that measuring adds to one picture.

    /// Returns whether two points did the same work, or their times are indistinguishable.
    [[nodiscard]] bool costsTheSame(const StudyPoint&, const StudyPoint&) const;
};

}  // namespace vitrine::study
