#include "render/glsl/block_copies.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace vitrine::render {
namespace {

constexpr const char* shader = R"(#version 450 core
#define COPY_BLOCKS
// The shape has a comment.
#define LAYER_FIELDS(FIELD, ARRAY) \
    FIELD(vec3, foot) /* meters */ \
    FIELD(float, radius)
BLOCK_STRUCT(Layer, LAYER_FIELDS)
#define SHAPE_FIELDS(FIELD, ARRAY) \
    ARRAY(Layer, layers, FOUR / 2) \
    ARRAY(Layer, candies, 10) \
    FIELD(Layer, plinth) \
    FIELD(int, parts)
BLOCK_STRUCT(Shape, SHAPE_FIELDS)
layout(std140, binding = 6) uniform Exhibit {
    Shape shape;
};
layout(std140, binding = 1) uniform Parameters {
    float size;  // meters
    bool shown;
} parameters;
float at(int i)
{
    return shape.candies[i].radius + shape.layers[1].radius + other.shape.x + float(shape.parts) * parameters.size;
}
)";

bool has(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

TEST(BlockCopies, ReadEachNumberAtTheBeginning)
{
    EXPECT_TRUE(asksForCopies(shader));
    const std::string changed = copyingBlocks(shader);
    EXPECT_TRUE(has(changed, "Shape shapeInBlock;"));
    EXPECT_TRUE(has(changed, "copied.layers[1].foot = shapeInBlock.layers[1].foot; "));
    EXPECT_TRUE(has(changed, "copied.plinth.radius = shapeInBlock.plinth.radius; "));
    EXPECT_TRUE(has(changed, "copied.parts = shapeInBlock.parts; "));
    EXPECT_TRUE(has(changed, "Shape shape = shapeCopied();"));
    EXPECT_FALSE(has(changed, "layers[0]")) << "nothing reads it";
    EXPECT_TRUE(has(changed, "shapeInBlock.candies[i].radius + shape.layers[1].radius + other.shape.x")) << changed;
    EXPECT_TRUE(has(changed, "} parametersInBlock; struct CopiedParameters {"));
    EXPECT_TRUE(has(changed, "parameters = CopiedParameters(parametersInBlock.size, parametersInBlock.shown);"));
    EXPECT_TRUE(has(changed, "float(shape.parts) * parameters.size"));
}

TEST(BlockCopies, KeepTheLines)
{
    const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
    const std::string changed = copyingBlocks(shader);
    EXPECT_EQ(lines(changed), lines(shader));
    const std::string before = changed.substr(0, changed.find("float at("));
    EXPECT_EQ(lines(before), lines(std::string(shader).substr(0, std::string(shader).find("float at("))));
}

TEST(BlockCopies, LeaveABlockWithArraysThatIsAnArgument)
{
    std::string text = shader;
    text += "float all() { return sizeOf(shape); }\nfloat other() { float shape = 1.0; shape += 2.0; return shape; }\n";
    const std::string changed = copyingBlocks(text);
    EXPECT_FALSE(has(changed, "shapeCopied"));
    EXPECT_TRUE(has(changed, "sizeOf(shapeInBlock)"));
    EXPECT_TRUE(has(changed, "float shapeInBlock = 1.0; shapeInBlock += 2.0;")) << "a variable keeps one name";
    EXPECT_TRUE(has(changed, "shapeInBlock.candies[i].radius + shapeInBlock.layers[1].radius"));
}

TEST(BlockCopies, AreMadeWhereTheShaderAsksForThem)
{
    EXPECT_FALSE(asksForCopies("#version 450 core\n// #define COPY_BLOCKS would\nvoid main() {}\n"));
}

}  // namespace
}  // namespace vitrine::render
