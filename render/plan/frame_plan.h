#pragma once

#include "render/glsl/shader_key.h"
#include "render/plan/contribution_bound.h"
#include "render/plan/history.h"
#include "render/plan/image_info.h"
#include "render/plan/local_lights.h"
#include "render/scene/camera.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace vitrine::render {

/// Order of the passes in a frame. Passes of the same phase keep the order in which they were added.
enum class PassPhase : std::uint8_t { simulate, shadow, probe, prepare, opaque, transparent, volume, resolve, present };

/// Texture that a shader samples at a texture unit: an image of the frame, or a texture loaded from a file.
struct SampledTexture {
    int unit = 0;  ///< One of the UNIT_ numbers of shaders/lib/bindings.glsl.
    std::variant<std::string, std::shared_ptr<const Texture>> source;
};

/// Content of a std140 block or of a std430 buffer.
using Bytes = std::vector<std::byte>;

/// Returns the bytes of these numbers or structs; zeros for one of them if there are none, because no buffer is empty.
template <typename T> [[nodiscard]] std::shared_ptr<const Bytes> bytesOf(const std::vector<T>& all)
{
    auto bytes = std::make_shared<Bytes>(std::max(all.size(), std::size_t{1}) * sizeof(T));
    if (!all.empty()) std::memcpy(bytes->data(), all.data(), all.size() * sizeof(T));
    return bytes;
}

enum class Access : std::uint8_t { read, write, readWrite };

/// Type of the vectors that a shader reads from a buffer texture.
enum class Texels : std::uint8_t { none, vec4, uvec4 };

/// Storage buffer that shaders read or write (std430), or buffer texture: a buffer of the frame, or constant bytes.
/// Constant bytes are uploaded once and identified by their address.
struct BufferUse {
    /// One of the STORAGE_ numbers of shaders/lib/bindings.glsl; of a buffer texture, one of the UNIT_BUFFER_ numbers.
    int binding = 0;
    std::variant<std::string, std::shared_ptr<const Bytes>> source;
    Access access = Access::read;  ///< `write`: the shader writes every byte, so that the old content does not matter.
    Texels texels = Texels::none;  ///< Not `none`: constant bytes, read as a buffer texture; a multiple of 16 bytes.
};

enum class Load : std::uint8_t { keep, clear };

struct Attachment {
    std::string image;
    Load load = Load::keep;
    glm::vec4 clear{0};
    int layer = -1;  ///< -1: the whole image (layered when it has layers).
    int level = 0;

    /// The whole image; its content is kept.
    [[nodiscard]] static Attachment whole(std::string image) { return {.image = std::move(image)}; }
    /// The whole image, cleared to `color`. A depth image is cleared to the farthest depth.
    [[nodiscard]] static Attachment cleared(std::string image, const glm::vec4& color = glm::vec4(0))
    {
        return {std::move(image), Load::clear, color, -1, 0};
    }
    /// One layer, slice or face of one mip level; its content is kept.
    [[nodiscard]] static Attachment slice(std::string image, int layer, int level = 0)
    {
        return {std::move(image), Load::keep, glm::vec4(0), layer, level};
    }
    /// The same, cleared to `color`.
    [[nodiscard]] static Attachment clearedSlice(std::string image, int layer, int level = 0,
                                                 const glm::vec4& color = glm::vec4(0))
    {
        return {std::move(image), Load::clear, color, layer, level};
    }
};

enum class DepthTest : std::uint8_t { none, nearer, nearerOrEqual, equal, farther };
enum class Cull : std::uint8_t { none, back, front };
enum class Blend : std::uint8_t { none, add, alpha, premultiplied, mean };

struct RasterState {
    DepthTest depthTest = DepthTest::none;
    bool depthWrite = false;
    Cull cull = Cull::none;
    Blend blend = Blend::none;
    float meanWeight = 1;    ///< For Blend::mean: result = mix(old, new, meanWeight).
    glm::vec2 depthBias{0};  ///< Slope-scaled and constant bias, away from the light or eye.
    bool depthClamp = false;
};

/// One draw call. Without a mesh: one triangle that covers the target.
struct Draw {
    std::shared_ptr<const Mesh> mesh;
    int instances = 1;
    bool mirrored = false;  ///< Front faces are clockwise.
    Bytes object;           ///< The OBJECT block; may be empty.
    std::vector<SampledTexture> inputs;
    std::vector<BufferUse> buffers = {};  ///< Read only: the instances' data at STORAGE_INSTANCES, by gl_InstanceID.
    std::optional<Cull> cull = {};  ///< Replaces the pass's cull mode. Either all draws of a pass set it, or none.
};

/// A simulation pass only appears in the frame report: its steps were taken when the frame was prepared.
enum class Work : std::uint8_t { simulation, raster, compute };
[[nodiscard]] const char* toString(Work);

/// Part of a pass that a permutation or a branch of its shader can leave out.
struct Effect {
    std::string name;  ///< "sdf_morph/occlusion".
    ContributionBound bound;
};

