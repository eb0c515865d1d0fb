#include "render/gl/mipmaps.h"

namespace vitrine::render::gl {

void makeMipmaps(const Texture& image, ProgramCache& programs)
{
    const bool isCube = image.type() == TextureType::cube;
    const glm::ivec2 smallest = image.size() >> (image.levels() - 1);
    const bool halves = (isCube || image.type() == TextureType::flat) && image.format() == Format::rgba16f &&
                        (smallest << (image.levels() - 1)) == image.size();
    if (!halves) return glGenerateTextureMipmap(image.name());
    ShaderKey shader{.compute = "lib/mipmap.comp"};
    if (isCube) shader.defines = {"CUBE"};
    glUseProgram(programs.use(shader, ProgramCache::Building::isWaitedFor).program);
    for (int level = 1; level < image.levels(); ++level) {
        glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
        glBindImageTexture(0, image.name(), level - 1, GL_TRUE, 0, GL_READ_ONLY, GL_RGBA16F);
        glBindImageTexture(1, image.name(), level, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA16F);
        const glm::uvec2 groups((image.size(level) + 7) / 8);
        glDispatchCompute(groups.x, groups.y, isCube ? 6 : 1);
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
}

}  // namespace vitrine::render::gl
