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
    glm::ivec2 size{0};  ///< In pixels. (0, 0): `scale` times the drawn tile, or the size of the whole picture divided
                         ///< by `divisor`.
    double scale = 1;
    int layers = 1;  ///< Number of layers of an array, or depth of a volume; a cube has 6.
    int levels = 1;
    bool persistent = false;  ///< Survives the frame: a shadow map, a probe, an average.
    bool comparison = false;  ///< Depth images: sampled through sampler2DShadow; a nearer or equal depth passes.
    bool repeat = false;      ///< Otherwise clamp to edge.
    bool nearest = false;     ///< Nearest filtering; otherwise linear filtering, between mip levels too.
    /// Above 0: one pixel for every `divisor` × `divisor` pixels of the whole picture, counted from the lower left
    /// corner and rounded up. Implies `ownPixels`.
    int divisor = 0;
    /// The pixel grid is independent of tile, jitter and supersample. A pass that draws into the image sees the whole
    /// picture, through pixel centers. A shader that samples it reads the nearest pixel.
    bool ownPixels = false;

    [[nodiscard]] bool hasOwnPixels() const { return ownPixels || divisor > 0; }
};

/// Returns whether the two images have the same storage, except for their size in pixels.
[[nodiscard]] bool sameStorage(const ImageInfo&, const ImageInfo&);

/// Returns the size of mip level 0 in pixels, at least 1 × 1.
[[nodiscard]] glm::ivec2 sizeOf(const ImageInfo&, const Raster& picture);

/// Returns the view of a pass that draws into an image with its own pixels. With `divisor`, pixel (i, j) covers exactly
/// `divisor` × `divisor` pixels of the picture; the last row and column may reach beyond it. With a fixed size, the
/// frustum is the picture's.
[[nodiscard]] View viewOfOwnPixels(const View& picture, const ImageInfo&);

/// A buffer of the frame that shaders read and write (std430), by name. All bytes are 0 before they are first written.
struct BufferInfo {
    std::string name;
    std::int64_t bytes = 0;
    bool persistent = false;  ///< Survives the frame.

    bool operator==(const BufferInfo&) const = default;
};

/// Handle of an image or buffer that a plan declared, returned by `FramePlan::image`, `buffer` and `history`. Passes
/// accept it in place of a name, so that a misspelled name does not compile.
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