/// Depth-only variant of a raster pass: the same draws, state and blocks, with another program. `inputs` replace the
/// inputs of the pass and of its draws.
struct DepthOnly {
    ShaderKey shader;
    std::vector<SampledTexture> inputs = {};
};

/// One step of a frame: a simulation step on the CPU, a raster pass or a compute dispatch.
struct Pass {
    std::string name;    ///< Unique in the plan: "sdf_morph/march".
    std::string reason;  ///< Why the pass is in the plan, for people: "in view, 1.2 m away".
    /// Variant that the pass draws in this frame, for people, if it draws several in turn: "built up to: bars".
    /// StepCosts keeps the time of each.
    std::string variant = {};
    PassPhase phase = PassPhase::opaque;
    Work work = Work::raster;

    ShaderKey shader;
    RasterState state;
    std::vector<Attachment> colors;  ///< Color outputs by location.
    std::optional<Attachment> depth;
    std::vector<Attachment> storage;  ///< Compute: writable images by binding.
    std::vector<SampledTexture> inputs;
    std::vector<BufferUse> buffers;
    std::vector<std::string> reads;   ///< Simulation states read, besides the images of `inputs`.
    std::vector<std::string> writes;  ///< Simulation states written, besides the attachments.
    std::map<int, Bytes> blocks;      ///< std140 blocks by BLOCK_ binding; FRAME is the renderer's.
    /// Local lights of the frame. `FramePlan::add` makes the block of those that may reach a place in `shaded`, and
    /// counts them as "localLights".
    std::shared_ptr<const LocalLightsBlock> localLights;
    ShadedSpace shaded;
    std::optional<View> view;  ///< Replaces the plan's view: a light's, or that of a face of a probe.
    /// Raster: draws only the pixels of the columns from `x` to before `y`. Clearing covers the whole image. Unset: all
    /// columns.
    std::optional<glm::ivec2> columns;
    /// Set: a stranger's shader runs, which may take any time (gl::Renderer::stopUnboundedAfter). The value identifies
    /// what that time depends on, other than the moment and the camera.
    std::optional<std::uint64_t> unbounded;
    std::vector<Draw> draws;
    /// Set: it draws opaque surfaces, at level 0, with a fragment shader that has the permutations of
    /// shaders/kit/stored_surface.glsl, and `FramePlan::withDeferredShading` may split it. A corner of every
    /// `trianglesPerSample`-th of its triangles, world space.
    std::shared_ptr<const std::vector<glm::vec3>> triangleSamples;
    static constexpr std::size_t trianglesPerSample = 16;
    std::optional<DepthOnly> depthOnly;  ///< Depth-only variant. Unset: the pass's own program also draws the depth.
    glm::ivec3 groups{1};                ///< Compute pass: number of work groups.
    std::vector<std::string> mipmaps;    ///< Images whose lower mip levels are made from level 0 after the pass.
    /// Work that the pass is known to do, by counter name ("fetches", "marchSteps"). Added to the report's counters
    /// when it runs.
    std::map<std::string, std::int64_t> counts;
    bool countSamples = false;  ///< Raster: samples that pass the depth test go to the counter "samples".

    /// Upper bound on what it changes. A pass with a bound of 0 is provably invisible and is skipped.
    ContributionBound bound;
    /// Parts of its shader; FramePlan::includeIfEffective decides which of them are listed here.
    std::vector<Effect> effects;

    /// Hash of everything that the outputs depend on. When it is set, and all outputs are persistent images last
    /// written under the same hash, the pass is skipped as unchanged.
    std::optional<std::uint64_t> contentHash;

    /// Number of slices of a pass that is spread over several frames; 1: an ordinary pass. Each frame runs the next
    /// slice until all have run. They start again when `contentHash` changes, which such a pass must have. The outputs
    /// are persistent; until the last slice is done, readers get the last complete result. The shader reads the number
    /// of the slice from lib/temporal.glsl. Attachments are cleared only before the first slice.
    int sliceCount = 1;

    /// State of earlier frames, filled in by `FramePlan::prune`.
    struct TemporalState {
        int firstSlice = 0;  ///< Runs the slices from `firstSlice` (from 0) to before `endSlice`.
        int endSlice = 1;
        bool used = false;  ///< It reads histories or outputs of a sliced pass, or is sliced itself: lib/temporal.glsl
                            ///< is filled.
        bool valid = true;  ///< All histories and sliced outputs that it reads have usable content.
        View lastView;      ///< View of the frame that drew the histories.
        /// True if the pass reads an unfinished output, so that it must run again even if its `contentHash` is
        /// unchanged.
        bool provisional = false;
    } temporal = {};
};

struct CulledPass {
    std::string name;
    std::string reason;
    Work work = Work::raster;
    bool complaint = false;    ///< The input was bad: a line is written to the log, besides the frame report.
    bool boundIsZero = false;  ///< The pass was left out because its bound is 0.
    /// For a file that cannot be read: which parameter names it, which file it is, and why it fails.
    std::string unreadable = {};
};

