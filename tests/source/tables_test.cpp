// Rules about parameter tables and the data derived from them.

#include "exhibits/exhibits.h"
#include "exhibits/framework/table/acting.h"
#include "exhibits/framework/table/derive.h"
#include "exhibits/hall/hall_table.h"
#include "exhibits/kit/sdf_parameters.h"
#include "exhibits/study/study_axis.h"
#include "tests/source/source_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string_view>

namespace vitrine {
namespace {

/// Returns all tables by the name of their exhibit. They live as long as the tests.
const std::map<std::string, const Parameters*>& tables()
{
    static const hall::HallTable hall;
    static const auto exhibits = allExhibits();
    static const std::map<std::string, const Parameters*> all = [] {
        std::map<std::string, const Parameters*> result{{"hall", &hall}};
        for (const auto& exhibit : exhibits) result.emplace(std::string(exhibit->name()), &exhibit->parameters());
        return result;
    }();
    return all;
}

struct DeclaredParameter {
    std::string member, name;
};

/// Returns the source text of an exhibit's table, with the parameters that it takes from the kit.
std::string tableText(const std::string& exhibit)
{
    const std::string file = "exhibits/" + exhibit + '/' + exhibit + "_table.h";
    std::string text = test::withoutComments(test::sourceText(file));
    const std::string own = text;
    static const std::regex rows(R"(\nstruct (\w+) : virtual Parameters \{[^]*?\n\};)");
    for (const test::Include& include : test::includesOf(file)) {
        if (!include.target.starts_with("exhibits/kit/")) continue;
        const std::string kit = test::withoutComments(test::sourceText(include.target));
        // If the kit's header has several groups, takes those that the table inherits.
        for (auto match = std::sregex_iterator(kit.begin(), kit.end(), rows); match != std::sregex_iterator(); ++match)
            if (own.find((*match)[1].str()) != std::string::npos) text += match->str();
    }
    return text;
}

/// Returns the parameters declared in a table's header.
std::vector<DeclaredParameter> declaredParameters(const std::string& text)
{
    static const std::regex row(
        R"re((\w+)\s*=\s*(?:this->Parameters::)?(?:real|count|toggle|choice|color|direction|file|text|document)\(\s*"(\w+)")re");
    std::vector<DeclaredParameter> rows;
    for (auto match = std::sregex_iterator(text.begin(), text.end(), row); match != std::sregex_iterator(); ++match)
        rows.push_back({(*match)[1], (*match)[2]});
    return rows;
}

TEST(Tables, EveryParameterIsNamedAfterItsMember)
{
    for (const auto& [exhibit, table] : tables()) {
        const std::vector<DeclaredParameter> rows = declaredParameters(tableText(exhibit));
        std::set<std::string> declared, made;
        for (const DeclaredParameter& row : rows) {
            EXPECT_EQ(row.member, row.name) << exhibit;
            declared.insert(row.name);
        }
        for (const ParameterInfo& parameter : table->rows())
            made.emplace(parameter.array.empty() ? parameter.name : parameter.elementParameter);
        EXPECT_EQ(declared, made) << exhibit;
    }
    EXPECT_NE(declaredParameters(R"(Real morf = real("morph", 1)").front().member, "morph");
}

TEST(Tables, NamesAreUniqueAndFitForPresetsFlagsAndGlsl)
{
    static const std::regex form("[a-z][A-Za-z0-9]*");
    for (const auto& [exhibit, table] : tables()) {
        std::set<std::string_view> seen;
        for (const ParameterInfo& parameter : table->rows()) {
            EXPECT_TRUE(seen.insert(parameter.name).second) << exhibit << '.' << parameter.name;
            EXPECT_TRUE(std::regex_match(std::string(parameter.name), form)) << exhibit << '.' << parameter.name;
        }
    }
}

TEST(Tables, NoTwoGroupsHaveTheSameTitle)
{
    for (const auto& [exhibit, table] : tables()) {
        std::set<std::string_view> seen;
        std::string_view before;
        for (const ParameterInfo& parameter : table->rows()) {
            if (parameter.group == before) continue;
            before = parameter.group;
            EXPECT_TRUE(seen.insert(before).second) << exhibit << ": two headings read " << before;
        }
    }
}

TEST(Tables, EveryExhibitSaysWhatItsAccuracyIs)
{
    for (const auto& [exhibit, table] : tables()) {
        const auto rows = table->rows();
        EXPECT_TRUE(std::any_of(rows.begin(), rows.end(),
                                [](const ParameterInfo& parameter) { return parameter.qualityReference.has_value(); }))
            << exhibit << " has no row marked quality(reference): nothing of it can be studied";
        for (const ParameterInfo& parameter : rows) {
            if (!parameter.qualityReference) continue;
            EXPECT_TRUE(parameter.kind == Kind::real || parameter.kind == Kind::count ||
                        parameter.kind == Kind::choice || parameter.kind == Kind::toggle)
                << exhibit << '.' << parameter.name;
            EXPECT_EQ(nearestLegal(parameter, *parameter.qualityReference), Value(*parameter.qualityReference))
                << exhibit << '.' << parameter.name << ": its reference is not legal";
            EXPECT_GE(derive::sweep(parameter, 3).size(), 2U)
                << exhibit << '.' << parameter.name << ": nothing to vary";
            const bool isChecked = parameter.exactByMeaning || !study::exactness(parameter).neighbors.empty();
            EXPECT_TRUE(isChecked || !parameter.isNumeric())
                << exhibit << '.' << parameter.name
                << ": no study can check its reference: let its scale be logarithmic, or say exactAt";
        }
    }
}

// A panel opens with them: one that does nothing yet would waste its place.
TEST(Tables, EveryExhibitAndTheHallNameSixEssentialsOfLookAndTechnique)
{
    for (const auto& [exhibit, table] : tables()) {
        const ParameterValues initial = table->initial();
        int essentials = 0, techniques = 0;
        for (std::size_t i = 0; i < initial.rows().size(); ++i) {
            const ParameterInfo& row = initial.rows()[i];
            if (!row.essential) continue;
            ++essentials;
            if (row.qualityReference) ++techniques;
            EXPECT_TRUE(acts(initial, i)) << exhibit << '.' << row.name << " has no effect at first";
            EXPECT_NE(row.kind, Kind::text) << exhibit << '.' << row.name << " is a text";
        }
        EXPECT_EQ(essentials, 6) << exhibit;
        EXPECT_GE(techniques, 1) << exhibit << ": name a parameter of accuracy, too";
        EXPECT_LT(techniques, essentials) << exhibit << ": name a parameter of the look, too";
    }
}

TEST(Tables, HelpIsOneOrTwoSentences)
{
    constexpr std::array<std::string_view, 8> notFirst = {"Of",    "What", "Where", "Whoever",
                                                          "Whose", "Who",  "That",  "Those"};
    for (const auto& [exhibit, table] : tables()) {
        for (const ParameterInfo& parameter : table->rows()) {
            const std::string help(parameter.help);
            ASSERT_GE(help.size(), 10U) << exhibit << '.' << parameter.name;
            EXPECT_TRUE(help.back() == '.') << exhibit << '.' << parameter.name << ": " << help;
            EXPECT_FALSE(std::islower(static_cast<unsigned char>(help.front())))
                << exhibit << '.' << parameter.name << ": " << help;
            const std::string first = help.substr(0, help.find(' '));
            EXPECT_EQ(std::find(notFirst.begin(), notFirst.end(), first), notFirst.end())
                << exhibit << '.' << parameter.name << " does not begin with its subject: " << help;
        }
    }
}

TEST(Tables, RangesHoldTheInitialValueAndTheComfortableRange)
{
    for (const auto& [exhibit, table] : tables()) {
        for (const ParameterInfo& parameter : table->rows()) {
            SCOPED_TRACE(exhibit + '.' + std::string(parameter.name));
            const std::optional<Value> legal = nearestLegal(parameter, parameter.initial);
            ASSERT_TRUE(legal);
            // Directions are normalized again, which may round. Numbers must stay exactly the same.
            if (parameter.kind != Kind::direction) {
                EXPECT_EQ(*legal, parameter.initial);
            }
            if (parameter.kind != Kind::real && parameter.kind != Kind::count) continue;
            EXPECT_LT(parameter.range.low, parameter.range.high);
            EXPECT_LE(parameter.range.low, parameter.range.softLow);
            EXPECT_LT(parameter.range.softLow, parameter.range.softHigh);
            EXPECT_LE(parameter.range.softHigh, parameter.range.high);
            EXPECT_LE(parameter.range.softLow, std::get<double>(parameter.initial));
            EXPECT_GE(parameter.range.softHigh, std::get<double>(parameter.initial));
            if (parameter.range.scale == Scale::logarithmic) {
                EXPECT_GT(parameter.range.low, 0);
            }
            if (parameter.qualityReference) {
                EXPECT_EQ(*nearestLegal(parameter, *parameter.qualityReference), Value(*parameter.qualityReference));
            }
        }
    }
}

/// Returns the source text that may read an exhibit's parameters: its own files except for the table. Parameters of the
/// hall may also be read by the museum, and those of the kit by the kit.
std::string readersOf(const std::string& exhibit)
{
    std::string text;
    const auto append = [&](const std::string& file) {
        if (!file.ends_with("_table.h")) text += test::withoutComments(test::sourceText(file));
    };
    for (const std::string& file : test::sourceFiles("exhibits/" + exhibit, test::cppExtensions)) append(file);
    for (const std::string& file : test::sourceFiles("shaders", test::glslExtensions))
        if (file.starts_with("shaders/" + exhibit + '/')) append(file);
    if (exhibit == "hall") append("exhibits/museum/museum.cpp");
    if (tableText(exhibit).find("struct SdfParameters") != std::string::npos) {
        for (const std::string& file : test::sourceFiles("exhibits/kit", test::cppExtensions))
            if (!file.ends_with("_rows.h")) append(file);
        for (const std::string& file : test::sourceFiles("shaders/kit/sdf", test::glslExtensions)) append(file);
    }
    return text;
}

bool isRead(const std::string& text, const ParameterInfo& parameter)
{
    // C++ reads the parameter from the table, or from one group of an array, or a shader reads it from its block.
    // Parameters that are not part of the picture are found by name through a constant: `supersamplesParameter`.
    const std::string name(parameter.array.empty() ? parameter.name : parameter.elementParameter);
    const std::string from = parameter.array.empty() ? "\\b(parameters|table|table_|t|parameters\\(\\)|rows\\(\\))"
                                                     : "(\\b" + std::string(parameter.array) + "\\[[^;]*\\]|\\brows)";
    if (text.find("find(" + name + "Row)") != std::string::npos) return true;
    // List of fields, whose names select the parameters for a struct.
    if (text.find("FIELD(float, " + name + ")") != std::string::npos) return true;
    // The pattern is tried only at occurrences of the name, because trying it everywhere takes half a minute.
    const std::regex reads(from + "(\\.|->)" + name + "\\b");
    constexpr std::size_t before = 300;
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
        const std::size_t first = at > before ? at - before : 0;
        if (std::regex_search(text.substr(first, at - first + name.size() + 1), reads)) return true;
    }
    return false;
}

bool isRead(const std::string& text, std::string_view row)
{
    return isRead(text, ParameterInfo{.name = row});
}

TEST(Tables, EveryParameterIsReadByItsOwnExhibit)
{
    // Every parameter must have an effect.
    for (const auto& [exhibit, table] : tables()) {
        const std::string text = readersOf(exhibit);
        for (const ParameterInfo& parameter : table->rows())
            EXPECT_TRUE(isRead(text, parameter)) << exhibit << '.' << parameter.name;
    }
    // A parameter of one exhibit is not read because another exhibit reads its own of the same name.
    EXPECT_TRUE(isRead(readersOf("sdf_morph"), "refractiveIndex"));
    EXPECT_FALSE(isRead(readersOf("fur"), "refractiveIndex"));
    EXPECT_FALSE(isRead(readersOf("hall"), "tessellation"));
}

/// Returns the table whose fields a shader may use; null: none.
const Parameters* dynamicParameters(const std::string& file, const std::string& exhibit)
{
    // Shaders of fields use the parameters of every field, and those of a material kind the parameters of a material.
    struct FieldTable final : SdfParameters {};
    struct MaterialTable final : SdfMaterialParameters {};
    static const FieldTable field;
    static const MaterialTable material;
    if (file == "shaders/kit/sdf/even_material.glsl") return &material;
    if (exhibit == "kit") return &field;
    return tables().contains(exhibit) ? tables().at(exhibit) : nullptr;
}

TEST(Tables, ShadersUseOnlyFieldsThatTheirTableHas)
{
    static const std::regex field(R"(\bparameters\.(\w+))");
    int found = 0;
    for (const std::string& file : test::sourceFiles("shaders", test::glslExtensions)) {
        const std::string exhibit = file.substr(8, file.find('/', 8) - 8);
        const std::string text = test::withoutComments(test::sourceText(file));
        for (auto match = std::sregex_iterator(text.begin(), text.end(), field); match != std::sregex_iterator();
             ++match) {
            const Parameters* table = dynamicParameters(file, exhibit);
            ASSERT_TRUE(table) << file << " uses " << match->str() << " but belongs to no exhibit";
            const std::string name = (*match)[1];
            ++found;
            EXPECT_NE(derive::uniformBlock(*table).find(' ' + name + ';'), std::string::npos) << file << ": " << name;
        }
    }
    EXPECT_GT(found, 10);
    EXPECT_EQ(derive::uniformBlock(*tables().at("sdf_morph")).find(" noSuchField;"), std::string::npos);
}

TEST(Tables, ParametersBearNamesThatAreKeysFlagsAndFields)
{
    for (const auto& [exhibit, table] : tables())
        for (const ParameterInfo& parameter : table->rows())
            EXPECT_TRUE(isParameterName(parameter.name)) << exhibit << '.' << parameter.name;
    for (const char* bad : {"", "1st", "two words", "under_score", "quote\"", "a=b", "caf\u00e9"})
        EXPECT_FALSE(isParameterName(bad)) << bad;
}

TEST(Tables, TheUniformBlockHasTheBytesThatStd140Asks)
{
    // Rules of OpenGL 4.5, 7.6.2.2: scalars align to 4; vec3 aligns to 16 and takes 12; a block ends on a multiple of
    // 16.
    for (const auto& [exhibit, table] : tables()) {
        std::size_t expected = 0;
        for (const ParameterInfo& parameter : table->rows()) {
            if (parameter.isWritten()) continue;
            const bool vector = parameter.kind == Kind::color || parameter.kind == Kind::direction;
            expected = vector ? (expected + 15) / 16 * 16 + 12 : expected + 4;
        }
        EXPECT_EQ(derive::uniformBytes(table->initial()).size(), (expected + 15) / 16 * 16) << exhibit;
    }
}

TEST(Tables, TheSweepOfAStudyHoldsBothEndsAndTheInitialValue)
{
    for (const auto& [exhibit, table] : tables()) {
        for (const ParameterInfo& parameter : table->rows()) {
            const std::vector<double> points = derive::sweep(parameter, 7);
            SCOPED_TRACE(exhibit + '.' + std::string(parameter.name));
            if (parameter.kind == Kind::color || parameter.kind == Kind::direction || parameter.isWritten()) {
                EXPECT_TRUE(points.empty());
                continue;
            }
            const auto has = [&](double x) { return std::find(points.begin(), points.end(), x) != points.end(); };
            EXPECT_TRUE(has(std::get<double>(parameter.initial)));
            if (parameter.kind == Kind::real || parameter.kind == Kind::count) {
                EXPECT_TRUE(has(parameter.range.softLow));
                EXPECT_TRUE(has(parameter.range.softHigh));
            }
            for (const double x : points) EXPECT_EQ(*nearestLegal(parameter, x), Value(x));
        }
    }
}

}  // namespace
}  // namespace vitrine
