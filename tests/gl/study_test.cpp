// Studies of real pictures whose law is known.

#include "exhibits/framework/study.h"
#include "render/gl/frame_clock.h"
#include "tests/gl/gallery.h"

namespace vitrine {
namespace {

using namespace test;

using StudyOfPictures = GlTest;

StudyResult run(const StudyRequest& request)
{
    render::gl::Renderer renderer;
    Study study(gallery().museum, renderer, request);
    while (study.step()) {}
    return study.result();
}

StudyRequest requestFor(std::size_t exhibit, std::string_view row, std::vector<double> values)
{
    const Shot shot;
    const Museum& museum = gallery().museum;
    StudyRequest request;
    request.subject = shot.sdf;
    request.look = shot.look;
    request.axes = {{exhibit, *museum.exhibits()[exhibit]->parameters().find(row), std::move(values)}};
    request.size = {64, 36};
    request.runs = 1;
    request.views = 2;
    request.alone = true;
    request.modelError = false;
    return request;
}

double meanOf(const render::Image& image)
{
    double sum = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < 3; ++c) sum += image.at(x, y, c);
    return sum / (3.0 * image.width * image.height);
}

TEST_F(StudyOfPictures, SupersamplesConvergeAsAQuasirandomSequenceShould)
{
    const StudyResult result = run(requestFor(0, supersamplesRow, {1, 2, 4, 8, 16}));
    ASSERT_EQ(result.points.size(), 5U);
    EXPECT_LT(result.points.back().error, result.points.front().error / 3);
    ASSERT_TRUE(result.law);
    // At edges, random samples need 4 times the work to halve the error; a low-discrepancy sequence of two
    // dimensions about 2^(4/3) times (its error falls with the power 3/4 of the samples; Mitchell 1996).
    EXPECT_TRUE(result.law->slopeInterval.holds(-4.0 / 3)) << result.law->slope << " in " << result.law->slopeInterval.low << " to " << result.law->slopeInterval.high;
    EXPECT_GT(result.law->slope, -2) << "no better than random";
    // The weights of the samples sum to 1, however many there are: more of them make no picture brighter.
    for (const StudyPoint& point : result.points)
        for (std::size_t view = 0; view < result.views.size(); ++view) {
            // The mean of independent errors of this size, four standard deviations.
            const double noise = point.shots[view].errors.at(render::Metric::rmse) / std::sqrt(64.0 * 36);
            EXPECT_NEAR(meanOf(point.shots[view].picture), meanOf(result.references[view]), 4 * noise + 1e-4);
        }
}

TEST_F(StudyOfPictures, AWiderToleranceCostsFewerEvaluationsAndMoreError)
{
    const StudyResult result = run(requestFor(gallery().museum.find("sdf_morph").value(), "hitTolerance", {0.1, 1, 8}));
    EXPECT_EQ(result.costName, "evaluations");
    for (std::size_t i = 1; i < result.points.size(); ++i) {
        EXPECT_GT(result.points[i].error, result.points[i - 1].error);
        EXPECT_LT(result.points[i].cost, result.points[i - 1].cost);
        EXPECT_GT(result.points[i].shots[0].errors.at(render::Metric::depth), result.points[i - 1].shots[0].errors.at(render::Metric::depth)) << "distance to the surface";
    }
    EXPECT_TRUE(result.converged) << result.convergence;
    // Processor time against processor time: how busy the machine is has no say in it.
    EXPECT_EQ(result.clock, render::gl::trustedClock(true).name);
    EXPECT_LT(result.overheadMilliseconds, 0.02 * result.points[0].time->median);
}

TEST_F(StudyOfPictures, WhatIsKeptBetweenFramesIsDrawnAnewWhereItIsStudied)
{
    // Kept as it is by the frames that follow, a shadow map would seem to cost nothing, whatever its size.
    const auto passes = [](const char* row, std::vector<double> values) {
        StudyRequest request = requestFor(0, row, std::move(values));
        request.subject = 0;
        request.views = 1;
        request.size = {32, 18};
        return run(request).points.front().counters.at("passes");
    };
    EXPECT_GT(passes("shadowMapSize", {256, 512}), passes("supersamples", {1, 2}));
}

}  // namespace
}  // namespace vitrine
