// All uniform blocks: positions of fields in the driver compared with those in C++.

#include "render/glsl/shader_source.h"
#include "render/glsl/std140.h"
#include "tests/support/block_of.h"
#include "tests/support/gallery.h"

#include <epoxy/gl.h>

#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace vitrine {
namespace {

using UniformBlocks = test::GlTest;

#include "shaders/crepuscular_rays/rays_block.glsl"
#include "shaders/fur/body_block.glsl"
#include "shaders/hall/air_light_block.glsl"
#include "shaders/hall/antialiasing_block.glsl"
#include "shaders/hall/bounce_block.glsl"
#include "shaders/hall/probe_block.glsl"
#include "shaders/ice_cream/backdrop_block.glsl"
#include "shaders/ice_cream/ice_cream_block.glsl"
#include "shaders/kit/floor_block.glsl"
#include "shaders/kit/portal/portal_block.glsl"
#include "shaders/kit/sdf/object_block.glsl"
#include "shaders/kit/surface_object_block.glsl"
#include "shaders/lenticular/card_block.glsl"
#include "shaders/lib/clock_load_block.glsl"
#include "shaders/lib/frame_block.glsl"
#include "shaders/lib/glare_block.glsl"
#include "shaders/lib/light_block.glsl"
#include "shaders/lib/local_lights_block.glsl"
#include "shaders/lib/temporal_block.glsl"
#include "shaders/noise/noise_block.glsl"
#include "shaders/paper_lanterns/lake_block.glsl"
#include "shaders/pixel_art/object_block.glsl"
#include "shaders/pixel_art/pixel_block.glsl"
#include "shaders/sdf_morph/torus_mug_shape_block.glsl"
#include "shaders/sdf_scenes/stage_block.glsl"

/// Byte offsets of all numbers, vectors and matrices by their GLSL names.
using Offsets = std::map<std::string, std::size_t>;

template <typename T> void addOffsets(const T& value, const std::string& name, render::Std140Writer&, Offsets&);

template <typename T, std::size_t N>
void addOffsets(const std::array<T, N>& values, const std::string& name, render::Std140Writer& writer, Offsets& offsets)
{
    writer.align(16);
    for (std::size_t i = 0; i < N; ++i) {
        addOffsets(values[i], name + '[' + std::to_string(i) + ']', writer, offsets);
        writer.align(16);
    }
}

template <typename T>
void addOffsets(const T& value, const std::string& name, render::Std140Writer& writer, Offsets& offsets)
{
    if constexpr (render::BlockStruct<T>) {
        writer.align(16);
        T::visitFields(value, [&](const char* field, const auto& member) {
            addOffsets(member, name + '.' + field, writer, offsets);
        });
        writer.align(16);
    } else {
        offsets[name] = writer.put(value);
    }
}

template <typename Block> Offsets offsetsInCpp()
{
    Offsets offsets;
    render::Std140Writer writer;
    addOffsets(Block(), "block", writer, offsets);
    return offsets;
}

/// Builds a program that declares a uniform block with the struct of this name and reads nothing of it. Members of a
/// std140 block are active all the same.
GLuint programWith(const std::string& declaration, const std::string& structName)
{
    const std::string text = declaration +
                             "\nlayout(local_size_x = 1) in;\n"
                             "layout(std140, binding = 0) uniform Test { " +
                             structName + " block; };\nvoid main() {}\n";
    const char* source = text.c_str();
    const GLuint program = glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &source);
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    std::string log(4096, '\0');
    glGetProgramInfoLog(program, 4096, nullptr, log.data());
    EXPECT_NE(linked, 0) << log.c_str() << text;
    return program;
}

/// Returns the driver's offsets, with all elements of arrays of numbers listed.
Offsets offsetsOfDriver(GLuint program, std::size_t& size)
{
    Offsets offsets;
    GLint blockSize = 0, count = 0;
    glGetActiveUniformBlockiv(program, 0, GL_UNIFORM_BLOCK_DATA_SIZE, &blockSize);
    size = static_cast<std::size_t>(blockSize);
    glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
        char text[256];
        GLint elements = 0, offset = 0, stride = 0;
        GLenum type = 0;
        glGetActiveUniform(program, i, sizeof text, nullptr, &elements, &type, text);
        glGetActiveUniformsiv(program, 1, &i, GL_UNIFORM_OFFSET, &offset);
        glGetActiveUniformsiv(program, 1, &i, GL_UNIFORM_ARRAY_STRIDE, &stride);
        const std::string name = text;
        const bool isArray = name.size() > 3 && name.substr(name.size() - 3) == "[0]";
        for (GLint k = 0; k < elements; ++k)
            offsets[isArray ? name.substr(0, name.size() - 2) + std::to_string(k) + ']' : name] =
                static_cast<std::size_t>(offset + k * stride);
    }
    return offsets;
}

