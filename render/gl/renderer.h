#pragma once

#include "render/gl/screen_pixels.h"
#include "render/gl/shared_context.h"
#include "render/gl/stored.h"
#include "render/plan/render_backend.h"

#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::render::gl {

/// Thrown by Renderer::draw when nobody wants the picture any more.
class Abandoned final : public std::exception {
public:
    [[nodiscard]] const char* what() const noexcept override { return "the picture was abandoned"; }
};

/// A shader that did not build: what to show over the last good picture.
struct ShaderProblem {
    std::string file;
    int line = 0;
    std::string message;
    std::string slot = {};  ///< Of a program that takes its place in a slot (ShaderKey::slot).
};

/// Executes frame plans on the OpenGL 4.5 core context that is current, at construction and at every call, on one
/// thread: drawing on another one is a std::logic_error. Images are kept while frames declare or use them, meshes and
/// pictures while their originals live, programs while they are among the last ones used (ProgramCache::mostIdle).
class Renderer final : public RenderBackend {
public:
    Renderer();
    /// Another one on the same context, with images of its own: programs, meshes and pictures are there once for both.
    [[nodiscard]] std::unique_ptr<Renderer> sibling() const;
    ~Renderer() override;  ///< The context must be current, or gone for good (see `abandon`).

    FrameReport draw(const FramePlan&) override;
    /// Asked between passes from now on: as soon as it says yes, `draw` throws Abandoned, and what the frame had not
    /// reached yet counts as never drawn. Empty: every frame is finished.
    void abandonWhen(std::function<bool()> unwanted);
    [[nodiscard]] Image read(const std::string& image) override;
    /// A buffer of the last frame; throws std::out_of_range for a name that was not used.
    [[nodiscard]] Bytes readBuffer(const std::string& name);
    [[nodiscard]] const PersistentState& persistentState() const override;
    [[nodiscard]] int largestSide() const override;

    /// An image of the last frame as a screen of `screen` pixels shows it, scaled with a smooth filter where the sizes
    /// differ. The image covers the part of the screen that begins at `offset` from the lower left corner and is `part`
    /// pixels large; only that part is returned.
    [[nodiscard]] ScreenPixels screenPixels(const std::string& image, glm::ivec2 screen, glm::ivec2 offset,
                                            glm::ivec2 part);

    /// Times each step, too, with a glFinish after each where no timer query can be trusted: slower, so only
    /// while the ledger is open.
    void timeSteps(bool on);

    /// Programs of slots are built on a thread with this context, while the last good ones draw; null: no more. Counts
    /// for siblings, too.
    void buildInBackground(std::shared_ptr<SharedContext>);

    /// Begins to build the better programs (ShaderKey::better) of a plan in the background, and draws nothing.
    void buildBetter(const FramePlan&);

    /// Debug builds: rebuilds programs whose files changed on disk; a program that fails keeps its last
    /// good build and is listed by `problems`. Returns whether any picture may have changed.
    bool reloadChangedShaders();
    [[nodiscard]] const std::vector<ShaderProblem>& problems() const;

    /// What is kept by owner: images of this renderer, and pictures, meshes and programs, which siblings share.
    [[nodiscard]] std::vector<Stored> stored() const;

    /// Forgets all GL objects without deleting them: the context was lost.
    void abandon();

private:
    struct State;
    struct Shared;
    explicit Renderer(std::unique_ptr<State>);
    std::unique_ptr<State> state_;
};

}  // namespace vitrine::render::gl
