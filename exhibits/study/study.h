#pragma once

#include "exhibits/museum/picture.h"
#include "exhibits/study/study_axis.h"
#include "render/image/image.h"
#include "render/measure/metrics.h"
#include "render/measure/statistics.h"

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vitrine {

/// What to measure.
struct StudyRequest {
    std::size_t subject = 1;
    Look look;                      ///< Everything that is not varied stays as it is here.
    std::vector<StudyAxis> axes;    ///< One: a curve. Two: a surface. More: the front is searched for.
    glm::ivec2 size{320, 180};
    int views = 3;                  ///< At most; spread over those that the exhibit names.
    int runs = 7;                   ///< Timed frames of each setting in each view, after one that is not timed.
    render::Metric metric = render::Metric::rmse;  ///< What fronts and choices go by; never psnr, which is rmse in decibels.
    double pixelsPerDegree = 67;    ///< For FLIP.
    bool alone = false;             ///< Without the hall, in the environment's light. The hall itself is never without.
    bool needsFiles = false;        ///< As FrameRequest's.
    bool modelError = true;         ///< Measure against everything at its best, too.
    int largestTile = 2048;         ///< Side in pixels: smaller ones make shorter steps.
    int settings = 60;              ///< At most, of a search over three axes or more.
    /// Choose: the cheapest setting with an error up to this in every view, or the most exact one whose frame takes
    /// no longer than that. At most one of them.
    std::optional<double> maxError, maxMilliseconds;
};

/// How far a picture is from a reference, by every metric that the pictures allow.
using Errors = std::map<render::Metric, double>;

/// One setting in one view.
struct StudyShot {
    /// As PictureMaker makes it; empty until drawn. Once the study is finished, color only, unless it goes by more.
    render::Image picture;
    Errors errors;                                 ///< Against the same model with the studied parameters exact.
    double modelError = 0;                         ///< By the request's metric, against everything exact.
    std::map<std::string, std::int64_t> counters;  ///< Of one picture, and "pixels": samples drawn; the machine's state left out.
    double firstMilliseconds = 0;                  ///< Of the picture that was not timed: a first guess.
    std::vector<double> milliseconds;              ///< Of one picture, run by run.
};

/// One setting.
struct StudyPoint {
    Setting setting;
    std::vector<StudyShot> shots;  ///< By view.

    // Over all views; the error by the request's metric.
    double error = 0;              ///< Root mean square of the views' RMS errors, largest of maxima, else the mean.
    double lowestError = 0, worstError = 0;
    double modelError = 0;
    std::map<std::string, std::int64_t> counters;  ///< Summed.
    std::optional<render::Summary> time;           ///< Milliseconds of one picture, the mean of the views in each run.
    double cost = 0;               ///< By StudyResult::costName.
    bool dominated = false;
    bool uncertain = false;        ///< Its error is under four times the reference's own uncertainty.
};

/// What was chosen, and whether it holds where it was not chosen for.
struct StudyChoice {
    std::size_t point = 0;
    double heldOutError = 0;             ///< Worst over the held-out views.
    double heldOutMilliseconds = 0;      ///< Slowest of them; measured when a time was the limit.
    std::vector<std::string> heldOutViews;
    bool holds = false;                  ///< The limit is kept in all of them.
};

/// What a study found so far; everything is filled in by the time that it is finished.
struct StudyResult {
    std::vector<std::string> views;
    std::vector<render::Image> references;       ///< By view.
    std::vector<double> exact;                   ///< Of the reference, by axis.
    double uncertainty = 0;                      ///< How far the reference is from one half as exact (or twice as exact, where it was doubled).
    bool converged = true;                       ///< No error that is not 0 is under four times that.
    std::string convergence;                     ///< The same as a sentence.
    std::vector<StudyPoint> points;
    std::string costName;                        ///< A counter, or "ms".
    std::vector<std::size_t> front;              ///< Points by growing cost.
    std::optional<std::size_t> knee;             ///< A point.
    std::optional<std::size_t> present;          ///< The point with the look's own values.
    std::optional<render::PowerLaw> law;         ///< Cost over error along the front of one or two axes, one of them numeric.
    std::optional<StudyChoice> choice;           ///< When one was asked for and any setting keeps the limit.
    bool complete = false;                       ///< Everything that was asked for was measured.
    std::string clock;
    bool clockTrusted = false;
    double overheadMilliseconds = 0;             ///< What timing adds to one picture.

    /// Whether the two did the same work, or cost the same as far as their times can tell.
    [[nodiscard]] bool costsTheSame(const StudyPoint&, const StudyPoint&) const;
};

/// Measures what accuracy costs, step by step, so that a window can show progress and stop between steps: it works
/// on copies, and whoever started it finds everything as it was.
class Study {
public:
    /// The museum and the painter must outlive it. Throws Failure (Blame::usage) when there is nothing to measure.
    Study(const Museum&, render::Painter&, StudyRequest);
    ~Study();

    /// Draws one sample, or times one frame. Returns false when all was done before.
    bool step();
    [[nodiscard]] bool finished() const { return phase_ == Phase::done; }
    [[nodiscard]] double progress() const;  ///< 0 to 1, as far as is known what is to be done.
    [[nodiscard]] const std::string& doing() const { return doing_; }
    [[nodiscard]] const StudyRequest& request() const { return request_; }
    [[nodiscard]] const StudyResult& result() const { return result_; }
    /// The same for good, its pictures moved: nothing more may be asked of the study.
    [[nodiscard]] StudyResult takeResult() { return std::move(result_); }
    /// The look with this point's values: what a click applies.
    [[nodiscard]] Look lookOf(const StudyPoint&) const;

private:
    enum class Phase { pictures, exactReferences, times, choice, done };
    struct Job {
        std::string name;
        std::function<bool()> step;  ///< Returns whether it is done.
    };
    /// One value of one axis, with all others as they are at present.
    struct Step {
        double error = 0;  ///< From the picture with this axis exact.
        double ratio = 1;  ///< Of its cost to that of the present setting; 1 where the two differ by noise.
        bool operator==(const Step&) const = default;
    };
    struct View {
        StudyView view;
        render::Image reference, exact;
        std::vector<render::Image> neighbors;  ///< What the reference is checked against.
        bool heldOut = false;
    };

    // Jobs: what is drawn.
    void addViews();
    void addPicture(std::string name, Look, std::size_t view, std::function<void(render::Image)> take);
    void addReference(std::size_t view, bool withNeighbors);
    void addSetting(const Setting&);
    void addTimes();
    void nextPhase();
    void findJob();
    void keepColors();
    [[nodiscard]] Look lookAt(const std::vector<double>& axisValues, std::size_t view) const;
    [[nodiscard]] std::vector<double> valuesOf(const Setting&) const;
    [[nodiscard]] PictureRequest pictureRequest(const Look&, std::size_t view) const;
    void findDependentPasses();
    [[nodiscard]] render::FrameReport drawTimed(const Look&, std::size_t view);

    // Judging: what it comes to.
    [[nodiscard]] Errors errorsOf(const render::Image& reference, const render::Image& picture) const;
    [[nodiscard]] double pooled(const std::vector<double>& errors) const;
    void renewErrors();
    bool refineReference();
    void judge();
    [[nodiscard]] std::string convergenceSentence(std::size_t uncertainErrors, double smallestError) const;
    void judgeCosts();

    // Searching and choosing.
    bool searchOn();
    void measureSteps();
    [[nodiscard]] double presentCost() const;
    /// Of a setting: `present` where it does the same work or differs by noise.
    [[nodiscard]] double searchedCost(const StudyPoint&, double present) const;
    [[nodiscard]] std::vector<Setting> predictedFront() const;
    /// How far this is from what was asked for, as a logarithm; 0 when nothing was.
    [[nodiscard]] double fromLimit(double error, double cost) const;
    [[nodiscard]] std::vector<std::size_t> searchedFront();
    void listCandidates();
    void tryCandidate();

    const Museum& museum_;
    render::Painter& painter_;
    StudyRequest request_;
    StudyResult result_;
    Phase phase_ = Phase::pictures;
    std::deque<Job> jobs_;
    std::size_t jobsDone_ = 0;
    std::string doing_;
    std::vector<View> views_;                ///< Those of the study, then those held out.
    int doublings_ = 0;
    int generation_ = 0;                     ///< Of the search.
    std::map<Setting, std::size_t> known_;
    std::set<std::string> dependentPasses_;  ///< Kept passes that the axes change: their work counts.
    std::vector<std::vector<Step>> steps_;   ///< Of the search, by axis and value.
    std::vector<std::size_t> candidates_;    ///< For the choice, best last.
};

}  // namespace vitrine