struct Described {
    Offsets offsets;
    std::size_t size = 0;
};

template <typename Block> Described described()
{
    return {offsetsInCpp<Block>(), render::std140Bytes(Block()).size()};
}

const std::map<std::string, Described>& blocksOfCpp()
{
    static const std::map<std::string, Described> blocks{
        {"BeamBlock", described<BeamBlock>()},
        {"Candy", described<Candy>()},
        {"CardObject", described<CardObject>()},
        {"CardPrintBlock", described<CardPrintBlock>()},
        {"ClockLoadBlock", described<ClockLoadBlock>()},
        {"ContactBlock", described<ContactBlock>()},
        {"CreamLayer", described<CreamLayer>()},
        {"FloorMirrorBlock", described<FloorMirrorBlock>()},
        {"FrameBlock", described<FrameBlock>()},
        {"FurBodies", described<FurBodies>()},
        {"FurBody", described<FurBody>()},
        {"GlareBlock", described<GlareBlock>()},
        {"IceCreamBackdrop", described<IceCreamBackdrop>()},
        {"IceCreamShape", described<IceCreamShape>()},
        {"LakeBlock", described<LakeBlock>()},
        {"LightBlock", described<LightBlock>()},
        {"LocalLightEntry", described<LocalLightEntry>()},
        {"LocalLightsBlock", described<LocalLightsBlock>()},
        {"AirLightBlock", described<AirLightBlock>()},
        {"AirOnWalls", described<AirOnWalls>()},
        {"AntialiasingBlock", described<AntialiasingBlock>()},
        {"BounceBlock", described<BounceBlock>()},
        {"ProbeLevel", described<ProbeLevel>()},
        {"ProbeWork", described<ProbeWork>()},
        {"RaysBlock", described<RaysBlock>()},
        {"NoiseBlock", described<NoiseBlock>()},
        {"PixelBlock", described<PixelBlock>()},
        {"PixelObjectBlock", described<PixelObjectBlock>()},
        {"PortalBlock", described<PortalBlock>()},
        {"SceneStage", described<SceneStage>()},
        {"SdfObject", described<SdfObject>()},
        {"StandingShape", described<StandingShape>()},
        {"SurfaceObject", described<SurfaceObject>()},
        {"TemporalBlock", described<TemporalBlock>()},
        {"TorusMug", described<TorusMug>()},
        {"TorusMugShape", described<TorusMugShape>()},
    };
    return blocks;
}

std::vector<std::string> structsIn(const std::string& text)
{
    static const std::regex declaration(R"(\nBLOCK_STRUCT\((\w+), \w+\))");
    std::vector<std::string> names;
    for (auto i = std::sregex_iterator(text.begin(), text.end(), declaration); i != std::sregex_iterator(); ++i)
        names.push_back((*i)[1]);
    return names;
}

TEST_F(UniformBlocks, HaveTheirFieldsWhereTheDriverLooksForThem)
{
    const render::ShaderSource shaders;
    std::set<std::string> seen;
    for (const std::string& file : shaders.list()) {
        if (file.find("_block.glsl") == std::string::npos) continue;
        const std::vector<std::string> names = structsIn(*shaders.read(file));
        EXPECT_FALSE(names.empty()) << file;
        const std::string declarations =
            shaders.load("lib/bindings.glsl", {}).text + shaders.load(file, {}).text.substr(sizeof "#version 450 core");
        for (const std::string& name : names) {
            seen.insert(name);
            const auto cpp = blocksOfCpp().find(name);
            if (cpp == blocksOfCpp().end()) {
                ADD_FAILURE() << file << " describes " << name << ", which is not in the list above";
                continue;
            }
            const GLuint program = programWith(declarations, name);
            std::size_t size = 0;
            const Offsets driver = offsetsOfDriver(program, size);
            EXPECT_EQ(driver, cpp->second.offsets) << name;
            EXPECT_EQ(size, cpp->second.size) << name;
            glDeleteProgram(program);
        }
    }
    EXPECT_EQ(seen.size(), blocksOfCpp().size());
}

