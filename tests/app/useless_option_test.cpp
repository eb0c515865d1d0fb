// Options without effect are refused by all commands in the same way.

#include "tests/app/child_process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

using namespace test;
using Words = std::vector<std::string>;

TEST(UselessOptions, AreRefusedByEveryCommandWithWhatTheyNeed)
{
    const TemporaryFolder folder;
    const std::string ball = folder / "ball.json";
    test::writeBytes(ball, R"({"format": "vitrine-scene", "version": 1, "root": {"kind": "sphere", "radius": 0.2}})");
    struct Case {
        Words words;
        std::string sentence;
    };
    const std::string out = "--out", picture = folder / "a.png", film = folder / "a.mp4", into = folder / "into";
    const std::vector<Case> cases{
        {{"render", "sdf_morph", out, picture, "--settings-only"}, "--settings-only has no effect without --preset;"},
        {{"render", "hall", out, picture, "--rotate", "0,9,0"}, "--rotate has no effect on the hall as a whole;"},
        {{"render", "sdf_morph", out, picture, "--alone", "--model", "a.glb"},
         "--model has no effect on an exhibit that is shown --alone;"},
        {{"record", "fur", out, film, "--shutter-samples", "4"},
         "--shutter-samples has no effect without --shutter above 0;"},
        {{"record", "fur", out, film, "--path", "still", "--turn", "90"},
         "--turn has no effect without --path turntable;"},
        {{"record", "fur", out, film, "--path", "still", "--pace", "eased"},
         "--pace has no effect without --path other than still;"},
        {{"record", "hall", out, film, "--eye", "0,0,0"}, "--eye has no effect on a camera that follows a tour;"},
        {{"record", "hall", out, film, "--path", "still", "--tour", "tour.json"},
         "--tour has no effect without --path tour;"},
        {{"record", "hall", out, film, "--scale", "1,1,2"}, "--scale has no effect on the hall as a whole;"},
        {{"sprite", "a.glb", out, picture, "--palette", "NES", "--colors", "4"},
         "--colors has no effect without --palette own;"},
        {{"sprite", out, picture, "--animation", "walk"}, "--animation has no effect without model;"},
        {{"study", "fur", "shellCount", out, into, "--values", "1,2", "--points", "3"},
         "--points has no effect on a study of --values;"},
        {{"study", "fur", "shellCount", out, into, "--settings", "9"},
         "--settings has no effect on a study of one or two parameters;"},
        {{"study", "hall", out, into, "--alone"}, "--alone has no effect on the hall as a whole;"},
        {{"compare-settings", "fur", "initial", out, into, "--exhibit", "noise"},
         "--exhibit has no effect on an exhibit that is named as A;"},
        {{"mesh", ball, out, folder / "a.stl", "--time", "2"},
         "--time has no effect on a scene in which nothing moves;"},
        {{"doctor", "--presets", "3"}, "--presets has no effect without --stability;"},
        {{"list", "--manual", "fur", "--json"}, "--json has no effect on the table of --manual;"},
        {{"print", out, folder / "a.tif", "--lpi", "60", "--width-mm", "9", "--height-mm", "9", "--chart", "phase",
          "--fit", "crop"},
         "--fit has no effect on a --chart, which has views of its own;"},
        {{"print", out, folder / "a.tif", "--lpi", "60", "--width-mm", "9", "--height-mm", "9", "--chart", "phase",
          "--place", "1:0,5,0"},
         "--place has no effect on a --chart, which has views of its own;"},
        {{"print", out, folder / "a.tif", "--sheet", "60-3d", "--width-mm", "9", "--height-mm", "9", "--views", "a",
          "--conic", "1"},
         "--conic has no effect on a --sheet, whose lenses are known;"},
    };
    for (const Case& each : cases) {
        SCOPED_TRACE(each.sentence);
        const Ended ended = test::vitrine(each.words);
        EXPECT_EQ(ended.code, 2);
        test::expectOneSentence(ended, {each.sentence, "leave it out"});
        const Ended german = test::vitrine(each.words, {{"LC_ALL", "de_DE.UTF-8"}});
        EXPECT_NE(german.err.find("bewirkt nichts"), std::string::npos) << german.err;
        for (const char* english : {" the ", " has ", " which "})
            EXPECT_EQ(german.err.find(english), std::string::npos) << german.err;
    }
    EXPECT_EQ(folder.files(), (Words{"ball.json"}));
}

}  // namespace
}  // namespace vitrine
