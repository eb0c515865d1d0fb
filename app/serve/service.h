#pragma once

#include "exhibits/museum/museum.h"
#include "render/files/strict_json.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::app {

/// What the service knows and does, whoever asks: one look for all, as a window has one.
class Service {
public:
    /// Told between the steps of long work: which part is done, 0 to 1, and what is being done. It stops the work by
    /// throwing.
    using Watch = std::function<void(double part, const std::string& doing)>;

    /// All three must outlive it. Starts with the initial look.
    Service(const Museum&, render::gl::Renderer&, const render::gl::ContextInfo&);

    /// The result of a method. Throws RpcFailure for an unknown one, Failure as its command of the command line does,
    /// and what `watch` throws; the look is then as before.
    [[nodiscard]] render::Json answer(const std::string& method, const render::Json& params, const Watch&);

    /// What has changed since the last call, for each exhibit by itself: {"exhibit", "values", "motions"}.
    [[nodiscard]] std::vector<render::Json> takeChanges() { return std::exchange(changes_, {}); }

    /// The methods, a line each, for the help text.
    [[nodiscard]] static std::string methodsText();

private:
    using Method = render::Json (Service::*)(const render::Json& params, const Watch&);
    struct Entry {
        const char* name;
        Method method;
        const char* help;
    };
    static const std::vector<Entry>& methods();

    render::Json listExhibits(const render::Json&, const Watch&);
    render::Json getValues(const render::Json&, const Watch&);
    render::Json setValues(const render::Json&, const Watch&);
    render::Json resetValues(const render::Json&, const Watch&);
    render::Json listPresets(const render::Json&, const Watch&);
    render::Json loadPreset(const render::Json&, const Watch&);
    render::Json planPicture(const render::Json&, const Watch&);
    render::Json renderPicture(const render::Json&, const Watch&);
    render::Json runStudy(const render::Json&, const Watch&);

    [[nodiscard]] std::size_t subjectNamed(const std::string& name) const;
    [[nodiscard]] std::optional<render::Camera> cameraOf(const std::string& name) const;
    /// Takes the look in place of the present one, and notes what is different.
    void become(SceneState);

    const Museum& museum_;
    render::gl::Renderer& renderer_;
    const render::gl::ContextInfo& gl_;
    SceneState sceneState_;
    std::map<std::size_t, render::Camera> cameras_;  ///< Of the preset that was loaded for a subject.
    std::vector<render::Json> changes_;
};

}  // namespace vitrine::app