// Everything that std140 pads and rounds: a number after a vector and a vector after one, arrays of numbers, structs in
// structs.
#define AWKWARD_PART_FIELDS(FIELD, ARRAY) FIELD(vec2, a) FIELD(float, b)
#define AWKWARD_FIELDS(FIELD, ARRAY)                                                                                   \
    FIELD(float, a)                                                                                                    \
    FIELD(vec3, b)                                                                                                     \
    FIELD(bool, c)                                                                                                     \
    FIELD(vec2, d)                                                                                                     \
    FIELD(int, e)                                                                                                      \
    FIELD(vec2, f)                                                                                                     \
    FIELD(vec3, g)                                                                                                     \
    FIELD(ivec2, h)                                                                                                    \
    FIELD(AwkwardPart, i)                                                                                              \
    FIELD(float, j)                                                                                                    \
    ARRAY(float, k, 3)                                                                                                 \
    FIELD(uint, l)                                                                                                     \
    ARRAY(AwkwardPart, m, 2)                                                                                           \
    FIELD(bool, n)                                                                                                     \
    ARRAY(vec3, o, 2)                                                                                                  \
    FIELD(mat4, p)                                                                                                     \
    FIELD(float, q)
BLOCK_STRUCT(AwkwardPart, AWKWARD_PART_FIELDS)
BLOCK_STRUCT(Awkward140, AWKWARD_FIELDS)

const std::string awkwardInGlsl = "#version 450 core\nstruct AwkwardPart { vec2 a; float b; };\n"
                                  "struct Awkward140 { float a; vec3 b; bool c; vec2 d; int e; vec2 f; vec3 g; ivec2 h;"
                                  " AwkwardPart i; float j; float k[3]; uint l; AwkwardPart m[2]; bool n; vec3 o[2];"
                                  " mat4 p; float q; };\n";

TEST_F(UniformBlocks, OfAwkwardOrderArePaddedAsTheDriverPadsThem)
{
    const GLuint program = programWith(awkwardInGlsl, "Awkward140");
    std::size_t size = 0;
    EXPECT_EQ(offsetsOfDriver(program, size), offsetsInCpp<Awkward140>());
    EXPECT_EQ(size, render::std140Bytes(Awkward140()).size());
    glDeleteProgram(program);
}

// The same fields, two of them swapped.
#define SWAPPED_FIELDS(FIELD, ARRAY) FIELD(vec3, g) FIELD(float, a)
BLOCK_STRUCT(Swapped140, SWAPPED_FIELDS)

TEST_F(UniformBlocks, WithFieldsInAnotherOrderAreSeen)
{
    const GLuint program = programWith("#version 450 core\nstruct S { float a; vec3 g; };", "S");
    std::size_t size = 0;
    EXPECT_NE(offsetsOfDriver(program, size), offsetsInCpp<Swapped140>());
    glDeleteProgram(program);
}

TEST_F(UniformBlocks, HoldTheValuesOfTheirFields)
{
    Awkward140 block;
    block.a = 1.5F;
    block.c = true;
    block.e = -7;
    block.l = 4000000000U;
    block.k[2] = 2.5F;
    block.m[1].b = 3.5F;
    block.p[2] = {1, 2, 3, 4};
    const std::vector<std::byte> bytes = render::std140Bytes(block);
    const Offsets at = offsetsInCpp<Awkward140>();
    const auto read = [&]<typename T>(T value, std::size_t offset) {
        std::memcpy(&value, bytes.data() + offset, sizeof value);
        return value;
    };
    EXPECT_EQ(read(0.0F, at.at("block.a")), 1.5F);
    EXPECT_EQ(read(std::int32_t{0}, at.at("block.c")), 1);
    EXPECT_EQ(read(std::int32_t{0}, at.at("block.n")), 0);
    EXPECT_EQ(read(std::int32_t{0}, at.at("block.e")), -7);
    EXPECT_EQ(read(std::uint32_t{0}, at.at("block.l")), 4000000000U);
    EXPECT_EQ(read(0.0F, at.at("block.k[2]")), 2.5F);
    EXPECT_EQ(read(0.0F, at.at("block.m[1].b")), 3.5F);
    EXPECT_EQ(read(glm::vec4(0), at.at("block.p") + 32), glm::vec4(1, 2, 3, 4));
    EXPECT_EQ(render::std140Bytes(test::blockOf<Awkward140>(bytes)), bytes);
    EXPECT_EQ(render::std140Offset<Awkward140>("n"), at.at("block.n"));
}

}  // namespace
}  // namespace vitrine
