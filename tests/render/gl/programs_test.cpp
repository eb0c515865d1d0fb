// Programs with sources made at run time: found, named in errors, built in the background, limited in number.

#include "render/failure.h"
#include "render/gl/program_binaries.h"
#include "render/gl/program_cache.h"
#include "shaders/lib/bindings.glsl"
#include "tests/render/gl/renderer_bench.h"
#include "tests/support/environment_variable.h"
#include "tests/support/image_bytes.h"
#include "tests/support/temporary_folder.h"

#include <array>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <future>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

namespace vitrine {
namespace {

using namespace render;
using gl::ProgramCache;

/// Context that its thread gets only when the test opens the gate, so that earlier frames certainly come first.
class GatedContext final : public gl::SharedContext {
public:
    explicit GatedContext(std::shared_ptr<gl::SharedContext> inner) : inner_(std::move(inner)) {}
    void open() { gate_.set_value(); }
    void makeCurrent() override
    {
        gate_.get_future().wait();
        inner_->makeCurrent();
    }
    void release() override { inner_->release(); }

private:
    std::shared_ptr<gl::SharedContext> inner_;
    std::promise<void> gate_;
};

class GeneratedShaders : public test::RendererTest {
protected:
    void SetUp() override
    {
        RendererTest::SetUp();
        expectsErrors_ = true;
    }

    /// Returns a program that fills with `value()`, which `scene` defines.
    [[nodiscard]] static ShaderKey key(const std::string& scene, const std::string& family = {})
    {
        ShaderKey made{"lib/fullscreen.vert", "filled.frag", "", {}};
        made.sources = std::make_shared<const ShaderSources>(std::map<std::string, std::string>{
            {"filled.frag", "#include \"generated/scene.glsl\"\nlayout(location = 0) out vec4 color;\nvoid main()\n{\n "
                            "   color = vec4(value());\n}\n"},
            {"generated/scene.glsl", scene}});
        made.programFamily = family;
        return made;
    }
    [[nodiscard]] static std::string returns(int value)
    {
        return "float value()\n{\n    return " + std::to_string(value) + ".0;\n}\n";
    }

