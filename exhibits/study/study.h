#pragma once

#include "exhibits/museum/picture.h"
#include "exhibits/study/study_judge.h"
#include "exhibits/study/study_parts.h"
#include "exhibits/study/study_search.h"
#include "exhibits/study/study_situation.h"

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vitrine {

/// Measures what accuracy costs, step by step, so that a window can show progress and stop between steps: it works
/// on copies, and whoever started it finds everything as it was.
class Study {
public:
    /// The museum, the painter and the parts must outlive it. Without parts all is measured here. Throws Failure
    /// (Blame::usage) when there is nothing to measure, and for a part of a search, whose next settings depend on what
    /// was found before.
    Study(const Museum&, render::RenderBackend&, StudyRequest, StudyParts* parts = nullptr);
    ~Study();
    Study(const Study&) = delete;  // Its search refers to it.
    Study& operator=(const Study&) = delete;

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
    [[nodiscard]] SceneState sceneStateOf(const StudyPoint&) const;

private:
    enum class Phase { pictures, exactReferences, times, choice, done };
    struct Job {
        std::string name;
        std::function<bool()> step;  ///< Returns whether it is done.
    };
    struct View {
        StudyView view;
        render::Image reference, exact;
        std::vector<render::Image> neighbors;  ///< What the reference is checked against.
        bool heldOut = false;
    };

    // Jobs: what is drawn.
    void addViews();
    /// What is to be drawn, and whether one frame of it is timed and counted.
    struct PictureJob {
        std::string key;   ///< In the parts.
        std::string name;  ///< For people.
        SceneState sceneState;
        PictureRequest wanted;
        std::optional<std::size_t> timedView = {};
    };
    void addPicture(PictureJob, std::function<void(StudyMeasure)> take);
    /// A job whose result is taken from the parts, or kept there, or used: `measure` returns nothing while it goes on.
    void addMeasure(std::string key, std::string name, std::function<std::optional<StudyMeasure>()> measure,
                    std::function<void(StudyMeasure)> take);
    void addReference(std::size_t view, bool withNeighbors);
    void addSetting(const Setting&);
    void takeShot(std::size_t point, std::size_t view, const SceneState&, StudyMeasure);
    void addExactReferences();
    void addTimes();
    void nextPhase();
    void findJob();
    void keepColors();
    [[nodiscard]] SceneState lookAt(const std::vector<double>& axisValues, std::size_t view) const;
    /// The scene of the reference picture that errors of this view are measured against.
    [[nodiscard]] SceneState referenceLook(std::size_t view) const;
    [[nodiscard]] std::vector<double> valuesOf(const Setting&) const;
    [[nodiscard]] PictureRequest pictureRequest(const SceneState&, std::size_t view) const;
    /// Of what the errors are taken against: as that of any setting, but at rest where pictures in motion are studied.
    [[nodiscard]] PictureRequest referenceRequest(const SceneState&, std::size_t view) const;
    [[nodiscard]] bool studiesMotion() const { return vitrine::studiesMotion(request_); }
    void findDependentPasses();
    [[nodiscard]] render::FrameReport drawTimed(const SceneState&, std::size_t view);

    void renewErrors();
    bool refineReference();
    /// How far the references are from their neighbors.
    [[nodiscard]] double uncertainty() const;
    void judge();
    void tryCandidate();

    const Museum& museum_;
    render::RenderBackend& backend_;
    StudyParts* parts_;
    std::size_t measures_ = 0;  ///< Jobs that measure, so far.
    StudyRequest request_;
    StudySituation situation_;
    StudyResult result_;
    StudyJudge judge_;
    StudySearch search_;
    Phase phase_ = Phase::pictures;
    std::deque<Job> jobs_;
    std::size_t jobsDone_ = 0;
    std::string doing_;
    std::vector<View> views_;  ///< Those of the study, then those held out.
    int doublings_ = 0;
    std::map<Setting, std::size_t> known_;
    std::set<std::string> dependentPasses_;  ///< Kept passes that the axes change: their work counts.
    std::vector<std::size_t> candidates_;    ///< For the choice, best last.
};

}  // namespace vitrine
