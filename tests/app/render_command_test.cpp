#include "render/files/assets.h"
#include "render/files/strict_json.h"
#include "render/image/image_io.h"
#include "tests/app/child_process.h"
#include "tests/support/german_locale.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace vitrine {
namespace {

using render::Json;
using namespace test;

using Words = std::vector<std::string>;

Words rendering(const std::string& exhibit, const std::string& out, const Words& more = {})
{
    Words words{"render",    exhibit,
                "--size",    "48x27",
                "--samples", "1",
                "--set",     "hall.probeSize=32",
                "--set",     "hall.shadowMapSize=512",
                "--out",     out};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

bool sameBytes(const std::filesystem::path& a, const std::filesystem::path& b)
{
    return test::bytesOf(a) == test::bytesOf(b);
}

const Words everyChannel{"--alone", "--transparent", "--channels", "color,depth,normal,evaluations"};

TEST(RenderCommand, AnOpenExrCarriesTheChannelsAskedFor)
{
    const TemporaryFolder folder;
    Words words = rendering("sdf_morph", folder / "x.exr", everyChannel);
    words.insert(words.end(), {"--report", folder / "r.json"});
    const Ended ended = test::vitrine(words);
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.out.find("size 48 × 27 px"), std::string::npos) << ended.out;
    EXPECT_EQ(test::withoutProgress(ended.err), "");
    const render::Image image = render::readImage(folder / "x.exr");
    EXPECT_EQ(image.width, 48);
    EXPECT_EQ(image.height, 27);
    const std::set<std::string> names(image.channelNames.begin(), image.channelNames.end());
    EXPECT_EQ(names, (std::set<std::string>{"R", "G", "B", "A", "depth.Z", "normal.X", "normal.Y", "normal.Z",
                                            "evaluations"}));
    const auto channel = [&](const char* name) {
        return static_cast<int>(std::find(image.channelNames.begin(), image.channelNames.end(), name) -
                                image.channelNames.begin());
    };
    int hits = 0, counted = 0;
    double evaluations = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const bool hit = image.at(x, y, channel("A")) > 0;
            hits += hit;
            evaluations += image.at(x, y, channel("evaluations"));
            counted += image.at(x, y, channel("evaluations")) > 0;
            if (hit) {
                EXPECT_GT(image.at(x, y, channel("depth.Z")), 0.5F);
                EXPECT_LT(image.at(x, y, channel("depth.Z")), 5.0F);
                EXPECT_NEAR(std::hypot(image.at(x, y, channel("normal.X")), image.at(x, y, channel("normal.Y")),
                                       image.at(x, y, channel("normal.Z"))),
                            1, 1e-3);
                EXPECT_GT(image.at(x, y, channel("evaluations")), 0);
            }
        }
    EXPECT_GT(hits, 100);
    EXPECT_GE(counted, hits);
    const Json report = render::readJson(folder / "r.json").root();
    EXPECT_NEAR(report["counters"]["evaluations"].get<double>(), evaluations, 1 + 1e-4 * evaluations);
    const Json& skipped = report["skipped"];
    EXPECT_TRUE(std::any_of(skipped.begin(), skipped.end(), [](const Json& step) {
        return step["name"] == "hall/walls" && step["reason"] == "the exhibit is shown alone";
    }));
}

