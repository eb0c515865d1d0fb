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

/// Thrown by Renderer::draw when the frame was canceled (`abandonWhen`).
class Abandoned final : public std::exception {
public:
    [[nodiscard]] const char* what() const noexcept override { return "the picture was abandoned"; }
};

/// Shader error: shown over the last good picture.
struct ShaderProblem {
    std::string file;
    int line = 0;
    std::string message;
    std::string programFamily = {};  ///< Family of the failed program (ShaderKey::programFamily); empty if it has none.
};

/// A program that was compiled and linked.
struct ProgramBuild {
    std::string program;  ///< For example "kit/sdf/march.frag [GLASS]".
    double seconds = 0;   ///< Time that the thread that built it needed, or waited for the driver.
};

/// Executes frame plans on the current OpenGL 4.5 core context, on one thread. The context must be current at
/// construction and at every call; drawing on another thread throws std::logic_error. Images are kept while frames
/// declare or use them. Meshes and textures are kept while their originals live. Programs are kept while they are among
/// the last ones used (ProgramCache::mostIdle).
class Renderer final : public RenderBackend {
public:
    Renderer();
    /// Creates another renderer on the same context. It has images of its own, but shares programs, meshes and
    /// textures.
    [[nodiscard]] std::unique_ptr<Renderer> sibling() const;
    ~Renderer() override;  ///< The context must be current, or lost (see `abandon`).

    FrameReport draw(const FramePlan&) override;
    /// Sets a function that is polled between passes. When it returns true, `draw` throws `Abandoned`; the remaining
    /// passes count as not drawn. Empty: every frame is finished.
    void abandonWhen(std::function<bool()> isCanceled);
    /// Limits the time that the unbounded passes of a frame take together (Pass::unbounded). They are drawn in bands
    /// of rows, and between two bands the frame can be abandoned, too. When the time is over, the remaining bands and
    /// unbounded passes are not drawn, FrameReport::stopped names the first of them, and PersistentState::stopped has
    /// it, on a graphics card after the second such frame in a row. Time of other programs does not count
    /// (UnboundedTime). Infinity, the initial value: they are drawn like all others.
    void stopUnboundedAfter(double seconds);
    [[nodiscard]] Image read(const std::string& image) override;
    /// Returns the content of a buffer of the last frame. Throws std::out_of_range for a name that was not used.
    [[nodiscard]] Bytes readBuffer(const std::string& name);
    [[nodiscard]] const PersistentState& persistentState() const override;
    [[nodiscard]] int largestSide() const override;

    /// Returns an image of the last frame as shown on a screen of `screen` pixels, scaled with a smooth filter if the
    /// sizes differ. The image covers the part of the screen that begins at `offset` from the lower left corner and is
    /// `part` pixels large. Only that part is returned.
    [[nodiscard]] ScreenPixels screenPixels(const std::string& image, glm::ivec2 screen, glm::ivec2 offset,
                                            glm::ivec2 part);

    /// Times each pass, too. If no timer query can be trusted, that needs a glFinish after each pass. It is slower, so
    /// use it only while the frame report is shown.
    void timeSteps(bool on);
    /// Deletes textures, meshes and buffers whose sources no longer exist. Each `draw` does so at its beginning.
    void sweep();

    /// Builds programs of families on a thread with this context, while their last good programs are used; null: no
    /// longer. Applies to siblings, too.
    void buildInBackground(std::shared_ptr<SharedContext>);

    /// Starts building the specialized programs (ShaderKey::specialized) of a plan in the background. Draws nothing.
    void buildBetter(const FramePlan&);

    /// Debug builds: rebuilds programs whose files changed on disk. A program that fails keeps its last good build and
    /// is listed by `problems`. Returns whether any picture may have changed.
    bool reloadChangedShaders();
    [[nodiscard]] const std::vector<ShaderProblem>& problems() const;

    /// Returns the programs that were built so far, in their order, without those from the cache on disk. Includes the
    /// siblings' programs.
    [[nodiscard]] const std::vector<ProgramBuild>& builds() const;

    /// Returns the memory in use by kind: images of this renderer, and textures, meshes and programs, which siblings
    /// share.
    [[nodiscard]] std::vector<Stored> stored() const;

    /// Forgets all GL objects without deleting them, because the context was lost.
    void abandon();

private:
    struct State;
    struct Shared;
    explicit Renderer(std::unique_ptr<State>);
    std::unique_ptr<State> state_;
};

}  // namespace vitrine::render::gl
