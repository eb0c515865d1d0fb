// Errors in GLSL that compile on one driver and break on another.

#include "tests/source/source_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace vitrine {
namespace {

/// Returns the `out` parameters of functions that are read before they are written, as "function:parameter".
std::vector<std::string> readBeforeWritten(const std::string& source)
{
    static const std::regex function(R"((\w+)\s*\(([^(){};]*\bout\s[^(){};]*)\)\s*\{)");
    static const std::regex parameter(R"(\bout\s+\w+\s+(\w+))");
    std::vector<std::string> found;
    const std::string text = test::withoutComments(source);
    for (auto f = std::sregex_iterator(text.begin(), text.end(), function); f != std::sregex_iterator(); ++f) {
        const std::string parameters = (*f)[2];
        auto end = static_cast<std::size_t>(f->position() + f->length());
        const std::size_t begin = end;
        for (int depth = 1; end < text.size() && depth > 0; ++end)
            depth += text[end] == '{' ? 1 : text[end] == '}' ? -1 : 0;
        const std::string body = text.substr(begin, end - begin);
        for (auto p = std::sregex_iterator(parameters.begin(), parameters.end(), parameter);
             p != std::sregex_iterator(); ++p) {
            const std::string name = (*p)[1];
            std::smatch first;
            if (!std::regex_search(body, first, std::regex("\\b" + name + "\\b"))) {
                found.push_back((*f)[1].str() + ':' + name + " (never written)");
                continue;
            }
            // Written completely: `name = ...`. Writing a component, or `+=`, reads or leaves undefined values.
            const std::string after = first.suffix();
            if (!std::regex_search(after, std::regex(R"(^\s*=[^=])"))) found.push_back((*f)[1].str() + ':' + name);
        }
    }
    return found;
}

TEST(Shaders, ReadNoOutParameterBeforeItIsWritten)
{
    for (const std::string& file : test::sourceFiles("shaders", test::glslExtensions))
        for (const std::string& fault : readBeforeWritten(test::sourceText(file)))
            ADD_FAILURE() << file << ": " << fault;

    EXPECT_EQ(readBeforeWritten("void f(float a, out vec3 n) { n.x += a; n = vec3(0.0); }").size(), 1U);
    EXPECT_EQ(readBeforeWritten("float f(out float d)\n{\n  return min(d, 1.0);\n}").size(), 1U);
    EXPECT_EQ(readBeforeWritten("float f(out float d)\n{\n  d = 1.0;\n  return d;\n}").size(), 0U);
    EXPECT_EQ(readBeforeWritten("layout(location = 0) out vec4 color; void main() { color = vec4(1.0); }").size(), 0U);
}

/// Body of a function, without comments and preprocessor lines.
struct Function {
    std::string name, body;
};

std::vector<Function> functionsOf(const std::string& source)
{
    static const std::regex head(R"(\b(\w+)\s*\([^(){};]*\)\s*\{)");
    static const std::regex keyword("if|for|while|switch");
    const std::string text =
        std::regex_replace(test::withoutComments(source), std::regex(R"((^|\n)[ ]*#[^\n]*)"), "$1");
    std::vector<Function> functions;
    for (auto f = std::sregex_iterator(text.begin(), text.end(), head); f != std::sregex_iterator(); ++f) {
        if (std::regex_match((*f)[1].str(), keyword)) continue;
        const auto begin = static_cast<std::size_t>(f->position() + f->length());
        std::size_t end = begin;
        for (int depth = 1; end < text.size() && depth > 0; ++end)
            depth += text[end] == '{' ? 1 : text[end] == '}' ? -1 : 0;
        functions.push_back({(*f)[1], text.substr(begin, end - begin)});
    }
    return functions;
}

/// Returns the calls of these functions in a body that not every pixel of a quad may reach: behind a discard or return,
/// in a nested block, or in a statement with a condition.
std::vector<std::string> conditionalCalls(const std::string& body, const std::set<std::string>& names)
{
    static const std::regex call(R"(\b(\w+)\s*\()");
    static const std::regex leaves(R"(\b(discard|return)\b[^;]*;)");
    static const std::regex condition(R"(\b(if|for|while)\b|\?|&&|\|\|)");
    std::vector<std::string> found;
    for (auto c = std::sregex_iterator(body.begin(), body.end(), call); c != std::sregex_iterator(); ++c) {
        if (!names.contains((*c)[1])) continue;
        const std::string before = body.substr(0, static_cast<std::size_t>(c->position()));
        const auto depth =
            std::count(before.begin(), before.end(), '{') - std::count(before.begin(), before.end(), '}');
        const std::size_t statement = before.find_last_of(";{}");
        if (depth > 0 || std::regex_search(before, leaves) ||
            std::regex_search(before.substr(statement == std::string::npos ? 0 : statement), condition))
            found.push_back((*c)[1]);
    }
    return found;
}

/// Returns the functions that look up a texture at an implicit level of detail or take a derivative, in these sources,
/// themselves or by a function that they call.
std::set<std::string> functionsWithDerivatives(const std::vector<Function>& functions)
{
    static const std::regex call(R"(\b(\w+)\s*\()");
    std::vector<std::set<std::string>> calls;
    for (const Function& function : functions) {
        const std::string& body = function.body;
        std::set<std::string> called;
        for (auto c = std::sregex_iterator(body.begin(), body.end(), call); c != std::sregex_iterator(); ++c)
            called.insert((*c)[1]);
        calls.push_back(std::move(called));
    }
    std::set<std::string> names{"texture", "dFdx", "dFdy", "fwidth"};
    for (std::size_t before = 0; before != names.size();) {
        before = names.size();
        for (std::size_t i = 0; i < functions.size(); ++i)
            if (std::any_of(calls[i].begin(), calls[i].end(),
                            [&](const std::string& name) { return names.contains(name); }))
                names.insert(functions[i].name);
    }
    return names;
}

TEST(Shaders, TakeDerivativesOnlyWhereAllPixelsOfAQuadDo)
{
    // OpenGL leaves derivatives and implicit levels of detail undefined in non-uniform control flow (GLSL 4.50, 8.9
    // and 8.13.1).
    std::vector<Function> all;
    for (const std::string& file : test::sourceFiles("shaders", test::glslExtensions))
        for (Function& function : functionsOf(test::sourceText(file))) all.push_back(std::move(function));
    const std::set<std::string> names = functionsWithDerivatives(all);
    EXPECT_TRUE(names.contains("materialColor"));
    for (const Function& function : all)
        for (const std::string& name : conditionalCalls(function.body, names))
            ADD_FAILURE() << function.name << ": " << name
                          << " is called where not every pixel of a quad may be; use textureLod, or call it earlier";

    const auto found = [](const char* source) {
        const std::vector<Function> functions = functionsOf(source);
        std::size_t count = 0;
        for (const Function& f : functions)
            count += conditionalCalls(f.body, functionsWithDerivatives(functions)).size();
        return count;
    };
    EXPECT_EQ(found("void main() { c = texture(map, uv); if (c.a < 0.5) discard; }"), 0U);
    EXPECT_EQ(found("void main() { if (c.a < 0.5) discard; c = texture(map, uv); }"), 1U);
    EXPECT_EQ(found("void main() { if (d > 0.0) { c = texture(map, uv); } }"), 1U);
    EXPECT_EQ(found("void main() { float w = d > 0.0 ? fwidth(d) : 0.0; }"), 1U);
    EXPECT_EQ(found("void main() { for (int i = 0; i < 3; ++i) c += textureLod(map, uv, 0.0); }"), 0U);
    EXPECT_EQ(found("vec4 look() { return texture(map, uv); } void main() { if (d > 0.0) c = look(); }"), 1U);
}

TEST(Shaders, HashWithIntegersAndNeverWithSines)
{
    // fract(sin(x) * 43758) differs between drivers, because the precision of sin is not specified, and repeats far
    // from 0.
    static const std::regex sine(R"(fract\s*\(\s*(?:[^;]*\b)?sin\s*\(|43758|12\.9898)");
    for (const std::string& file : test::sourceFiles("shaders", test::glslExtensions))
        EXPECT_FALSE(std::regex_search(test::withoutComments(test::sourceText(file)), sine)) << file;
    EXPECT_TRUE(std::regex_search(std::string("return fract(sin(dot(p, k)) * 1e4);"), sine));
}

TEST(Shaders, IncludeOnlyFilesThatExist)
{
    for (const std::string& file : test::sourceFiles("shaders", test::glslExtensions))
        for (const test::Include& include : test::includesOf(file))
            EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(VITRINE_SOURCE_DIR) / "shaders" / include.target))
                << file << ':' << include.line << ' ' << include.target;
}