TEST(RenderCommand, TheReportSaysWhatRanWhatWasSkippedAndWhatItCost)
{
    const TemporaryFolder folder;
    Words words = rendering("sdf_morph", folder / "x.png", {"--report", folder / "report.json"});
    const Ended ended = test::vitrine(words);
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.out.find("size 48 × 27 px"), std::string::npos) << ended.out;
    const Json report = render::readJson(folder / "report.json").root();
    std::set<std::string> keys;
    for (const auto& [key, value] : report.items()) keys.insert(key);
    EXPECT_EQ(keys, (std::set<std::string>{"app", "exhibit", "size", "renderer", "clock", "ran", "skipped", "counters",
                                           "memory", "ms"}));
    for (const char* owner : {"images", "pictures", "meshes", "programs"})
        EXPECT_GT(report.at("memory").at(owner).at("count").get<int>(), 0) << owner;
    EXPECT_EQ(report["exhibit"], "sdf_morph");
    EXPECT_EQ(report["size"], Json::array({48, 27}));
    EXPECT_FALSE(report["renderer"].get<std::string>().empty());
    EXPECT_FALSE(report["clock"]["method"].get<std::string>().empty());
    EXPECT_TRUE(report["clock"]["trusted"].is_boolean());
    std::set<std::string> ran;
    for (const Json& step : report["ran"]) {
        ran.insert(step["name"].get<std::string>());
        EXPECT_FALSE(step["reason"].get<std::string>().empty());
        EXPECT_TRUE(step["kind"] == "raster" || step["kind"] == "compute" || step["kind"] == "simulation");
        EXPECT_TRUE(step.contains("ms"));
    }
    EXPECT_TRUE(ran.contains("sdf_morph/march"));
    EXPECT_TRUE(ran.contains("hall/walls"));
    for (const Json& step : report["skipped"]) {
        EXPECT_FALSE(step["reason"].get<std::string>().empty()) << step["name"];
        EXPECT_TRUE(step.contains("kind"));
        EXPECT_FALSE(ran.contains(step["name"].get<std::string>())) << step["name"];
    }
    for (const char* counter : {"draws", "triangles", "passes", "evaluations"})
        EXPECT_GT(report["counters"][counter].get<std::int64_t>(), 0) << counter;
    const Json& ms = report["ms"];
    EXPECT_GT(ms["runs"].get<int>(), 2);
    EXPECT_GT(ms["low"].get<double>(), 0);
    EXPECT_LE(ms["low"].get<double>(), ms["median"].get<double>());
    EXPECT_LE(ms["median"].get<double>(), ms["high"].get<double>());
}

TEST(LongRenderCommand, CountersDoNotDependOnTheRun)
{
    const TemporaryFolder folder;
    Json counters[2];
    for (Json& c : counters) {
        ASSERT_EQ(test::vitrine(rendering("sdf_morph", folder / "x.exr",
                                          {"--alone", "--transparent", "--report", folder / "r.json"}))
                      .code,
                  0);
        c = render::readJson(folder / "r.json").root()["counters"];
    }
    EXPECT_EQ(counters[0], counters[1]);
}

TEST(LongRenderCommand, EveryLocaleAndThreadCountGivesTheSameBytes)
{
    const TemporaryFolder folder;
    const Words setting{"--alone", "--set", "morph=0.35", "--eye", "0.5,0.4,1.7"};
    ASSERT_EQ(test::vitrine(rendering("sdf_morph", folder / "plain.exr", setting), {{"LC_ALL", "C"}}).code, 0);
    ASSERT_EQ(test::vitrine(rendering("sdf_morph", folder / "threads.exr", setting), {{"LP_NUM_THREADS", "0"}}).code,
              0);
    EXPECT_TRUE(sameBytes(folder / "plain.exr", folder / "threads.exr"));
    const test::GermanLocale german;
    if (!german.active()) GTEST_SKIP() << "there is no German locale here";
    ASSERT_EQ(test::vitrine(rendering("sdf_morph", folder / "german.exr", setting), {{"LC_ALL", "de_DE.UTF-8"}}).code,
              0);
    EXPECT_TRUE(sameBytes(folder / "plain.exr", folder / "german.exr"));
}

TEST(LongRenderCommand, APictureBringsItsLookBack)
{
    const TemporaryFolder folder;
    for (const char* extension : {".png", ".exr"}) {
        const std::string first = folder / (std::string("first") + extension);
        const std::string again = folder / (std::string("again") + extension);
        const Ended made = test::vitrine(rendering("sdf_morph", first,
                                                   {"--alone", "--set", "morph=0.2", "--set", "baseColor=#c08040",
                                                    "--eye", "0.4,0.5,1.6", "--target", "0,0,0"}));
        ASSERT_EQ(made.code, 0) << made.err;
        const Ended ended = test::vitrine(rendering("sdf_morph", again, {"--alone", "--preset", first}));
        ASSERT_EQ(ended.code, 0) << ended.err;
        EXPECT_EQ(render::readImage(again).pixels, render::readImage(first).pixels) << extension;
        const Ended checked = test::vitrine({"preset", "check", first});
        EXPECT_EQ(checked.code, 0) << checked.err;
        EXPECT_NE(checked.out.find("good ("), std::string::npos) << checked.out;
    }
}

