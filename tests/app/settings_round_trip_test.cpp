// All writers of settings with all readers, on random settings: the values read are exactly those written.

#include "app/kit/picture_options.h"
#include "exhibits/exhibits.h"
#include "exhibits/framework/table/random_values.h"
#include "exhibits/museum/picture_settings.h"
#include "exhibits/museum/render_command.h"
#include "render/failure.h"
#include "render/image/image_io.h"
#include "render/image/picture_stream.h"
#include "render/video/carried_settings.h"
#include "render/video/video_file.h"
#include "tests/support/temporary_folder.h"
#include "ui/presets/scene_text.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <numbers>

namespace vitrine {
namespace {

namespace fs = std::filesystem;

const Museum& museum()
{
    static const Museum all{allExhibits()};
    return all;
}

/// Returns a random animation of a parameter.
Motion randomMotion(const ParameterInfo& parameter, RandomNumbers& random)
{
    Motion motion;
    motion.kind = static_cast<MotionKind>(random.index(static_cast<int>(motionKinds.size())));
    motion.from = randomValue(parameter, random);
    motion.to = randomValue(parameter, random);
    if (isEased(motion.kind)) motion.ease = static_cast<Ease>(random.index(static_cast<int>(easeNames.size())));
    if (motion.kind != MotionKind::distance) motion.period = random.number(0.1, 100);
    if (isPeriodic(motion.kind)) motion.phase = random.number(-2, 2);
    if (motion.kind == MotionKind::ease) motion.start = random.number(-5, 5);
    if (motion.kind == MotionKind::steps) motion.steps = 2 + random.index(9);
    if (motion.kind == MotionKind::noise) motion.seed = static_cast<std::uint32_t>(random.number(0, 4294967295.0));
    if (motion.kind == MotionKind::distance) {
        motion.nearest = random.number(0, 3);
        motion.farthest = random.number(3, 9);
    }
    if (random.chance(0.5)) motion.heldAt = random.number(0, 50);
    return motion;
}

render::Camera randomCamera(RandomNumbers& random)
{
    render::Camera camera{random.point({-9, 0.2, -9}, {9, 4, 9}), random.point({-9, 0.2, -9}, {9, 4, 9}),
                          random.number(0.2, 1.5)};
    if (random.chance(0.3)) camera.lensShift = {random.number(-0.5, 0.5), random.number(-0.5, 0.5)};
    return camera;
}

/// Returns random values of all parameters of all tables, with some animations.
SceneState randomState(RandomNumbers& random)
{
    SceneState state = museum().readTables(museum().initialSceneState()).sceneState;
    for (ParameterValues& values : state.values) {
        values = randomValues(values.table(), random, 0.6);
        for (int i = 0; i < 3; ++i) {
            const auto row = static_cast<std::size_t>(random.index(static_cast<int>(values.rows().size())));
            if (whyUnmoved(values.rows()[row]).empty()) values.setMotion(row, randomMotion(values.rows()[row], random));
        }
    }
    state.camera = randomCamera(random);
    return state;
}

/// Returns a random request for a picture of the subject.
PictureRequest randomRequest(std::size_t subject, RandomNumbers& random)
{
    PictureRequest request;
    FrameRequest& frame = request.frame;
    frame.camera = randomCamera(random);
    frame.raster.size = {1 + random.index(2000), 1 + random.index(2000)};
    frame.time = random.number(-10, 1000);
    frame.seed = static_cast<std::uint32_t>(random.number(0, 4294967295.0));
    request.samples = 1 + random.index(64);
    frame.transparent = random.chance(0.3);
    if (subject == hallIndex) return request;
    if (random.chance(0.5))
        frame.alone = subject;
    else
        frame.subject = subject;
    if (frame.transparent && !frame.alone) frame.cutOut = subject;
    if (random.chance(0.5))
        frame.exhibitTransform = glm::scale(glm::rotate(glm::dmat4(1), random.number(-3, 3), random.direction()),
                                            random.point({-2, 1, 1}, {-1, 2, 3}));
    return request;
}

/// Expects that the command line makes the same picture from a file.
void expectSamePicture(const std::string& file, std::size_t subject, const SceneState& state,
                       const PictureRequest& request)
{
    app::PictureOptions options;
    options.subject = std::string(museum().subject(subject).name());
    options.preset = file;
    options.out = "again.exr";
    const app::RequestedPicture again = app::requestedPicture(museum(), options);
    EXPECT_TRUE(again.sceneState.values == state.values) << file;
    EXPECT_TRUE(again.notes.empty()) << file << ": " << again.notes.front();
    const FrameRequest &a = again.request.frame, &b = request.frame;
    EXPECT_TRUE(a.camera == b.camera) << file;
    EXPECT_EQ(a.raster.size, b.raster.size) << file;
    EXPECT_EQ(a.time, b.time) << file;
    EXPECT_EQ(a.seed, b.seed) << file;
    EXPECT_EQ(a.transparent, b.transparent) << file;
    EXPECT_EQ(a.alone, b.alone) << file;
    EXPECT_EQ(a.cutOut, b.cutOut) << file;
    EXPECT_EQ(a.subject, b.subject) << file;
    EXPECT_TRUE(a.exhibitTransform == b.exhibitTransform) << file;
    ASSERT_TRUE(again.taken) << file;
    EXPECT_TRUE(again.taken->channels == b.channels) << file;
    EXPECT_EQ(again.taken->depth, request.depth) << file;
    EXPECT_EQ(again.request.samples, request.samples) << file;
}

/// Expects that the window reads the same state from a text.
void expectSameState(const std::string& text, const SceneState& state, const render::Camera& camera)
{
    std::vector<std::string> notes;
    const SceneState read = museum().readTables(ui::lookFrom(museum(), text, "text", notes)).sceneState;
    EXPECT_TRUE(read.values == state.values);
    EXPECT_TRUE(read.camera == camera);
    EXPECT_TRUE(notes.empty()) << notes.front();
}

/// Splits a command line quoted by `render::shellWord` into words.
std::vector<std::string> wordsOf(const std::string& line)
{
    std::vector<std::string> words(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '\'')
            quoted = !quoted;
        else if (line[i] == '\\' && !quoted)
            words.back() += line[++i];
        else if (line[i] == ' ' && !quoted)
            words.emplace_back();
        else
            words.back() += line[i];
    }
    return words;
}

}  // namespace

