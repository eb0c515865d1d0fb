#pragma once

#include "render/plan/bound.h"
#include "render/scene/camera.h"
#include "render/scene/mesh.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace vitrine::render {

/// The order of a frame. Passes of one stage keep the order in which they were added.
enum class Stage : std::uint8_t { simulate, shadow, probe, prepare, opaque, transparent, volume, resolve, present };

enum class Format : std::uint8_t { rgba8, rgba16f, rgba32f, rg16f, r16f, r32f, depth32f };
enum class Shape : std::uint8_t { flat, array, cube };

/// An image of the frame, by name.
struct ImageInfo {
    std::string name;
    Format format = Format::rgba16f;
    Shape shape = Shape::flat;
    glm::ivec2 size{0};      ///< In pixels; (0, 0): `scale` times the drawn tile.
    double scale = 1;
    int layers = 1;          ///< 6 for a cube.
    int levels = 1;
    bool kept = false;       ///< Survives the frame: a shadow map, a probe, an average.
    bool comparison = false; ///< Depth images: sampled through sampler2DShadow, nearer or equal passes.
    bool repeat = false;     ///< Otherwise clamp to edge.
    bool nearest = false;    ///< Otherwise linear filtering, between levels too.
};

/// Shader files under shaders/ and the permutation to build: {"SHADOW_METHOD 2", "GLASS"}.
struct ShaderKey {
    std::string vertex;
    std::string fragment;
    std::string compute;
    std::vector<std::string> defines;
    std::string prelude = {};  ///< GLSL before the files: the parameter block derived from a table.

    bool operator==(const ShaderKey&) const = default;
};

/// What a shader reads at a texture unit: an image of the frame, or a picture from a file.
struct Input {
    int unit = 0;  ///< One of the UNIT_ numbers of shaders/lib/bindings.glsl.
    std::variant<std::string, std::shared_ptr<const Texture>> source;
};

enum class Load : std::uint8_t { keep, clear };

struct Attachment {
    std::string image;
    Load load = Load::keep;
    glm::vec4 clear{0};
    int layer = -1;  ///< -1: the whole image (layered when it has layers).
    int level = 0;
};

enum class DepthTest : std::uint8_t { none, nearer, nearerOrEqual, equal, farther };
enum class Cull : std::uint8_t { none, back, front };
enum class Blend : std::uint8_t { none, add, alpha, premultiplied, mean };

struct RasterState {
    DepthTest depthTest = DepthTest::none;
    bool depthWrite = false;
    Cull cull = Cull::none;
    Blend blend = Blend::none;
    float meanWeight = 1;              ///< For Blend::mean: result = mix(old, new, meanWeight).
    glm::vec2 depthBias{0};            ///< Slope-scaled and constant, away from the light or eye.
    bool depthClamp = false;
};

/// Bytes of a std140 block.
using Bytes = std::vector<std::byte>;

/// The bytes of a trivially copyable struct that mirrors a std140 block.
template <typename T> [[nodiscard]] Bytes bytesOf(const T& block)
{
    static_assert(std::is_trivially_copyable_v<T>);
    const auto* first = reinterpret_cast<const std::byte*>(&block);
    return Bytes(first, first + sizeof(T));
}

/// One draw call. Without a mesh: one triangle that covers the target.
struct Draw {
    std::shared_ptr<const Mesh> mesh;
    int instances = 1;
    bool mirrored = false;  ///< Front faces are clockwise.
    Bytes object;           ///< The OBJECT block; may be empty.
    std::vector<Input> inputs;
};

/// A simulation is ledger only: whoever prepared the frame has taken its steps.
enum class Work : std::uint8_t { simulation, raster, compute };
[[nodiscard]] const char* toString(Work);

/// Part of a pass that a permutation or a branch of its shader can leave out.
struct Effect {
    std::string name;  ///< "sdf_morph/occlusion".
    Bound bound;
};

/// One step of a frame: a simulation step on the CPU, a raster pass or a compute dispatch.
struct Pass {
    std::string name;    ///< Unique in the plan: "sdf_morph/march".
    std::string reason;  ///< Why it is here, for people: "in view, 1.2 m away".
    Stage stage = Stage::opaque;
    Work work = Work::raster;

