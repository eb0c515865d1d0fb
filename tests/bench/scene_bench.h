#pragma once

#include "exhibits/sdf_scenes/sdf_scenes_table.h"
#include "exhibits/sdf_scenes/shown_scene.h"
#include "tests/bench/bench_frame.h"

#include <filesystem>
#include <string>

namespace vitrine::bench {

/// What pictures of a scene cost. Counts are means of the frame's pixels.
struct SceneCosts {
    double evaluations = 0, shapes = 0;
    double milliseconds = 0;               ///< Of the exhibit's own pass.
    double firstSeconds = 0;               ///< Of the first frame, with its program built.
    int missed = 0, extra = 0, asked = 0;  /// Pixels that are not hit as a trace at float64 finds, of so many.
};

[[nodiscard]] double wallNow();

/// Every program is built by whoever measures: none comes from a cache on disk, and none is left there.
class FreshPrograms {
public:
    FreshPrograms();
    ~FreshPrograms();

private:
    std::filesystem::path folder_;
};

/// Scenes of the exhibit, alone, each drawn by a way to ask its field.
struct SceneBench : BenchFrame {
    int runs = 3;

    SceneBench();
    ~SceneBench();

    [[nodiscard]] static const SdfScenesTable& table();
    /// A file of this root and camera, which lives as long as this.
    std::filesystem::path write(const std::string& root, const std::string& camera);
    /// Shows a file; throws Failure where it cannot be read.
    void read(const std::filesystem::path&);
    [[nodiscard]] const scenes::ShownScene& shown();
    /// Programs are waited for. `source`: with the source's own march.
    [[nodiscard]] render::FramePlan planNow(bool source = false);
    /// Milliseconds of the exhibit's pass, while steps are timed.
    double draw(const render::FramePlan& plan) { return BenchFrame::draw(plan, "sdf_scenes/scene"); }
    double drawNow(bool source = false) { return draw(planNow(source)); }
    [[nodiscard]] SceneCosts measure(SceneEvaluation, bool source = false);

private:
    void compare(SceneCosts&);

    std::filesystem::path folder_;
};

}  // namespace vitrine::bench