/// Returns the members of uniform blocks that are declared by hand: neither one struct of a `*_block.glsl` nor one
/// array of vec4.
std::vector<std::string> membersByHand(const std::string& source, const std::string& described)
{
    static const std::regex block(R"(layout\s*\(\s*std140[^)]*\)\s*uniform\s+\w+\s*\{([^}]*)\})");
    static const std::regex structMember(R"(^\s*(\w+)\s+\w+;\s*$)");
    static const std::regex arrayMember(R"(^\s*vec4\s+\w+\[[^\]]*\];\s*$)");
    const std::string text = test::withoutComments(source);
    std::vector<std::string> found;
    for (auto i = std::sregex_iterator(text.begin(), text.end(), block); i != std::sregex_iterator(); ++i) {
        const std::string members = (*i)[1];
        std::smatch match;
        if (std::regex_match(members, arrayMember)) continue;
        if (std::regex_match(members, match, structMember) &&
            described.find("\nBLOCK_STRUCT(" + match[1].str() + ",") != std::string::npos)
            continue;
        found.push_back(members);
    }
    return found;
}

TEST(Shaders, DeclareNoUniformBlockByHand)
{
    std::string described;
    for (const std::string& file : test::sourceFiles("shaders", test::glslExtensions))
        described += test::sourceText(file);
    for (const std::string& file : test::sourceFiles("shaders", test::glslExtensions))
        for (const std::string& members : membersByHand(test::sourceText(file), described))
            ADD_FAILURE() << file << ": describe this block in a file *_block.glsl, for C++ reads it too:" << members;

    const std::string known = "\nBLOCK_STRUCT(Lamp, LAMP_FIELDS)";
    EXPECT_EQ(membersByHand("layout(std140, binding = 2) uniform A { Lamp lamp; };", known).size(), 0U);
    EXPECT_EQ(membersByHand("layout(std140, binding = 2) uniform A { Lump lamp; };", known).size(), 1U);
    EXPECT_EQ(membersByHand("layout(std140, binding = 2) uniform A {\n  vec4 a;\n  vec4 b;\n} x;", known).size(), 1U);
}

