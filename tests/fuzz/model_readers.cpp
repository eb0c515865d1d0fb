#include "exhibits/sdf_scenes/scene_field.h"
#include "exhibits/sdf_scenes/scene_glsl.h"
#include "exhibits/sdf_scenes/scene_reader.h"
#include "render/scene/gltf.h"
#include "tests/fuzz/promises.h"
#include "tests/fuzz/readers.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace vitrine::fuzz {
namespace {

void requireDrawable(const render::Model& model)
{
    for (const render::MeshInstance& part : model.parts) {
        require(part.mesh && part.material, "a part has a mesh and a material");
        const double* first = glm::value_ptr(part.modelFromPart);
        require(std::all_of(first, first + 16, [](double x) { return std::isfinite(x); }), "transforms are finite");
        for (const std::uint32_t index : part.mesh->indices)
            require(index < part.mesh->vertices.size(), "indices name vertices");
        require(part.mesh->indices.size() % 3 == 0, "triangles are whole");
        for (const render::Vertex& v : part.mesh->vertices) {
            require(std::isfinite(glm::dot(glm::dvec3(v.position), glm::dvec3(1))), "positions are finite");
            require(std::abs(glm::length(v.normal) - 1) < 1e-3F, "normals have unit length");
        }
    }
}

}  // namespace

bool readGltf(std::string_view bytes)
{
    render::GltfLimits limits;
    limits.bufferBytes = 16U << 20U;
    limits.vertices = 100'000;
    limits.indices = 300'000;
    limits.textureBytes = 16U << 20U;
    return accepts([&] { requireDrawable(render::parseGltf(std::string(bytes), "/nowhere/fuzz.glb", limits)); });
}

bool readScene(std::string_view bytes)
{
    scenes::SceneLimits limits;
    limits.nodes = 256;
    const auto noFile = [](const std::string& path) -> std::string {
        throw Failure(ErrorKind::file, "There is no file " + path + ".");
    };
    const scenes::ReadScene read = scenes::readScene(std::string(bytes), "fuzz.json", noFile, limits);
    require(read.scene != nullptr || !read.findings.empty(), "a refusal says why");
    for (const scenes::Finding& finding : read.findings)
        require(finding.line >= 1 && finding.column >= 1 && !finding.sentence.empty(), "a finding has its place");
    if (!read.scene) return false;
    for (const double time : {0.0, -1.5, 1e6}) {
        const std::vector<double> numbers = read.scene->numbersAt(time);
        require(std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); }),
                "numbers of an accepted scene are finite");
    }
    const scenes::SceneField field(read.scene);
    for (const glm::dvec3& p : {glm::dvec3(0), glm::dvec3(0.3, -0.2, 0.1), glm::dvec3(-1e4, 5, 2e3)})
        require(!std::isnan(field.distance(p)), "the distance of an accepted scene is a number");
    require(!scenes::sceneGlsl(scenes::SceneProgram(read.scene)).empty(), "an accepted scene has a shader");
    return true;
}

}  // namespace vitrine::fuzz
