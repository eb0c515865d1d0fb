#pragma once

#include "render/gl/object.h"
#include "render/plan/frame_plan.h"

#include <cstdint>

namespace vitrine::render::gl {

/// GL texture with immutable storage: an image of a frame, or a picture to sample.
class Texture {
public:
    /// Allocates an image of a frame; `size` is that of level 0, in pixels. Throws Failure (ErrorKind::openGl) if the
    /// driver has no memory for it.
    Texture(const ImageInfo&, glm::ivec2 size);
    /// Uploads a picture, with mipmaps if it asks for them.
    explicit Texture(const render::Texture&);

    [[nodiscard]] GLuint name() const { return name_.name(); }
    [[nodiscard]] glm::ivec2 size(int level = 0) const;
    [[nodiscard]] int layers() const { return layers_; }
    [[nodiscard]] Format format() const { return format_; }
    /// Bytes of all levels and layers, assuming a driver that pads three channels to four.
    [[nodiscard]] std::int64_t bytes() const;
    void bind(int unit) const { glBindTextureUnit(static_cast<GLuint>(unit), name_.name()); }
    /// Fills all of level 0 with zeros: black, or the farthest depth.
    void clear() const;
    [[nodiscard]] int levels() const { return levels_; }
    [[nodiscard]] TextureType type() const { return type_; }
    void abandon() { name_.abandon(); }

private:
    TextureName name_;
    glm::ivec2 size_{0};
    int layers_ = 1;
    int levels_ = 1;
    int texelBytes_ = 4;
    TextureType type_ = TextureType::flat;  ///< For a volume, the number of layers halves with each level, too.
    Format format_ = Format::rgba8;
};

/// Returns the GL internal format of an image.
[[nodiscard]] GLenum internalFormat(Format);

}  // namespace vitrine::render::gl
