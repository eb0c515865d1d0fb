#include "render/files/json_text.h"
#include "tests/support/sanitized.h"

#include <gtest/gtest.h>

#include <random>

namespace vitrine::render {
namespace {

const std::string sample =
    "{ \"a\" : [1, -2.5e3 ,\"x\\ny\"],\n  \"b\": {\"c\\u0041\":true, \"d\" :null, \"e\": {} } ,\n\t\"f\":[]}\n";

TEST(JsonText, KnowsWhereEveryValueStands)
{
    const JsonText json(sample, "s.json");
    const std::pair<const char*, const char*> values[] = {{"a[0]", "1"},    {"a[1]", "-2.5e3"}, {"a[2]", "\"x\\ny\""},
                                                          {"b.cA", "true"}, {"b.d", "null"},    {"b.e", "{}"},
                                                          {"f", "[]"}};
    for (const auto& [path, written] : values) {
        const auto index = json.at(path);
        ASSERT_TRUE(index) << path;
        EXPECT_EQ(json.written(*index), written);
        EXPECT_EQ(json.path(*index), path);
    }
    EXPECT_EQ(json.string(json.at("a[2]").value()), "x\ny");
    EXPECT_EQ(json.number(json.at("a[1]").value()), -2500);
    EXPECT_EQ(json.position(json.at("b.d").value()).line, 2);
    EXPECT_EQ(json.position(json.at("b.d").value()).column, 25);
    EXPECT_EQ(json.position(json.at("f").value()).column, 2);
    for (const char* path : {"a[3]", "b.x", "a.b", "c", "a[", "b[0]"}) EXPECT_FALSE(json.at(path)) << path;
}

/// Random JSON text with random white space, in the order of writing.
class RandomText {
public:
    explicit RandomText(unsigned seed) : random_(seed) { add(0); }
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    unsigned pick(unsigned count) { return static_cast<unsigned>(random_()) % count; }
    void blank()
    {
        for (unsigned n = pick(3); n > 0; --n) text_ += " \n\t\r"[pick(4)];
    }
    void list(int depth, char open, char close, bool named)
    {
        text_ += open;
        const unsigned count = pick(4);
        for (unsigned i = 0; i < count; ++i) {
            blank();
            if (i > 0) text_ += ',';
            blank();
            if (named) text_ += "\"k\\\"" + std::to_string(i) + "\"";
            blank();
            if (named) text_ += ':';
            add(depth + 1);
        }
        blank();
        text_ += close;
    }
    void add(int depth)
    {
        blank();
        const unsigned kind = pick(depth < 5 ? 8 : 6);
        if (kind == 6) list(depth, '[', ']', false);
        if (kind == 7) list(depth, '{', '}', true);
        const char* plain[] = {"null", "true", "-12", "0.5e-3", "\"\\u00e9 \\\\\\\"]}, :\"", "7"};
        if (kind < 6) text_ += plain[kind];
        blank();
    }

