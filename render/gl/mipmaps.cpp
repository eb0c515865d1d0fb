#include "render/gl/mipmaps.h"

#include <bit>

namespace vitrine::render::gl {

void makeMipmaps(const Texture& image, ProgramCache& programs)
{
    const bool halves = image.type() == TextureType::cube && image.format() == Format::rgba16f &&
                        std::has_single_bit(static_cast<unsigned>(image.size().x));
    if (!halves) return glGenerateTextureMipmap(image.name());
    glUseProgram(programs.use({.compute = "lib/mipmap_cube.comp"}, ProgramCache::Building::isWaitedFor).program);
    for (int level = 1; level < image.levels(); ++level) {
        glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
        glBindImageTexture(0, image.name(), level - 1, GL_TRUE, 0, GL_READ_ONLY, GL_RGBA16F);
        glBindImageTexture(1, image.name(), level, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA16F);
        const auto groups = static_cast<GLuint>((image.size(level).x + 7) / 8);
        glDispatchCompute(groups, groups, 6);
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
}

}  // namespace vitrine::render::gl
