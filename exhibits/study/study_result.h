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

namespace vitrine {

/// A row of a subject's table.
struct StudyRow {
    std::size_t subject = 0, row = 0;

    bool operator==(const StudyRow&) const = default;
};

/// A setting that a study changed for itself, so that one of its parameters shows.
struct StudyChange {
    enum class Why : std::uint8_t {
        acts,   ///< The parameter acts only with this value.
        shows,  ///< Its table declares that it shows only with this value.
        limits  ///< The row caps or overrides the parameter with any other value.
    };
    StudyRow row;
    double from = 0, to = 0;
    std::size_t axis = 0;  ///< The parameter.
    Why why = Why::acts;

    bool operator==(const StudyChange&) const = default;
};

/// What to measure.
struct StudyRequest {
    std::size_t subject = 1;
    SceneState sceneState;        ///< Everything that is not varied stays as it is here.
    std::vector<StudyAxis> axes;  ///< One: a curve. Two: a surface. More: the front is searched for.
    glm::ivec2 size{320, 180};
    int views = 3;  ///< At most; spread over those that the exhibit names.
    int runs = 7;   ///< Timed frames of each setting in each view, after one that is not timed.
    render::Metric metric =
        render::Metric::rmse;     ///< What fronts and choices go by; never psnr, which is rmse in decibels.
    double pixelsPerDegree = 67;  ///< For FLIP.
    bool alone = false;           ///< Without the hall, in the environment's light. The hall itself is never without.
    bool needsFiles = false;      ///< As FrameRequest's.
    bool modelError = true;       ///< Measure against everything at its best, too.
    bool asSet = false;           ///< Change no setting, even where a parameter does not show.
    std::vector<StudyRow> pinned = {};  ///< Rows that no study may change: the user named their values.
    int largestTile = 2048;             ///< Side in pixels: smaller ones make shorter steps.
    int settings = 60;                  ///< At most, of a search over three axes or more.
    /// Choose: the cheapest setting with an error up to this in every view, or the most exact one whose frame takes
    /// no longer than that. At most one of them.
    std::optional<double> maxError, maxMilliseconds;
};

/// Whether its errors are taken of colors, not of normals or depths.
[[nodiscard]] bool goesByColor(const StudyRequest&);

/// How far a picture is from a reference, by every metric that the pictures allow.
using Errors = std::map<render::Metric, double>;

/// One setting in one view.
struct StudyShot {
    /// As PictureMaker makes it; empty until drawn. Once the study is finished, color only, unless it goes by more.
    render::Image picture;
    Errors errors;                     ///< Against the same model with the studied parameters exact.
    std::optional<double> modelError;  ///< By the request's metric, against everything exact; unset until measured.
    std::map<std::string, std::int64_t>
        counters;                      ///< Of one picture, and "pixels": samples drawn; the machine's state left out.
    double firstMilliseconds = 0;      ///< Of the picture that was not timed: a first guess.
    std::vector<double> milliseconds;  ///< Of one picture, run by run.
};

/// One setting.
struct StudyPoint {
    Setting setting;
    std::vector<StudyShot> shots;  ///< By view.

    // Over all views; the error by the request's metric.
    double error = 0;  ///< Root mean square of the views' RMS errors, largest of maxima, else the mean.
    double lowestError = 0, worstError = 0;
    std::optional<double> modelError;              ///< Unset until every view is measured against everything exact.
    std::map<std::string, std::int64_t> counters;  ///< Summed.
    std::optional<render::Summary> time;           ///< Milliseconds of one picture, the mean of the views in each run.
    double cost = 0;                               ///< By StudyResult::costName.
    bool dominated = false;
    bool uncertain = false;  ///< Its error is under four times the reference's own uncertainty.
};

/// Whether its pictures of all views are there, so that its errors are known.
[[nodiscard]] bool isDrawn(const StudyPoint&);

/// What was chosen, and whether it holds where it was not chosen for.
struct StudyChoice {
    std::size_t point = 0;
    double heldOutError = 0;         ///< Worst over the held-out views.
    double heldOutMilliseconds = 0;  ///< Slowest of them; measured when a time was the limit.
    std::vector<std::string> heldOutViews;
    bool holds = false;  ///< The limit is kept in all of them.
};

/// What a study found so far; everything is filled in by the time that it is finished.
struct StudyResult {
    std::vector<std::string> views;
    std::vector<StudyChange> changes;        ///< What was set otherwise than in the request, in every view.
    std::vector<StudyRow> exactInReference;  ///< Rows with their most exact value in the references only.
    std::vector<render::Image> references;   ///< By view.
    std::vector<double> exact;               ///< Of the reference, by axis.
    double uncertainty =
        0;  ///< How far the reference is from one half as exact (or twice as exact, where it was doubled).
    bool converged = true;    ///< No error that is not 0 is under four times that.
    std::string convergence;  ///< The same as a sentence.
    std::vector<StudyPoint> points;
    /// Counter that tells the settings' work apart, chosen when all of them were drawn for the first time and kept from
    /// then on. Empty before, and if no counter does.
    std::string workName;
    std::string costName;                 ///< `workName` or "ms": the cost that searches and choices go by.
    std::vector<std::size_t> front;       ///< Points by growing cost.
    std::optional<std::size_t> knee;      ///< A point.
    std::optional<std::size_t> present;   ///< The point with the look's own values.
    std::optional<render::PowerLaw> law;  ///< Cost over error along the front of one or two axes, one of them numeric.
    std::optional<StudyChoice> choice;    ///< When one was asked for and any setting keeps the limit.
    bool complete = false;                ///< Everything that was asked for was measured.
    std::string clock;
    bool clockTrusted = false;
    double overheadMilliseconds = 0;  ///< What timing adds to one picture.

    /// Whether the two did the same work, or cost the same as far as their times can tell.
    [[nodiscard]] bool costsTheSame(const StudyPoint&, const StudyPoint&) const;
};

}  // namespace vitrine
