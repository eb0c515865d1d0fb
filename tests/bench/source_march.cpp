#include "tests/bench/source_march.h"

#include "exhibits/sdf_scenes/list_glsl.h"
#include "exhibits/sdf_scenes/near_scene.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace vitrine::bench {
namespace {

/// Hart's march with a fixed step limit and a fixed tolerance, in place of the library's.
const char* const plainMarch = R"(
#undef sphereTrace
March sphereTrace(vec3 origin, vec3 direction, MarchSettings s)
{
    March march = March(false, s.tMin, 0.0, 1.0, 0, 0, false);
    for (int i = 0; i < 255; ++i) {
        float d = fieldDistance(origin + direction * march.t);
        march.steps = march.evaluations = i + 1;
        if (d < 0.001) {
            march.hit = true;
            return march;
        }
        march.t += d;
        if (march.t > 100.0) return march;
    }
    return march;
}
)";

}  // namespace

void useSourceMarch(render::Pass& pass, const scenes::SceneProgram& program, const scenes::SceneWords& words)
{
    scenes::ListVocabulary all = scenes::ListVocabulary::of(program);
    for (const char* kind :
         {"sphere", "plane", "box", "roundBox", "boxFrame", "cylinder", "capsule", "torus", "triangle", "link", "cone",
          "hexagonalPrism", "triangularPrism", "ellipsoid", "octahedron", "pyramid"}) {
        const scenes::NodeKind* found = scenes::findKind(kind);
        if (std::find(all.shapes.begin(), all.shapes.end(), found) == all.shapes.end()) all.shapes.push_back(found);
    }
    const auto near = scenes::nearScene(program, words, all, 0);
    std::ifstream file("shaders/lib/sphere_tracing.glsl");
    const std::string library{std::istreambuf_iterator<char>(file), {}};
    const scenes::FurtherMember stage{"sdf_scenes/stage_block.glsl", "SceneStage stage"};
    pass.shader.sources = std::make_shared<const render::ShaderSources>(std::map<std::string, std::string>{
        {scenes::generatedField, scenes::listGlsl(all, 0, stage)},
        {"lib/sphere_tracing.glsl", "#define sphereTrace libraryTrace\n" + library + plainMarch}});
    pass.buffers = {
        {STORAGE_EXHIBIT_A, near->records}, {STORAGE_EXHIBIT_B, near->lists}, {STORAGE_EXHIBIT_C, near->grid}};
    std::vector<std::string>& defines = pass.shader.defines;
    const auto has = [&](std::string_view word) {
        return std::any_of(defines.begin(), defines.end(), [&](const std::string& d) { return d.starts_with(word); });
    };
    if (has("SOURCE_LOOK"))
        for (const char* word : {"LIGHTS", "SHADOWS 6", "OCCLUSION 0", "MIRRORS"})
            if (!has(std::string_view(word).substr(0, 6))) defines.emplace_back(word);
    // The stage alone, which follows the scene's numbers.
    if (!scenes::isInBuffer(program)) {
        render::Bytes& block = pass.blocks[BLOCK_EXHIBIT];
        block.erase(block.begin(), block.begin() + static_cast<std::ptrdiff_t>(scenes::sceneBlock(words).size()));
    }
}

}  // namespace vitrine::bench
