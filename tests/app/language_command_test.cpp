// Languages of the command line: errors follow the locale, pictures follow --language only, files are always English.

#include "tests/app/child_process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <regex>

namespace vitrine {
namespace {

using test::Ended;

const test::Environment german{{"LC_ALL", "de_DE.UTF-8"}};

using Words = std::vector<std::string>;

/// Returns calls with every kind of error of the command line itself, and with unreadable files of each kind.
std::vector<Words> wrongCalls(const test::TemporaryFolder& folder)
{
    test::writeBytes(folder / "broken.png", "\x89PNG\r\n\x1a\n");
    test::writeBytes(folder / "twice.json", R"({"format": 1, "format": 2})");
    test::writeBytes(folder / "zero.json", std::string("1\0]", 3));
    test::writeBytes(folder / "lesson.md", "# Title\n");
    test::writeBytes(folder / "text.txt", "text");
    const std::string missing = folder / "missing.png", out = folder / "a.png", film = folder / "a.mp4";
    std::vector<Words> calls{
        {"compare", missing, missing},
        {"compare", folder / "broken.png", folder / "broken.png"},
        {"compare", folder / "text.txt", folder / "text.txt"},
        {"compare", missing, missing, "--metric", "ssm"},
        {"preset", "check", missing},
        {"preset", "check", folder / "twice.json"},
        {"preset", "check", folder / "zero.json"},
        {"scene", "check", folder / "zero.json"},
        {"scene", "check", missing},
        {"mesh", folder / "zero.json", "--out", folder / "a.obj"},
        {"mesh", missing, "--out", folder / "a.stl", "--cell", "0"},
        {"mesh", missing, "--out", folder / "a.stl", "--low", "0,0,0"},
        {"lesson", "check", folder / "lesson.md"},
        {"lesson", "check", missing},
        {"compare-studies", folder / "zero.json", missing, "--out", folder / "b"},
        {"proof", missing, "--angle", "0", "--out", out},
        {"proof", missing, "--angle", "0", "--out", folder / "a.gif"},
        {"merge", out},
        {"open", missing},
        {"list", "--manual", "nobody"},
        {"rende"},
        {"zzzzzzzz"},
        {"--st"},
        {"render"},
        {"preset"},
        {"render", "sdf_morph", "--st", "a"},
        {"render", "sdf_morph", "--out"},
        {"render", "sdf_morph", "one", "two"},
        {"render", "sdf_morph", "--out", out, "--out", out},
        {"render", "sdf_morph", "--out", out, "--alone=perhaps"},
        {"render", "sdf_morfh", "--out", out},
        {"render", "nobody", "--out", out},
        {"render", "hall", "--alone", "--out", out},
        {"render", "sdf_morph", "--out", folder / "a.webp", "--sixteen-bit"},
        {"study", "fur", "--out", folder / "s", "--max-ms", "1", "--max-error", "1"},
        {"print", "--width-mm", "3", "--height-mm", "3", "--view-size", "8x8"},
        {"print", "--width-mm", "3", "--height-mm", "3"},
        {"print", "--width-mm", "3", "--height-mm", "3", "--views", missing, "--out", folder / "a.tif"},
        {"print", "--width-mm", "3", "--height-mm", "3", "--lpi", "60", "--views", missing, "--out", folder / "a.webp"},
        {"print", "--width-mm", "3", "--height-mm", "3", "--lpi", "60", "--quilt", "a", missing, "--out",
         folder / "a.tif"},
        {"record", "fur", "--out", folder / "a.xyz"},
        {"sprite", missing, "--out", out, "--palette", "isel"},
        {"sprite", missing, "--out", folder / "a.webp"},
    };
    for (const Words& more : std::vector<Words>{{"--fov", "nan"},
                                                {"--fov", "0,5"},
                                                {"--samples", "0.5"},
                                                {"--time", "inf"},
                                                {"--size", "8"},
                                                {"--eye", "1,2"},
                                                {"--scale", "0,1,1"},
                                                {"--channels", "paint"},
                                                {"--channels", "depth"},
                                                {"--preset", folder / "twice.json"},
                                                {"--preset", folder / "zero.json"},
                                                {"--preset", "nothing"},
                                                {"--set", "morph"},
                                                {"--set", "morph=abc"},
                                                {"--set", "morph=0,5"},
                                                {"--set", "morf=1"},
                                                {"--set", "zzzzzz=1"},
                                                {"--set", "nobody.morph=1"},
                                                {"--set", "animate=perhaps"},
                                                {"--set", "material=wood"},
                                                {"--animate", "morph=sine"},
                                                {"--animate", "morph=swing:0:1"},
                                                {"--animate", "morph=sine:0:1:period=0"},
                                                {"--animate", "morph=sine:0:1:period=4:period=5"},
                                                {"--animate", "morph=distance:0:1:nearest=5:farthest=1"},
                                                {"--animate", "morph=sine:a:1"},
                                                {"--animate", "morph=sine:0:1:speed=2"}}) {
        calls.push_back({"render", "sdf_morph", "--out", out, "--size", "8x8"});
        calls.back().insert(calls.back().end(), more.begin(), more.end());
    }
    for (const Words& more : std::vector<Words>{{"--pace", "slow"}, {"--seconds", "nan"}, {"--turn", "1e9"}}) {
        calls.push_back({"record", "fur", "--out", film});
        calls.back().insert(calls.back().end(), more.begin(), more.end());
    }
    return calls;
}

/// Removes the parts of a sentence that are equal in both languages: quoted texts, options and file names.
std::string wordsOf(const char* language, std::string text)
{
    for (const char* untranslated : {"\"[^\"]*\"", "`[^`]*`", "„[^“]*“", "--[a-z-]+", "[^ ]*/[^ ]*",
                                     "(von|of) [a-z0-9_]+(, [a-zA-Z0-9_ ]+)*", "[a-z0-9]+(-[a-z0-9]+)+"})
        text = std::regex_replace(text, std::regex(untranslated), "");
    std::string found;
    const std::regex words(language);
    for (std::sregex_iterator at(text.begin(), text.end(), words), end; at != end; ++at) found += at->str() + ' ';
    return found;
}
constexpr const char* english =
    "\\b(the|is|are|of|give|to|from|no|not|and|or|with|such|as|has|than|must|there|cannot|which|"
    "this|it|number|did|mean|needs|takes|what|names|lists|check|read|choose)\\b";
constexpr const char* notEnglish =
    "\\b(der|die|das|ist|sind|Sie|und|oder|nicht|kein|keine|eine|einen|von|bis|mit|kann|gibt|hat|"
    "dieser|braucht|nimmt|kennt|Geben|geben)\\b";

TEST(LongLanguageOfTheCommandLine, EveryErrorIsWholeInThatOfTheLocale)
{
    const test::TemporaryFolder folder;
    for (const Words& words : wrongCalls(folder)) {
        std::string call;
        for (const std::string& word : words) call += word + ' ';
        SCOPED_TRACE(call);
        const Ended plain = test::vitrine(words, {{"LC_ALL", "C.UTF-8"}});
        const Ended translated = test::vitrine(words, german);
        EXPECT_NE(plain.code, 0);
        EXPECT_EQ(translated.code, plain.code);
        const std::string said = plain.err + plain.out, gesagt = translated.err + translated.out;
        EXPECT_NE(said, gesagt);
        EXPECT_EQ(wordsOf(notEnglish, said), "") << said;
        EXPECT_EQ(wordsOf(english, gesagt), "") << gesagt;
    }
}

TEST(LanguageOfTheCommandLine, IsEnglishWhereTheLocaleIsUnknown)
{
    const test::TemporaryFolder folder;
    const Words words{"compare", folder / "missing.png", folder / "missing.png"};
    for (const char* locale : {"C", "C.UTF-8", "xx_YY", "deutsch", ""}) {
        const Ended ended =
            test::vitrine(words, {{"LC_ALL", locale}, {"LC_MESSAGES", ""}, {"LANG", ""}, {"LANGUAGE", ""}});
        EXPECT_NE(ended.err.find("there is no such file"), std::string::npos) << locale << ": " << ended.err;
    }
}

TEST(LongLanguageOfTheCommandLine, ListsAndPicturesAreTheSameInEveryLocale)
{
    const test::TemporaryFolder folder;
    EXPECT_EQ(test::vitrine({"list", "--json"}, german).out, test::vitrine({"list", "--json"}).out);
    // The camera looks straight at the plaque of the first exhibit.
    const auto drawn = [&](const char* name, std::vector<std::string> before, const test::Environment& changes) {
        const std::string file = folder / name;
        for (const char* word : {"render", "hall", "--size", "96x64", "--samples", "1", "--out"})
            before.emplace_back(word);
        before.push_back(file);
        const Ended ended = test::vitrine(before, changes);
        EXPECT_EQ(ended.code, 0) << ended.err;
        return test::bytesOf(file);
    };
    EXPECT_EQ(drawn("a.png", {}, german), drawn("b.png", {}, {}));
}

TEST(LanguageOfTheCommandLine, AnUnknownOneIsUsage)
{
    const Ended ended = test::vitrine({"--language", "xx", "list"});
    EXPECT_EQ(ended.code, 2);
    EXPECT_EQ(ended.out, "");
}

}  // namespace
}  // namespace vitrine
