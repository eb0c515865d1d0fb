#include "render/gl/texture.h"

#include "render/failure.h"
#include "render/image/mipmap.h"

#include <algorithm>
#include <bit>
#include <string>

namespace vitrine::render::gl {
namespace {

GLenum targetOf(TextureType type)
{
    switch (type) {
    case TextureType::flat: return GL_TEXTURE_2D;
    case TextureType::array: return GL_TEXTURE_2D_ARRAY;
    case TextureType::cube: return GL_TEXTURE_CUBE_MAP;
    case TextureType::volume: return GL_TEXTURE_3D;
    }
    return GL_TEXTURE_2D;
}

TextureName create(GLenum target)
{
    GLuint name = 0;
    glCreateTextures(target, 1, &name);
    return TextureName(name);
}

int mipLevels(int width, int height)
{
    return static_cast<int>(std::bit_width(static_cast<unsigned>(std::max({width, height, 1}))));
}

struct PixelFormat {
    GLenum internal, external, type;
};

PixelFormat pixelFormat(const render::Texture& picture)
{
    const bool floats = !picture.floats.empty();
    switch (picture.channels) {
    case 1:
        return {floats ? GLenum(GL_R16F) : GLenum(GL_R8), GL_RED, floats ? GLenum(GL_FLOAT) : GLenum(GL_UNSIGNED_BYTE)};
    case 3:
        if (floats) return {GL_RGB16F, GL_RGB, GL_FLOAT};
        return {picture.sRgb ? GLenum(GL_SRGB8) : GLenum(GL_RGB8), GL_RGB, GL_UNSIGNED_BYTE};
    default:
        if (floats) return {GL_RGBA16F, GL_RGBA, GL_FLOAT};
        return {picture.sRgb ? GLenum(GL_SRGB8_ALPHA8) : GLenum(GL_RGBA8), GL_RGBA, GL_UNSIGNED_BYTE};
    }
}

int bytesOfTexel(Format format)
{
    switch (format) {
    case Format::rgba8: return 4;
    case Format::rgba16f: return 8;
    case Format::rgba32f: return 16;
    case Format::rg16f: return 4;
    case Format::r8: return 1;
    case Format::r16f: return 2;
    case Format::r32f: return 4;
    case Format::depth32f: return 4;
    }
    return 4;
}

void upload(GLuint name, int level, const PixelFormat& format, const render::Texture& picture)
{
    const void* data = picture.floats.empty() ? static_cast<const void*>(picture.bytes.data()) : picture.floats.data();
    if (picture.layers > 1)
        glTextureSubImage3D(name, level, 0, 0, 0, picture.width, picture.height, picture.layers, format.external,
                            format.type, data);
    else
        glTextureSubImage2D(name, level, 0, 0, picture.width, picture.height, format.external, format.type, data);
}

GLenum minifyingFilter(const render::Texture& picture, int levels)
{
    if (levels < 2) return picture.minifyNearest ? GL_NEAREST : GL_LINEAR;
    if (picture.nearestLevel) return picture.minifyNearest ? GL_NEAREST_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_NEAREST;
    return picture.minifyNearest ? GL_NEAREST_MIPMAP_LINEAR : GL_LINEAR_MIPMAP_LINEAR;
}

void setParameter(GLuint name, GLenum parameter, GLenum value)
{
    glTextureParameteri(name, parameter, static_cast<GLint>(value));
}

}  // namespace

GLenum internalFormat(Format format)
{
    switch (format) {
    case Format::rgba8: return GL_RGBA8;
    case Format::rgba16f: return GL_RGBA16F;
    case Format::rgba32f: return GL_RGBA32F;
    case Format::rg16f: return GL_RG16F;
    case Format::r8: return GL_R8;
    case Format::r16f: return GL_R16F;
    case Format::r32f: return GL_R32F;
    case Format::depth32f: return GL_DEPTH_COMPONENT32F;
    }
    return GL_RGBA8;
}

Texture::Texture(const ImageInfo& info, glm::ivec2 size)
    : name_(create(targetOf(info.type))), size_(size), layers_(info.type == TextureType::cube ? 6 : info.layers),
      levels_(info.levels), texelBytes_(bytesOfTexel(info.format)), type_(info.type), format_(info.format)
{
    const GLuint name = name_.name();
    while (glGetError() != GL_NO_ERROR) {
    }
    if (info.type == TextureType::array || info.type == TextureType::volume)
        glTextureStorage3D(name, info.levels, internalFormat(info.format), size.x, size.y, info.layers);
    else
        glTextureStorage2D(name, info.levels, internalFormat(info.format), size.x, size.y);
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
        throw Failure(
            ErrorKind::openGl,
            message("The graphics driver cannot store the image \"{1}\" of {2} × {3} pixels; choose a smaller size.",
                    info.name, size.x, size.y));
    }
    const bool mipped = info.levels > 1;
    const bool nearest = info.nearest || info.hasOwnPixels();
    setParameter(name, GL_TEXTURE_MAG_FILTER, nearest ? GL_NEAREST : GL_LINEAR);
    setParameter(name, GL_TEXTURE_MIN_FILTER, nearest ? GL_NEAREST : (mipped ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR));
    const GLenum wrap = info.repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    setParameter(name, GL_TEXTURE_WRAP_S, wrap);
    setParameter(name, GL_TEXTURE_WRAP_T, wrap);
    setParameter(name, GL_TEXTURE_WRAP_R, wrap);
    if (info.comparison) {
        // Depth is reversed: a point is lit if it is at least as close to the light as the stored depth.
        setParameter(name, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        setParameter(name, GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
    }
    glObjectLabel(GL_TEXTURE, name, -1, info.name.c_str());
}

Texture::Texture(const render::Texture& picture)
    : name_(create(picture.layers > 1 ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D)), size_(picture.width, picture.height),
      layers_(picture.layers), levels_(picture.mipmaps ? mipLevels(picture.width, picture.height) : 1),
      texelBytes_((picture.channels == 1 ? 1 : 4) * (picture.floats.empty() ? 1 : 2))
{
    const GLuint name = name_.name();
    const PixelFormat format = pixelFormat(picture);
    const int levels = levels_;
    if (picture.layers > 1)
        glTextureStorage3D(name, levels, format.internal, picture.width, picture.height, picture.layers);
    else
        glTextureStorage2D(name, levels, format.internal, picture.width, picture.height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    upload(name, 0, format, picture);
    render::Texture smaller;
    for (int level = 1; level < levels; ++level) {
        smaller = halved(level == 1 ? picture : smaller);
        upload(name, level, format, smaller);
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    setParameter(name, GL_TEXTURE_MAG_FILTER, picture.magnifyNearest ? GL_NEAREST : GL_LINEAR);
    setParameter(name, GL_TEXTURE_MIN_FILTER, minifyingFilter(picture, levels));
    const GLenum wrap = picture.repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    setParameter(name, GL_TEXTURE_WRAP_S, wrap);
    setParameter(name, GL_TEXTURE_WRAP_T, wrap);
    if (picture.channels == 1) {
        setParameter(name, GL_TEXTURE_SWIZZLE_G, GL_RED);
        setParameter(name, GL_TEXTURE_SWIZZLE_B, GL_RED);
    }
    glObjectLabel(GL_TEXTURE, name, -1, picture.name.substr(0, 200).c_str());
}

std::int64_t Texture::bytes() const
{
    std::int64_t texels = 0;
    for (int level = 0; level < levels_; ++level) {
        const int layers = type_ == TextureType::volume ? std::max(layers_ >> level, 1) : layers_;
        texels += static_cast<std::int64_t>(size(level).x) * size(level).y * layers;
    }
    return texels * texelBytes_;
}

void Texture::clear() const
{
    glClearTexImage(name_.name(), 0, format_ == Format::depth32f ? GL_DEPTH_COMPONENT : GL_RGBA, GL_FLOAT, nullptr);
}

glm::ivec2 Texture::size(int level) const
{
    return glm::max(glm::ivec2(size_.x >> level, size_.y >> level), glm::ivec2(1));
}

}  // namespace vitrine::render::gl
