#include "exhibits/your_shader/guest_built_in.h"

#include "render/hash.h"

#include <bit>
#include <utility>

namespace vitrine::guest {

bool isBuiltIn(PassPicture::From from)
{
    using From = PassPicture::From;
    return from == From::environment || from == From::grayNoise || from == From::colorNoise;
}

std::string planBuiltIn(PassPicture::From from, render::FramePlan& plan)
{
    const bool isCube = from == PassPicture::From::environment, isGray = from == PassPicture::From::grayNoise;
    const std::string name = isCube ? "your_shader.environment" : isGray ? "your_shader.gray" : "your_shader.noise";
    if (plan.images().contains(name)) return name;
    const int side = sizeOfBuiltIn(from).x;
    plan.image({.name = name,
                .format = render::Format::rgba8,
                .type = isCube ? render::TextureType::cube : render::TextureType::volume,
                .size = glm::ivec2(side),
                .layers = isCube ? 1 : side,
                .levels = isCube ? static_cast<int>(std::bit_width(static_cast<unsigned>(side))) : 1,
                .persistent = true,
                .repeat = !isCube});
    render::Pass pass;
    pass.name = isCube ? "your_shader/sky" : isGray ? "your_shader/gray noise" : "your_shader/noise";
    pass.reason = "the shader reads it";
    pass.phase = render::PassPhase::simulate;
    pass.work = render::Work::compute;
    pass.shader.compute = isCube ? "your_shader/environment.comp" : "your_shader/noise_volume.comp";
    if (isGray) pass.shader.defines = {"GRAY"};
    pass.storage = {render::Attachment::whole(name)};
    pass.groups = isCube ? glm::ivec3(side / 8, side / 8, 6) : glm::ivec3(side / 4);
    if (isCube) pass.mipmaps = {name};
    pass.contentHash = render::Hash().add(name).value();
    plan.add(std::move(pass));
    return name;
}

glm::ivec2 sizeOfBuiltIn(PassPicture::From from)
{
    return glm::ivec2(from == PassPicture::From::environment ? environmentSide : noiseSide);
}

}  // namespace vitrine::guest
