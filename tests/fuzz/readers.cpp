#include "tests/fuzz/readers.h"

#include "app/serve/json_rpc.h"
#include "exhibits/exhibits.h"
#include "exhibits/framework/preset.h"
#include "exhibits/hall/hall_table.h"
#include "exhibits/sdf_scenes/scene_field.h"
#include "exhibits/sdf_scenes/scene_glsl.h"
#include "exhibits/sdf_scenes/scene_reader.h"
#include "render/failure.h"
#include "render/image/image_io.h"
#include "render/scene/camera.h"
#include "render/scene/gltf.h"
#include "tests/exhibits/framework/every_kind.h"

#include <glm/gtc/type_ptr.hpp>

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace vitrine::fuzz {
namespace {

/// Ends the program, in a way that fuzzers and tests notice.
void require(bool good, const char* promise)
{
    if (good) return;
    std::fprintf(stderr, "broken promise: %s\n", promise);
    std::abort();
}

/// Calls `work`; false when it refused.
template <typename Work> bool accepts(const Work& work)
{
    try {
        work();
        return true;
    } catch (const Failure& failure) {
        require(failure.what()[0] != '\0', "a refusal says why");
        return false;
    }
}

void requireLegal(const ParameterValues& values)
{
    for (std::size_t i = 0; i < values.rows().size(); ++i)
        require(nearestLegal(values.rows()[i], values.row(i)) == values.row(i), "accepted values are legal");
}

void requireFiniteView(const render::Camera& camera)
{
    const render::View view = render::makeView(camera, {});
    const glm::mat4 m(view.clipFromWorld);
    require(std::all_of(glm::value_ptr(m), glm::value_ptr(m) + 16, [](float x) { return std::isfinite(x); }),
            "an accepted camera can be looked through");
}

/// Every exhibit's table, as the program has them.
const NamedValues& initialValues()
{
    static const HallTable hall;
    static const auto exhibits = allExhibits();
    static const NamedValues values = [] {
        NamedValues all{{"hall", hall.initial()}};
        for (const auto& exhibit : exhibits)
            all.emplace_back(std::string(exhibit->name()), exhibit->parameters().initial());
        return all;
    }();
    return values;
}

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

/// A file that is only in memory, by a name that readers can open.
class MemoryFile {
public:
    explicit MemoryFile(std::string_view bytes) : descriptor_(::memfd_create("picture", 0))
    {
        require(descriptor_ >= 0 &&
                    ::write(descriptor_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()),
                "there is memory for a file");
    }
    ~MemoryFile() { ::close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

private:
    int descriptor_;
};

}  // namespace

bool readPreset(std::string_view bytes)
{
    static const test::EveryKind table;
    return accepts([&] {
        const Preset preset = parsePreset(std::string(bytes), "fuzz.json", "everything", table);
        requireLegal(preset.values);
        if (preset.camera) requireFiniteView(*preset.camera);
        const std::string text = presetText(preset);
        require(presetText(parsePreset(text, "again.json", "everything", table)) == text,
                "a preset reads back as it was written");
    });
}

bool readExhibition(std::string_view bytes)
{
    return accepts([&] {
        const Exhibition exhibition = parseExhibition(std::string(bytes), "fuzz.json", initialValues());
        for (const auto& [name, values] : exhibition.values) requireLegal(values);
        requireFiniteView(exhibition.camera);
        const std::string text = exhibitionText(exhibition);
        require(exhibitionText(parseExhibition(text, "again.json", initialValues())) == text,
                "an exhibition reads back as it was written");
    });
}

bool readGltf(std::string_view bytes)
{
    render::GltfLimits limits;
    limits.bufferBytes = 16U << 20U;
    limits.vertices = 100'000;
    limits.indices = 300'000;
    limits.textureBytes = 16U << 20U;
    return accepts([&] { requireDrawable(render::parseGltf(std::string(bytes), "/nowhere/fuzz.glb", limits)); });
}

bool readImage(std::string_view bytes)
{
    render::ImageLimits limits;
    limits.pixels = 1U << 20U;
    limits.decodedBytes = 16U << 20U;
    const bool texture = accepts([&] {
        const auto t = render::textureFromBytes(bytes, "fuzz", true, true, true, limits);
        require(t && t->width > 0 && t->height > 0, "a texture has a size");
        const std::size_t texels = static_cast<std::size_t>(t->width) * static_cast<std::size_t>(t->height);
        require(t->bytes.size() % texels == 0 && t->floats.size() % texels == 0 &&
                    !(t->bytes.empty() && t->floats.empty()),
                "a texture has all its texels");
    });
    const bool image = accepts([&] {
        const MemoryFile file(bytes);
        render::ReadOptions options;
        options.limits = limits;
        const render::Image read = render::readImage(file.path(), options);
        require(read.pixels.size() == static_cast<std::size_t>(read.width) * static_cast<std::size_t>(read.height) *
                                          static_cast<std::size_t>(read.channels),
                "an image has all its pixels");
        require(std::all_of(read.pixels.begin(), read.pixels.end(), [](float x) { return std::isfinite(x); }),
                "an image is finite");
    });
    return texture || image;
}

bool readScene(std::string_view bytes)
{
    scenes::SceneLimits limits;
    limits.nodes = 256;
    const auto noFile = [](const std::string& path) -> std::string {
        throw Failure(Blame::file, "There is no file " + path + ".");
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

bool readRequest(std::string_view bytes)
{
    const auto requireOneLine = [](const std::string& line) {
        require(line.find('\n') == line.size() - 1, "an answer is one line");
        return render::parseJson(line, "answer").root();
    };
    try {
        const app::RpcRequest request = app::parseRequest(std::string(bytes));
        require(request.params.is_object(), "params go by name");
        const render::Json answer = requireOneLine(app::answerLine(request.id, request.params));
        require(answer["id"] == request.id && answer["result"] == request.params, "what was read is written again");
        return true;
    } catch (const app::RpcFailure& failure) {
        require(requireOneLine(app::errorLine(failure.id(), failure))["id"] == failure.id(), "a refusal has the id");
        return false;
    }
}

}  // namespace vitrine::fuzz