TEST(SettingsRoundTrip, APictureOfEverySubjectAndFormatBringsItselfBack)
{
    const test::TemporaryFolder folder;
    const render::Image image(2, 2, 4, 0.5F);
    RandomNumbers random(1);
    for (std::size_t subject = 0; subject < museum().subjects().size(); ++subject)
        for (const auto& [extension, format] : {std::pair{"png", render::PictureFormat::png8},
                                                {"exr", render::PictureFormat::exr},
                                                {"tif", render::PictureFormat::tiff16},
                                                {"jpg", render::PictureFormat::jpeg}}) {
            const SceneState state = randomState(random);
            PictureRequest request = randomRequest(subject, random);
            if (format == render::PictureFormat::exr) {
                request.depth = random.chance(0.5);
                request.frame.channels = {random.chance(0.5), random.chance(0.5)};
            }
            const std::string file = folder / (std::string("a.") + extension);
            const std::string text = pictureSettings(museum(), subject, state, request, "Picture");
            render::writePicture(file, image, format, {.preset = text});
            expectSamePicture(file, subject, state, request);
            const render::Camera& camera = request.frame.camera;
            expectSameState(*render::carriedSettings(file), state,
                            request.frame.alone ? camera.transformed(museum().worldFromExhibit(subject)) : camera);
        }
}