    float drawn(const ShaderKey& shader, bool finishedPicture = false)
    {
        FramePlan plan = planOf({2, 2});
        plan.allSlices = finishedPicture;
        Pass pass = fill("filled", "frame", "");
        pass.shader = shader;
        pass.blocks[BLOCK_EXHIBIT] = block_;
        pass.buffers = buffers_;
        plan.add(std::move(pass));
        report_ = draw(plan);
        return renderer().read("frame").at(0, 0, 0);
    }
    /// Draws frames until no further one is needed. Each must show one of the two values.
    void drawUntilFinished(const ShaderKey& shader, float old, float fresh)
    {
        do {
            const float value = drawn(shader);
            EXPECT_TRUE(value == old || value == fresh) << value;
            EXPECT_EQ(report_.unfinished, value == old) << report_.ran.front().reason;
            if (report_.unfinished) {
                EXPECT_NE(report_.ran.front().reason.find("while the new program is being built"), std::string::npos)
                    << report_.ran.front().reason;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        } while (report_.unfinished);
        EXPECT_EQ(drawn(shader), fresh);
    }

    FrameReport report_;
    Bytes block_;  ///< Uniform block BLOCK_EXHIBIT of the drawn pass.
    std::vector<BufferUse> buffers_;
};

TEST_F(GeneratedShaders, AreFoundByIncludeBeforeFilesOfTheirPath)
{
    EXPECT_EQ(drawn(key(returns(3))), 3);
    ShaderKey over =
        key("#include \"lib/bindings.glsl\"\nfloat value()\n{\n    return float(UNIT_SOURCE) + float(OURS);\n}\n");
    EXPECT_THROW((void)drawn(over), Failure) << "the file of the library does not define it";
    std::map<std::string, std::string> texts = over.sources->textByPath();
    texts["lib/bindings.glsl"] = "#define OURS 5\n#define UNIT_SOURCE 2\n";
    over.sources = std::make_shared<const ShaderSources>(std::move(texts));
    EXPECT_EQ(drawn(over), 7);
}

TEST_F(GeneratedShaders, AreNamedInErrorsWithTheirOwnLine)
{
    try {
        (void)drawn(key("// A scene.\n\nfloat value()\n{\n    return undeclaredThing;\n}\n"));
        FAIL() << "nothing was thrown";
    } catch (const Failure& failure) {
        EXPECT_EQ(failure.kind(), ErrorKind::shader);
        EXPECT_EQ(failure.place().file, "generated/scene.glsl");
        EXPECT_EQ(failure.place().line, 5);
        EXPECT_NE(std::string(failure.what()).find("The generated shader generated/scene.glsl, line 5"),
                  std::string::npos)
            << failure.what();
        EXPECT_NE(std::string(failure.what()).find("undeclaredThing"), std::string::npos) << failure.what();
    }
}

TEST_F(GeneratedShaders, ThatDoNotBuildLeaveTheLastGoodProgramOfTheirSlotDrawing)
{
    EXPECT_EQ(drawn(key(returns(3), "scene")), 3);
    const ShaderKey broken = key("float value()\n{\n    return oops;\n}\n", "scene");
    for (int frame = 0; frame < 100 && (frame == 0 || report_.unfinished); ++frame) EXPECT_EQ(drawn(broken), 3);
    EXPECT_EQ(drawn(broken), 3);
    EXPECT_NE(report_.ran.front().reason.find("drawn with the last good program because the new program does not "
                                              "build: The generated shader generated/scene.glsl, line 3"),
              std::string::npos)
        << report_.ran.front().reason;
    ASSERT_EQ(renderer().problems().size(), 1U);
    EXPECT_EQ(renderer().problems()[0].file, "generated/scene.glsl");
    EXPECT_EQ(renderer().problems()[0].line, 3);
    EXPECT_EQ(drawn(key(returns(4), "scene")), 4);
    EXPECT_TRUE(renderer().problems().empty()) << "it is mended";
    EXPECT_THROW((void)drawn(key("broken", "other")), Failure) << "a family without a good program";
}

TEST_F(GeneratedShaders, AreBuiltOnAThreadWhileTheLastGoodProgramDraws)
{
    const auto gate = std::make_shared<GatedContext>(context().shared());
    renderer().buildInBackground(gate);
    EXPECT_EQ(drawn(key(returns(1), "scene")), 1) << "the first one is waited for";
    EXPECT_FALSE(report_.unfinished);
    const ShaderKey second = key(returns(2), "scene");
    for (int frame = 0; frame < 3; ++frame) {
        EXPECT_EQ(drawn(second), 1) << "no frame waits";
        EXPECT_TRUE(report_.unfinished);
        EXPECT_NE(
            report_.ran.front().reason.find("drawn with the last good program while the new program is being built"),
            std::string::npos)
            << report_.ran.front().reason;
    }
    gate->open();
    drawUntilFinished(second, 1, 2);
    EXPECT_EQ(drawn(key(returns(1), "scene")), 1) << "which is still there";
    EXPECT_FALSE(report_.unfinished);
}

TEST_F(GeneratedShaders, KeepTheInputsOfTheLastGoodProgramWhileItDraws)
{
    const auto gate = std::make_shared<GatedContext>(context().shared());
    renderer().buildInBackground(gate);
    // Two scenes with different numbers: the second one's block is shorter and has another meaning.
    const auto scene = [](int size, int at) {
        return key(
            "#include \"lib/bindings.glsl\"\nlayout(std140, binding = BLOCK_EXHIBIT) uniform Numbers {\n    vec4 "
            "numbers[" +
                std::to_string(size) + "];\n};\nfloat value()\n{\n    return numbers[" + std::to_string(at) +
                "].x;\n}\n",
            "scene");
    };
    const auto numbers = [](const std::vector<float>& values) {
        Bytes bytes(values.size() * 16);
        for (std::size_t i = 0; i < values.size(); ++i) std::memcpy(&bytes[16 * i], &values[i], sizeof(float));
        return bytes;
    };
    block_ = numbers({7, 8, 9});
    EXPECT_EQ(drawn(scene(3, 2)), 9);
    block_ = numbers({5});
    EXPECT_EQ(drawn(scene(1, 0)), 9) << "the last good program has its own numbers";
    EXPECT_TRUE(report_.unfinished);
    const auto sibling = renderer().sibling();
    FramePlan plan = planOf({2, 2});
    Pass pass = fill("filled", "frame", "");
    pass.shader = scene(1, 0);
    pass.blocks[BLOCK_EXHIBIT] = block_;
    plan.add(std::move(pass));
    plan.prune({"frame"}, sibling->persistentState());
    (void)sibling->draw(plan);
    EXPECT_EQ(sibling->read("frame").at(0, 0, 0), 5) << "who has no numbers for it waits";
    gate->open();
    EXPECT_EQ(drawn(scene(1, 0)), 5);
    block_ = numbers({6});
    EXPECT_EQ(drawn(scene(1, 0)), 6) << "of the same scene, numbers count at once";
}

TEST_F(GeneratedShaders, KeepTheBuffersOfTheLastGoodProgramWhileItDraws)
{
    const auto gate = std::make_shared<GatedContext>(context().shared());
    renderer().buildInBackground(gate);
    const auto scene = [](int at) {
        return key(
            "#include \"lib/bindings.glsl\"\nlayout(std430, binding = STORAGE_EXHIBIT_A) readonly buffer Numbers "
            "{\n    float numbers[];\n};\nfloat value()\n{\n    return numbers[" +
                std::to_string(at) + "];\n}\n",
            "scene");
    };
    const auto numbers = [](const std::vector<float>& values) {
        Bytes bytes(values.size() * sizeof(float));
        std::memcpy(bytes.data(), values.data(), bytes.size());
        return std::vector<BufferUse>{{STORAGE_EXHIBIT_A, std::make_shared<const Bytes>(std::move(bytes))}};
    };
    buffers_ = numbers({7, 8, 9});
    EXPECT_EQ(drawn(scene(2)), 9);
    buffers_ = numbers({5, 4, 3});
    EXPECT_EQ(drawn(scene(0)), 9) << "the last good program has its own numbers";
    gate->open();
    drawUntilFinished(scene(0), 9, 5);
    buffers_ = numbers({6});
    EXPECT_EQ(drawn(scene(0)), 6) << "of the same scene, numbers count at once";
}

TEST_F(GeneratedShaders, ReadConstantBytesAsTexels)
{
    const auto bytesOf = [](const auto& values) {
        Bytes bytes(sizeof values);
        std::memcpy(bytes.data(), values.data(), bytes.size());
        return std::make_shared<const Bytes>(std::move(bytes));
    };
    // As a float, the first word is a signaling NaN.
    const std::array<std::uint32_t, 4> words{0x7F800001U, 2, 3, 4};
    const std::array<float, 8> numbers{1, 2, 3, 4, 5, 6, 7, 0.5F};
    buffers_ = {{.binding = UNIT_BUFFER_A, .source = bytesOf(numbers), .texels = Texels::vec4},
                {.binding = UNIT_BUFFER_B, .source = bytesOf(words), .texels = Texels::uvec4}};
    const ShaderKey shader =
        key("#include \"lib/bindings.glsl\"\nlayout(binding = UNIT_BUFFER_A) uniform samplerBuffer "
            "numbers;\nlayout(binding = UNIT_BUFFER_B) uniform usamplerBuffer words;\nfloat value()\n"
            "{\n    uvec4 w = texelFetch(words, 0);\n    return texelFetch(numbers, 1).w + (w.x == "
            "0x7F800001u ? float(w.w) : 0.0);\n}\n");
    EXPECT_EQ(drawn(shader), 4.5);
    buffers_[0].source = bytesOf(std::array<float, 8>{0, 0, 0, 0, 0, 0, 0, 3});
    EXPECT_EQ(drawn(shader), 7) << "other bytes";
}

TEST_F(GeneratedShaders, AreWaitedForByPicturesThatAreNotDrawnAgain)
{
    const auto gate = std::make_shared<GatedContext>(context().shared());
    renderer().buildInBackground(gate);
    EXPECT_EQ(drawn(key(returns(1), "scene")), 1);
    EXPECT_EQ(drawn(key(returns(2), "scene")), 1) << "control: another frame does not wait";
    EXPECT_EQ(drawn(key(returns(2), "scene"), true), 2) << "what is being built";
    EXPECT_FALSE(report_.unfinished);
    EXPECT_EQ(drawn(key(returns(3), "scene"), true), 3) << "what nobody began to build";
    gate->open();
}

TEST_F(GeneratedShaders, AreDrawnByWhatTheyNameMeanwhile)
{
    const auto gate = std::make_shared<GatedContext>(context().shared());
    renderer().buildInBackground(gate);
    ShaderKey special = key(returns(2), "scene");
    special.meanwhile = std::make_shared<const ShaderKey>(key(returns(9)));
    EXPECT_EQ(drawn(special), 9);
    EXPECT_NE(report_.ran.front().reason.find("drawn with filled.frag while"), std::string::npos)
        << report_.ran.front().reason;
    gate->open();
    drawUntilFinished(special, 9, 2);
}

TEST_F(GeneratedShaders, OfALookThatRestsAreDrawnByABetterProgramOnceItIsThere)
{
    const auto gate = std::make_shared<GatedContext>(context().shared());
    renderer().buildInBackground(gate);
    const auto resting = [&](int value) {
        ShaderKey made = key(returns(1), "scene");
        ShaderKey specialized = key(returns(value), "scene");  // The different value shows which program drew.
        specialized.about = "with its numbers folded";
        made.specialized = std::make_shared<const ShaderKey>(specialized);
        return made;
    };
    const auto isBetter = [&] { return report_.ran.front().reason.find("numbers folded") != std::string::npos; };
    EXPECT_EQ(drawn(resting(2)), 1) << "the program itself comes first";
    EXPECT_EQ(drawn(resting(2)), 1);
    EXPECT_FALSE(report_.unfinished) << "no frame is drawn for the sake of it";
    EXPECT_FALSE(isBetter());
    EXPECT_EQ(drawn(resting(3)), 1) << "the one for other numbers is given up";
    EXPECT_EQ(report_.counters.at("programs"), 2);
    gate->open();
    for (int frame = 0; frame < 2000 && drawn(resting(3)) != 3; ++frame)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(drawn(resting(3)), 3);
    EXPECT_TRUE(isBetter()) << report_.ran.front().reason;
    EXPECT_EQ(drawn(resting(3), true), 1) << "a finished picture does without";
    const auto programs = report_.counters.at("programs");
    EXPECT_EQ(drawn(key(returns(1), "scene")), 1) << "a drag: back at once";
    EXPECT_FALSE(report_.unfinished);
    EXPECT_FALSE(isBetter());
    EXPECT_EQ(report_.counters.at("programs"), programs) << "and nothing is compiled";
    // A specialized program that does not build is ignored.
    ShaderKey broken = resting(2);
    broken.specialized = std::make_shared<const ShaderKey>(key("float value()\n{\n    return oops;\n}\n", "scene"));
    for (int frame = 0; frame < 2000 && renderer().problems().empty(); ++frame) {
        EXPECT_EQ(drawn(broken), 1);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_EQ(drawn(broken), 1);
    EXPECT_EQ(renderer().problems().size(), 1U);
}

TEST_F(GeneratedShaders, ABetterProgramIsBuiltAheadWithoutAFrame)
{
    const auto gate = std::make_shared<GatedContext>(context().shared());
    gate->open();
    renderer().buildInBackground(gate);
    ShaderKey resting = key(returns(1), "scene");
    EXPECT_EQ(drawn(resting), 1);
    resting.specialized = std::make_shared<const ShaderKey>(key(returns(2), "scene"));
    FramePlan plan = planOf({2, 2});
    Pass pass = fill("filled", "frame", "");
    pass.shader = resting;
    plan.add(std::move(pass));
    renderer().buildBetter(plan);
    std::this_thread::sleep_for(std::chrono::seconds(1));
    EXPECT_EQ(drawn(resting), 2) << "the first frame after that";
}

TEST_F(GeneratedShaders, OfWhichTheNewestIsWanted)
{
    const auto gate = std::make_shared<GatedContext>(context().shared());
    renderer().buildInBackground(gate);
    EXPECT_EQ(drawn(key(returns(1), "scene")), 1);
    for (int i = 2; i < 20; ++i) EXPECT_EQ(drawn(key(returns(i), "scene")), 1);
    EXPECT_EQ(report_.counters.at("programs"), 2) << "those that were given up are gone";
    const ShaderKey last = key(returns(20), "scene");
    (void)drawn(last);
    gate->open();
    drawUntilFinished(last, 1, 20);
    EXPECT_EQ(report_.counters.at("programs"), 2);
}

TEST_F(GeneratedShaders, AreLetGoWhenNotUsedForLong)
{
    ProgramCache cache;
    const int before = gl::ProgramName::live();
    for (int i = 0; i < 60; ++i) {
        cache.beginFrame();
        (void)cache.use(key(returns(100 + i), "scene"));
        cache.dropIdle();
    }
    EXPECT_LE(cache.size(), 1 + ProgramCache::mostIdle);
    EXPECT_EQ(static_cast<std::size_t>(gl::ProgramName::live() - before), cache.size());
}

TEST_F(GeneratedShaders, OfOneFrameAreBuiltTogether)
{
    if (!gl::buildsInParallel()) GTEST_SKIP() << "the driver compiles one program after the other";
    std::vector<Pass> passes(3);
    for (std::size_t i = 0; i < 3; ++i)
        passes[i].shader = key(i == 1 ? "not GLSL\n" : returns(50 + static_cast<int>(i)), "scene");
    std::optional<test::EnvironmentVariable> noBinaries(std::in_place, "VITRINE_NO_PROGRAM_CACHE", "1");
    ProgramCache cache;
    cache.beginFrame();
    cache.begin(passes, ProgramCache::Building::goesOn);
    EXPECT_EQ(cache.size(), 3U);
    EXPECT_EQ(cache.builds().size(), 0U) << "none is waited for yet";
    EXPECT_NE(cache.use(passes[0].shader).program, 0U);
    EXPECT_EQ(cache.builds().size(), 1U);
    EXPECT_FALSE(cache.use(passes[1].shader).fallback.empty()) << "drawn with the first, of the same family";
    EXPECT_TRUE(cache.use(passes[2].shader).fallback.empty());
    EXPECT_EQ(cache.builds().size(), 3U) << "each was built once";
    noBinaries.reset();

    passes.resize(1);
    passes[0].shader = key(returns(60));
    cache.begin(passes, ProgramCache::Building::isWaitedFor);
    for (int i = 0; i < 30; ++i) {
        cache.beginFrame();
        (void)cache.use(key(returns(100 + i)));
        cache.dropIdle();
    }
    EXPECT_LE(cache.size(), 1 + ProgramCache::mostIdle) << "what no frame used is deleted, finished or not";
}

TEST_F(GeneratedShaders, ComeBackFromTheCacheOnDisk)
{
    const test::TemporaryFolder folder;
    const test::EnvironmentVariable caches("XDG_CACHE_HOME", folder.path().string());
    {
        ProgramCache first;
        (void)first.use(key(returns(1)));
        EXPECT_EQ(first.builds().size(), 1U);
    }
    ProgramCache second;
    (void)second.use(key(returns(1)));
    EXPECT_EQ(second.builds().size(), 0U) << "the same text";
    (void)second.use(key(returns(2)));
    EXPECT_EQ(second.builds().size(), 1U) << "another one under the same path";
}

TEST(ProgramBinaries, OnDiskAreThoseThatWereUsedLast)
{
    const test::TemporaryFolder folder;
    const auto now = std::filesystem::file_time_type::clock::now();
    for (int i = 0; i < 10; ++i) {
        const auto file = folder / (std::to_string(i) + ".bin");
        test::writeBytes(file, "x");
        std::filesystem::last_write_time(file, now - std::chrono::hours((i * 7) % 10));
    }
    test::writeBytes(folder / "other.txt", "x");
    gl::dropOldBinaries(folder.path(), 3);
    int left = 0;
    for (int i = 0; i < 10; ++i) {
        const bool there = std::filesystem::exists(folder / (std::to_string(i) + ".bin"));
        EXPECT_EQ(there, (i * 7) % 10 < 3) << i;
        left += there;
    }
    EXPECT_EQ(left, 3);
    EXPECT_TRUE(std::filesystem::exists(folder / "other.txt"));
}

}  // namespace
}  // namespace vitrine
