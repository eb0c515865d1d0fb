#include "render/text/joined.h"

#include "render/text/escaped.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace vitrine {
namespace {

TEST(Joined, HasTheSeparatorBetweenElementsOnly)
{
    const std::vector<std::string> none, words{"a", "", "c"};
    EXPECT_EQ(joined(none), "");
    EXPECT_EQ(joined(std::array<std::string_view, 1>{"a"}), "a");
    EXPECT_EQ(joined(words), "a, , c");
    EXPECT_EQ(joined(words, "|", [](const std::string& word) { return word + word; }), "aa||cc");
}

TEST(Joined, AlternativesHaveOrBeforeTheLast)
{
    using Words = std::vector<std::string_view>;
    EXPECT_EQ(alternatives(Words{}), "");
    EXPECT_EQ(alternatives(Words{"a"}), "a");
    EXPECT_EQ(alternatives(Words{"a", "b"}), "a or b");
    EXPECT_EQ(alternatives(Words{"a", "b", "c"}), "a, b or c");
}

TEST(Escaped, ReplacesWhatMarkupWouldRead)
{
    EXPECT_EQ(escaped(""), "");
    EXPECT_EQ(escaped("5 < 6 & \"7\" > 'x'"), "5 &lt; 6 &amp; &quot;7&quot; &gt; 'x'");
    EXPECT_EQ(escaped("&amp;"), "&amp;amp;");
}

}  // namespace
}  // namespace vitrine