TEST(SettingsRoundTrip, ARecordingOfEveryFormatBringsItsFirstFrameBack)
{
    const test::TemporaryFolder folder;
    const render::Image image(64, 64, 3, 0.5F);
    RandomNumbers random(2);
    for (const char* name : {"a.mp4", "a.webm", "a.gif", "a.webp", "a.apng"}) {
        const std::string file = folder / name;
        const std::size_t subject = 1 + static_cast<std::size_t>(random.index(9));
        const SceneState state = randomState(random);
        const PictureRequest request = randomRequest(subject, random);
        render::VideoSpec spec{*render::videoFormatOf(file), 64, 64, 10, false, {}};
        spec.comment = pictureSettings(museum(), subject, state, request, "Recording");
        render::VideoFile video(file, spec);
        for (int i = 0; i < 3; ++i) video.add(image);
        video.finish();
        expectSamePicture(file, subject, state, request);
    }
}

TEST(SettingsRoundTrip, APrintBringsItsViewsBackFromItsFileAndTheDescriptionBesideIt)
{
    const test::TemporaryFolder folder;
    RandomNumbers random(3);
    const std::vector<std::uint8_t> rows(std::size_t{16} * 16 * 3, 100);
    for (const char* name : {"a.tif", "a.png"}) {
        const std::size_t subject = 1 + static_cast<std::size_t>(random.index(9));
        const SceneState state = randomState(random);
        const PictureRequest request = randomRequest(subject, random);
        const render::Json preset = render::Json::parse(pictureSettings(museum(), subject, state, request, "View"));
        const std::string json = render::writeJson({{"format", "vitrine-job"}, {"job", "print"}, {"scene", preset}});
        render::PictureStream stream(folder / name,
                                     {.width = 16, .height = 16, .dpiX = 300, .dpiY = 300, .json = json});
        stream.write(rows.data(), 16);
        stream.finish();
        stream.publish();
        test::writeBytes(folder / "beside.json", json);
        expectSamePicture(folder / name, subject, state, request);
        expectSamePicture(folder / "beside.json", subject, state, request);
    }
}

TEST(SettingsRoundTrip, TheCopiedCommandLineSetsAndMovesEverything)
{
    RandomNumbers random(4);
    for (int i = 0; i < 10; ++i) {
        const SceneState state = randomState(random);
        PictureRequest request = randomRequest(hallIndex, random);
        request.frame.transparent = false;
        request.frame.camera.lensShift = {};  // Used for views of prints only.
        app::PictureOptions options;
        options.subject = "hall";
        const std::vector<std::string> words =
            wordsOf(renderCommand(museum(), state, request.frame, request.samples, "out.png"));
        const auto valueOf = [&](const std::string& option) {
            for (std::size_t w = 0; w < words.size(); ++w) {
                if (words[w] == option) return words[w + 1];
                if (words[w].starts_with(option + '=')) return words[w].substr(option.size() + 1);
            }
            return std::string();
        };
        for (const std::string& word : words) {
            if (word.starts_with("--set=")) options.sets.push_back(word.substr(6));
            if (word.starts_with("--animate=")) options.motions.push_back(word.substr(10));
        }
        options.size = valueOf("--size");
        options.eye = valueOf("--eye");
        options.target = valueOf("--target");
        options.fovDegrees = std::stod(valueOf("--fov"));
        options.time = std::stod(valueOf("--time"));
        options.seed = static_cast<std::uint32_t>(std::stoul(valueOf("--seed")));
        const app::RequestedPicture again = app::requestedPicture(museum(), options);
        for (std::size_t s = 0; s < state.values.size(); ++s)
            EXPECT_TRUE(again.sceneState.values[s] == state.values[s]) << museum().subject(s).name();
        // Converting radians to degrees and back is not exact: two in ten angles differ by one rounding.
        EXPECT_DOUBLE_EQ(again.request.frame.camera.fovY, request.frame.camera.fovY);
        render::Camera camera = again.request.frame.camera;
        camera.fovY = request.frame.camera.fovY;
        EXPECT_TRUE(camera == request.frame.camera);
        EXPECT_EQ(again.request.frame.raster.size, request.frame.raster.size);
        EXPECT_EQ(again.request.frame.time, request.frame.time);
        EXPECT_EQ(again.request.frame.seed, request.frame.seed);
    }
}