/// List of the passes of a frame, and of those left out with the reason. Plain data: it is built, pruned and tested
/// without a GL context.
class FramePlan {
public:
    View view;        ///< View of the frame.
    double time = 0;  ///< Seconds; exhibits wrap it per period before it becomes a float.
    std::uint32_t seed = 1;
    int sample = 0;  ///< Index of the supersample being drawn.
    /// Diagnostic switch: no pass is pruned or skipped as unchanged, and surfaces ask all lights.
    bool runEverything = false;
    bool resetHistory = false;  ///< This frame does not continue the last one: histories start again.
    bool allSlices = false;  ///< Runs all slices of a sliced pass in this frame and waits for programs to be built: for
                             ///< pictures that are drawn only once.

    ResourceId image(ImageInfo);
    ResourceId buffer(BufferInfo);
    /// Returns the image that this frame writes; `previous` of its name is the last frame's content.
    ResourceId history(History);
    /// Adds the pass. One with a bound of 0 is listed as skipped instead, unless `runEverything` is set.
    void add(Pass);
    void skip(std::string name, std::string reason, Work = Work::raster);
    /// Reports bad input: something was left out or replaced, and `reason` says why in one sentence for people.
    void warn(std::string name, std::string reason, Work = Work::raster);
    /// Reports a file that cannot be read. `unreadable` says which parameter, which file and why, `instead` what is
    /// drawn in its place. Both are full sentences.
    void warnOfFile(std::string name, std::string unreadable, const std::string& instead);
    /// Returns whether an effect has to be drawn: its bound is not 0, or `runEverything` is set. Otherwise lists its
    /// passes, given by name, as skipped.
    [[nodiscard]] bool includeIfEffective(const ContributionBound&, std::initializer_list<const char*> passes);
    /// The same for an effect within a pass. It is added to the pass's effects, or listed as skipped.
    [[nodiscard]] bool includeIfEffective(Pass&, Effect);

    /// Returns a copy of the plan, pruned or not, with further passes before all others, for checks. The images of
    /// these passes must be declared in the plan.
    [[nodiscard]] FramePlan withPassesFirst(std::vector<Pass>) const;

    /// Returns a copy of the pruned plan in which passes with many small triangles in view are drawn in two steps
    /// (deferred shading): the first stores the surface of each pixel, the second computes its light. With small
    /// triangles, drivers run a fragment shader several times for each pixel: software renderers for whole blocks of
    /// 4 × 2 pixels. Returns nothing if there is no such pass.
    [[nodiscard]] std::optional<FramePlan> withDeferredShading() const;

    /// Sorts the passes by phase. Drops every pass that no output depends on, and those whose persistent outputs are up
    /// to date under `kept`. A dropped pass moves to `skipped()` with its reason.
    void prune(const std::vector<std::string>& outputs, const PersistentState& kept = {});

    [[nodiscard]] const std::vector<Pass>& passes() const { return passes_; }
    [[nodiscard]] const std::vector<CulledPass>& skipped() const { return skipped_; }
    [[nodiscard]] const std::map<std::string, ImageInfo>& images() const { return images_; }
    [[nodiscard]] const std::map<std::string, BufferInfo>& buffers() const { return buffers_; }
    /// States by image name; known after `prune`.
    [[nodiscard]] const std::map<std::string, HistoryState>& histories() const { return histories_; }
    /// Images that sliced passes write. Readers of them get the last complete result.
    [[nodiscard]] const std::set<std::string>& slicedImages() const { return slicedImages_; }
    /// Returns whether sliced passes need another frame to finish; known after `prune`.
    [[nodiscard]] bool unfinished() const;
    /// Returns the errors of the plan itself, a sentence each: passes that use images or buffers which the plan does
    /// not declare. A plan that is drawn must have none; tests check this for all plans.
    [[nodiscard]] std::vector<std::string> errors() const;
    [[nodiscard]] const Pass* find(std::string_view passName) const;
    [[nodiscard]] const CulledPass* findSkipped(std::string_view passName) const;

private:
    [[nodiscard]] bool isUnchanged(const Pass&, const PersistentState&) const;
    [[nodiscard]] std::vector<bool> calledFor(const std::vector<std::string>& outputs,
                                              const std::vector<bool>& unchanged) const;
    void drop(const std::vector<std::string>& outputs, const PersistentState&);
    void takeSlice(Pass&, const PersistentState&) const;
    void readTemporalState(const PersistentState&);

    std::vector<Pass> passes_;
    std::vector<CulledPass> skipped_;
    std::map<std::string, ImageInfo> images_;
    std::map<std::string, BufferInfo> buffers_;
    std::map<std::string, HistoryState> histories_;
    std::set<std::string> slicedImages_;
};

/// Returns the passes in order, the form that tests compare: "hall/walls > sdf_morph/march > present".
[[nodiscard]] std::string toString(const FramePlan&);

/// Returns the name of every image, buffer or simulation state that a pass writes.
[[nodiscard]] std::vector<std::string> outputsOf(const Pass&);
/// Returns the name of every image, buffer or simulation state that a pass reads, including attachments that it does
/// not clear.
[[nodiscard]] std::vector<std::string> inputsOf(const Pass&);

}  // namespace vitrine::render