TEST(LongRenderCommand, SixteenBitsOfAnOpenExrAreHalfFloats)
{
    const TemporaryFolder folder;
    // OpenEXR's list of channels: name, zero byte, and type, which is 1 for half floats and 2 for floats.
    const auto typeOf = [&](const Words& more) {
        Words words = rendering("sdf_morph", folder / "a.exr", {"--alone"});
        words.insert(words.end(), more.begin(), more.end());
        const Ended made = test::vitrine(words);
        EXPECT_EQ(made.code, 0) << made.err;
        const std::string bytes = test::bytesOf(folder / "a.exr");
        const std::size_t list = bytes.find(std::string("chlist\0", 7)) + 7 + 4;
        return static_cast<int>(bytes.at(list + 2));
    };
    EXPECT_EQ(typeOf({}), 2);
    EXPECT_EQ(typeOf({"--sixteen-bit"}), 1);
}

TEST(RenderCommand, APictureIsWrittenInTheFormatThatItsNameEndsIn)
{
    const TemporaryFolder folder;
    const Ended made = test::vitrine(rendering("sdf_morph", folder / "a.JPG", {"--alone"}));
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_EQ(test::bytesOf(folder / "a.JPG").substr(0, 3), "\xff\xd8\xff");
    test::expectOneSentence(test::vitrine(rendering("sdf_morph", folder / "a.gif")),
                            {"a.gif", ".png, .jpg, .tif, .exr or .webp"});
    test::expectOneSentence(test::vitrine(rendering("sdf_morph", folder / "b.webp", {"--sixteen-bit"})),
                            {"--sixteen-bit", ".png, .tif or .exr"});
    test::expectOneSentence(test::vitrine(rendering("sdf_morph", folder / "b.jpg", {"--sixteen-bit"})),
                            {"b.jpg", ".png, .tif or .exr", "--sixteen-bit"});
    EXPECT_EQ(folder.files().size(), 1U);
}

TEST(LongRenderCommand, AWebpIsLosslessAndCarriesItsSettings)
{
    const TemporaryFolder folder;
    for (const Words& more : {Words{"--alone"}, Words{"--alone", "--transparent"}}) {
        for (const char* name : {"a.webp", "a.png"})
            ASSERT_EQ(test::vitrine(rendering("sdf_morph", folder / name, more)).code, 0);
        const render::Image webp = render::readImage(folder / "a.webp"), png = render::readImage(folder / "a.png");
        ASSERT_EQ(webp.width, png.width);
        int wrong = 0;
        for (int y = 0; y < png.height; ++y)
            for (int x = 0; x < png.width; ++x)
                for (int c = 0; c < 3 && (webp.channels == 3 || webp.at(x, y, 3) > 0); ++c)
                    wrong += webp.at(x, y, c) != png.at(x, y, c);
        EXPECT_EQ(wrong, 0);
        const Ended again =
            test::vitrine({"render", "sdf_morph", "--preset", folder / "a.webp", "--out", folder / "b.png"});
        ASSERT_EQ(again.code, 0) << again.err;
        EXPECT_EQ(render::readImage(folder / "b.png").pixels, png.pixels);
    }
}

