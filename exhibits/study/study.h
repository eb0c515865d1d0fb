#pragma once

#include "exhibits/museum/picture.h"
#include "exhibits/study/study_judge.h"
#include "exhibits/study/study_queue.h"
#include "exhibits/study/study_search.h"
#include "exhibits/study/study_situation.h"

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vitrine::study {

/// Measures the cost of accuracy. It works step by step, so a window can show progress and stop between steps. It works
/// on copies and changes nothing in the museum.
class Study {
public:
    /// The museum, the backend and the parts must outlive it. Without parts everything is measured here. Throws Failure
    /// (ErrorKind::usage) if there is nothing to measure. Also throws for a part of a search, whose next settings
    /// depend on earlier results.
    Study(const Museum&, render::RenderBackend&, StudyRequest, StudyParts* parts = nullptr);
    ~Study();
    Study(const Study&) = delete;  // The search refers to the study.
    Study& operator=(const Study&) = delete;

    /// Draws one sample, or times one frame. Returns false when all was done before.
    bool step();
    [[nodiscard]] bool finished() const { return phase_ == Phase::done; }
    [[nodiscard]] double progress() const;  ///< Progress, 0 to 1, of the known work.
    [[nodiscard]] const std::string& doing() const { return queue_.doing(); }
    [[nodiscard]] const StudyRequest& request() const { return request_; }
    [[nodiscard]] const StudyResult& result() const { return result_; }
    /// Moves the result out. The study must not be used afterwards.
    [[nodiscard]] StudyResult takeResult() { return std::move(result_); }
    /// Returns the scene state with the values of this point, which a click applies.
    [[nodiscard]] SceneState sceneStateOf(const StudyPoint&) const;

private:
    enum class Phase { pictures, exactReferences, times, choice, done };
    struct View {
        StudyView view;
        render::Image reference, exact;
        std::vector<render::Image> neighbors;  ///< Pictures with which the reference is checked.
        bool heldOut = false;
        std::vector<double> changes = {};            ///< Differences of the reference from the first neighbors.
        std::optional<Setting> setting = {};         ///< Setting whose picture is the first reference.
        std::vector<Setting> neighborSettings = {};  ///< Settings whose pictures are neighbors.
    };

    // Functions that list the pictures to draw and the frames to time.
    void addViews();
    /// A picture to draw, and whether one frame of it is timed and counted.
    struct PictureJob {
        std::string key;   ///< Key in the parts.
        std::string name;  ///< Name as displayed.
        SceneState sceneState;
        PictureRequest wanted;
        std::optional<std::size_t> timedView = {};
        bool isReference = false;  ///< The reference of the timed view, drawn just before, is the picture.
    };
    void addPicture(PictureJob, std::function<void(StudyMeasure)> take);
    /// Adds a job to the queue, and notes the clock of its measure.
    void addMeasure(std::string key, std::string name, StudyQueue::Measuring, std::function<void(StudyMeasure)> take);
    void addReference(std::size_t view, bool withNeighbors);
    void addNeighbors(std::size_t view);
    /// Returns the setting of the grid with these values, if its picture is the one of this scene state.
    [[nodiscard]] std::optional<Setting> settingShownBy(const std::vector<double>& axisValues, std::size_t view,
                                                        const SceneState&) const;
    void addSetting(const Setting&);
    /// Adds a point without pictures. Returns false if it is known.
    bool addPoint(const Setting&);
    void addShot(const Setting&, std::size_t view);
    void takeShot(std::size_t point, std::size_t view, const SceneState&, StudyMeasure);
    void addExactReferences();
    void addTimes();
    void nextPhase();
    void findJob();
    void keepColors();
    [[nodiscard]] SceneState lookAt(const std::vector<double>& axisValues, std::size_t view) const;
    /// Returns the scene state of a reference picture of this view: these values, and the parameters that are exact in
    /// references only.
    [[nodiscard]] SceneState referenceLook(const std::vector<double>& axisValues, std::size_t view) const;
    [[nodiscard]] std::vector<double> valuesOf(const Setting&) const;
    [[nodiscard]] PictureRequest pictureRequest(const SceneState&, std::size_t view) const;
    /// Returns the request of the reference: like that of any setting, but converged if pictures in motion are studied.
    [[nodiscard]] PictureRequest referenceRequest(const SceneState&, std::size_t view) const;
    [[nodiscard]] bool studiesMotion() const { return study::studiesMotion(request_); }
    void findDependentPasses();
    [[nodiscard]] render::FrameReport drawTimed(const SceneState&, std::size_t view);

    void renewErrors();
    bool refineReference();
    /// Returns the difference of the references from their neighbors.
    [[nodiscard]] double uncertainty();
    void judge();
    void tryCandidate();

    const Museum& museum_;
    render::RenderBackend& backend_;
    StudyQueue queue_;
    StudyRequest request_;
    StudySituation situation_;
    StudyResult result_;
    StudyJudge judge_;
    StudySearch search_;
    Phase phase_ = Phase::pictures;
    std::vector<View> views_;  ///< Views of the study, then the held-out ones.
    int doublings_ = 0;
    std::map<Setting, std::size_t> known_;
    std::set<std::string> dependentPasses_;  ///< Kept passes that depend on the axes, so their work counts.
    std::vector<std::size_t> candidates_;    ///< Candidates for the choice, best last.
};

}  // namespace vitrine::study
