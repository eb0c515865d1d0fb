#pragma once

#include "exhibits/museum/museum.h"

namespace vitrine::test {

// Prepare a scene state, and plan or query it, in one call.

inline render::FramePlan planned(const Museum& museum, const SceneState& sceneState, const FrameRequest& request,
                                 const render::PersistentState& kept = {})
{
    return museum.plan(museum.prepare(sceneState, request), request, kept);
}

inline double nextChange(const Museum& museum, const SceneState& sceneState, const FrameRequest& request)
{
    return museum.nextChange(museum.prepare(sceneState, request), request);
}

}  // namespace vitrine::test
