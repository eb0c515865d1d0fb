// Document parameters: the content of a file, edited and not yet written.

#include "exhibits/framework/files/preset.h"
#include "exhibits/framework/table/derive.h"
#include "exhibits/framework/table/value_text.h"
#include "tests/support/blocks.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

const std::string text = "{\n  \"a\": \"b\\n\",\t\"c\": [1, 2]\n}\n";

const test::BlocksExhibit& blocks()
{
    static const test::BlocksExhibit exhibit;
    return exhibit;
}

ParameterValues named(const std::string& file, const std::string& document)
{
    ParameterValues values = blocks().parameters().initial();
    values.set(blocks().parameters().pile, file);
    values.set(blocks().parameters().document, document);
    return values;
}

TEST(Documents, AreTextsThatGiveRowsAsTheirFilesDo)
{
    const ParameterInfo& row = blocks().parameters().rows()[blocks().parameters().document.row];
    EXPECT_EQ(row.kind, Kind::text);
    EXPECT_EQ(row.documentOf, "pile");
    EXPECT_TRUE(row.isWritten());
    EXPECT_EQ(named("a", text).tableFiles(), (std::vector<std::string>{"a", text}));
    EXPECT_EQ(parseValue(row, text), Value(text)) << "blanks at both ends, too";
    EXPECT_EQ(formatValue(row, text), text);
    EXPECT_EQ(toString(row.kind), "text");
    EXPECT_EQ(nearestLegal(row, 1.0), std::nullopt);
}

TEST(Documents, GoWithTheirFile)
{
    const File pile = blocks().parameters().pile, document = blocks().parameters().document;
    ParameterValues values = named("a", text);
    EXPECT_TRUE(values.chooseFile(pile.row, std::string("a")));
    EXPECT_EQ(values[document], text);
    EXPECT_TRUE(values.chooseFile(pile.row, std::string("b")));
    EXPECT_EQ(values[document], "");
    EXPECT_EQ(values[pile], "b");
    values = named("a", text);
    values.setParameter(pile.row, std::string("b"));
    EXPECT_EQ(values[document], text) << "whoever reads a preset sets one row after the other";
}

TEST(Documents, StandInPresetsToTheByte)
{
    const ParameterValues values = named("a.json", text);
    const Preset written{"blocks", "Mine", values, {}};
    const Preset read = parsePreset(presetText(written), "mine.json", "blocks", blocks().parameters());
    EXPECT_EQ(read.values[blocks().parameters().document], text);
    EXPECT_TRUE(read.notes.empty());
}

TEST(Documents, AreNothingForShaders)
{
    EXPECT_EQ(derive::uniformBlock(blocks().parameters()), "");
    EXPECT_TRUE(derive::uniformBytes(named("a", text)).empty());
}

TEST(Documents, OfTablesWithTheSameParametersAreTold)
{
    const test::BlocksExhibit other;
    EXPECT_TRUE(blocks().parameters().hasParametersOf(other.parameters()));
    MadeTable one, two;
    static_cast<void>(one.toggle("a", true, "What."));
    static_cast<void>(two.toggle("a", false, "What."));
    EXPECT_FALSE(one.hasParametersOf(two)) << "another initial value";
}

}  // namespace
}  // namespace vitrine
