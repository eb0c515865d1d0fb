// Positions at which the driver reads parameters, compared with those at which their values are written.

#include "exhibits/exhibits.h"
#include "exhibits/framework/table/derive.h"
#include "tests/support/gallery.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstring>
#include <string>

namespace vitrine {
namespace {

using UniformBlock = test::GlTest;

/// Builds a program that reads the block of these parameters; 0 if it does not build.
GLuint programOf(const Parameters& table, std::string_view anyNumber)
{
    const std::string source = "#version 450\n" + derive::uniformBlock(table) +
                               "layout(local_size_x = 1) in;\nlayout(std430, binding = 0) buffer Out { float found; "
                               "};\nvoid main() { found = float(parameters." +
                               std::string(anyNumber) + "); }\n";
    const char* text = source.c_str();
    const GLuint program = glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &text);
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked != 0) return program;
    glDeleteProgram(program);
    return 0;
}

GLint offsetOf(GLuint program, const std::string& name)
{
    const std::string full = "Parameters." + name;
    const char* names[] = {full.c_str()};
    GLuint index = GL_INVALID_INDEX;
    glGetUniformIndices(program, 1, names, &index);
    if (index == GL_INVALID_INDEX) return -1;
    GLint offset = -1;
    glGetActiveUniformsiv(program, 1, &index, GL_UNIFORM_OFFSET, &offset);
    return offset;
}

template <typename T> T at(const render::Bytes& bytes, GLint offset)
{
    T value{};
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

void expectBlockOf(const Parameters& table, const std::string& exhibit)
{
    // Every parameter has a different value, so that they cannot be confused.
    ParameterValues values(table);
    for (std::size_t i = 0; i < table.rows().size(); ++i) {
        const ParameterInfo& row = table.rows()[i];
        const double share = (static_cast<double>(i) + 1) / (static_cast<double>(table.rows().size()) + 2);
        if (row.kind == Kind::color)
            values.setParameter(i, glm::dvec3(share, 0.5 * share, 0.25 * share));
        else if (row.kind == Kind::direction)
            values.setParameter(i, glm::dvec3(share, 0.3, 1 - share));
        else if (!row.isWritten())
            values.setParameter(i, row.range.low + share * (row.range.high - row.range.low));
    }
    const render::Bytes bytes = derive::uniformBytes(values);
    const auto number = std::find_if(table.rows().begin(), table.rows().end(),
                                     [](const ParameterInfo& parameter) { return parameter.isNumeric(); });
    ASSERT_NE(number, table.rows().end()) << exhibit;
    const GLuint program = programOf(table, number->name);
    ASSERT_NE(program, 0U) << exhibit;
    for (std::size_t i = 0; i < table.rows().size(); ++i) {
        const ParameterInfo& row = table.rows()[i];
        if (row.isWritten()) continue;
        SCOPED_TRACE(exhibit + '.' + std::string(row.name));
        const GLint offset = offsetOf(program, std::string(row.name));
        ASSERT_GE(offset, 0);
        const bool vector = row.kind == Kind::color || row.kind == Kind::direction;
        ASSERT_LE(static_cast<std::size_t>(offset) + (vector ? 12U : 4U), bytes.size());
        if (vector) {
            EXPECT_EQ(at<glm::vec3>(bytes, offset), glm::vec3(std::get<glm::dvec3>(values.row(i))));
        } else if (row.kind == Kind::real) {
            EXPECT_EQ(at<float>(bytes, offset), static_cast<float>(std::get<double>(values.row(i))));
        } else {
            EXPECT_EQ(at<std::int32_t>(bytes, offset), static_cast<std::int32_t>(std::get<double>(values.row(i))));
        }
    }
    glDeleteProgram(program);
}

TEST_F(UniformBlock, HasEveryParameterWhereTheDriverLooksForIt)
{
    for (const SceneObject* subject : test::gallery().museum.subjects())
        expectBlockOf(subject->parameters(), std::string(subject->name()));
}

/// Table with everything that std140 pads: a number after a vector, a vector after one, two and three numbers,
/// consecutive vectors.
struct Awkward final : Parameters {
    Real a = real("a", 0.5, none, {0, 1}, "A.");
    Color b = color("b", {0, 0, 0}, "B.");
    Real c = real("c", 0.5, none, {0, 1}, "C.");
    Color d = color("d", {0, 0, 0}, "D.");
    Color e = color("e", {0, 0, 0}, "E.");
    Count f = count("f", 1, {0, 99}, "F.");
    Toggle g = toggle("g", false, "G.");
    File h = file("h", "H.");
    Direction i = direction("i", {0, 0, 1}, "I.");
    Real j = real("j", 0.5, none, {0, 1}, "J.");
    Real k = real("k", 0.5, none, {0, 1}, "K.");
    Real l = real("l", 0.5, none, {0, 1}, "L.");
    Color m = color("m", {0, 0, 0}, "M.");
};

TEST_F(UniformBlock, OfAwkwardOrderIsPaddedAsTheDriverPadsIt)
{
    expectBlockOf(Awkward(), "awkward");
}

}  // namespace
}  // namespace vitrine
