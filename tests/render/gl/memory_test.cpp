// Data kept between frames, and how long. Counts are exact: GL names and bytes of data, not the process's memory.

#include "exhibits/study/study.h"
#include "render/gl/program_cache.h"
#include "render/image/oiio_codec.h"
#include "tests/support/gallery.h"
#include "tests/support/planned.h"

namespace vitrine {
namespace {

using namespace test;
using render::gl::Stored;

using Memory = GlTest;

Stored of(const std::vector<Stored>& all, const char* what)
{
    for (const Stored& one : all)
        if (one.what == what) return one;
    return {};
}

render::FramePlan planOf(const Shot& shot)
{
    return test::planned(gallery().museum, shot.sceneState, shot.request.frame);
}

using LongMemory = Memory;

TEST_F(Memory, KeepsNoMoreThanTheLastPrograms)
{
    const int before = render::gl::ProgramName::live();
    render::gl::ProgramCache cache;
    const auto permutation = [](int i) {
        return render::ShaderKey{"lib/fullscreen.vert", "lib/copy.frag", "", {"PERMUTATION " + std::to_string(i)}};
    };
    constexpr int perFrame = 5;
    GLuint always = 0;
    for (int frame = 0; frame < 20; ++frame) {
        cache.beginFrame();
        const GLuint name = cache.use(permutation(-1)).program;
        EXPECT_TRUE(frame == 0 || name == always) << "what every frame uses is built once";
        always = name;
        for (int i = 0; i < perFrame; ++i) (void)cache.use(permutation(frame * perFrame + i));
        cache.dropIdle();
        EXPECT_LE(cache.size(), 1 + perFrame + render::gl::ProgramCache::mostIdle);
        EXPECT_EQ(static_cast<std::size_t>(render::gl::ProgramName::live() - before), cache.size());
    }
    EXPECT_EQ(cache.size(), 1 + perFrame + render::gl::ProgramCache::mostIdle);
}

TEST_F(Memory, HoldsProgramsMeshesAndPicturesOnceForSiblings)
{
    const Shot shot = Shot().inHall().size(32, 18);
    render::gl::Renderer first;
    (void)first.draw(planOf(shot));
    const std::vector<Stored> alone = first.stored();
    EXPECT_GT(of(alone, "pictures").bytes, 0);
    const int names = render::gl::liveGlNames();
    {
        const std::unique_ptr<render::gl::Renderer> sibling = first.sibling();
        const render::FrameReport report = sibling->draw(planOf(shot));
        EXPECT_GT(report.counters.at("passes"), 0);
        for (const char* what : {"pictures", "meshes", "programs"}) {
            EXPECT_EQ(of(first.stored(), what), of(alone, what)) << what;
            EXPECT_EQ(of(sibling->stored(), what), of(alone, what)) << what;
        }
        EXPECT_EQ(largestDifference(first.read("frame"), sibling->read("frame")), 0);
    }
    EXPECT_EQ(render::gl::liveGlNames(), names) << "its images went with it";
}

TEST_F(LongMemory, OfFramebuffersIsMadeOnceAndNotByTheNextSameFrame)
{
    const Museum& museum = gallery().museum;
    render::gl::Renderer renderer;
    for (std::size_t i = 0; i < museum.subjects().size(); ++i) {
        Shot shot;
        shot.inHall().size(32, 18);
        shot.request.frame.camera = museum.bestView(i, shot.sceneState.values[i]);
        const auto made = [&] {
            return renderer.draw(test::planned(museum, shot.sceneState, shot.request.frame, renderer.persistentState()))
                .counters.at("framebuffers made");
        };
        const std::int64_t first = made();
        if (i == 0) {
            EXPECT_GT(first, 0);
        }
        // Some go now: those of the surfaces that only the probe's capture stores.
        const int live = render::gl::FramebufferName::live();
        EXPECT_EQ(made(), 0) << museum.subject(i).name();
        const int stillLive = render::gl::FramebufferName::live();
        EXPECT_LE(stillLive, live) << museum.subject(i).name();
        EXPECT_EQ(made(), 0) << museum.subject(i).name();
        EXPECT_EQ(render::gl::FramebufferName::live(), stillLive) << museum.subject(i).name();
    }
}

// The reader of foreign pictures takes 261 libraries and 131 MB. It must be loaded for the visitor's own files only.
TEST_F(Memory, IsNotSpentOnTheReaderOfForeignPicturesForWhatIsShipped)
{
    const Museum& museum = gallery().museum;
    for (std::size_t i = 0; i < museum.subjects().size(); ++i) {
        FrameRequest frame;
        frame.raster.size = {16, 9};
        SceneState sceneState = museum.initialSceneState();
        sceneState.camera = museum.bestView(i, sceneState.values[i]);
        (void)test::planned(museum, sceneState, frame);
    }
    EXPECT_FALSE(render::oiioCodecIsOpen());
}

TEST_F(Memory, OfAStudyThatIsFinishedIsItsColors)
{
    const Shot shot;
    study::StudyRequest request;
    request.subject = shot.exhibit;
    request.sceneState = shot.sceneState;
    request.axes = {
        {shot.exhibit, *gallery().museum.subject(shot.exhibit).parameters().find("hitTolerance"), {1e-3, 1e-2}}};
    request.size = {32, 18};
    request.runs = 1;
    request.views = 1;
    request.alone = true;
    render::gl::Renderer renderer;
    study::Study study(gallery().museum, renderer, request);
    while (study.step()) {
    }
    const study::StudyResult result = study.takeResult();
    ASSERT_TRUE(result.complete);
    ASSERT_EQ(result.points.size(), 2U);
    for (const study::StudyPoint& point : result.points) EXPECT_EQ(point.shots[0].picture.channels, 4);
    EXPECT_EQ(result.references.at(0).channels, 4);
    EXPECT_TRUE(study.result().references.empty()) << "moved, not copied";
}

}  // namespace
}  // namespace vitrine
