#pragma once

#include "render/plan/contribution_bound.h"
#include "render/plan/history.h"
#include "render/plan/image_info.h"
#include "render/plan/shader_key.h"
#include "render/scene/camera.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace vitrine::render {

/// The order of a frame. Passes of one stage keep the order in which they were added.
enum class PassPhase : std::uint8_t { simulate, shadow, probe, prepare, opaque, transparent, volume, resolve, present };

/// What a shader reads at a texture unit: an image of the frame, or a picture from a file.
struct SampledTexture {
    int unit = 0;  ///< One of the UNIT_ numbers of shaders/lib/bindings.glsl.
    std::variant<std::string, std::shared_ptr<const Texture>> source;
};

/// Bytes of a std140 block, or of a std430 buffer.
using Bytes = std::vector<std::byte>;

enum class Access : std::uint8_t { read, write, readWrite };

/// What shaders read or write as a std430 buffer: one of the frame, or bytes that never change (std430, uploaded once,
/// by address).
struct BufferUse {
    int binding = 0;  ///< One of the STORAGE_ numbers of shaders/lib/bindings.glsl.
    std::variant<std::string, std::shared_ptr<const Bytes>> source;
    Access access = Access::read;  ///< `write`: all of it, so that what was in it does not matter.
};

enum class Load : std::uint8_t { keep, clear };

struct Attachment {
    std::string image;
    Load load = Load::keep;
    glm::vec4 clear{0};
    int layer = -1;  ///< -1: the whole image (layered when it has layers).
    int level = 0;

    /// All of it, over what is there.
    [[nodiscard]] static Attachment whole(std::string image) { return {.image = std::move(image)}; }
    /// All of it, filled with `color` before; a depth image is as far as can be where nothing is drawn.
    [[nodiscard]] static Attachment cleared(std::string image, const glm::vec4& color = glm::vec4(0))
    {
        return {std::move(image), Load::clear, color, -1, 0};
    }
    /// One layer, slice or face of one level, over what is there.
    [[nodiscard]] static Attachment slice(std::string image, int layer, int level = 0)
    {
        return {std::move(image), Load::keep, glm::vec4(0), layer, level};
    }
    /// The same, filled with `color` before.
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
    glm::vec2 depthBias{0};  ///< Slope-scaled and constant, away from the light or eye.
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
    std::optional<Cull> cull = {};        ///< In place of the pass's. Set by all draws of a pass, or by none.
};

/// A simulation is ledger only: whoever prepared the frame has taken its steps.
enum class Work : std::uint8_t { simulation, raster, compute };
[[nodiscard]] const char* toString(Work);

/// Part of a pass that a permutation or a branch of its shader can leave out.
struct Effect {
    std::string name;  ///< "sdf_morph/occlusion".
    ContributionBound bound;
};

/// How the depth of a raster pass is drawn without the rest of it: by its own draws, state and blocks, with another
/// program and these inputs in place of the pass's and its draws'.
struct DepthOnly {
    ShaderKey shader;
    std::vector<SampledTexture> inputs = {};
};

/// One step of a frame: a simulation step on the CPU, a raster pass or a compute dispatch.
struct Pass {
    std::string name;    ///< Unique in the plan: "sdf_morph/march".
    std::string reason;  ///< Why it is here, for people: "in view, 1.2 m away".
    /// Which of several things it draws in turn, for people: "built up to: bars". The ledger keeps the time of each.
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
    std::optional<View> view;         ///< In place of the plan's: a light, a face of a probe.
    /// Raster: of the targets, only the pixels of these columns are drawn, from the first to before the second; what
    /// is cleared is cleared as a whole. Unset: all.
    std::optional<glm::ivec2> columns;
    std::vector<Draw> draws;
    std::optional<DepthOnly> depthOnly;  ///< For whoever asks for no more; unset: only its own program finds its depth.
    glm::ivec3 groups{1};                ///< Compute.
    std::vector<std::string> mipmaps;    ///< Images whose lower levels are made from level 0 afterwards.
    /// Work that the plan knows this pass does, by counter name ("fetches", "marchSteps"): added to the
    /// report's counters when it runs.
    std::map<std::string, std::int64_t> counts;
    bool countSamples = false;  ///< Raster: samples that pass the depth test go to the counter "samples".

    ContributionBound bound;      ///< What it changes: 0 for what is provably invisible, which is then skipped.
    std::vector<Effect> effects;  ///< In its shader; FramePlan::needs says which of them belong here.

    /// When set and all outputs are persistent images last written under the same key, the pass is skipped
    /// as unchanged. It must cover everything that the output depends on.
    std::optional<std::uint64_t> key;

    /// Above 1: work for several frames. Part 1, 2, ... of them runs in each frame until all have, and starts again
    /// when `key`, which it must have, is another. Its outputs are persistent; whoever reads them meanwhile gets the
    /// last whole result. The shader sees which part it is in lib/temporal.glsl; attachments are cleared before part 1
    /// only.
    int parts = 1;

