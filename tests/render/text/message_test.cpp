// Messages: the English text, the translation with its arguments, and the message of a failure.

#include "render/text/message.h"

#include "render/failure.h"
#include "render/files/read_file.h"
#include "render/text/translation.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

static_assert(placesIn("100 % of {} and {a}") == 0);
static_assert(placesIn("{2} of {1}, {1}") == 2);
static_assert(placesIn("{2}") == -1, "a gap");

const Catalog& germanMessages()
{
    static const Catalog catalog({{"Roughness", "Rauheit"},
                                  {"it is empty", "es ist leer"},
                                  {"Cannot read {1}: {2}", "{=1} kann nicht gelesen werden: {2}"},
                                  {"{1} of {2}", "{2}: {1}"}});
    return catalog;
}

TEST(MessageText, IsEnglishWithItsArgumentsInPlace)
{
    EXPECT_EQ(message("it is empty").english(), "it is empty");
    EXPECT_EQ(message("Cannot read {1}: {2}", std::filesystem::path("a.png"), message("it is empty")).english(),
              "Cannot read a.png: it is empty");
    EXPECT_EQ(message("{1}, {2}{3} of {1}", -1, std::size_t{2}, 'x').english(), "-1, 2x of -1");
    EXPECT_EQ(message("{1}: {2}", "{2}", "b").english(), "{2}: b") << "an argument holds no placeholders";
    EXPECT_TRUE(Message().empty());
    EXPECT_FALSE(message("it is empty").empty());
}

TEST(MessageText, IsTranslatedWithItsMessagesButNotItsNames)
{
    const Message inner = message("it is empty");
    EXPECT_EQ(germanMessages().translated(message("Cannot read {1}: {2}", "Roughness", inner)),
              "Roughness kann nicht gelesen werden: es ist leer");
    EXPECT_EQ(germanMessages().translated(message("{1} of {2}", "Roughness", Message::ofTable("Roughness"))),
              "Rauheit: Roughness");
    EXPECT_EQ(germanMessages().translated(Message::verbatim("Roughness")), "Roughness");
}

TEST(MessageText, OfAnUnmarkedPartIsTranslatedAsAWholeOrNot)
{
    const std::string known = "it is empty", unknown = "the light went out";
    EXPECT_FALSE(message("Cannot read {1}: {2}", "a", Message(known)).isMarked());
    EXPECT_EQ(germanMessages().translated(message("Cannot read {1}: {2}", "a", Message(known))),
              "a kann nicht gelesen werden: es ist leer");
    EXPECT_EQ(germanMessages().translated(message("Cannot read {1}: {2}", "a", Message(unknown))),
              "Cannot read a: the light went out");
}

TEST(MessageText, OfAFailureIsItsEnglishSentence)
{
    const test::TemporaryFolder folder;
    const std::string missing = folder / "missing.png";
    try {
        static_cast<void>(render::readFile(missing, 1));
        FAIL() << "nothing was thrown";
    } catch (const Failure& failure) {
        EXPECT_EQ(failure.message(), "Cannot read " + missing + ": there is no such file; check the name.");
        EXPECT_EQ(failure.what(), failure.message().english());
        EXPECT_TRUE(failure.message().isMarked());
        EXPECT_NE(germanMessages().translated(failure.message()).find(missing + " kann nicht gelesen werden: "),
                  std::string::npos);
    }
}

}  // namespace
}  // namespace vitrine
