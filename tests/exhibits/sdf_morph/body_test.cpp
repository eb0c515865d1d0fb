// The torus-mug at one time, without a GPU.

#include "exhibits/sdf_morph/sdf_morph.h"
#include "shaders/lib/bindings.glsl"
#include "tests/support/museum_on_paper.h"

#include <gtest/gtest.h>

#include <cstring>

namespace vitrine::sdf_morph {
namespace {

float floatAt(const render::Bytes& bytes, std::size_t offset)
{
    float value = 0;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

TEST(SdfMorphBody, ReachesItsShadersWithOneMorphTheOneOfTheMoment)
{
    test::Scene scene;
    scene.object().set(test::sdfTable().animate, true);
    for (const double time : {0.0, 1.5, 40.25}) {
        scene.request.time = time;
        const auto now = static_cast<float>(morphAt(0.62, 0.08, time));
        for (const char* name : {"sdf_morph/march", "sdf_morph/cone"}) {
            const render::FramePlan plan = scene.plan();
            const render::Pass* pass = plan.find(name);
            ASSERT_TRUE(pass);
            // `morph` is the first parameter of the table and the first field of the shape.
            EXPECT_EQ(floatAt(pass->blocks.at(BLOCK_PARAMETERS), 0), now) << name << " at " << time;
            EXPECT_EQ(floatAt(pass->blocks.at(BLOCK_EXHIBIT), 0), now) << name << " at " << time;
        }
    }
}

TEST(SdfMorphBody, HasAnotherMeshForAnotherShapeOnly)
{
    const SdfMorph exhibit;
    const auto shapeOf = [&](const auto& change, double time) {
        ParameterValues values = exhibit.parameters().initial();
        change(values);
        return exhibit.body(values, time).shape;
    };
    const auto& t = test::sdfTable();
    const std::string still = shapeOf([](ParameterValues&) {}, 0);
    EXPECT_EQ(shapeOf([&](ParameterValues& v) { v.set(t.roughness, 0.5); }, 7), still);
    EXPECT_NE(shapeOf([&](ParameterValues& v) { v.set(t.blend, 0.1); }, 0), still);
    EXPECT_NE(shapeOf([&](ParameterValues& v) { v.set(t.animate, true); }, 3), still);
}

}  // namespace
}  // namespace vitrine::sdf_morph
