// Results made from many small pictures: frames of sprites, and the table of methods.

#include "exhibits/jobs/sprite/sprite_shots.h"
#include "exhibits/pixel_art/method_table.h"
#include "exhibits/pixel_art/pixel_passes.h"
#include "render/text/joined.h"
#include "tests/exhibits/pixel_art/pixel_art_pictures.h"
#include "tests/support/gallery.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace vitrine::pixel_art {
namespace {

using namespace test;
using glm::dvec3;
using glm::ivec2;
using render::Image;

class MadeOfPictures : public GlTest {};

TEST_F(MadeOfPictures, SpritesFitTheirFramesFromAllSides)
{
    const jobs::SpriteSubject pillar;
    const auto frames = jobs::drawSprite(table().initial(), pillar, {6, 5, {40, 52}, {}}, gallery().renderer);
    ASSERT_EQ(frames.size(), 30U);
    for (const jobs::SpriteFrame& frame : frames) {
        int seen = 0;
        for (int y = 0; y < 52; ++y)
            for (int x = 0; x < 40; ++x) {
                const bool covered = frame.color.at(x, y, 3) > 0.5F;
                seen += covered;
                EXPECT_EQ(covered, frame.depth.at(x, y) > 0);
                if (covered) {
                    EXPECT_TRUE(x > 0 && y > 0 && x < 39 && y < 51);
                    EXPECT_NEAR(glm::length(at(frame.normal, x, y)), 1, 2e-3);
                }
            }
        EXPECT_GT(seen, 100);
        EXPECT_NEAR(frame.pivot.x, 20, 1e-4);
    }
    const auto tiny = jobs::drawSprite(table().initial(), pillar, {1, 1, {1, 1}, {}}, gallery().renderer);
    EXPECT_EQ(tiny.front().color.width, 1);
}

TEST_F(MadeOfPictures, TheTableOfMethodsHasALineForEachAndTheirErrors)
{
    MethodTable measured({{"bars", barParts()}}, {{PixelResolution::r240, DepthBits::float32}}, 1);
    int steps = 1;
    while (measured.step(gallery().renderer)) ++steps;
    EXPECT_EQ(steps, 7);
    EXPECT_EQ(measured.progress(), 1);
    const std::vector<std::vector<std::string>>& lines = measured.lines();
    EXPECT_EQ(joined(lines.front(), ","), "scene,size,depth,method,mean,p99,beyond5,beyond20,fetches,ms");
    std::map<std::string, std::vector<double>> found;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        ASSERT_EQ(lines[i].size(), 10U);
        EXPECT_EQ(lines[i][0] + lines[i][1] + lines[i][2], "bars240 x 13532 bit");
        for (std::size_t k = 4; k < 10; ++k) found[lines[i][3]].push_back(std::stod(lines[i][k]));
    }
    ASSERT_EQ(found.size(), 7U);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(found["9 tap"][i], found["9 plus tap"][i]);
    EXPECT_EQ(found["9 tap"][4], 13);
    EXPECT_EQ(found["9 plus tap"][4], 9);
    EXPECT_GT(found["3 tap"][2], found["vote"][2]);
}

}  // namespace
}  // namespace vitrine::pixel_art
