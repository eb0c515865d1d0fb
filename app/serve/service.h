#pragma once

#include "app/jobs/job_arguments.h"
#include "app/serve/served_state.h"
#include "exhibits/jobs/kit/job.h"
#include "exhibits/museum/museum.h"
#include "render/files/strict_json.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::app {

/// OpenGL context and renderer of a service, made when they are first needed. For one thread.
class ServedGraphics {
public:
    /// Both throw Failure (ErrorKind::openGl).
    [[nodiscard]] render::gl::Renderer& renderer();
    [[nodiscard]] const render::gl::ContextInfo& info();

private:
    std::unique_ptr<render::gl::HeadlessContext> context_;
    std::unique_ptr<render::gl::Renderer> renderer_;
};

/// Methods of the service. All clients share one scene state.
class Service {
public:
    /// Called between the steps of long work with the part that is done, 0 to 1, and a description. Stops the work by
    /// throwing.
    using Watch = std::function<void(double part, const std::string& doing)>;

    /// All must outlive this object.
    Service(const Museum&, ServedState&, ServedGraphics&);

    /// Calls a method and returns its result. Throws RpcFailure for an unknown method, Failure like the command of the
    /// same name, and what `watch` throws; the scene state is then unchanged.
    [[nodiscard]] render::Json answer(const std::string& method, const render::Json& params, const Watch&);

    /// Takes over what something else than the service changed in the scene state; see `takeChanges`.
    void refresh();
    /// Returns the descriptor of `ServedState::changedDescriptor`.
    [[nodiscard]] int changedDescriptor() const { return state_.changedDescriptor(); }

    /// Returns the bytes that follow the last answer on the connection, as its `binary` describes them; empty: none.
    [[nodiscard]] std::string takeBytes() { return std::exchange(bytes_, {}); }

    /// Returns the changes since the last call, one for each exhibit: {"exhibit", "values", "motions"}.
    [[nodiscard]] std::vector<render::Json> takeChanges() { return std::exchange(changes_, {}); }

    /// Returns a line for each method, for the help text. Includes `events` and `cancel`, which the server answers.
    [[nodiscard]] static std::string methodsText();

private:
    using Method = render::Json (Service::*)(const render::Json& params, const Watch&);
    struct Entry {
        const char* name;
        Method method;  ///< Null: the server answers it.
        const char* help;
    };
    static const std::vector<Entry>& methods();
    /// Returns whether a method is written by hand, and not derived from a job.
    [[nodiscard]] static bool hasMethod(std::string_view name);

    render::Json discover(const render::Json&, const Watch&);
    render::Json listExhibits(const render::Json&, const Watch&);
    render::Json getValues(const render::Json&, const Watch&);
    render::Json setValues(const render::Json&, const Watch&);
    render::Json resetValues(const render::Json&, const Watch&);
    render::Json visitExhibit(const render::Json&, const Watch&);
    render::Json listPresets(const render::Json&, const Watch&);
    render::Json loadPreset(const render::Json&, const Watch&);
    render::Json planPicture(const render::Json&, const Watch&);
    render::Json renderPicture(const render::Json&, const Watch&);
    render::Json comparePictures(const render::Json&, const Watch&);
    render::Json runJob(const jobs::Job&, const render::Json&, const Watch&);

    /// Returns where jobs begin: the service's scene state and cameras.
    [[nodiscard]] JobStart start(bool answers) const;
    [[nodiscard]] std::size_t subjectNamed(const std::string& name) const;
    [[nodiscard]] std::optional<render::Camera> cameraOf(const std::string& name) const;
    /// Changes the scene state to this one, and notes the changes.
    void become(SceneState);
    /// Takes this scene state as the present one, and notes the changes.
    void noteState(SceneState);

    const Museum& museum_;
    ServedState& state_;
    ServedGraphics& graphics_;
    SceneState sceneState_;                          ///< Present state, as of the last `refresh` or change.
    std::map<std::size_t, render::Camera> cameras_;  ///< Cameras of the presets loaded last, by subject.
    std::vector<render::Json> changes_;
    std::string bytes_;
};

}  // namespace vitrine::app
