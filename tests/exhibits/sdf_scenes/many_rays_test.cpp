// Steps of a million rays through random trees: ten times as many as in the usual run.

#include "tests/exhibits/sdf_scenes/ray_steps.h"

namespace vitrine {
namespace {

TEST(SceneRays, NoneOfAMillionPassesASurface)
{
    test::Random random(31);
    for (int sample = 0; sample < 20'000; ++sample) {
        const std::string root = test::randomTree(random, 4);
        const scenes::SceneField field = test::fieldOf(root);
        const auto distance = [&field](const glm::dvec3& p) { return field.distance(p); };
        ASSERT_EQ(test::overshoots(distance, random, 50), 0) << root;
    }
}

}  // namespace
}  // namespace vitrine
