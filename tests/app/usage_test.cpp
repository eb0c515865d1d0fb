// What is typed wrongly: exit code 2 and one sentence that says what to type.

#include "tests/app/child_process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace vitrine {
namespace {

using test::Ended;
using test::expectOneSentence;

TEST(Usage, HelpNeedsNeitherDisplayNorOpenGl)
{
    // With a driver that does not exist, anything that touches OpenGL would fail.
    const test::Environment noGl{
        {"GALLIUM_DRIVER", "none"}, {"MESA_LOADER_DRIVER_OVERRIDE", "none"}, {"QT_QPA_PLATFORM", "none"}};
    const Ended help = test::vitrine({"--help"}, noGl);
    EXPECT_EQ(help.code, 0);
    EXPECT_EQ(help.err, "");
    for (const char* command : {"list", "render", "record", "study", "compare-studies", "compare", "compare-settings",
                                "preset", "scene", "sprite", "serve", "doctor"})
        EXPECT_NE(help.out.find(command), std::string::npos) << command;
    EXPECT_NE(help.out.find("Exit codes"), std::string::npos);
    const Ended render = test::vitrine({"render", "--help"}, noGl);
    EXPECT_EQ(render.code, 0);
    for (const char* option :
         {"--out", "--size", "--preset", "--set", "--time", "--seed", "--eye", "--target", "--fov", "--scale",
          "--rotate", "--alone", "--samples", "--transparent", "--channels", "--environment", "--model", "--report"})
        EXPECT_NE(render.out.find(option), std::string::npos) << option;
    EXPECT_EQ(test::vitrine({"list"}, noGl).code, 0);
}

TEST(Usage, VersionIsANumber)
{
    const Ended ended = test::vitrine({"--version"});
    EXPECT_EQ(ended.code, 0);
    EXPECT_EQ(ended.out, std::string("vitrine ") + VITRINE_VERSION + "\n");
}

TEST(Usage, WhatIsUnknownIsUsage)
{
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{{"--no-such-option"},
                                                                                       {"no-such-command"},
                                                                                       {"list", "--xml"},
                                                                                       {"render"},
                                                                                       {"render", "sdf_morph"},
                                                                                       {"preset"},
                                                                                       {"preset", "check"}}) {
        const Ended ended = test::vitrine(words);
        EXPECT_EQ(ended.code, 2) << words.front();
        EXPECT_EQ(ended.out, "") << words.front();
        EXPECT_NE(ended.err, "") << words.front();
    }
}

/// Renders with a few more arguments; the picture must not be there afterwards.
Ended refused(std::vector<std::string> more, const std::string& exhibit = "sdf_morph")
{
    const test::TemporaryFolder folder;
    std::vector<std::string> words{"render", exhibit, "--out", folder / "x.png"};
    if (std::find(more.begin(), more.end(), "--size") == more.end()) words.insert(words.end(), {"--size", "8x8"});
    words.insert(words.end(), more.begin(), more.end());
    const Ended ended = test::vitrine(words);
    EXPECT_TRUE(folder.files().empty());
    return ended;
}

TEST(Usage, AnUnknownExhibitIsNamed)
{
    const Ended ended = refused({}, "sdf_melt");
    EXPECT_EQ(ended.code, 2);
    expectOneSentence(ended, {"sdf_melt", "vitrine list"});
}

TEST(Usage, ABadSettingNamesItsKeyAndWhatItTakes)
{
    const auto expectUsage = [](const std::string& assignment, const std::vector<std::string>& parts) {
        const Ended ended = refused({"--set", assignment});
        EXPECT_EQ(ended.code, 2) << assignment;
        expectOneSentence(ended, parts);
        EXPECT_EQ(ended.err.find(" ."), std::string::npos) << ended.err;
    };
    expectUsage("morf=0.5", {"morf", "list"});
    expectUsage("morph=soup", {"morph", "soup", "0 to 1"});
    expectUsage("morph=nan", {"morph"});
    expectUsage("material=wood", {"material", "opaque", "glass"});
    expectUsage("animate=perhaps", {"animate", "on or off"});
    expectUsage("nobody.morph=1", {"nobody"});
    expectUsage("morph", {"name=value"});
    expectUsage("hall.morph=1", {"morph", "hall"});
}