TEST(Shaders, IncludeWhatTheirRoomMay)
{
    const auto folderOf = [](const std::string& path) { return path.substr(0, path.find('/')); };
    for (const std::string& file : test::sourceFiles("shaders", test::glslExtensions)) {
        const std::string own = folderOf(file.substr(std::string("shaders/").size()));
        for (const test::Include& include : test::includesOf(file)) {
            const std::string other = folderOf(include.target);
            const bool kit = other == "kit" && own != "lib";
            const bool printing = other == "printing" && own != "lib" && own != "kit" && own != "hall";
            EXPECT_TRUE(other == own || other == "lib" || kit || printing)
                << file << ':' << include.line << ' ' << include.target;
        }
    }
}

TEST(Shaders, NamedInPlansExist)
{
    // File names of shaders in any folder, such as "lib/copy.frag" and "crepuscular_rays/polar.comp".
    static const std::regex name(R"re("([\w/]+/[\w/]+\.(?:vert|frag|comp))")re");
    std::map<std::string, int> found;
    for (const char* folder : {"exhibits", "render"}) {
        for (const std::string& file : test::sourceFiles(folder, test::cppExtensions)) {
            const std::string text = test::withoutComments(test::sourceText(file));
            for (auto match = std::sregex_iterator(text.begin(), text.end(), name); match != std::sregex_iterator();
                 ++match) {
                ++found[(*match)[1].str().substr(0, (*match)[1].str().find('/'))];
                EXPECT_TRUE(
                    std::filesystem::exists(std::filesystem::path(VITRINE_SOURCE_DIR) / "shaders" / (*match)[1].str()))
                    << file << ": " << (*match)[1];
            }
        }
    }
    for (const std::string& stage : test::sourceFiles("shaders", {".vert", ".frag", ".comp"})) {
        const std::string path = stage.substr(std::string("shaders/").size());
        EXPECT_GT(found[path.substr(0, path.find('/'))], 0) << "no plan was seen to name a shader beside " << stage;
    }
}

TEST(Shaders, EveryStageIsNamedByAPlanOrATest)
{
    std::string text;
    for (const char* folder : {"exhibits", "render", "tests", "app"})
        for (const std::string& file : test::sourceFiles(folder, test::cppExtensions)) text += test::sourceText(file);
    for (const std::string& file : test::sourceFiles("shaders", {".vert", ".frag", ".comp"}))
        EXPECT_NE(text.find('"' + file.substr(8) + '"'), std::string::npos) << file << " is drawn by nothing";
}

TEST(Shaders, ShareTheirBlocksWithTheCodeByNumber)
{
    // Literal binding numbers could differ from those of bindings.glsl unnoticed.
    static const std::regex literal(R"(binding\s*=\s*\d)");
    for (const std::string& file : test::sourceFiles("shaders", test::glslExtensions)) {
        const std::string text = test::withoutComments(test::sourceText(file));
        if (file.find(".comp") == std::string::npos) {  // Compute passes bind writable images in their order.
            EXPECT_FALSE(std::regex_search(text, literal)) << file;
        }
    }
}

}  // namespace
}  // namespace vitrine
