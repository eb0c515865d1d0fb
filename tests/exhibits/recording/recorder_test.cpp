// Frames of a recording, compared with pictures of their times.

#include "exhibits/museum/render_command.h"
#include "exhibits/recording/record.h"
#include "render/image/image_io.h"
#include "render/image/srgb.h"
#include "tests/support/gallery.h"
#include "tests/support/temporary_folder.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace vitrine::recording {
namespace {

using test::gallery;

class RecorderTest : public test::GlTest {};

/// Recording of the melting mug, which the camera orbits in four frames.
struct Film {
    test::Shot shot;
    RecordingRequest request;

    Film()
    {
        shot.values().set(test::sdfTable().animate, true);
        shot.size(40, 24);
        request.picture = shot.request;
        request.picture.frame.channels = {};
        request.picture.depth = false;
        request.picture.samples = 4;
        request.camera = [start = shot.request.frame.camera](double part) { return turned(start, 6.283185307 * part); };
        request.seconds = 2;
        request.framesPerSecond = 2;
        request.closed = true;
    }
    [[nodiscard]] render::Image frame(int k) const
    {
        FrameMaker maker(gallery().museum, gallery().renderer, shot.sceneState, request, k);
        double before = -1;
        while (maker.step()) {
            EXPECT_GT(maker.progress(), before);
            before = maker.progress();
        }
        EXPECT_EQ(maker.progress(), 1);
        return maker.picture();
    }
    [[nodiscard]] render::Image pictureAt(const MotionSample& moment) const
    {
        PictureRequest picture = request.picture;
        picture.frame.camera = moment.camera;
        picture.frame.time = moment.time;
        SceneState sceneState = shot.sceneState;
        sceneState.camera = moment.camera;
        PictureMaker maker(gallery().museum, gallery().renderer, sceneState, picture);
        while (maker.step()) {
        }
        return maker.picture();
    }
};

using LongRecorderTest = RecorderTest;

TEST_F(RecorderTest, AFrameIsThePictureOfItsMoment)
{
    const Film film;
    const render::Image third = film.frame(2);
    EXPECT_EQ(test::largestDifference(third, film.pictureAt(motionSamplesOf(film.request, 2).front())), 0);
    EXPECT_GT(test::largestDifference(third, film.frame(1)), 0.1) << "the control: it moves";
    EXPECT_EQ(test::largestDifference(third, film.frame(2)), 0) << "whatever was drawn before";
}

TEST_F(RecorderTest, FramesOfAShaderWithFeedbackAreCountedFromTheBeginning)
{
    // A visitor's shader that counts its steps, 60 a second; in order, from the middle as in a part, and backwards.
    const test::TemporaryFolder folder;
    const std::string file = folder / "counter.fs";
    test::writeBytes(file,
                     R"(/*{"ISFVSN": "2", "PASSES": [{"TARGET": "count", "PERSISTENT": true, "FLOAT": true}, {}]}*/
void main() { gl_FragColor = PASSINDEX == 0 ? IMG_THIS_PIXEL(count) + 1.0 : vec4(IMG_THIS_PIXEL(count).rrr / 255.0, 1.0); })");
    test::Shot shot("your_shader");
    shot.size(12, 8);
    shot.values().setParameter(*shot.values().table().find("file"), file);
    shot.sceneState = gallery().museum.readTables(shot.sceneState).sceneState;
    shot.values().setParameter(*shot.values().table().find("animate"), 1.0);
    Film film;
    film.shot = shot;
    film.request.picture = shot.request;
    film.request.picture.frame.averageIn = AverageIn::display;
    film.request.picture.frame.transparent = false;
    film.request.picture.samples = 1;
    film.request.camera = [at = shot.request.frame.camera](double) { return at; };
    film.request.framesPerSecond = 20;
    for (const int k : {0, 1, 2, 7, 6, 7, 2}) {
        const render::Image frame = film.frame(k);
        EXPECT_EQ(std::lround(255 * render::srgbFromLinear(frame.at(5, 4, 0))), 3 * k + 1) << k;
    }
}

TEST_F(RecorderTest, MotionBlurIsTheMeanOfItsMoments)
{
    Film film;
    film.request.shutter = 0.5;
    film.request.shutterSamples = 3;
    const render::Image blurred = film.frame(1);
    render::Image mean(blurred.width, blurred.height, 4);
    for (const MotionSample& moment : motionSamplesOf(film.request, 1)) {
        const render::Image one = film.pictureAt(moment);
        for (std::size_t i = 0; i < one.pixels.size(); ++i)
            mean.pixels[i] += one.pixels[i] * (i % 4 < 3 ? one.pixels[i - i % 4 + 3] : 1.0F) / 3;
    }
    double worst = 0;
    for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
        const float alpha = i % 4 < 3 ? blurred.pixels[i - i % 4 + 3] : 1.0F;
        worst = std::max(worst, std::abs(static_cast<double>(blurred.pixels[i] * alpha - mean.pixels[i])));
    }
    EXPECT_LT(worst, 1e-5);  // Float32 rounding of values up to about 10.
}