TEST(Usage, BadNumbersNameTheirOption)
{
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
        {{"--size", "0x9"}, "--size"},           {{"--size", "9"}, "--size"},
        {{"--size", "1e9x3"}, "--size"},         {{"--eye", "1,2"}, "--eye"},
        {{"--target", "a,b,c"}, "--target"},     {{"--fov", "500"}, "--fov"},
        {{"--scale", "1,0,1"}, "--scale"},       {{"--rotate", "nan,0,0"}, "--rotate"},
        {{"--samples", "0"}, "--samples"},       {{"--time", "inf"}, "--time"},
        {{"--channels", "depth"}, "--channels"}, {{"--channels", "paint"}, "--channels"}};
    for (const auto& [words, option] : cases) {
        const Ended ended = refused(words);
        EXPECT_EQ(ended.code, 2) << words[1];
        EXPECT_EQ(ended.out, "");
        EXPECT_NE(ended.err.find(option), std::string::npos) << ended.err;
    }
}

TEST(Usage, ASizeThatNoMachineHasMemoryForIsRefusedWithOneThatItHas)
{
    for (const char* size : {"1000000x1000000", "1000000x700000"}) {
        const Ended ended = refused({"--size", size});
        EXPECT_EQ(ended.code, 2) << size;
        expectOneSentence(ended, {"1000000 × ", "GB of memory", "ask for no more than"});
    }
    const Ended beyond = refused({"--size", "2000000x10"});
    EXPECT_EQ(beyond.code, 2);
    expectOneSentence(beyond, {"--size", "1 to 1000000"});
}

TEST(Usage, APictureOfUnknownKindIsRefusedBeforeItIsDrawn)
{
    const test::TemporaryFolder folder;
    for (const char* name : {"x.jpg", "x", "x.exr.bak"}) {
        const Ended ended = test::vitrine({"render", "sdf_morph", "--out", folder / name});
        EXPECT_EQ(ended.code, 2) << name;
        expectOneSentence(ended, {".png", ".exr"});
    }
    EXPECT_TRUE(folder.files().empty());
}

TEST(Usage, TheHallCannotBeAlone)
{
    const Ended ended = refused({"--alone"}, "hall");
    EXPECT_EQ(ended.code, 2);
    expectOneSentence(ended, {"--alone"});
}

TEST(OldMachine, WithoutOpenGl45OneSentenceAndExit3)
{
    const test::TemporaryFolder folder;
    const Ended ended = test::vitrine({"render", "sdf_morph", "--size", "8x8", "--out", folder / "x.png"},
                                      {{"MESA_GL_VERSION_OVERRIDE", "3.3"}});
    EXPECT_EQ(ended.code, 3);
    expectOneSentence(ended, {"OpenGL 3.3 found", "4.5 needed"});
    EXPECT_TRUE(folder.files().empty());
}

TEST(OldMachine, SaysWhichVersionWasFound)
{
    const test::TemporaryFolder folder;
    const Ended ended = test::vitrine({"render", "sdf_morph", "--size", "8x8", "--out", folder / "x.png"},
                                      {{"GALLIUM_DRIVER", "softpipe"}});
    EXPECT_EQ(ended.code, 3);
    expectOneSentence(ended, {"3.3", "4.5"});
}

TEST(NoDisplay, TheWindowSaysSoInOneSentence)
{
    const Ended ended = test::vitrine({}, {{"QT_QPA_PLATFORM", ""}});
    EXPECT_NE(ended.code, 0);
    EXPECT_LT(ended.code, 128) << "ended by a signal";
    expectOneSentence(ended, {"display"});
}

}  // namespace
}  // namespace vitrine
