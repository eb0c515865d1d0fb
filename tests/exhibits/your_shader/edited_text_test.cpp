// Texts of shaders as they are edited: values, errors with their places, templates. No context is needed.

#include "exhibits/framework/files/file_path.h"
#include "exhibits/framework/table/morph.h"
#include "exhibits/your_shader/guest_work.h"
#include "exhibits/your_shader/your_shader.h"
#include "render/files/assets.h"
#include "render/files/read_file.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

const std::string text = "uniform float gain; // 0 .. 10, default 2\n"
                         "uniform float bias; // 0 .. 1, default 0.5\n"
                         "void main() { gl_FragColor = vec4(gain, bias, 0.0, 1.0); }\n";

class EditedTexts : public testing::Test {
protected:
    [[nodiscard]] EditedText edited(const ParameterValues& values, const std::string& of)
    {
        return exhibit_.withText(values, of, assets_);
    }
    [[nodiscard]] static double number(const ParameterValues& values, const char* row)
    {
        return std::get<double>(values.row(values.table().find(row).value()));
    }
    [[nodiscard]] ParameterValues initial() const { return exhibit_.parameters().initial(); }

    guest::YourShader exhibit_;
    render::AssetStore assets_;
};

TEST_F(EditedTexts, BecomeTheShaderAndTakeTheValuesOfInputsThatStay)
{
    EditedText first = edited(initial(), text);
    ASSERT_TRUE(first.isShown);
    EXPECT_EQ(exhibit_.unsavedText(first.values), text);
    first.values.setParameter(first.values.table().find("gain").value(), 7.0);
    std::string other = text;
    other.replace(other.find("uniform float bias"), 18, "uniform float tilt");
    other.replace(other.find("bias, 0.0"), 4, "tilt");
    const EditedText second = edited(first.values, other);
    ASSERT_TRUE(second.isShown);
    EXPECT_EQ(number(second.values, "gain"), 7);
    EXPECT_EQ(number(second.values, "tilt"), 0.5);
    EXPECT_FALSE(second.values.table().find("bias"));
    EXPECT_EQ(exhibit_.dynamicParameters(second.values, assets_).table, second.values.sharedTable());
}

TEST_F(EditedTexts, HaveInputsThatAreBlendedLikeOtherParameters)
{
    const EditedText shown = edited(initial(), text);
    ASSERT_TRUE(shown.isShown);
    ParameterValues other = shown.values;
    other.setParameter(other.table().find("gain").value(), 6.0);
    other.setParameter(other.table().find("bias").value(), 1.0);
    const ParameterValues between = morphed(shown.values, other, 0.25);
    EXPECT_DOUBLE_EQ(number(between, "gain"), 3);
    EXPECT_DOUBLE_EQ(number(between, "bias"), 0.625);
    EXPECT_EQ(exhibit_.unsavedText(between), text);
    EXPECT_EQ(between.sharedTable(), shown.values.sharedTable());
}

TEST_F(EditedTexts, WithErrorsAreKeptBesideTheLastGoodOne)
{
    const EditedText good = edited(initial(), text);
    std::string wrong = text;
    wrong.replace(wrong.find("vec4("), 5, "vec5(");
    const EditedText bad = edited(good.values, wrong);
    EXPECT_FALSE(bad.isShown);
    ASSERT_FALSE(bad.findings.empty());
    EXPECT_EQ(bad.findings.front().line, 3);
    EXPECT_EQ(bad.findings.front().column, 30) << "the place of vec5 in its line";
    EXPECT_EQ(bad.findings.front().file, exhibit_.document(bad.values).path);
    EXPECT_EQ(exhibit_.unsavedText(bad.values), wrong);
    EXPECT_EQ(exhibit_.documentText(bad.values), wrong);
    EXPECT_EQ(bad.values.sharedTable(), good.values.sharedTable());
    EXPECT_EQ(exhibit_.dynamicParameters(bad.values, assets_).table, good.values.sharedTable());
    ParameterValues dropped = bad.values;
    exhibit_.dropUnsaved(dropped);
    EXPECT_EQ(exhibit_.unsavedText(dropped), "");
}

TEST_F(EditedTexts, ThatAreEmptyAreErrors)
{
    const EditedText empty = edited(initial(), "");
    EXPECT_FALSE(empty.isShown);
    ASSERT_EQ(empty.findings.size(), 1U);
    EXPECT_NE(empty.findings.front().sentence.english().find("empty"), std::string::npos);
    EXPECT_NE(exhibit_.unsavedText(empty.values), "");
}

TEST_F(EditedTexts, BeginFromTemplatesOfEveryForm)
{
    std::vector<guest::Form> forms;
    for (const TextTemplate& each : exhibit_.templates()) {
        ParameterValues values = initial();
        values.set(exhibit_.parameters().file, each.file);
        const DocumentPlace place = exhibit_.document(values);
        EXPECT_FALSE(place.writable) << each.file;
        const auto reading = guest::readWork(place.path, assets_);
        ASSERT_TRUE(reading->table) << each.file << ": " << reading->why.english();
        EXPECT_TRUE(reading->findings.empty()) << each.file;
        EXPECT_TRUE(reading->table->work->readsTime) << each.file;
        EXPECT_GE(reading->table->rows().size(), exhibit_.parameters().rows().size() + 2) << each.file;
        forms.push_back(reading->table->work->shader->form);
    }
    EXPECT_EQ(forms, (std::vector{guest::Form::plain, guest::Form::isf, guest::Form::shadertoy}));
}

TEST_F(EditedTexts, OfTheFirstShaderHaveItsInputsBeforeAFileIsChosen)
{
    const DynamicParameters first = exhibit_.dynamicParameters(initial(), assets_);
    ASSERT_TRUE(first.table);
    const std::string path = (render::asset("shaders") / guest::YourShaderTable::firstShader).string();
    EXPECT_EQ(exhibit_.document(initial()).path, path);
    EXPECT_EQ(exhibit_.documentText(initial()), render::readFile(path, 1 << 20));
    // The same parameters as those of the file by its path.
    ParameterValues named = initial();
    named.set(exhibit_.parameters().file, path);
    const DynamicParameters read = exhibit_.dynamicParameters(named, assets_);
    ASSERT_TRUE(read.table) << read.why.english();
    EXPECT_TRUE(first.table->hasParametersOf(*read.table));
    EXPECT_GT(first.table->rows().size(), exhibit_.parameters().rows().size());
    // So it is where the name was taken away.
    ParameterValues none = initial();
    none.set(exhibit_.parameters().file, std::string());
    EXPECT_EQ(exhibit_.dynamicParameters(none, assets_).table, first.table);
}

TEST(FilePaths, OfTheProgramsOwnFilesMayHaveAFolder)
{
    const guest::YourShader exhibit;
    const ParameterInfo& row = exhibit.parameters().rows()[exhibit.parameters().file.row];
    const auto own = [](const char* name) { return (render::asset("shaders") / name).string(); };
    EXPECT_EQ(filePath(row, "ink.fs"), own("ink.fs"));
    EXPECT_EQ(filePath(row, "templates/isf.fs"), own("templates/isf.fs"));
    for (const char* other : {"no-such.fs", "templates/no-such.fs", "../presets/hall", "/tmp/ink.fs", ""})
        EXPECT_EQ(filePath(row, other), other);
}

}  // namespace
}  // namespace vitrine
