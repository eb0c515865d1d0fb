// Images, buffers and framebuffers of plans, as the driver has them.

#include "render/gl/object.h"
#include "tests/render/gl/renderer_bench.h"

#include <algorithm>
#include <cstring>
#include <memory>

namespace vitrine {
namespace {

using namespace render;
using Attach = render::Attachment;

using Framebuffers = test::RendererTest;
using PictureTexture = test::RendererTest;
using OwnPixels = test::RendererTest;
using CubeMipmaps = test::RendererTest;
using Volume = test::RendererTest;
using HistoryImage = test::RendererTest;
using PartsOfWork = test::RendererTest;
using StorageBuffers = test::RendererTest;

constexpr const char* frameInclude = "#include \"lib/frame.glsl\"\n";
constexpr const char* temporalInclude = "#include \"lib/temporal.glsl\"\n";
constexpr const char* sourceSampler =
    "#include \"lib/bindings.glsl\"\nlayout(binding = UNIT_SOURCE) uniform sampler2D source;\n";
constexpr int unitSource = 12;  // UNIT_SOURCE

// ---- pictures

TEST_F(PictureTexture, OfOneChannelIsGray)
{
    for (const bool floats : {false, true}) {
        auto picture = std::make_shared<render::Texture>();
        picture->width = picture->height = 1;
        picture->channels = 1;
        if (floats)
            picture->floats = {0.2F};
        else
            picture->bytes = {51};
        FramePlan plan = planOf({1, 1});
        Pass look = fill("look", "frame", "color = texture(source, vec2(0.5));", sourceSampler);
        look.inputs = {{unitSource, std::shared_ptr<const render::Texture>(picture)}};
        plan.add(std::move(look));
        (void)draw(plan);
        const Image frame = renderer().read("frame");
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(frame.at(0, 0, c), 0.2, 1e-3) << c;
        EXPECT_EQ(frame.at(0, 0, 3), 1);
    }
}

// ---- mipmaps

TEST_F(CubeMipmaps, AreTheMeansOfFourTexelsOfTheirFace)
{
    // The driver halves sides that are no powers of two. This is the control: means of a ramp also fit.
    for (const int side : {8, 12}) {
        FramePlan plan = planOf({6, 4});
        plan.image({.name = "cube", .type = TextureType::cube, .size = {side, side}, .layers = 6, .levels = 4});
        for (int face = 0; face < 6; ++face) {
            Pass pass = fill("face " + std::to_string(face), "cube",
                             "color = vec4(gl_FragCoord.x, gl_FragCoord.y * gl_FragCoord.x, float(" +
                                 std::to_string(face) + "), 1.0);");
            pass.colors = {Attach::slice("cube", face)};
            if (face == 5) pass.mipmaps = {"cube"};
            plan.add(std::move(pass));
        }
        Pass look =
            fill("look", "frame", "color = textureLod(cube, directions[int(gl_FragCoord.x)], floor(gl_FragCoord.y));",
                 "#include \"lib/bindings.glsl\"\nlayout(binding = UNIT_SOURCE) uniform samplerCube cube;\n"
                 "const vec3 directions[6] = vec3[](vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 1, 0), vec3(0, -1, 0), "
                 "vec3(0, 0, 1), vec3(0, 0, -1));\n");
        look.inputs = {{unitSource, std::string("cube")}};
        plan.add(std::move(look));
        (void)draw(plan);
        const Image frame = renderer().read("frame");
        for (int face = 0; face < 6; ++face)
            for (int level = 0; level < 4; ++level) {
                // Center of a face, between texels that are means: a ramp's mean is the value at its center, and so is
                // its product's.
                const int row = frame.height - 1 - level;
                EXPECT_NEAR(frame.at(face, row, 0), side / 2.0, 0.05) << side << ", level " << level;
                EXPECT_NEAR(frame.at(face, row, 2), face, 0.01) << side << ", level " << level;
                EXPECT_GT(frame.at(face, row, 1), side * side / 4.0 - 0.1) << side << ", level " << level;
            }
    }
}

// ---- framebuffers

TEST_F(Framebuffers, AreMadeOnceAndNotInTheNextSameFrame)
{
    const int before = gl::FramebufferName::live();
    const auto frame = [&](glm::ivec2 size) {
        FramePlan plan = planOf(size);
        plan.image({.name = "half", .scale = 0.5});
        plan.image({.name = "depth", .format = Format::depth32f});
        plan.add(fill("half", "half", "color = vec4(1.0);"));
        Pass with = fill("with", "frame", "color = texture(source, vec2(0.5));", sourceSampler);
        with.inputs = {{unitSource, std::string("half")}};
        with.depth = Attach::cleared("depth");
        plan.add(std::move(with));
        Pass without = fill("without", "frame", "color = vec4(0.25);");
        without.colors = {Attach::whole("frame")};
        without.state.blend = Blend::add;
        plan.add(std::move(without));
        const FrameReport report = draw(plan);
        EXPECT_EQ(renderer().read("frame").at(1, 1, 0), 1.25F);
        return report.counters.at("framebuffers made");
    };
    EXPECT_EQ(frame({8, 6}), 3);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(frame({8, 6}), 0);
    EXPECT_EQ(gl::FramebufferName::live() - before, 3);
    // Framebuffers are deleted with their textures: another size leaves the same number.
    EXPECT_EQ(frame({16, 6}), 3);
    EXPECT_EQ(gl::FramebufferName::live() - before, 3);
    FramePlan empty = planOf({16, 6});
    (void)draw(empty);
    EXPECT_EQ(gl::FramebufferName::live(), before);
}

// ---- images with their own pixels

TEST_F(OwnPixels, AreTheSameForEveryTileJitterAndSupersample)
{
    for (const ImageInfo& info :
         {ImageInfo{.name = "own", .format = Format::rgba32f, .divisor = 4},
          ImageInfo{.name = "own", .format = Format::rgba32f, .size = {5, 3}, .ownPixels = true}}) {
        const auto seen = [&](const Raster& raster, int sample) {
            FramePlan plan = planOf(raster.size);
            plan.view = makeView({{0.4, 0.2, 5}, {0, 0, 0}}, raster);
            plan.sample = sample;
            plan.image(info);
            plan.add(fill("own", "own",
                          "color = vec4(frameRay(gl_FragCoord.xy), float(frame.sampleIndex) + frameTile().x);",
                          frameInclude));
            Pass show = fill("show", "frame", "color = texture(source, vec2(0.999, 0.999) * 0.5);", sourceSampler);
            show.inputs = {{unitSource, std::string("own")}};
            plan.add(std::move(show));
            (void)draw(plan);
            return std::pair(renderer().read("own"), renderer().read("frame"));
        };
        const auto [whole, shown] = seen({.size = {18, 11}}, 0);
        const auto [tile, shownAgain] =
            seen({.size = {18, 11}, .offset = {8, 4}, .tile = {8, 7}, .jitter = {0.25, -0.5}}, 3);
        EXPECT_EQ(whole.pixels, tile.pixels);
        EXPECT_EQ(whole.width, 5);
        EXPECT_EQ(whole.height, 3);
        // Sampled without filtering: each value is that of one texel.
        const float value = shown.at(0, 0, 0);
        bool found = false;
        for (int y = 0; y < whole.height; ++y)
            for (int x = 0; x < whole.width; ++x) found = found || whole.at(x, y, 0) == value;
        EXPECT_TRUE(found) << value;
    }
}

// ---- volumes

TEST_F(Volume, IsWrittenByComputeAndInterpolatedBetweenSlices)
{
    FramePlan plan = planOf({4, 4});
    const ResourceId density = plan.image(
        {.name = "density", .format = Format::r16f, .type = TextureType::volume, .size = {4, 4}, .layers = 8});
    Pass bake =
        compute("bake", "imageStore(density, ivec3(gl_GlobalInvocationID), vec4(float(gl_GlobalInvocationID.z)));",
                "layout(r16f, binding = 0) writeonly uniform image3D density;");
    bake.groups = {4, 4, 8};
    bake.storage = {Attach::whole(density)};
    plan.add(std::move(bake));
    Pass show = fill("show", "frame", "color = vec4(texture(density, vec3(0.5, 0.5, (gl_FragCoord.x + 2.0) / 8.0)).r);",
                     "#include \"lib/bindings.glsl\"\nlayout(binding = UNIT_SOURCE) uniform sampler3D density;\n");
    show.inputs = {{unitSource, density}};
    plan.add(std::move(show));
    (void)draw(plan);
    const Image frame = renderer().read("frame");
    for (int x = 0; x < 4; ++x) EXPECT_NEAR(frame.at(x, 0, 0), x + 2.0, 1e-2) << "slice centers are at (i + 0.5) / 8";
    EXPECT_EQ(renderer().stored().front().what, "images");
    EXPECT_EQ(renderer().stored().front().bytes, 4 * 4 * 8 * 2 + 4 * 4 * 16);
}

TEST_F(Volume, IsDrawnSliceBySlice)
{
    FramePlan plan = planOf({2, 2});
    plan.image({.name = "slices",
                .format = Format::rgba32f,
                .type = TextureType::volume,
                .size = {2, 2},
                .layers = 3,
                .nearest = true});
    for (int i = 0; i < 3; ++i) {
        const std::string name = "slice" + std::to_string(i);
        Pass slice = fill(name, "slices", "color = vec4(" + std::to_string(i + 1) + ".0);");
        slice.colors = {Attach::clearedSlice("slices", i)};
        plan.add(std::move(slice));
    }
    Pass show = fill("show", "frame",
                     "color = vec4(texelFetch(slices, ivec3(0, 0, 0), 0).r, texelFetch(slices, ivec3(1, 1, 1), 0).r, "
                     "texelFetch(slices, ivec3(0, 1, 2), 0).r, 1.0);",
                     "#include \"lib/bindings.glsl\"\nlayout(binding = UNIT_SOURCE) uniform sampler3D slices;\n");
    show.inputs = {{unitSource, std::string("slices")}};
    plan.add(std::move(show));
    (void)draw(plan);
    const Image frame = renderer().read("frame");
    EXPECT_EQ(frame.at(0, 0, 0), 1);
    EXPECT_EQ(frame.at(0, 0, 1), 2);
    EXPECT_EQ(frame.at(0, 0, 2), 3);
}

// ---- histories

TEST_F(HistoryImage, CountsFramesUntilTheCameraJumps)
{
    const auto frame = [&](const glm::dvec3& eye, std::uint64_t values) {
        FramePlan plan = planOf({4, 3});
        plan.view = makeView({eye, {0, 0, 0}}, {.size = {4, 3}});
        const ResourceId count = plan.history(
            {.image = {.name = "count", .format = Format::r32f}, .dependencies = {{"a value changed", values}}});
        Pass add =
            fill("add", count,
                 "color = vec4(temporalIsValid() ? texelFetch(source, ivec2(gl_FragCoord.xy), 0).r + 1.0 : 1.0);",
                 std::string(temporalInclude) + sourceSampler);
        add.inputs = {{unitSource, previous(count)}};
        plan.add(std::move(add));
        Pass show = fill("show", "frame", "color = texelFetch(source, ivec2(gl_FragCoord.xy), 0);", sourceSampler);
        show.inputs = {{unitSource, count}};
        plan.add(std::move(show));
        (void)draw(plan);
        return renderer().read("frame").at(2, 1, 0);
    };
    EXPECT_EQ(frame({0, 0, 5}, 1), 1);
    EXPECT_EQ(frame({0, 0, 5}, 1), 2);
    EXPECT_EQ(frame({0.1, 0, 5}, 1), 3);
    EXPECT_EQ(frame({0.1, 4, 5}, 1), 1) << "the camera jumped";
    EXPECT_EQ(frame({0.1, 4, 5}, 1), 2);
    EXPECT_EQ(frame({0.1, 4, 5}, 2), 1) << "a value changed";
}

TEST_F(HistoryImage, SaysWhereAPointOfTheWorldWas)
{
    const glm::dvec3 point(0.5, -0.3, 1);
    const auto frame = [&](const glm::dvec3& eye, glm::dvec2 jitter) {
        FramePlan plan = planOf({8, 6});
        plan.view = makeView({eye, {0, 0, 0}}, {.size = {8, 6}, .jitter = jitter});
        plan.history({.image = {.name = "past", .format = Format::rgba32f}});
        Pass where =
            fill("where", "past",
                 "color = vec4(temporalCoordinate(vec3(0.5, -0.3, 1.0)), texelFetch(source, ivec2(0), 0).x, 1.0);",
                 std::string(temporalInclude) + sourceSampler);
        where.inputs = {{unitSource, previous("past")}};
        plan.add(std::move(where));
        Pass show = fill("show", "frame", "color = texelFetch(source, ivec2(gl_FragCoord.xy), 0);", sourceSampler);
        show.inputs = {{unitSource, std::string("past")}};
        plan.add(std::move(show));
        (void)draw(plan);
        const Image image = renderer().read("frame");
        return glm::dvec2(image.at(0, 0, 0), image.at(0, 0, 1));
    };
    (void)frame({0, 0, 5}, {0.25, 0.25});
    const glm::dvec2 was = frame({0.3, 0.2, 5}, {-0.25, 0.1});
    const View lastView = makeView({{0, 0, 5}, {0, 0, 0}}, {.size = {8, 6}});
    const glm::dvec4 clip = lastView.clipFromWorld * glm::dvec4(point, 1);
    EXPECT_LT(glm::distance(was, glm::dvec2(clip) / clip.w * 0.5 + 0.5), 1e-6);
}

// ---- work over several frames

class Baking : public test::RendererTest {
protected:
    /// Bakes `value` in four slices of one column each, and shows the result so far; -1 if nothing can be used yet.
    std::vector<float> frame(float value, bool allSlices = false)
    {
        FramePlan plan = planOf({4, 1});
        plan.allSlices = allSlices;
        const ResourceId map = plan.image({.name = "map", .format = Format::r32f, .size = {4, 1}, .nearest = true});
        Pass bake =
            fill("bake", map,
                 "if (int(gl_FragCoord.x) != temporalSlice()) discard;\ncolor = vec4(" + std::to_string(value) + ");",
                 temporalInclude);
        bake.sliceCount = 4;
        bake.contentHash = static_cast<std::uint64_t>(value);
        plan.add(std::move(bake));
        Pass show = fill("show", "frame",
                         "color = temporalIsValid() ? texelFetch(source, ivec2(gl_FragCoord.xy), 0) : vec4(-1.0);",
                         std::string(temporalInclude) + sourceSampler);
        show.inputs = {{unitSource, map}};
        plan.add(std::move(show));
        const FrameReport report = draw(plan);
        unfinished_ = report.unfinished;
        reason_ = report.ran.front().reason;
        std::vector<float> row;
        for (int x = 0; x < 4; ++x) row.push_back(renderer().read("frame").at(x, 0, 0));
        return row;
    }
    bool unfinished_ = false;
    std::string reason_;
};

TEST_F(Baking, ShowsTheLastWholeResultUntilTheNextIsWhole)
{
    using Row = std::vector<float>;
    for (int part = 1; part <= 3; ++part) {
        EXPECT_EQ(frame(1), Row(4, -1.0F)) << part;
        EXPECT_TRUE(unfinished_);
        EXPECT_NE(reason_.find("part " + std::to_string(part) + " of 4"), std::string::npos) << reason_;
    }
    EXPECT_EQ(frame(1), Row(4, 1.0F)) << "the frame of the last part shows it";
    EXPECT_FALSE(unfinished_);
    EXPECT_EQ(frame(1), Row(4, 1.0F));
    for (int part = 1; part <= 2; ++part) EXPECT_EQ(frame(2), Row(4, 1.0F));
    for (int part = 1; part <= 3; ++part) EXPECT_EQ(frame(3), Row(4, 1.0F)) << "another key starts again";
    EXPECT_EQ(frame(3), Row(4, 3.0F));
    EXPECT_EQ(frame(4, true), Row(4, 4.0F)) << "all parts in one frame";
    EXPECT_FALSE(unfinished_);
}

// ---- buffers

/// Four instances of a triangle. Each covers one column of the picture with its own color.
Pass instances(const std::string& name)
{
    Pass pass;
    pass.name = name;
    pass.shader = {"columns.vert", "columns.frag", "", {}};
    pass.shader.sources = std::make_shared<const ShaderSources>(std::map<std::string, std::string>{
        {"columns.vert",
         "#include \"lib/bindings.glsl\"\nlayout(std430, binding = STORAGE_INSTANCES) readonly buffer Instances { vec4 "
         "instances[]; };\nflat out vec4 tint;\n"
         "void main()\n{\n    vec2 corner = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);\n    "
         "vec4 own = instances[gl_InstanceID];\n    tint = vec4(own.yzw, 1.0);\n"
         "    gl_Position = vec4((own.x + corner.x * 0.25) * 2.0 - 1.0, corner.y * 2.0 - 1.0, 0.0, 1.0);\n}\n"},
        {"columns.frag",
         "flat in vec4 tint;\nlayout(location = 0) out vec4 color;\nvoid main()\n{\n    color = tint;\n}\n"}});
    pass.colors = {Attach::cleared("frame")};
    return pass;
}

TEST_F(StorageBuffers, GiveEachInstanceItsBytes)
{
    std::vector<glm::vec4> data;
    for (int i = 0; i < 4; ++i) data.emplace_back(0.25F * static_cast<float>(i), static_cast<float>(i + 1), 0, 0);
    Bytes bytes(data.size() * sizeof(glm::vec4));
    std::memcpy(bytes.data(), data.data(), bytes.size());
    auto shared = std::make_shared<const Bytes>(std::move(bytes));
    {
        FramePlan plan = planOf({4, 1});
        Pass pass = instances("columns");
        pass.draws = {{.instances = 4, .buffers = {{0, shared}}}};
        plan.add(std::move(pass));
        (void)draw(plan);
        for (int x = 0; x < 4; ++x) EXPECT_EQ(renderer().read("frame").at(x, 0, 0), static_cast<float>(x + 1));
    }
    const auto held = [&] {
        for (const gl::Stored& stored : renderer().stored())
            if (stored.what == "constant buffers") return stored.bytes;
        return std::int64_t{-1};
    };
    EXPECT_EQ(held(), 64);
    shared.reset();
    FramePlan empty = planOf({4, 1});
    (void)draw(empty);
    EXPECT_EQ(held(), 0) << "they go with the original";
}

TEST_F(StorageBuffers, AreWrittenByComputeAndReadByWhatIsDrawn)
{
    FramePlan plan = planOf({4, 1});
    const ResourceId places = plan.buffer({.name = "places", .bytes = 4 * 16});
    Pass place = compute(
        "place",
        "uint i = gl_GlobalInvocationID.x;\nplaces[i] = vec4(0.25 * float(i), 10.0 + float(i), places[i].x, 0.0);",
        "#include \"lib/bindings.glsl\"\nlayout(std430, binding = STORAGE_EXHIBIT_A) buffer Places { vec4 places[]; "
        "};");
    place.groups = {4, 1, 1};
    place.buffers = {{1, places, Access::readWrite}};
    plan.add(std::move(place));
    Pass pass = instances("columns");
    pass.draws = {{.instances = 4, .buffers = {{0, places}}}};
    plan.add(std::move(pass));
    (void)draw(plan);
    for (int x = 0; x < 4; ++x) EXPECT_EQ(renderer().read("frame").at(x, 0, 0), static_cast<float>(10 + x));
    const Bytes bytes = renderer().readBuffer("places");
    ASSERT_EQ(bytes.size(), 64U);
    glm::vec4 last;
    std::memcpy(&last, bytes.data() + 48, sizeof last);
    EXPECT_EQ(last, glm::vec4(0.75F, 13, 0, 0)) << "it began with zeros";
}

}  // namespace
}  // namespace vitrine
