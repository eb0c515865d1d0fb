#include "ui/viewport/shader_builds.h"

#include <functional>

namespace vitrine::ui {

ShaderBuilds::ShaderBuilds(Renderers& renderers, RenderThread& thread) : renderers_(renderers), thread_(thread)
{
#ifndef NDEBUG
    connect(&poll_, &QTimer::timeout, this, &ShaderBuilds::reload);
    poll_.start(500);
#endif
}

void ShaderBuilds::reload()
{
    thread_.post([this] {
        const bool changed = renderers_.reloadChangedShaders();
        return [this, changed, problems = renderers_.problems()] { emit reloaded(changed, problems); };
    });
}

void ShaderBuilds::specialize(const SceneState& state, const FrameRequest& request)
{
    thread_.post([this, state, request] {
        renderers_.buildBetter(state, request);
        return std::function<void()>();
    });
}

}  // namespace vitrine::ui

#include "moc_shader_builds.cpp"