    /// What `FramePlan::prune` finds out about the frames before.
    struct Past {
        int firstPart = 0;  ///< Runs parts `firstPart` + 1 to `endPart`.
        int endPart = 1;
        bool used = false;  ///< It reads histories or results of parts, or is such a part: lib/temporal.glsl is filled.
        bool valid = true;  ///< All that it reads of these holds something that it can use.
        View lastView;      ///< Of the frame that drew the histories.
        bool provisional = false;  ///< It read what is not finished, so that it must run again, `key` or not.
    } past = {};
};

struct CulledPass {
    std::string name;
    std::string reason;
    Work work = Work::raster;
    bool complaint = false;    ///< Its input was bad: a line in the log, besides the ledger's.
    bool boundIsZero = false;  ///< It could be drawn, and would change nothing.
    std::string unreadable =
        {};  ///< Of a complaint about a file that the look names: which parameter, which file, and why.
};

/// What a frame will do, and what it will not do and why. Plain data: built, pruned and tested
/// without a GL context.
class FramePlan {
public:
    View view;        ///< Of the picture.
    double time = 0;  ///< Seconds; exhibits wrap it per period before it becomes a float.
    std::uint32_t seed = 1;
    int sample = 0;              ///< Index of the supersample being drawn.
    bool runEverything = false;  ///< The ledger's switch: nothing is pruned or skipped as unchanged.
    bool cut = false;            ///< This frame has nothing to do with the last one: histories start again.
    bool allParts = false;  ///< Work for several frames is done in this one, and programs are waited for: for pictures
                            ///< that are not redrawn.

    ResourceId image(ImageInfo);
    ResourceId buffer(BufferInfo);
    /// Returns the image that this frame writes; `previous` of it is what the last frame left.
    ResourceId history(History);
    /// A pass with a bound of 0 is skipped, but for `runEverything`.
    void add(Pass);
    void skip(std::string name, std::string reason, Work = Work::raster);
    /// Left out or mended because the input was bad, and why, in one sentence for the visitor.
    void warn(std::string name, std::string reason, Work = Work::raster);
    /// The look names a file that cannot be read: `unreadable` says which parameter, which file and why, `instead` what
    /// is drawn in its place. Both are full sentences.
    void warnOfFile(std::string name, std::string unreadable, const std::string& instead);
    /// Whether an effect has to be drawn: its bound is not 0, or everything runs. Otherwise its passes, by name, are
    /// listed as skipped.
    [[nodiscard]] bool includeIfEffective(const ContributionBound&, std::initializer_list<const char*> passes);
    /// The same for an effect within a pass, which is then listed with the pass.
    [[nodiscard]] bool includeIfEffective(Pass&, Effect);

    /// The same plan, pruned or not, with further passes before all others: what a check adds. Their images are there.
    [[nodiscard]] FramePlan withPassesFirst(std::vector<Pass>) const;

    /// Sorts by stage, drops every pass that no output depends on, and those whose persistent outputs are
    /// up to date under `kept`. A dropped pass moves to `skipped()` with its reason.
    void prune(const std::vector<std::string>& outputs, const PersistentState& kept = {});

    [[nodiscard]] const std::vector<Pass>& passes() const { return passes_; }
    [[nodiscard]] const std::vector<CulledPass>& skipped() const { return skipped_; }
    [[nodiscard]] const std::map<std::string, ImageInfo>& images() const { return images_; }
    [[nodiscard]] const std::map<std::string, BufferInfo>& buffers() const { return buffers_; }
    /// By image; known after `prune`.
    [[nodiscard]] const std::map<std::string, HistoryState>& histories() const { return histories_; }
    /// Images that are written by parts: what is read of them is the last whole result.
    [[nodiscard]] const std::set<std::string>& imagesInParts() const { return imagesInParts_; }
    /// Whether another frame is called for to finish what was begun; known after `prune`.
    [[nodiscard]] bool unfinished() const;
    /// What is wrong with the plan itself, a sentence each: passes that read or write what no one declared. None is
    /// left in a plan that is to be drawn; tests plan everything and look.
    [[nodiscard]] std::vector<std::string> errors() const;
    [[nodiscard]] const Pass* find(std::string_view passName) const;
    [[nodiscard]] const CulledPass* findSkipped(std::string_view passName) const;

private:
    [[nodiscard]] bool isUnchanged(const Pass&, const PersistentState&) const;
    [[nodiscard]] std::vector<bool> calledFor(const std::vector<std::string>& outputs,
                                              const std::vector<bool>& unchanged) const;
    void drop(const std::vector<std::string>& outputs, const PersistentState&);
    void takePart(Pass&, const PersistentState&) const;
    void lookBack(const PersistentState&);

    std::vector<Pass> passes_;
    std::vector<CulledPass> skipped_;
    std::map<std::string, ImageInfo> images_;
    std::map<std::string, BufferInfo> buffers_;
    std::map<std::string, HistoryState> histories_;
    std::set<std::string> imagesInParts_;
};

/// "hall/walls > sdf_morph/march > present": the form tests compare.
[[nodiscard]] std::string toString(const FramePlan&);

/// Every image, buffer or state that a pass writes, by name.
[[nodiscard]] std::vector<std::string> outputsOf(const Pass&);
/// Every image, buffer or state that a pass reads, by name; what it writes without clearing included.
[[nodiscard]] std::vector<std::string> inputsOf(const Pass&);

}  // namespace vitrine::render
