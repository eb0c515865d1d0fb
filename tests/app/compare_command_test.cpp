// `vitrine compare`: differences, limits, heat maps, and errors for pictures that cannot be compared.

#include "render/image/image_io.h"
#include "tests/app/child_process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace vitrine {
namespace {

using test::Ended;

/// Two pictures of linear light that differ by exactly 1/8, as float files.
struct Pair {
    test::TemporaryFolder folder;
    std::string a = folder / "a.exr";
    std::string b = folder / "b.exr";

    Pair()
    {
        render::writePicture(a, render::Image(24, 16, 3, 0.25F), render::PictureFormat::exr);
        render::writePicture(b, render::Image(24, 16, 3, 0.375F), render::PictureFormat::exr);
    }
};

TEST(LongCompare, TheFirstLineIsTheMetricAskedFor)
{
    const Pair pair;
    const Ended ended = test::vitrine({"compare", pair.a, pair.b});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(ended.out.substr(0, ended.out.find('\n')), "rmse     0.125");
    const Ended psnr = test::vitrine({"compare", pair.a, pair.b, "--metric", "psnr"});
    EXPECT_EQ(psnr.out.rfind("psnr     18.06", 0), 0U) << psnr.out;
    EXPECT_EQ(test::vitrine({"compare", pair.a, pair.a, "--metric", "flip"}).out.rfind("flip     0\n", 0), 0U);
}

TEST(LongCompare, BeyondTheLimitIsAFailedCheck)
{
    const Pair pair;
    EXPECT_EQ(test::vitrine({"compare", pair.a, pair.b, "--max", "0.126"}).code, 0);
    const Ended beyond = test::vitrine({"compare", pair.a, pair.b, "--max", "0.124"});
    EXPECT_EQ(beyond.code, 1);
    EXPECT_NE(beyond.err.find("0.124"), std::string::npos) << beyond.err;
    // Less noise means more decibels, so the limit of this metric is a lower one.
    EXPECT_EQ(test::vitrine({"compare", pair.a, pair.b, "--metric", "psnr", "--max", "18"}).code, 0);
    EXPECT_EQ(test::vitrine({"compare", pair.a, pair.b, "--metric", "psnr", "--max", "19"}).code, 1);
}

TEST(Compare, TheHeatMapHasTheSizeOfThePictures)
{
    const Pair pair;
    const std::string map = pair.folder / "map.png";
    EXPECT_EQ(test::vitrine({"compare", pair.a, pair.b, "--metric", "flip", "--heatmap", map}).code, 0);
    const render::Image image = render::readImage(map);
    EXPECT_EQ(image.width, 24);
    EXPECT_EQ(image.height, 16);
}

TEST(Compare, WhatCannotBeComparedIsSaidInOneSentence)
{
    const Pair pair;
    const std::string other = pair.folder / "other.exr";
    render::writePicture(other, render::Image(8, 16, 3, 0.25F), render::PictureFormat::exr);
    const Ended sizes = test::vitrine({"compare", pair.a, other});
    EXPECT_EQ(sizes.code, 2);
    test::expectOneSentence(sizes, {"24 × 16", "8 × 16"});
    const Ended metric = test::vitrine({"compare", pair.a, pair.b, "--metric", "ssim"});
    EXPECT_EQ(metric.code, 2);
    test::expectOneSentence(metric, {"--metric", "ssim", "flip"});
    const Ended channel = test::vitrine({"compare", pair.a, pair.b, "--metric", "depth"});
    EXPECT_EQ(channel.code, 2);
    test::expectOneSentence(channel, {"depth", "--channels"});
    EXPECT_EQ(test::vitrine({"compare", pair.a, pair.folder / "none.png"}).code, 5);
    EXPECT_EQ(test::vitrine({"compare", pair.a, pair.b, "--heatmap", pair.folder / "map.webp"}).code, 2);
}

}  // namespace
}  // namespace vitrine
