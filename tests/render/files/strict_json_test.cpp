#include "render/files/strict_json.h"

#include "tests/support/failures.h"
#include "tests/support/german_locale.h"
#include "tests/support/sanitized.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace vitrine;
using render::Json;
using render::JsonDocument;
using render::parseJson;
using render::writeJson;

std::string nested(std::size_t depth)
{
    return std::string(depth, '[') + std::string(depth, ']');
}

TEST(StrictJson, ReadsWhatTheGrammarAllows)
{
    const auto document =
        parseJson(R"( {"b": [1, -2, 3.5, 4e-324, true, false, null], "a": {"text": "é\u00e9\"\\\n"}} )", "x.json");
    EXPECT_EQ(document.root()["b"][3].get<double>(), 4e-324);
    EXPECT_EQ(document.root()["a"]["text"].get<std::string>(), "éé\"\\\n");
    EXPECT_EQ(document.root().begin().key(), "b") << "the order of keys is kept";
}

TEST(StrictJson, RefusesAKeyThatStandsTwiceAndNamesLineAndPath)
{
    EXPECT_FAILURE(parseJson("{\n  \"values\": {\n    \"a\": 1,\n    \"a\": 2\n  }\n}", "x.json"),
                   "x.json, line 4, column 7, values.a: this key appears twice");
}

TEST(StrictJson, RefusesNumbersBeyondDouble)
{
    EXPECT_FAILURE(parseJson("{\n\"a\": 1e999}", "x.json"), "line 2, column 10, a: the number 1e999 is too large");
    EXPECT_FAILURE(parseJson("[-1e400]", "x.json"), "column 7");
    EXPECT_FAILURE(parseJson("1e400", "x.json"), "column 5");
    EXPECT_FAILURE(parseJson("[NaN]", "x.json"), "not valid JSON");
    EXPECT_FAILURE(parseJson("[Infinity]", "x.json"), "not valid JSON");
}

TEST(StrictJson, RefusesControlCharactersInKeysAndNulAnywhere)
{
    EXPECT_FAILURE(parseJson(R"({"a\u0001": 1})", "x.json"), "control character");
    EXPECT_FAILURE(parseJson(R"({"a\u0000b": 1})", "x.json"), "control character");
    EXPECT_FAILURE(parseJson(R"({"a": "b\u0000"})", "x.json"), "U+0000");
}

TEST(StrictJson, RefusesAZeroByteWithItsPlace)
{
    const auto with = [](const std::string& before, const std::string& behind) {
        return before + std::string(1, '\0') + behind;
    };
    EXPECT_FAILURE(parseJson(with("1", "]"), "x.json"), "x.json, line 1, column 2: here is a zero byte");
    EXPECT_FAILURE(parseJson(with("{\n \"a\": 1}\n", "garbage"), "x.json"),
                   "x.json, line 3, column 1: here is a zero byte");
    EXPECT_FAILURE(parseJson(with("[1", ",2]"), "x.json"), "column 3: here is a zero byte");
    EXPECT_FAILURE(parseJson(with("[\"a", "b\"]"), "x.json"), "column 4: here is a zero byte");
    EXPECT_FAILURE(parseJson(with("", "1"), "x.json"), "line 1, column 1: here is a zero byte");
    EXPECT_FAILURE(parseJson(with("1", ""), "x.json"), "line 1, column 2: here is a zero byte");
}

TEST(StrictJson, TakesAByteOrderMarkOfUtf8AndRefusesUtf16)
{
    const auto document = parseJson("\xEF\xBB\xBF{\"a\": 1}", "x.json");
    EXPECT_EQ(document.root()["a"], 1);
    EXPECT_EQ(document.lineOf("a"), 1);
    EXPECT_FAILURE(parseJson("\xEF\xBB\xBF{\"a\" 1}", "x.json"), "line 1");
    EXPECT_FAILURE(parseJson("\xEF\xBB\xBF\xEF\xBB\xBF{}", "x.json"), "two byte order marks");
    EXPECT_FAILURE(parseJson(std::string("\xFF\xFE{\0}\0", 6), "x.json"), "UTF-16");
}

