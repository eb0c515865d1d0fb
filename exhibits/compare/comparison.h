#pragma once

#include "exhibits/compare/differing_rows.h"
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

namespace vitrine {

/// Two settings of one museum, A and B, seen by one camera at one moment with one seed.
struct ComparisonRequest {
    std::array<SceneState, 2> settings;
    FrameRequest frame;                ///< Camera, size, time and seed of both; the rest as in PictureRequest.
    std::array<int, 2> samples{4, 4};  ///< Supersamples per pixel.
    /// Timed frames of each, after one that is not timed. A and B take turns, so that in every frame what the two do
    /// not share (a shadow map of another size) is drawn anew, and what they share is kept, as between two frames of
    /// either. Without any, the ledger is that of the pictures.
    int runs = 5;
    int largestTile = 2048;  ///< As PictureRequest's.
    double pixelsPerDegree = render::flipPixelsPerDegree;
};

/// What one of them looks like and costs.
struct ComparedSide {
    render::Image picture;       ///< R, G, B, A: display-referred linear light.
    render::FrameReport report;  ///< Of one frame of one sample; its steps' milliseconds are medians of the runs.
    std::optional<render::Summary> time;  ///< Milliseconds of that frame over the runs.
    std::vector<double> milliseconds;     ///< Run by run.
};

struct ComparisonResult {
    std::array<ComparedSide, 2> sides;
    std::map<render::Metric, double> errors;  ///< Of B's colors, with A as the reference.
    std::vector<DifferingRow> rows;
    std::vector<PassCost> passes;
    std::vector<CounterCost> counters;
};

/// Makes the pictures of two settings and measures both, step by step, so that a window can show progress and stop
/// between steps.
class Comparison {
public:
    /// Museum and backend must outlive it. Steps are timed one by one where the backend does that. Throws Failure
    /// (Blame::usage) as PictureMaker does.
    Comparison(const Museum&, render::RenderBackend&, ComparisonRequest);

    /// Draws one sample of one tile, or times one frame. Returns false when all was done before.
    bool step();
    [[nodiscard]] double progress() const;  ///< 0 to 1.
    [[nodiscard]] bool finished() const { return finished_; }
    [[nodiscard]] const ComparisonRequest& request() const { return request_; }
    /// Only when finished.
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
    // By pass, and its number among those of that name.
    std::array<std::map<std::pair<std::string, int>, std::vector<double>>, 2> stepTimes_;
    std::size_t framesTimed_ = 0;  // Of both, the first of each among them.
    bool finished_ = false;
};

}  // namespace vitrine