TEST(LongRenderCommand, StandardOutputTakesThePictureAlone)
{
    const TemporaryFolder folder;
    Words words = rendering("sdf_morph", "-", {"--alone"});
    const Ended png = test::vitrine(words);
    ASSERT_EQ(png.code, 0) << png.err;
    ASSERT_EQ(test::vitrine(rendering("sdf_morph", folder / "a.png", {"--alone"})).code, 0);
    EXPECT_EQ(png.out, test::bytesOf(folder / "a.png"));
    const Ended exr = test::vitrine(rendering("sdf_morph", "-.exr", {"--alone"}));
    ASSERT_EQ(exr.code, 0) << exr.err;
    EXPECT_EQ(exr.out.substr(0, 4), "\x76\x2f\x31\x01");
    words.emplace_back("--json");
    test::expectOneSentence(test::vitrine(words), {"--json", "--out -"});
    test::expectOneSentence(test::vitrine(rendering("sdf_morph", "-.gif", {"--alone"})), {".png"});
}

TEST(LongRenderCommand, ChannelsComeBackFromThePicture)
{
    const TemporaryFolder folder;
    const Ended made =
        test::vitrine(rendering("sdf_morph", folder / "a.exr", {"--channels", "albedo,position,object"}));
    ASSERT_EQ(made.code, 0) << made.err;
    const Ended again = test::vitrine({"render", "sdf_morph", "--preset", folder / "a.exr", "--out", folder / "b.exr"});
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(test::withoutProgress(again.err), "");
    EXPECT_TRUE(sameBytes(folder / "a.exr", folder / "b.exr"));
    test::expectOneSentence(test::vitrine(rendering("sdf_morph", folder / "c.exr", {"--channels", "luminance"})),
                            {"\"luminance\"", "depth, normal, evaluations, albedo, position, object or motion"});
}

TEST(LongRenderCommand, APictureOfEveryExhibitAloneBringsItselfBackWithNothingElseSaid)
{
    const TemporaryFolder folder;
    const Ended listed = test::vitrine({"list", "--json"});
    ASSERT_EQ(listed.code, 0);
    int exhibits = 0;
    const Json list = Json::parse(listed.out).at("exhibits");
    for (const Json& exhibit : list) {
        const std::string name = exhibit.at("name");
        if (name == "hall") continue;
        ++exhibits;
        const std::string first = folder / (name + ".png");
        const Ended made = test::vitrine(rendering(name, first, {"--alone", "--rotate", "0,25,0", "--time", "1.25"}));
        ASSERT_EQ(made.code, 0) << made.err;
        const Ended ended = test::vitrine({"render", name, "--preset", first, "--out", folder / "again.png"});
        ASSERT_EQ(ended.code, 0) << ended.err;
        EXPECT_TRUE(sameBytes(first, folder / "again.png")) << name;
    }
    EXPECT_GE(exhibits, 9);
}