TEST(StrictJson, RefusesWhatIsNotJson)
{
    EXPECT_FAILURE(parseJson("", "x.json"), "empty");
    EXPECT_FAILURE(parseJson("{} x", "x.json"), "line 1, column 4");
    EXPECT_FAILURE(parseJson("{\"a\": 1,\n}", "x.json"), "line 2");
    EXPECT_FAILURE(parseJson("[1, // no\n2]", "x.json"), "not valid JSON");
    EXPECT_FAILURE(parseJson("[\"\xC0\x80\"]", "x.json"), "UTF-8");
    EXPECT_FAILURE(parseJson(R"(["\ud800"])", "x.json"), "surrogate");
    EXPECT_FAILURE(parseJson("{\"a\"", "x.json"), "not valid JSON");
    EXPECT_FAILURE(parseJson("{'a': 1}", "x.json"), "not valid JSON");
    EXPECT_FAILURE(parseJson("\x9F\x01\x02{}", "x.json"), "this is binary data and not JSON");
    EXPECT_FAILURE(parseJson(std::string("PNG\0\1", 5), "x.json"), "this is binary data and not JSON");
    EXPECT_FAILURE(parseJson("yes", "x.json"), "not valid JSON");  // Control: this is text.
}

TEST(StrictJson, KeepsItsLimits)
{
    EXPECT_NO_THROW((void)parseJson(nested(64), "x.json"));
    EXPECT_FAILURE(parseJson(nested(65), "x.json"), "more than 64 deep");
    EXPECT_FAILURE(parseJson(nested(200'000), "x.json"), "more than 64 deep");
    EXPECT_FAILURE(parseJson("[1,2,3,4]", "x.json", {.nodes = 4}), "more than 4 values");
    EXPECT_NO_THROW((void)parseJson("[1,2,3]", "x.json", {.nodes = 4}));
    EXPECT_FAILURE(parseJson("[\"12345\"]", "x.json", {.stringBytes = 4}), "longer than 4 bytes");
    EXPECT_FAILURE(parseJson("{\"12345\":1}", "x.json", {.stringBytes = 4}), "longer than 4 bytes");
    EXPECT_FAILURE(parseJson("[1,2,3]", "x.json", {.bytes = 4}), "more than the 4 allowed");
}

TEST(StrictJson, ReadsAHundredThousandKeysOfOneObjectInTime)
{
    std::string text = "{";
    for (int i = 0; i < 100'000; ++i) text += "\"k" + std::to_string(i) + "\":1,";
    text.back() = '}';
    EXPECT_EQ(parseJson(text, "x.json").root().size(), 100'000U);
}

TEST(StrictJson, SaysOnWhichLineAKeyStands)
{
    const auto document = parseJson("{\n \"a\": {\n  \"b.c\": 1,\n  \"d\": [1,\n 2, {\"e\":\n 3}]\n }\n}", "x.json");
    EXPECT_EQ(document.lineOf("a"), 2);
    EXPECT_EQ(document.lineOf("a.b.c"), 3);
    EXPECT_EQ(document.lineOf("a.d"), 4);
    EXPECT_EQ(document.lineOf("a.d[1]"), 5);
    EXPECT_EQ(document.lineOf("a.d[2].e"), 5);
    EXPECT_EQ(document.lineOf("a.missing"), 2) << "the nearest one above";
    EXPECT_EQ(document.lineOf("nothing"), 1);
    EXPECT_STREQ(document.failure("a.d[1]", "is odd.").what(), "x.json, line 5, a.d[1]: is odd.");
}

TEST(StrictJson, GivesTheErrorOfAValueItsPlace)
{
    const auto document = parseJson("{\n \"a: b\": 1}", "x.json, line 9");
    const FilePlace at = document.failure("a: b", "line 7, column 3, c: is odd.").place();
    EXPECT_EQ(at.file, "x.json, line 9");
    EXPECT_EQ(at.line, 2);
    EXPECT_EQ(at.column, 0);
    EXPECT_EQ(at.key, "a: b");
    const FilePlace whole = document.failure("", "line 7, column 3, c: is odd.").place();
    EXPECT_EQ(whole.file, "x.json, line 9");
    EXPECT_EQ(whole.line, 0) << "the text is no place";
    EXPECT_EQ(whole.key, "");
}

TEST(StrictJson, WritesTextThatDiffsWell)
{
    const Json json = Json::parse(R"({"b": 1.5, "a": [0.1, 2], "c": {}, "d": ["x"], "whole": 2.0, "count": 2})");
    EXPECT_EQ(writeJson(json), "{\n  \"b\": 1.5,\n  \"a\": [0.1, 2],\n  \"c\": {},\n  \"d\": [\n    \"x\"\n  ],\n  "
                               "\"whole\": 2.0,\n  \"count\": 2\n}\n");
}

TEST(StrictJson, WritesNoNumberThatIsNotFinite)
{
    Json json;
    json["values"]["exposure"] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FAILURE(writeJson(json), "values.exposure is not a finite number");
    json["values"]["exposure"] = std::numeric_limits<double>::infinity();
    EXPECT_FAILURE(writeJson(json), "not a finite number");
    EXPECT_FAILURE(writeJson(Json("\xff")), "UTF-8");
}

TEST(StrictJson, WritesAsciiForPlacesThatNeedIt)
{
    EXPECT_EQ(render::asciiJson("{\"é\": \"漢😀\"}"), R"({"\u00e9": "\u6f22\ud83d\ude00"})");
    EXPECT_EQ(Json::parse(render::asciiJson("[\"漢😀\"]"))[0].get<std::string>(), "漢😀");
    EXPECT_FAILURE(render::asciiJson("[\"\xff\"]"), "UTF-8");
}

TEST(StrictJson, IsTheSameInAGermanLocale)
{
    const test::GermanLocale german;
    if (!german.active()) GTEST_SKIP() << "no German locale here";
    EXPECT_EQ(parseJson("[0.5]", "x.json").root()[0].get<double>(), 0.5);
    EXPECT_EQ(writeJson(Json::array({0.5})), "[0.5]\n");
    EXPECT_FAILURE(parseJson("[0,5.5.5]", "x.json"), "not valid JSON");
}

TEST(StrictJson, RefusesFilesThatAreNone)
{
    const test::TemporaryFolder folder;
    EXPECT_FAILURE(render::readJson(folder / "missing.json"), "there is no such file");
    EXPECT_FAILURE(render::readJson(folder.path()), "not a regular file");
}

TEST(StrictJson, NeverCrashesOnDamagedText)
{
    const std::string good =
        R"({"format":"vitrine-preset","values":{"a":[1,2.5e-3,true],"b":"\u00e9\n","c":{"d":null}}})";
    std::mt19937 generator(1);
    const auto random = [&generator] { return static_cast<unsigned>(generator()); };
    for (int i = 0; i < (test::isSanitized ? 2'000 : 20'000); ++i) {
        std::string text = good;
        for (unsigned n = random() % 4 + 1; n > 0; --n) text[random() % text.size()] = static_cast<char>(random());
        text.resize(random() % 8 == 0 ? random() % text.size() : text.size());
        try {
            const auto document = parseJson(text, "x.json");
            EXPECT_EQ(writeJson(parseJson(writeJson(document.root()), "y.json").root()), writeJson(document.root()));
        } catch (const Failure& failure) {
            EXPECT_TRUE(std::string(failure.what()).starts_with("x.json"));
        }
    }
}

}  // namespace
