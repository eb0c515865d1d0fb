#pragma once

#include "exhibits/exhibits.h"
#include "exhibits/hall/hall_model.h"
#include "exhibits/museum/museum.h"
#include "tests/support/plan_steps.h"
#include "tests/support/planned.h"
#include "tests/support/tables.h"

#include <limits>
#include <string>

namespace vitrine::test {

/// Time of a change that never comes.
inline constexpr double never = std::numeric_limits<double>::infinity();

/// Return the real museum and its building, loaded once.
inline const Museum& museum()
{
    static const Museum opened{allExhibits()};
    return opened;
}
inline const hall::HallModel& building()
{
    static const hall::HallModel model;
    return model;
}

/// Frame to plan: a scene state and a request.
struct Scene {
    SceneState sceneState = museum().initialSceneState();
    FrameRequest request;
    std::size_t sdf = *museum().find("sdf_morph");

    Scene()
    {
        request.raster.size = {64, 36};
        see(museum().bestView(sdf, sceneState.values[sdf]));
    }
    void see(const render::Camera& camera) { request.camera = sceneState.camera = camera; }
    void see(const glm::dvec3& eye, const glm::dvec3& target) { see({eye, target, 0.96}); }
    [[nodiscard]] ParameterValues& hall() { return sceneState.hall(); }
    [[nodiscard]] ParameterValues& object() { return sceneState.values[sdf]; }
    [[nodiscard]] ParameterValues& rays() { return sceneState.values[*museum().find("crepuscular_rays")]; }
    [[nodiscard]] render::FramePlan plan(const render::PersistentState& kept = {}) const
    {
        return test::planned(museum(), sceneState, request, kept);
    }
};

/// Returns the persistent state of a renderer that drew the plan.
inline render::PersistentState keptAfter(const render::FramePlan& plan)
{
    render::PersistentState kept;
    for (const render::Pass& pass : plan.passes())
        if (pass.contentHash) kept.passes[pass.name] = *pass.contentHash;
    return kept;
}

}  // namespace vitrine::test
