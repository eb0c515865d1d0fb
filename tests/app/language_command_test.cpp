// The languages of the command line: errors by the locale, pictures by --language alone, files always English.

#include "tests/app/child_process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

using test::Ended;

const test::Environment german{{"LC_ALL", "de_DE.UTF-8"}};

/// The two sentences of one failure.
struct Said {
    std::vector<std::string> words;
    const char* english;
    const char* german;
};

std::vector<Said> failures(const test::TemporaryFolder& folder)
{
    test::writeBytes(folder / "broken.png", "\x89PNG\r\n\x1a\n");
    test::writeBytes(folder / "twice.json", R"({"format": 1, "format": 2})");
    const std::string missing = folder / "missing.png";
    return {
        {{"compare", missing, missing}, "there is no such file; check the name.", "eine solche Datei gibt es nicht"},
        {{"compare", folder / "broken.png", folder / "broken.png"}, "Cannot read ", " kann nicht gelesen werden: "},
        {{"render", "sdf_morph", "--preset", folder / "twice.json", "--out", folder / "a.png"},
         "this key stands twice; remove one of the two",
         "dieser Schlüssel steht zweimal da; entfernen Sie einen der beiden"},
    };
}

TEST(LanguageOfTheCommandLine, ErrorsAreInThatOfTheLocale)
{
    const test::TemporaryFolder folder;
    for (const Said& said : failures(folder)) {
        const Ended english = test::vitrine(said.words, {{"LC_ALL", "C.UTF-8"}});
        const Ended translated = test::vitrine(said.words, german);
        EXPECT_EQ(translated.code, english.code);
        EXPECT_NE(english.err.find(said.english), std::string::npos) << english.err;
        EXPECT_NE(translated.err.find(said.german), std::string::npos) << translated.err;
        EXPECT_EQ(translated.err.find(said.english), std::string::npos) << translated.err;
    }
}

TEST(LanguageOfTheCommandLine, IsEnglishWhereTheLocaleIsUnknown)
{
    const test::TemporaryFolder folder;
    const Said said = failures(folder).front();
    for (const char* locale : {"C", "C.UTF-8", "xx_YY", "deutsch", ""}) {
        const Ended ended =
            test::vitrine(said.words, {{"LC_ALL", locale}, {"LC_MESSAGES", ""}, {"LANG", ""}, {"LANGUAGE", ""}});
        EXPECT_NE(ended.err.find(said.english), std::string::npos) << locale << ": " << ended.err;
    }
}

TEST(LanguageOfTheCommandLine, ListsAndPicturesAreTheSameInEveryLocale)
{
    const test::TemporaryFolder folder;
    EXPECT_EQ(test::vitrine({"list", "--json"}, german).out, test::vitrine({"list", "--json"}).out);
    // Straight at the plaque of the first exhibit.
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