    ShaderKey shader;
    RasterState state;
    std::vector<Attachment> colors;       ///< Color outputs by location.
    std::optional<Attachment> depth;
    std::vector<Attachment> storage;      ///< Compute: writable images by binding.
    std::vector<Input> inputs;
    std::vector<std::string> reads;       ///< Simulation states read, besides the images of `inputs`.
    std::vector<std::string> writes;      ///< Simulation states written, besides the attachments.
    std::map<int, Bytes> blocks;          ///< std140 blocks by BLOCK_ binding; FRAME is the renderer's.
    std::optional<View> view;             ///< In place of the plan's: a light, a face of a probe.
    std::vector<Draw> draws;
    glm::ivec3 groups{1};                 ///< Compute.
    std::vector<std::string> mipmaps;     ///< Images whose lower levels are made from level 0 afterwards.
    /// Work that the plan knows this pass does, by counter name ("fetches", "marchSteps"): added to the
    /// report's counters when it runs.
    std::map<std::string, std::int64_t> counts;
    bool countSamples = false;            ///< Raster: samples that pass the depth test go to the counter "samples".

    Bound bound;                   ///< What it changes: 0 for what is provably invisible, which is then skipped.
    std::vector<Effect> effects;   ///< In its shader; FramePlan::needs says which of them belong here.

    /// When set and all outputs are kept images last written under the same key, the pass is skipped
    /// as unchanged. It must cover everything that the output depends on.
    std::optional<std::uint64_t> key;
};

struct Skipped {
    std::string name;
    std::string reason;
    Work work = Work::raster;
    bool complaint = false;  ///< Its input was bad: a line in the log, besides the ledger's.
    bool boundIsZero = false;  ///< It could be drawn, and would change nothing.
    std::string unreadable = {};  ///< Of a complaint about a file that the look names: which parameter, which file, and why.
};

/// Keys under which kept images were last written: image name and pass name -> key.
using KeptKeys = std::map<std::string, std::uint64_t>;

/// What a frame will do, and what it will not do and why. Plain data: built, pruned and tested
/// without a GL context.
class FramePlan {
public:
    View view;            ///< Of the picture.
    double time = 0;      ///< Seconds; exhibits wrap it per period before it becomes a float.
    std::uint32_t seed = 1;
    int sample = 0;       ///< Index of the supersample being drawn.
    bool runEverything = false;  ///< The ledger's switch: nothing is pruned or skipped as unchanged.

    void image(ImageInfo);
    /// A pass with a bound of 0 is skipped, but for `runEverything`.
    void add(Pass);
    void skip(std::string name, std::string reason, Work = Work::raster);
    /// Left out or mended because the input was bad, and why, in one sentence for the visitor.
    void complain(std::string name, std::string reason, Work = Work::raster);
    /// The look names a file that cannot be read: `unreadable` says which parameter, which file and why, `instead` what
    /// is drawn in its place. Both are full sentences.
    void complainOfFile(std::string name, std::string unreadable, const std::string& instead);
    /// Whether an effect has to be drawn: its bound is not 0, or everything runs. Otherwise its passes, by name, are
    /// listed as skipped.
    [[nodiscard]] bool needs(const Bound&, std::initializer_list<const char*> passes);
    /// The same for an effect within a pass, which is then listed with the pass.
    [[nodiscard]] bool needs(Pass&, Effect);

    /// Sorts by stage, drops every pass that no output depends on, and those whose kept outputs are
    /// up to date under `kept`. A dropped pass moves to `skipped()` with its reason.
    void prune(const std::vector<std::string>& outputs, const KeptKeys& kept = {});

    [[nodiscard]] const std::vector<Pass>& passes() const { return passes_; }
    [[nodiscard]] const std::vector<Skipped>& skipped() const { return skipped_; }
    [[nodiscard]] const std::map<std::string, ImageInfo>& images() const { return images_; }
    [[nodiscard]] const Pass* find(std::string_view passName) const;
    [[nodiscard]] const Skipped* findSkipped(std::string_view passName) const;

private:
    std::vector<Pass> passes_;
    std::vector<Skipped> skipped_;
    std::map<std::string, ImageInfo> images_;
};

/// "hall/opaque > sdf_morph/march > present": the form tests compare.
[[nodiscard]] std::string toString(const FramePlan&);

/// Every image that a pass writes, by name.
[[nodiscard]] std::vector<std::string> outputsOf(const Pass&);
/// Every image or state that a pass reads, by name; what it writes without clearing included.
[[nodiscard]] std::vector<std::string> inputsOf(const Pass&);

}  // namespace vitrine::render