TEST_F(RecorderTest, FramesThatAreThereAreKeptWhenTheyAreTheSame)
{
    Film film;
    const test::TemporaryFolder folder;
    const auto pattern = folder / "frames/%04d.png";
    std::filesystem::create_directory(folder / "frames");  // The job makes it.
    const auto keptOf = [&](double until) {
        Recording recording(gallery().museum, gallery().renderer, {film.shot.sceneState, film.shot.exhibit},
                            film.request, pattern);
        while (recording.progress() < until && recording.step()) {
        }
        EXPECT_EQ(recording.finished(), until > 1);
        return recording.kept();
    };
    // Stopped in the third frame: two complete frames exist.
    EXPECT_EQ(keptOf(0.6), 0);
    EXPECT_EQ(folder.files(), (std::vector<std::string>{"frames/0001.png", "frames/0002.png"}));
    const std::string bytes = test::bytesOf(folder / "frames/0001.png");
    test::writeBytes(folder / "frames/0002.png", bytes.substr(0, bytes.size() / 2));  // A damaged frame.
    EXPECT_EQ(keptOf(2), 1);
    EXPECT_EQ(keptOf(2), 4);
    const render::Image read = render::readImage(folder / "frames/0003.png");
    EXPECT_EQ(read.width, 40);
    EXPECT_NE(render::embeddedPreset(folder / "frames/0003.png")->find("\"camera\""), std::string::npos);
    // Any change of the picture draws all frames again.
    film.shot.values().set(test::sdfTable().animate, false);
    EXPECT_EQ(keptOf(2), 0);
    film.request.picture.samples = 2;
    EXPECT_EQ(keptOf(2), 0);
    film.request.picture.frame.seed = 9;
    EXPECT_EQ(keptOf(2), 0);
    film.request.shutter = 0.1;
    EXPECT_EQ(keptOf(2), 0);
    EXPECT_EQ(keptOf(2), 4);
}

TEST_F(RecorderTest, AStoppedVideoLeavesNothing)
{
    const Film film;
    const test::TemporaryFolder folder;
    {
        Recording recording(gallery().museum, gallery().renderer, {film.shot.sceneState, film.shot.exhibit},
                            film.request, folder / "a.apng");
        while (recording.progress() < 0.6) recording.step();
    }
    EXPECT_TRUE(folder.files().empty());
}

/// Runs a command line like a shell, with this build's program.
int runLine(std::string line)
{
    line.replace(0, std::string("vitrine").size(), VITRINE_PROGRAM);
    return std::system(line.c_str());
}

TEST_F(LongRecorderTest, ACopiedCommandLineDrawsTheSamePicture)
{
    const Museum& museum = gallery().museum;
    SceneState sceneState = museum.initialSceneState();
    test::useSmallMaps(sceneState.hall(), 512);
    const auto set = [&](const char* exhibit, const char* row, const Value& value) {
        ParameterValues& values = sceneState.values[*museum.find(exhibit)];
        values.setParameter(values.table().find(row).value(), value);
    };
    set("sdf_morph", "morph", 0.1 + 0.2);
    set("crepuscular_rays", "tint", glm::dvec3(0.1, 1.0 / 3, 0.7));
    set("hall", "sunElevation", 0.3);
    FrameRequest frame;
    frame.raster.size = {64, 36};
    frame.camera = museum.bestView(*museum.find("sdf_morph"), sceneState.values[*museum.find("sdf_morph")]);
    frame.camera.fovY = 1.0 / 3;
    frame.time = 12.3;
    sceneState.camera = frame.camera;
    const test::TemporaryFolder folder;
    const std::string line = renderCommand(museum, sceneState, frame, 4, (folder / "it's here.png").string());
    PictureMaker maker(museum, gallery().renderer, sceneState, {.frame = frame, .samples = 4});
    while (maker.step()) {
    }
    render::writePicture(folder / "shown.png", maker.picture(), render::PictureFormat::png8);
    ASSERT_EQ(runLine(line), 0) << line;
    const render::Image again = render::readImage(folder / "it's here.png");
    EXPECT_EQ(test::largestDifference(again, render::readImage(folder / "shown.png")), 0) << line;
    // Control: the content of the line matters.
    SceneState other = sceneState;
    other.values = museum.initialSceneState().values;
    test::useSmallMaps(other.hall(), 512);
    ASSERT_EQ(runLine(renderCommand(museum, other, frame, 4, (folder / "other.png").string())), 0);
    EXPECT_GT(test::largestDifference(again, render::readImage(folder / "other.png")), 0.02);
}

}  // namespace
}  // namespace vitrine::recording
