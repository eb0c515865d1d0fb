// The order in which translucent parts are blended.

#include "exhibits/kit/surface_draw.h"

#include <gtest/gtest.h>

#include <string>

namespace vitrine {
namespace {

/// Returns a cube around a place. Its count of instances serves as its number.
TranslucentPart translucentCube(int number, const glm::dvec3& place, double halfSide, bool doubleSided)
{
    TranslucentPart part;
    part.draw.instances = number;
    part.box = {place - halfSide, place + halfSide};
    part.doubleSided = doubleSided;
    return part;
}

/// Returns the order of back and front faces: "1b 2b 2f 1f".
std::string blendOrderOf(const std::vector<TranslucentPart>& parts, const glm::dvec3& seenFrom)
{
    std::string order;
    for (const render::Draw& draw : farToNear(parts, seenFrom))
        order += std::to_string(draw.instances) + (draw.cull == render::Cull::front ? "b " : "f ");
    return order;
}

TEST(TranslucentParts, AreDrawnFromFarToNearWithTheirBacksFirst)
{
    const glm::dvec3 viewer(0, 0, 10);
    const TranslucentPart outer = translucentCube(1, {0, 0, 0}, 2, true),
                          inner = translucentCube(2, {0, 0, 0}, 1, true);
    EXPECT_EQ(blendOrderOf({outer, inner}, viewer), "1b 2b 2f 1f ");
    EXPECT_EQ(blendOrderOf({inner, outer}, viewer), "1b 2b 2f 1f ");
    const TranslucentPart distant = translucentCube(3, {0, 0, -8}, 1, true),
                          nearby = translucentCube(4, {0, 0, 4}, 1, true);
    EXPECT_EQ(blendOrderOf({nearby, distant}, viewer), "3b 3f 4b 4f ");
    EXPECT_EQ(blendOrderOf({nearby, distant}, {0, 0, -30}), "4b 4f 3b 3f ");
    // The back of a single-sided part is not drawn.
    EXPECT_EQ(blendOrderOf({translucentCube(5, {0, 0, 0}, 1, false), outer}, viewer), "1b 5f 1f ");
    EXPECT_EQ(blendOrderOf({}, viewer), "");
}

}  // namespace
}  // namespace vitrine