TEST(SettingsRoundTrip, WhatTheCommandLineSaysTakesPrecedenceAndSettingsOnlyLeavesTheRest)
{
    const test::TemporaryFolder folder;
    RandomNumbers random(5);
    const std::size_t subject = *museum().find("sdf_morph");
    const SceneState state = randomState(random);
    PictureRequest request = randomRequest(subject, random);
    request.frame.subject.reset();
    request.frame.cutOut.reset();
    request.frame.alone = subject;
    const std::string file = folder / "a.json";
    test::writeBytes(file, pictureSettings(museum(), subject, state, request, "Picture"));
    app::PictureOptions options;
    options.subject = "sdf_morph";
    options.preset = file;
    options.size = "12x34";
    options.samples = 7;
    options.time = 2.5;
    options.seed = 9;
    options.rotate = "0,0,0";
    const PictureRequest given = app::requestedPicture(museum(), options).request;
    EXPECT_EQ(given.frame.raster.size, glm::ivec2(12, 34));
    EXPECT_EQ(given.samples, 7);
    EXPECT_EQ(given.frame.time, 2.5);
    EXPECT_EQ(given.frame.seed, 9U);
    EXPECT_TRUE(given.frame.exhibitTransform == glm::dmat4(1));
    EXPECT_EQ(given.frame.alone, subject);
    app::PictureOptions settings;
    settings.subject = "sdf_morph";
    settings.preset = file;
    settings.settingsOnly = true;
    const app::RequestedPicture only = app::requestedPicture(museum(), settings);
    EXPECT_TRUE(only.sceneState.values == state.values);
    EXPECT_FALSE(only.request.frame.alone);
    EXPECT_EQ(only.request.frame.raster.size, glm::ivec2(640, 360));
    EXPECT_EQ(only.request.frame.time, 0);
    // For another exhibit only the settings are applied, and a note says so.
    settings.subject = "fur";
    settings.settingsOnly = false;
    const app::RequestedPicture other = app::requestedPicture(museum(), settings);
    EXPECT_TRUE(other.sceneState.values == state.values);
    EXPECT_FALSE(other.request.frame.alone);
    ASSERT_EQ(other.notes.size(), 1U);
    EXPECT_NE(other.notes.front().find("a picture of sdf_morph"), std::string::npos) << other.notes.front();
}

TEST(SettingsRoundTrip, ARecordOfAPictureThatCannotBeIsRefusedByKey)
{
    const test::TemporaryFolder folder;
    const std::string whole = pictureSettings(museum(), 1, museum().initialSceneState(),
                                              randomRequest(1, *std::make_unique<RandomNumbers>(6)), "Picture");
    for (const auto& [key, value] : {std::pair<const char*, const char*>{"size", "[0, 5]"},
                                     {"size", "\"large\""},
                                     {"samples", "1.5"},
                                     {"samples", "0"},
                                     {"time", "\"noon\""},
                                     {"seed", "-1"},
                                     {"alone", "1"},
                                     {"transform", "[[1, 0, 0], [0, 1, 0], [0, 0, 0]]"},
                                     {"transform", "[1, 2, 3]"},
                                     {"channels", "[\"smell\"]"},
                                     {"camera", "7"},
                                     {"language", "[]"}}) {
        render::Json root = render::Json::parse(whole);
        root["picture"][key] = render::Json::parse(value);
        test::writeBytes(folder / "a.json", root.dump());
        app::PictureOptions options;
        options.subject = std::string(museum().subject(1).name());
        options.preset = folder / "a.json";
        try {
            (void)app::requestedPicture(museum(), options);
            ADD_FAILURE() << key << ' ' << value;
        } catch (const Failure& failure) {
            EXPECT_NE(std::string(failure.what()).find(std::string("picture.") + key), std::string::npos)
                << failure.what();
        }
    }
}

}  // namespace vitrine
