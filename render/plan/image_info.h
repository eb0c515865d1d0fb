#pragma once

#include "render/scene/camera.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>

namespace vitrine::render {

enum class Format : std::uint8_t { rgba8, rgba16f, rgba32f, rg16f, r8, r16f, r32f, depth32f };
enum class TextureType : std::uint8_t { flat, array, cube, volume };

/// An image of the frame, by name.
struct ImageInfo {
    std::string name;
    Format format = Format::rgba16f;
    TextureType type = TextureType::flat;
    glm::ivec2 size{0};  ///< In pixels; (0, 0): `scale` times the drawn tile, or the whole picture over `divisor`.
    double scale = 1;
    int layers = 1;  ///< Of an array; of a volume its depth; a cube has 6.
    int levels = 1;
    bool persistent = false;  ///< Survives the frame: a shadow map, a probe, an average.
    bool comparison = false;  ///< Depth images: sampled through sampler2DShadow, nearer or equal passes.
    bool repeat = false;      ///< Otherwise clamp to edge.
    bool nearest = false;     ///< Otherwise linear filtering, between levels too.
    /// Above 0: one pixel for every `divisor` × `divisor` pixels of the whole picture, from its lower left corner on,
    /// rounded up; `ownPixels` is then implied.
    int divisor = 0;
    /// Its pixels are its own and not samples of the picture: whoever draws into it sees the whole picture through the
    /// middle of each pixel, whatever tile, jitter and supersample is drawn, and whoever samples it gets the nearest
    /// one.
    bool ownPixels = false;

    [[nodiscard]] bool hasOwnPixels() const { return ownPixels || divisor > 0; }
};

/// Whether one can take the other's place but for its size in pixels.
[[nodiscard]] bool sameStorage(const ImageInfo&, const ImageInfo&);

/// Of level 0, in pixels, at least 1 × 1.
[[nodiscard]] glm::ivec2 sizeOf(const ImageInfo&, const Raster& picture);

/// What a pass sees that draws into an image with its own pixels: for `divisor`, pixel (i, j) covers exactly `divisor`
/// × `divisor` pixels of the picture (those of the last row and column may reach beyond it); for a fixed size the
/// frustum is the picture's.
[[nodiscard]] View viewOfOwnPixels(const View& picture, const ImageInfo&);

/// A buffer of the frame that shaders read and write (std430), by name. All bytes are 0 before they are first written.
struct BufferInfo {
    std::string name;
    std::int64_t bytes = 0;
    bool persistent = false;  ///< Survives the frame.

    bool operator==(const BufferInfo&) const = default;
};

/// An image, or a buffer, that a plan declared: what `FramePlan::image` and its like return. Passes take it wherever
/// they take a name, so that a misspelled one does not compile.
class ResourceId {
public:
    [[nodiscard]] const std::string& name() const { return name_; }
    operator const std::string&() const { return name_; }  // NOLINT: names and handles mix until all are handles.
    bool operator==(const ResourceId&) const = default;

private:
    friend class FramePlan;
    explicit ResourceId(std::string name) : name_(std::move(name)) {}
    std::string name_;
};

}  // namespace vitrine::render
