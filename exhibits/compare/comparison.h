#pragma once

#include "exhibits/compare/differing_parameters.h"
#include "exhibits/compare/pass_costs.h"
#include "exhibits/museum/picture.h"
#include "render/measure/flip.h"
#include "render/measure/metrics.h"
#include "render/measure/statistics.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::compare {

/// Two settings of one museum, A and B, seen by one camera at one time with one seed.
struct ComparisonRequest {
    std::array<SceneState, 2> settings;
    FrameRequest frame;                ///< Camera, size, time and seed of both; the rest is as in PictureRequest.
    std::array<int, 2> samples{4, 4};  ///< Supersamples per pixel.
    /// Number of timed frames of each, after one that is not timed. A and B alternate, so each frame draws again what
    /// the two do not share (a shadow map of another size). Shared data is kept, as between two frames of either. With
    /// 0, the frame report is that of the pictures.
    int runs = 5;
    int largestTile = 2048;  ///< As in PictureRequest.
    double pixelsPerDegree = render::flipPixelsPerDegree;
};

/// Picture and cost of one setting.
struct ComparedSide {
    render::Image picture;       ///< R, G, B, A: linear light for display.
    render::FrameReport report;  ///< Report of one frame of one sample; milliseconds of steps are medians of the runs.
    std::optional<render::Summary> time;  ///< Milliseconds of that frame over the runs.
    std::vector<double> milliseconds;     ///< One per run.
};

struct ComparisonResult {
    std::array<ComparedSide, 2> sides;
    std::map<render::Metric, double> errors;  ///< Errors of B's colors relative to A.
    std::vector<DifferingParameter> rows;
    std::vector<PassCost> passes;
    std::vector<CounterCost> counters;
};

/// Makes the pictures of two settings and measures both. It works step by step, so a window can show progress and stop
/// between steps.
class Comparison {
public:
    /// Museum and backend must outlive it. Each pass is timed if the backend supports it. Throws Failure
    /// (ErrorKind::usage) like PictureMaker.
    Comparison(const Museum&, render::RenderBackend&, ComparisonRequest);

    /// Draws one sample of one tile, or times one frame. Returns false if everything is done.
    bool step();
    [[nodiscard]] double progress() const;  ///< 0 to 1.
    [[nodiscard]] bool finished() const { return finished_; }
    [[nodiscard]] const ComparisonRequest& request() const { return request_; }
    /// Valid once finished.
    [[nodiscard]] const ComparisonResult& result() const { return result_; }

private:
    [[nodiscard]] PictureRequest pictureRequest(std::size_t side) const;
    void takePicture(std::size_t side);
    void drawTimed(std::size_t side);
    void finish();

    const Museum& museum_;
    render::RenderBackend& backend_;
    ComparisonRequest request_;
    ComparisonResult result_;
    std::array<std::optional<PictureMaker>, 2> makers_;
    // Milliseconds by name of the step, and its index among those of that name.
    std::array<std::map<std::pair<std::string, int>, std::vector<double>>, 2> stepTimes_;
    std::size_t framesTimed_ = 0;  // Frames of both, including the first of each.
    bool finished_ = false;
};

}  // namespace vitrine::compare