TEST(LongRenderCommand, APictureAtItsPlaceBringsTheHallTheTimeAndTheTurnBack)
{
    const TemporaryFolder folder;
    const std::string first = folder / "first.png";
    const Ended made = test::vitrine(rendering(
        "sdf_morph", first,
        {"--set", "hall.exposure=1", "--set", "morph=0.2", "--rotate", "0,40,0", "--time", "3", "--seed", "7"}));
    ASSERT_EQ(made.code, 0) << made.err;
    const Ended ended = test::vitrine({"render", "sdf_morph", "--preset", first, "--out", folder / "again.png"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(sameBytes(first, folder / "again.png"));
    // Control: with its settings alone, the picture differs.
    ASSERT_EQ(test::vitrine({"render", "sdf_morph", "--preset", first, "--settings-only", "--size", "48x27",
                             "--samples", "1", "--out", folder / "settings.png"})
                  .code,
              0);
    EXPECT_NE(render::readImage(folder / "settings.png").pixels, render::readImage(first).pixels);
}

TEST(LongRenderCommand, AParameterThatMovesIsWhereTheTimeSays)
{
    const TemporaryFolder folder;
    const auto render = [&](const std::string& name, Words options) {
        options.insert(options.end(), {"--alone", "--time"});
        const std::string out = folder / name;
        options.push_back(name[0] == 'b' ? "3" : "1");
        const Ended ended = test::vitrine(rendering("sdf_morph", out, options));
        EXPECT_EQ(ended.code, 0) << ended.err;
        return render::readImage(out).pixels;
    };
    const Words moving{"--animate", "morph=triangle:0:1:ease=linear:period=8"};
    EXPECT_EQ(render("a.png", moving), render("still-a.png", {"--set", "morph=0.25"}));
    EXPECT_EQ(render("b.png", moving), render("bs.png", {"--set", "morph=0.75"}));
    // The picture contains the animation.
    EXPECT_EQ(render("again.png", {"--preset", folder / "a.png"}),
              render("still.png", {"--preset", folder / "still-a.png"}));
    EXPECT_EQ(render("b-again.png", {"--preset", folder / "a.png"}),
              render("b-still.png", {"--preset", folder / "bs.png"}));
}

TEST(RenderCommand, AMotionThatIsNoneSaysWhatToGive)
{
    const TemporaryFolder folder;
    const auto said = [&](const char* motion) {
        const Ended ended = test::vitrine(rendering("sdf_morph", folder / "x.png", {"--animate", motion}));
        EXPECT_EQ(ended.code, 2) << motion;
        return ended.err;
    };
    EXPECT_NE(said("morph=waltz:0:1").find("give one of ease, sine"), std::string::npos);
    EXPECT_NE(said("morph=sine:0").find("give a kind and two values"), std::string::npos);
    EXPECT_NE(said("morph=sine:0:1:period=never").find("give a number from"), std::string::npos);
    EXPECT_NE(said("stepLimit=sine:1:9").find("accuracy parameter cannot be animated"), std::string::npos);
    EXPECT_NE(said("nothing=sine:0:1").find("has no parameter of that name"), std::string::npos);
}

TEST(RenderCommand, AValueOutOfRangeIsBroughtBackAndSaidSo)
{
    const TemporaryFolder folder;
    const Ended ended = test::vitrine(rendering("sdf_morph", folder / "x.png", {"--alone", "--set", "morph=7"}));
    EXPECT_EQ(ended.code, 0);
    EXPECT_NE(ended.out.find("size 48 × 27 px"), std::string::npos) << ended.out;
    EXPECT_NE(ended.err.find("morph"), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find("the nearest allowed value"), std::string::npos) << ended.err;
}

TEST(LongRenderCommand, DottedNamesSetAnyExhibitInTheHall)
{
    const TemporaryFolder folder;
    const Words eye{"--eye", "0.62,1.87,1.9", "--target", "0,1.42,0"};
    Words changed = eye;
    changed.insert(changed.end(), {"--set", "sdf_morph.morph=0"});
    ASSERT_EQ(test::vitrine(rendering("hall", folder / "a.png", eye)).code, 0);
    ASSERT_EQ(test::vitrine(rendering("hall", folder / "b.png", changed)).code, 0);
    EXPECT_NE(render::readImage(folder / "a.png").pixels, render::readImage(folder / "b.png").pixels);
}

TEST(LongRenderCommand, ScaleAndRotationTurnTheExhibit)
{
    const TemporaryFolder folder;
    std::set<std::string> pictures;
    for (const Words& more :
         {Words{}, Words{"--scale", "1,2,0.5"}, Words{"--scale", "-1,1,1"}, Words{"--rotate", "0,90,0"}}) {
        Words words = rendering("sdf_morph", folder / "x.exr", {"--alone", "--transparent", "--set", "morph=1"});
        words.insert(words.end(), more.begin(), more.end());
        ASSERT_EQ(test::vitrine(words).code, 0);
        pictures.insert(test::bytesOf(folder / "x.exr"));
    }
    EXPECT_EQ(pictures.size(), 4U);
}

TEST(RenderCommand, WhatCannotBeWrittenIsExit5AndNothingIsLeft)
{
    const TemporaryFolder folder;
    const Ended ended = test::vitrine(rendering("sdf_morph", folder / "no/such/folder/x.png", {"--alone"}));
    EXPECT_EQ(ended.code, 5);
    test::expectOneSentence(ended, {"x.png"});
    EXPECT_TRUE(folder.files().empty());
    const Ended device = test::vitrine(rendering("sdf_morph", "/dev/full/x.png", {"--alone"}));
    EXPECT_EQ(device.code, 5);
    // A report that cannot be written is also an error.
    const Ended report =
        test::vitrine(rendering("sdf_morph", folder / "x.png", {"--alone", "--report", folder / "no/r.json"}));
    EXPECT_EQ(report.code, 5);
    test::expectOneSentence(report, {"r.json"});
    EXPECT_TRUE(folder.files().empty()) << "a picture without its report";
}

TEST(LongRenderCommand, WhatCannotBeReadIsExit5)
{
    const TemporaryFolder folder;
    test::writeBytes(folder / "broken.json", "{\"format\": ");
    test::writeBytes(folder / "broken.glb", "glTF but not really");
    for (const Words& more : {Words{"--preset", folder / "none.json"}, Words{"--preset", folder / "broken.json"},
                              Words{"--environment", folder / "none.hdr"}, Words{"--model", folder / "broken.glb"}}) {
        const Ended ended = test::vitrine(rendering("hall", folder / "x.png", more));
        EXPECT_EQ(ended.code, 5) << more[1];
        test::expectOneSentence(ended, {std::filesystem::path(more[1]).filename().string()});
    }
    // An exhibit is not drawn without the file that it needs.
    for (const auto& [exhibit, row] : {std::pair{"fur", "ringModel"}, {"lenticular", "frontPrint"}}) {
        const Ended ended = test::vitrine(
            rendering(exhibit, folder / "x.png", {"--set", std::string(row) + "=" + (folder / "broken.glb").string()}));
        EXPECT_EQ(ended.code, 5) << row;
        test::expectOneSentence(ended, {"broken.glb"});
    }
    EXPECT_EQ(folder.files().size(), 2U);
}

TEST(LongRenderCommand, SeveralObjectsOfTheVisitorsStandInTheHallAndABadOneIsNamed)
{
    const TemporaryFolder folder;
    const std::string bear = render::asset("models/teddy.glb").string();
    const Words two{"--set", "model=" + bear, "--set", "secondModel=" + bear, "--report", folder / "r.json"};
    const Ended ended = test::vitrine(rendering("hall", folder / "two.png", two));
    ASSERT_EQ(ended.code, 0) << ended.err;
    const Json report = Json::parse(test::bytesOf(folder / "r.json"));
    std::set<std::string> ran, skipped;
    for (const Json& pass : report["ran"]) ran.insert(pass["name"].get<std::string>());
    for (const Json& pass : report["skipped"]) skipped.insert(pass["name"].get<std::string>());
    EXPECT_TRUE(ran.contains("hall/visitor") && ran.contains("hall/visitor/2"));
    EXPECT_TRUE(skipped.contains("hall/visitor/3") && skipped.contains("hall/visitor/4"));
    ASSERT_EQ(test::vitrine(rendering("hall", folder / "one.png", {"--model", bear})).code, 0);
    EXPECT_FALSE(sameBytes(folder / "one.png", folder / "two.png"));

    test::writeBytes(folder / "broken.glb", "glTF but not really");
    const Ended bad = test::vitrine(rendering(
        "hall", folder / "x.png", {"--model", bear, "--set", "thirdModel=" + (folder / "broken.glb").string()}));
    EXPECT_EQ(bad.code, 5);
    test::expectOneSentence(bad, {"Third model", "broken.glb"});
}

TEST(LongRenderCommand, AShippedPresetIsKnownByItsName)
{
    const TemporaryFolder folder;
    ASSERT_EQ(test::vitrine(rendering("sdf_morph", folder / "named.exr", {"--alone", "--preset", "old-gold"})).code, 0);
    const std::string file = render::asset("presets/sdf_morph/old-gold.json").string();
    ASSERT_EQ(test::vitrine(rendering("sdf_morph", folder / "file.exr", {"--alone", "--preset", file})).code, 0);
    ASSERT_EQ(test::vitrine(rendering("sdf_morph", folder / "initial.exr", {"--alone"})).code, 0);
    const auto named = render::readImage(folder / "named.exr").pixels;
    EXPECT_EQ(named, render::readImage(folder / "file.exr").pixels);
    EXPECT_NE(named, render::readImage(folder / "initial.exr").pixels);
    const Ended ended = test::vitrine(rendering("sdf_morph", folder / "x.png", {"--preset", "old-golf"}));
    EXPECT_EQ(ended.code, 5);
    test::expectOneSentence(ended, {"old-golf", "old-gold"});
}

TEST(RenderCommand, WithoutAssetsSaysWhatToDo)
{
    const TemporaryFolder folder;
    test::writeBytes(folder / "models/materials.json", "{");
    const Ended ended =
        test::vitrine(rendering("sdf_morph", folder / "x.png"), {{"VITRINE_ASSETS", folder.path().string()}});
    EXPECT_EQ(ended.code, 5);
    test::expectOneSentence(ended, {"materials.json"});
}

TEST(LongRenderCommand, ABrokenPictureOfTheHallIsNamedAndIsNotNeededForAnExhibitAlone)
{
    const TemporaryFolder folder;
    const std::filesystem::path assets = render::asset("models/materials.json").parent_path().parent_path();
    const auto link = [&](const std::filesystem::path& from, const std::string& to, const std::string& without) {
        std::filesystem::create_directories(folder / to);
        for (const auto& each : std::filesystem::directory_iterator(from))
            if (each.path().filename() != without)
                std::filesystem::create_symlink(each.path(), folder / (to + "/" + each.path().filename().string()));
    };
    link(assets, "assets", "models");
    link(assets / "models", "assets/models", "hall_light_sky.png");
    test::writeBytes(folder / "assets/models/hall_light_sky.png", "not a picture");
    const test::Environment changed{{"VITRINE_ASSETS", folder / "assets"}};
    const Ended hall = test::vitrine(rendering("hall", folder / "x.png"), changed);
    EXPECT_EQ(hall.code, 5);
    test::expectOneSentence(hall, {"hall_light_sky.png"});
    EXPECT_EQ(test::vitrine(rendering("sdf_morph", folder / "y.png", {"--alone"}), changed).code, 0);
}

std::string preset(const std::string& values)
{
    return "{\"format\": \"vitrine-preset\", \"version\": 1, \"exhibit\": \"sdf_morph\", \"name\": \"Test\", "
           "\"values\": {" +
           values + "}}";
}

TEST(PresetCheck, TellsGoodFilesFromBad)
{
    const TemporaryFolder folder;
    test::writeBytes(folder / "good.json", preset("\"morph\": 0.25"));
    const Ended good = test::vitrine({"preset", "check", folder / "good.json"});
    EXPECT_EQ(good.code, 0) << good.err;
    EXPECT_NE(good.out.find("good"), std::string::npos);

    const std::vector<std::pair<std::string, std::string>> bad{{"type", preset("\"morph\": \"soup\"")},
                                                               {"duplicate", preset("\"morph\": 0.1, \"morph\": 0.2")},
                                                               {"nan", preset("\"morph\": NaN")},
                                                               {"torn", preset("").substr(0, 40)}};
    for (const auto& [name, text] : bad) {
        test::writeBytes(folder / (name + ".json"), text);
        const Ended ended = test::vitrine({"preset", "check", folder / (name + ".json")});
        EXPECT_EQ(ended.code, 1) << name;
        EXPECT_EQ(ended.out, "");
        EXPECT_NE(ended.err.find(name + ".json, line 1"), std::string::npos) << ended.err;
    }
    // One invalid file fails the check. Valid files are still reported as good.
    const Ended both = test::vitrine({"preset", "check", folder / "good.json", folder / "type.json"});
    EXPECT_EQ(both.code, 1);
    EXPECT_NE(both.out.find("good.json: good"), std::string::npos);

    EXPECT_EQ(test::vitrine({"preset", "check", folder / "none.json"}).code, 5);
}

TEST(PresetCheck, SaysTheSameAsJson)
{
    const TemporaryFolder folder;
    test::writeBytes(folder / "good.json", preset("\"morph\": 7"));
    test::writeBytes(folder / "type.json", preset("\n\"morph\": \"soup\""));
    test::writeBytes(folder / "torn.json", preset("").substr(0, 40));
    const Ended ended = test::vitrine({"preset", "check", "--json", folder / "good.json", folder / "type.json",
                                       folder / "torn.json", folder / "none.json"});
    EXPECT_EQ(ended.code, 5);
    EXPECT_EQ(ended.err, "");
    const render::Json document = render::Json::parse(ended.out);
    EXPECT_EQ(document["format"], "vitrine-findings");
    EXPECT_EQ(document["version"], 1);
    EXPECT_EQ(document["command"], "preset check");
    EXPECT_EQ(document["good"], false);
    const render::Json& files = document["files"];
    ASSERT_EQ(files.size(), 4U);
    EXPECT_EQ(files[0]["good"], true);
    EXPECT_EQ(files[0]["exhibit"], "sdf_morph");
    EXPECT_EQ(files[0]["kind"], "preset");
    EXPECT_EQ(files[0]["findings"][0]["level"], "note");
    EXPECT_EQ(files[0]["findings"][0]["sentence"], "morph 7 -> 1 (allowed 0 to 1)");
    EXPECT_EQ(files[1]["good"], false);
    EXPECT_EQ(files[1]["findings"][0]["level"], "error");
    EXPECT_EQ(files[1]["findings"][0]["line"], 2);
    EXPECT_EQ(files[1]["findings"][0]["key"], "values.morph");
    EXPECT_EQ(files[2]["findings"][0]["line"], 1);
    const render::Json& torn = files[2]["findings"][0];
    EXPECT_NE(torn["sentence"].get<std::string>().find(", column " + torn["column"].dump()), std::string::npos) << torn;
    EXPECT_EQ(files[3]["good"], false);
    EXPECT_FALSE(files[3]["findings"][0].contains("line"));
    EXPECT_EQ(test::vitrine({"preset", "check", "--json", folder / "good.json"}).code, 0);
}

TEST(PresetCheck, TakesNothingInAMessageForThePlace)
{
    // Files, keys and texts that look like places, in the sentence that names the real one.
    const TemporaryFolder folder;
    const std::string twice = folder / "twice.json, line 9, column 9, values: a", none = folder / "x.json, line 7";
    test::writeBytes(twice, preset("\n\"a: line 8, b\": 1,\n\"a: line 8, b\": 2"));
    test::writeBytes(folder / "odd.json", R"({"format": "vitrine-preset", "version": 1,
"exhibit": "x.json, line 6, column 6, values: odd", "values": {}})");
    const Ended ended = test::vitrine({"preset", "check", "--json", twice, none, folder / "odd.json"});
    const render::Json files = render::Json::parse(ended.out)["files"];
    ASSERT_EQ(files.size(), 3U);
    const render::Json& found = files[0]["findings"][0];
    EXPECT_EQ(found["file"], twice);
    EXPECT_EQ(found["line"], 3) << found;
    EXPECT_EQ(found["key"], "values.a: line 8, b") << found;
    EXPECT_FALSE(files[1]["findings"][0].contains("line")) << files[1];
    EXPECT_EQ(files[2]["findings"][0]["line"], 2) << files[2];
    EXPECT_FALSE(files[2]["findings"][0].contains("column")) << files[2];
    EXPECT_EQ(files[2]["findings"][0]["key"], "exhibit") << files[2];
}

TEST(PresetCheck, SaysWhatReadingWouldChange)
{
    const TemporaryFolder folder;
    test::writeBytes(folder / "x.json", preset("\"morph\": 7, \"fromTheFuture\": 1"));
    const Ended ended = test::vitrine({"preset", "check", folder / "x.json"});
    EXPECT_EQ(ended.code, 0);
    EXPECT_NE(ended.out.find("morph 7 -> 1"), std::string::npos) << ended.out;
    EXPECT_NE(ended.out.find("fromTheFuture"), std::string::npos) << ended.out;
}

}  // namespace
}  // namespace vitrine