    std::mt19937 random_;
    std::string text_;
};

/// The library's own reader gives the expected places.
TEST(JsonText, KnowsThePlacesOfRandomTexts)
{
    for (unsigned seed = 0; seed < 2000; ++seed) {
        const RandomText random(seed);
        const JsonText json(random.text(), "s.json");
        const Json root = Json::parse(random.text());
        std::vector<const Json*> inOrder{&root};
        std::size_t count = 0;
        for (std::uint32_t i = 0; i < json.values().size(); ++i) {
            ASSERT_EQ(i, count++);
            ASSERT_LT(i, inOrder.size()) << random.text();
            const Json& value = *inOrder[i];
            EXPECT_EQ(Json::parse(json.written(i)), value) << random.text();
            const std::vector<std::uint32_t> children = json.children(i);
            ASSERT_EQ(children.size(), value.is_structured() ? value.size() : 0U) << random.text();
            std::size_t n = 0;
            for (const auto& [key, child] : value.items()) {
                if (!value.is_structured()) break;
                EXPECT_EQ(json.value(children[n]).parent, i);
                EXPECT_EQ(json.key(children[n]), value.is_object() ? key : std::string());
                if (inOrder.size() <= children[n]) inOrder.resize(children[n] + 1);
                inOrder[children[n++]] = &child;
            }
        }
        EXPECT_EQ(inOrder.size(), json.values().size());
    }
}

TEST(JsonText, HasNoByteOrderMark)
{
    const JsonText json("\xEF\xBB\xBF{}", "s.json");
    EXPECT_EQ(json.text(), "{}");
    EXPECT_EQ(json.withMember(0, "a", "1"), "{\"a\": 1}");
    EXPECT_EQ(json.position(0).column, 1);
}

TEST(JsonText, RefusesAZeroByteAndWalksNoFurther)
{
    for (const std::string& behind : {std::string(), std::string("]"), std::string("}\"")})
        EXPECT_THROW(JsonText(std::string("1\0", 2) + behind, "s.json"), JsonFailure);
}

TEST(JsonText, TakesOutPutsInAndRenamesAndKeepsTheRest)
{
    const JsonText json(sample, "s.json");
    const auto edited = [&](const std::string& from, const std::string& to) {
        std::string text = sample;
        text.replace(text.find(from), from.size(), to);
        return text;
    };
    EXPECT_EQ(json.withValue(json.at("a[1]").value(), "7"), edited("-2.5e3", "7"));
    EXPECT_EQ(json.without(json.at("a[0]").value()), edited("1, ", ""));
    EXPECT_EQ(json.without(json.at("a[1]").value()), edited(", -2.5e3", ""));
    EXPECT_EQ(json.without(json.at("a[2]").value()), edited(" ,\"x\\ny\"", ""));
    EXPECT_EQ(json.without(json.at("b").value()),
              edited(",\n  \"b\": {\"c\\u0041\":true, \"d\" :null, \"e\": {} }", ""));
    EXPECT_EQ(json.withMember(0, "f", "[1]"), edited("[]", "[1]"));
    EXPECT_EQ(json.withMember(json.at("b").value(), "g", "3"), edited("\"e\": {}", "\"e\": {}, \"g\": 3"));
    EXPECT_EQ(json.withMember(json.at("b.e").value(), "h", "4"), edited("{} }", "{\"h\": 4} }"));
    EXPECT_EQ(json.withElement(json.at("f").value(), 0, "1"), edited("[]", "[1]"));
    EXPECT_EQ(json.withElement(json.at("a").value(), 1, "9"), edited("1, -2.5e3", "1, 9, -2.5e3"));
    EXPECT_EQ(json.withKey(json.at("b.d").value(), "q\"q"), edited("\"d\"", "\"q\\\"q\""));
}

TEST(JsonText, RefusesWhatTheStrictReaderRefusesWithItsPlace)
{
    try {
        const JsonText json("{\n \"a\": 1,\n \"a\": 2}", "s.json");
        FAIL();
    } catch (const JsonFailure& failure) {
        EXPECT_EQ(failure.place().file, "s.json");
        EXPECT_EQ(failure.place().line, 3);
        EXPECT_EQ(failure.place().column, 4);
        EXPECT_EQ(failure.place().key, "a");
        EXPECT_NE(std::string(failure.what()).find("s.json, line 3, column 4, a: "), std::string::npos);
    }
}

/// After any sequence of edits that change values and restore them, the text is JSON of the same content.
TEST(JsonText, RandomEditsLeaveJson)
{
    std::mt19937 random(3);
    for (int i = 0; i < (test::isSanitized ? 300 : 3000); ++i) {
        std::string text = sample;
        for (int edit = 0; edit < 4; ++edit) {
            const JsonText json(text, "s.json");
            const auto index = static_cast<std::uint32_t>(random() % json.values().size());
            const JsonSpan& span = json.value(index);
            const bool isChild = span.parent != JsonSpan::none;
            if (random() % 3 == 0 && isChild)
                text = json.without(index);
            else if (span.type == JsonSpan::Type::object)
                text = json.withMember(index, "k" + std::to_string(random() % 3), "[0]");
            else if (span.type == JsonSpan::Type::array)
                text = json.withElement(index, random() % 3, "{\"z\": 1}");
            else
                text = json.withValue(index, "\"other\"");
        }
        EXPECT_NO_THROW(static_cast<void>(JsonText(text, "s.json"))) << text;
    }
}

}  // namespace
}  // namespace vitrine::render
