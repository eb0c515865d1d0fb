// Usage errors: exit code 2 and one sentence that says what to type.

#include "render/version.h"
#include "tests/app/child_process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <regex>
#include <sstream>

namespace vitrine {
namespace {

using namespace test;

TEST(Usage, HelpNeedsNeitherDisplayNorOpenGl)
{
    // With a driver that does not exist, any use of OpenGL would fail.
    const test::Environment noGl{
        {"GALLIUM_DRIVER", "none"}, {"MESA_LOADER_DRIVER_OVERRIDE", "none"}, {"QT_QPA_PLATFORM", "none"}};
    const Ended help = test::vitrine({"--help"}, noGl);
    EXPECT_EQ(help.code, 0);
    EXPECT_EQ(help.err, "");
    for (const char* command : {"list", "render", "record", "study", "compare-studies", "compare", "compare-settings",
                                "preset", "scene", "sprite", "mesh", "proof", "serve", "doctor"})
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

/// Tests are not told the commit: `programVersion` is the number alone here.
TEST(Usage, VersionIsTheNumberAndTheCommit)
{
    const Ended ended = test::vitrine({"--version"});
    EXPECT_EQ(ended.code, 0);
    EXPECT_TRUE(std::regex_match(ended.out,
                                 std::regex("vitrine " + render::programVersion() + "(\\+[0-9a-f]{7,40}(-dirty)?)?\n")))
        << ended.out;
    // Neither an archive nor a machine without git tells it.
    const bool isKnown = std::system("git -C " VITRINE_SOURCE_DIR " rev-parse HEAD > /dev/null 2>&1") == 0;
    EXPECT_EQ(ended.out.find('+') != std::string::npos, isKnown) << ended.out;
    EXPECT_EQ(render::programVersion(), "0.2.0");
}

TEST(Usage, DoctorNamesTheVersionOfTheProgram)
{
    const std::string version = test::vitrine({"--version"}).out;
    const std::string number = version.substr(8, version.size() - 9);
    EXPECT_NE(test::vitrine({"doctor", "--json"}).out.find('"' + number + '"'), std::string::npos);
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

/// Runs `render` with a few more arguments, and expects that no picture is written.
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

TEST(Usage, MisspelledWordsGetASuggestion)
{
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
        {{"--set", "morp=0.5"}, "did you mean morph?"},
        {{"--animate", "morph=sin:0:1"}, "did you mean sine?"},
        {{"--channels", "colr"}, "did you mean color?"},
    };
    for (const auto& [words, suggestion] : cases) {
        const Ended ended = refused(words);
        EXPECT_EQ(ended.code, 2) << words[1];
        expectOneSentence(ended, {suggestion});
    }
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
    for (const char* name : {"x.bmp", "x", "x.exr.bak"}) {
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

/// Returns the commands listed in a help text.
std::vector<std::string> commandsIn(const std::string& help)
{
    std::vector<std::string> names;
    std::istringstream lines(help.substr(std::min(help.find("Subcommands:"), help.size())));
    std::string line;
    while (std::getline(lines, line))
        if (line.size() > 2 && line.starts_with("  ") && line[2] != ' ')
            names.push_back(line.substr(2, line.find(' ', 2) - 2));
    return names;
}

struct NumberOption {
    std::vector<std::string> command;
    std::string name;
    std::string words;  ///< Words that it accepts besides numbers: "|inf|auto".
};

/// Returns all options of all commands that take a number, from their help texts.
std::vector<NumberOption> numberOptions()
{
    std::vector<std::vector<std::string>> commands{{}};
    std::vector<NumberOption> found;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        std::vector<std::string> words = commands[i];
        words.emplace_back("--help");
        const std::string help = test::vitrine(words).out;
        for (const std::string& below : commandsIn(help)) {
            commands.push_back(commands[i]);
            commands.back().push_back(below);
        }
        for (const char* unchecked : {" FLOAT", " INT", " UINT"})
            EXPECT_EQ(help.find(unchecked), std::string::npos) << "a number that is not checked: " << words.front();
        const std::regex option("\n  (--[a-z-]+) (?:NUMBER|-?[0-9][^ ]*?\\.\\.)[^ |=]*((?:\\|[a-z]+)*)");
        for (std::sregex_iterator at(help.begin(), help.end(), option), end; at != end; ++at)
            found.push_back({commands[i], (*at)[1], (*at)[2]});
    }
    return found;
}

TEST(LongUsageOfNumbers, EveryOptionRefusesWhatIsNone)
{
    const std::vector<NumberOption> options = numberOptions();
    EXPECT_GT(options.size(), 50U);
    const std::vector<std::string> always{"nan", "0,5"},
        inTurn{"inf", "-inf", "-nan", "1e400", "abc", "", "0x10", "1e+"};
    std::size_t turn = 0;
    for (const NumberOption& option : options) {
        std::vector<std::string> typed = always;
        while ((option.words + '|').find('|' + inTurn[turn % inTurn.size()] + '|') != std::string::npos) ++turn;
        typed.push_back(inTurn[turn++ % inTurn.size()]);
        for (const std::string& number : typed) {
            std::vector<std::string> words = option.command;
            words.push_back(option.name);
            words.push_back(number);
            if (number.starts_with('-')) {
                words.pop_back();
                words.back() += '=' + number;
            }
            const Ended ended = test::vitrine(words);
            SCOPED_TRACE((option.command.empty() ? "the window" : option.command.front()) + ' ' + option.name + ' ' +
                         number);
            EXPECT_EQ(ended.code, 2);
            if (number == "0,5")
                expectOneSentence(ended, {option.name + " \"0,5\": ", "decimal point", "write 0.5."});
            else
                expectOneSentence(ended, {option.name + " \"" + number + "\": give a "});
        }
    }
}

TEST(UsageOfNumbers, TakesUnitsAndNamesTheRangeInTheUnitThatWasTyped)
{
    const auto noteOf = [](const std::string& typed) {
        return test::vitrine({"list", "--set", "noise.sunElevation=" + typed}).err;
    };
    const std::string plain = noteOf("12"), withUnit = noteOf("95deg");
    EXPECT_NE(plain.find("12 was changed to 1.57"), std::string::npos) << plain;
    EXPECT_NE(plain.find(" rad; degrees are written 12deg)"), std::string::npos) << plain;
    EXPECT_EQ(plain.find("°"), std::string::npos) << plain;
    EXPECT_NE(withUnit.find("95deg was changed to 90°, the nearest allowed value (a number from -5 to 90°)"),
              std::string::npos)
        << withUnit;
    for (const char* angle : {"200deg", "4rad", "200"}) {
        const Ended ended = refused({"--fov", angle});
        EXPECT_EQ(ended.code, 2);
        expectOneSentence(ended, {std::string("--fov \"") + angle + "\": give a number from 1 to 175°."});
    }
    const Ended zero = refused({"--fov", "0"});
    EXPECT_EQ(zero.code, 2) << "0 is no angle, and not the same as nothing";
    expectOneSentence(refused({"--set", "morph=0,5"}), {"--set morph \"0,5\"", "write 0.5."});
}

TEST(UsageOfNumbers, OfPrintsAreThoseOfTheWindow)
{
    const test::TemporaryFolder folder;
    const auto refusedPrint = [&](const std::string& option, const std::string& number) {
        std::vector<std::string> words{"print", "--views", folder / "none", "--out", folder / "x.tif", "--lpi", "60"};
        for (const char* size : {"--width-mm", "--height-mm"})
            if (option != size) words.insert(words.end(), {size, "30"});
        words.insert(words.end(), {option, number});
        const Ended ended = test::vitrine(words);
        EXPECT_EQ(ended.code, 2) << option;
        expectOneSentence(ended, {option + " \"" + number + "\": give a number from "});
    };
    refusedPrint("--width-mm", "1e6");
    refusedPrint("--bleed-mm", "1e6");
    refusedPrint("--effective-lpi", "-1");
    refusedPrint("--ink-um", "1e300");
    const Ended quilt = test::vitrine({"print", "--width-mm", "30", "--height-mm", "30", "--lpi", "60", "--out",
                                       folder / "x.tif", "--quilt", "a", folder / "q.png"});
    EXPECT_EQ(quilt.code, 2);
    expectOneSentence(quilt, {"--quilt 8x6 quilt.png"});
}

/// The views do not exist: a size that is checked only after reading them would be reported as a missing folder.
TEST(UsageOfNumbers, TooLargeForAFileIsRefusedBeforeAnythingIsReadOrDrawn)
{
    const test::TemporaryFolder folder;
    const auto expectRefused = [&](const char* name, const std::vector<std::string>& size, int code,
                                   const std::string& sentence) {
        std::vector<std::string> words{"print", "--views", folder / "none", "--out", folder / name, "--lpi", "60"};
        words.insert(words.end(), size.begin(), size.end());
        const Ended ended = test::vitrine(words);
        EXPECT_EQ(ended.code, code) << ended.err;
        expectOneSentence(ended, {sentence});
    };
    expectRefused("x.tif", {"--width-mm", "99999", "--height-mm", "30"}, 2, "which ends at 1048576 per side");
    expectRefused(
        "x.tif", {"--width-mm", "30", "--height-mm", "30", "--bleed-mm", "999", "--border-mm", "999", "--dpi", "99999"},
        2, "which ends at 1048576 per side");
    // 2362181 x 2362181 pixels of 3 bytes, a quarter of which is needed, plus a tenth: 4.6e12 bytes.
    expectRefused("x.png", {"--width-mm", "99999", "--height-mm", "99999", "--dpi", "600"}, 5, "it needs 46034");
    // 2362181 x 236197 pixels of 3 bytes plus a tenth: 1.8412e12 bytes.
    expectRefused("x.tif", {"--width-mm", "99999", "--height-mm", "9999", "--tile-mm", "30", "--dpi", "600"}, 5,
                  "it needs 18412");
    const Ended sprite = test::vitrine({"sprite", "none.glb", "--size", "20000x20", "--out", folder / "s.png"});
    EXPECT_EQ(sprite.code, 2);
    expectOneSentence(sprite, {"--size 20000x20 \"20000\": give a whole number from 1 to 16384."});
}

TEST(Usage, WhatWasMistypedIsNamedWithItsCommandAndWhatIsNear)
{
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
        {{"rende", "sdf_morph", "--out", "q.png"},
         "`vitrine` has no command \"rende\"; did you mean render? `vitrine --help`"},
        {{"zzzzzz"}, "`vitrine` has no command \"zzzzzz\"; `vitrine --help`"},
        {{"--no-such"}, "`vitrine` has no option --no-such; `vitrine --help`"},
        {{"render", "sdf_morph", "--st", "morph=1"}, "`vitrine render` has no option --st; did you mean --set?"},
        {{"render", "sdf_morph", "--sam=3"}, "`vitrine render` has no option --sam; did you mean --samples?"},
        {{"render", "sdf_morph", "one", "two", "--out", "x.png"}, "takes no further argument, and \"one\" is one"},
        {{"scene", "chek", "a.json"}, "`vitrine scene` has no command \"chek\"; did you mean check?"},
        {{"render"}, "`vitrine render` needs exhibit; `vitrine render --help`"},
        {{"render", "sdf_morph"}, "`vitrine render` needs --out;"},
        {{"preset"}, "`vitrine preset` needs a command;"},
        {{"preset", "check"}, "`vitrine preset check` needs files;"},
        {{"render", "sdf_morph", "--out"}, "--out needs a value behind it"},
        {{"render", "sdf_morph", "--out", "a.png", "--out", "b.png"}, "--out was given more than once"},
        {{"render", "sdf_morph", "--out", "a.png", "--alone=maybe"}, "--alone takes no value"},
        {{"study", "fur", "--out", "x", "--max-ms", "1", "--max-error", "1"}, "exclude each other; give one of them."},
        {{"print", "--width-mm", "3", "--height-mm", "3", "--view-size", "8x8"},
         "--view-size has no effect without --exhibit;"},
        {{"render", "sdf_morfh", "--out", "/nowhere/x.png"},
         "There is no exhibit \"sdf_morfh\"; did you mean sdf_morph?"},
        {{"list", "--set", "sdf_morph.morf=1"}, "did you mean morph?"},
        {{"list", "--set", "sdfmorph.morph=1"}, "did you mean sdf_morph?"},
        {{"sprite", "--out", "x.png", "--palette", "isel"}, "--palette \"isel\": did you mean isle? give one of own, "},
        {{"--language", "xx", "list"}, "--language \"xx\": give one of en, de."},
        {{"record", "fur", "--out", "x.mp4", "--pace", "slow"}, "--pace \"slow\": give one of auto, constant, eased."},
        {{"open", "/nowhere/a.json"}, "Cannot open /nowhere/a.json: there is no such file"},
        {{"--serve", "/tmp/none.socket", "list"}, "--serve is an option of the window, and list opens none;"},
        {{"--kiosk", "--serve", "/tmp/none.socket"}, "--serve and --kiosk exclude each other; give one of them."},
        {{"--kiosk-minutes", "3"}, "--kiosk-minutes has no effect without --kiosk;"},
        {{"--kiosk", "--kiosk-minutes", "0"}, "--kiosk-minutes \"0\": give a number from 0.1 to 1440"},
        {{"study", "fur", "--out", "x", "--metric", "ssm"},
         "did you mean dssim? give one of rmse, max, beyond, mape, relmse, dssim, flip, normal, depth."},
    };
    for (const auto& [words, part] : cases) {
        const Ended ended = test::vitrine(words);
        EXPECT_EQ(ended.code, 2) << part;
        expectOneSentence(ended, {part});
    }
}

TEST(Usage, ErrorsAreOneExactSentenceOnTheWordThatWasTypedFirst)
{
    const std::string lists = " --help` lists what it has.\n", says = " --help` says what it takes.\n";
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
        {{"rendre", "fur"}, "`vitrine` has no command \"rendre\"; did you mean render? `vitrine" + lists},
        {{"--lang", "de"}, "`vitrine` has no option --lang; did you mean --language? `vitrine" + lists},
        {{"render", "sdf_morph", "--sampels", "3", "--sise", "8x8", "--out", "x.png"},
         "`vitrine render` has no option --sampels; did you mean --samples? `vitrine render" + lists},
        {{"render", "sdf_morph", "--frobnicate", "--out", "x.png"},
         "`vitrine render` has no option --frobnicate; `vitrine render" + lists},
        {{"render", "sdf_morph", "--size", "0x9", "--samples", "0", "--st", "a=1", "--out", "x.png"},
         "--size 0x9 \"0\": give a whole number from 1 to 1000000, or auto.\n"},
        {{"render", "sdf_morph", "--samples", "0", "--size", "0x9", "--out", "x.png"},
         "--samples \"0\": give a whole number from 1 to 4096, or auto.\n"},
        {{"render", "sdf_morph", "--st", "a=1", "--samples", "0", "--out", "x.png"},
         "`vitrine render` has no option --st; did you mean --set? `vitrine render" + lists},
        {{"preset", "chek", "a.json"},
         "`vitrine preset` has no command \"chek\"; did you mean check? `vitrine preset" + lists},
        {{"print", "--widthmm", "3"},
         "`vitrine print` has no option --widthmm; did you mean --width-mm? `vitrine print" + lists},
        {{"doctor", "cats"}, "`vitrine doctor` takes no further argument, and \"cats\" is one; `vitrine doctor" + says},
        {{"list", "cats"}, "list: there is no exhibit \"cats\"; `vitrine list` names them.\n"},
        {{"record", "fur", "--out", "x.mp4", "--pace", "ease"},
         "--pace \"ease\": did you mean eased? give one of auto, constant, eased.\n"},
        {{"render", "sdf_morph", "--set", "material=glas", "--out", "x.png"},
         "--set material: \"glas\" is not a value for it; did you mean glass? give one of opaque, glass.\n"},
        {{"render", "sdf_morph", "--set", "mroph=1", "--out", "x.png"},
         "--set mroph: sdf_morph has no parameter of that name; did you mean morph? `vitrine list --json` names "
         "them.\n"},
    };
    for (const auto& [words, sentence] : cases) {
        const Ended ended = test::vitrine(words);
        EXPECT_EQ(ended.code, 2) << sentence;
        EXPECT_EQ(ended.err, "vitrine: " + sentence);
        EXPECT_EQ(ended.out, "") << sentence;
    }
}

TEST(Usage, AMistypedPresetNamesTheNearestOne)
{
    const Ended ended = refused({"--preset", "glas"});
    EXPECT_EQ(ended.code, 5);
    expectOneSentence(ended,
                      {"There is neither a file nor a preset of sdf_morph named glas; did you mean glass? its presets "
                       "are a-box-too-small, "});
}

TEST(Usage, TheLanguageMayStandBehindTheCommand)
{
    const test::Environment english{{"LC_ALL", "C.UTF-8"}};
    EXPECT_EQ(test::vitrine({"list", "--language", "de"}, english).code, 0);
    const Ended german = test::vitrine({"render", "nobody", "--out", "x.png", "--language", "de"}, english);
    EXPECT_EQ(german.code, 2);
    EXPECT_NE(german.err.find("Exponat"), std::string::npos) << german.err;
}

TEST(Usage, HelpHasAShortName)
{
    EXPECT_EQ(test::vitrine({"render", "-h"}).out, test::vitrine({"render", "--help"}).out);
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
