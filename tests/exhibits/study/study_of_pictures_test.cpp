// Studies of real pictures with a known law.

#include "exhibits/study/study.h"
#include "render/gl/frame_clock.h"
#include "render/scene/camera.h"
#include "tests/support/edge_error.h"
#include "tests/support/gallery.h"

namespace vitrine::study {
namespace {

using namespace test;

using StudyOfPictures = GlTest;

StudyResult run(const StudyRequest& request)
{
    render::gl::Renderer renderer;
    Study study(gallery().museum, renderer, request);
    while (study.step()) {
    }
    return study.result();
}

StudyRequest requestFor(std::size_t exhibit, std::string_view row, std::vector<double> values)
{
    const Shot shot;
    const Museum& museum = gallery().museum;
    StudyRequest request;
    request.subject = shot.exhibit;
    request.sceneState = shot.sceneState;
    request.axes = {{exhibit, *museum.subject(exhibit).parameters().find(row), std::move(values)}};
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

/// Returns the error of `samplePosition` at edges of all directions, from exact areas, without a picture.
double errorOfEdges(int samples)
{
    return edgeError(samples, [&](int i) { return render::samplePosition(i, samples); });
}

TEST_F(StudyOfPictures, SupersamplesOfEdgesConvergeAsTheirSequenceShould)
{
    // The mug alone: samples differ only at outlines and creases.
    StudyRequest request = requestFor(0, supersamplesParameter, {2, 4, 8, 16, 32, 64});
    request.size = {128, 72};
    request.views = 1;
    const StudyResult result = run(request);
    ASSERT_EQ(result.points.size(), 6U);
    ASSERT_TRUE(result.converged) << result.convergence;
    // Low-discrepancy sequence: half the error needs 2^(4/3) times the samples; random samples need four times as many.
    ASSERT_TRUE(result.law);
    EXPECT_TRUE(result.law->slopeInterval.holds(-4.0 / 3))
        << result.law->slope << " in " << result.law->slopeInterval.low << " to " << result.law->slopeInterval.high;
    EXPECT_GT(result.law->slope, -1.75) << "no better than random, which is -2";
    // The ratio of each error to the first is that of straight edges.
    for (std::size_t i = 1; i < result.points.size(); ++i) {
        const auto samples = static_cast<int>(request.axes[0].values[i]);
        const double expected = errorOfEdges(samples) / errorOfEdges(2);
        EXPECT_NEAR(result.points[i].error / result.points[0].error / expected, 1, 0.25) << samples;
    }
    // The weights of the samples sum to 1: more samples make no picture brighter.
    for (const StudyPoint& point : result.points)
        for (std::size_t view = 0; view < result.views.size(); ++view) {
            // Mean of independent errors of this size, four standard deviations.
            const double noise = point.shots[view].errors.at(render::Metric::rmse) / std::sqrt(128.0 * 72);
            EXPECT_NEAR(meanOf(point.shots[view].picture), meanOf(result.references[view]), 4 * noise + 1e-4);
        }
}

TEST_F(StudyOfPictures, SupersamplesOfTheHallFollowTheEdgesOnceThereAreTwo)
{
    // With the visitors' settings, including beams and noise. Up to 16 samples the sequence has not reached its law:
    // straight edges need more than three times the samples there, and so does the hall.
    StudyRequest request = requestFor(0, supersamplesParameter, {2, 4, 8, 16});
    request.subject = 0;
    request.views = 1;
    request.size = {96, 54};
    const StudyResult result = run(request);
    ASSERT_EQ(result.points.size(), 4U);
    ASSERT_TRUE(result.converged) << result.convergence;
    for (std::size_t i = 1; i < result.points.size(); ++i) {
        const auto samples = static_cast<int>(request.axes[0].values[i]);
        const double expected = errorOfEdges(samples) / errorOfEdges(2);
        EXPECT_NEAR(result.points[i].error / result.points[0].error / expected, 1, 0.25) << samples;
    }
    ASSERT_TRUE(result.law);
    const double ofEdges = std::log(8.0) / std::log(errorOfEdges(2) / errorOfEdges(16));
    EXPECT_GT(ofEdges, 1.6);
    EXPECT_NEAR(-result.law->slope, ofEdges, 0.3) << "halving the error costs two to the power of this";
}

TEST_F(StudyOfPictures, InMotionMoreFramesComeNearerToThePictureAtRest)
{
    const StudyResult result = run(requestFor(0, historyFramesParameter, {1, 8}));
    ASSERT_EQ(result.points.size(), 2U);
    EXPECT_GT(result.points[0].error, 1.3 * result.points[1].error);
    EXPECT_FALSE(result.converged) << "there is no second reference to tell by";
    EXPECT_NE(result.convergence.find("without motion"), std::string::npos) << result.convergence;
}

TEST_F(StudyOfPictures, AWiderToleranceCostsFewerEvaluationsAndMoreError)
{
    const StudyResult result = run(requestFor(gallery().museum.find("sdf_morph").value(), "hitTolerance", {0.1, 1, 8}));
    EXPECT_EQ(result.costName, "evaluations");
    for (std::size_t i = 1; i < result.points.size(); ++i) {
        EXPECT_GT(result.points[i].error, result.points[i - 1].error);
        EXPECT_LT(result.points[i].cost, result.points[i - 1].cost);
        EXPECT_GT(result.points[i].shots[0].errors.at(render::Metric::depth),
                  result.points[i - 1].shots[0].errors.at(render::Metric::depth))
            << "distance to the surface";
    }
    EXPECT_TRUE(result.converged) << result.convergence;
    // Both are processor times, so that other work on the machine has no influence.
    EXPECT_EQ(result.clock, render::gl::trustedClock(true).name);
    EXPECT_LT(result.overheadMilliseconds, 0.02 * result.points[0].time->median);
}

// A reference is checked with another value of what is studied. What is exact in references only is exact there, too:
// otherwise its error, here that of interpolated clouds, would be taken for a doubt about the reference.
TEST_F(StudyOfPictures, OfAReferenceAndItsCheckTheSameIsExact)
{
    const std::size_t noise = gallery().museum.find("noise").value();
    const Parameters& table = gallery().museum.subject(noise).parameters();
    StudyRequest request = requestFor(noise, "march", {0, 1});
    request.subject = noise;
    request.axes.push_back({noise, table.find("cloudSteps").value(), {64, 512}});
    request.sceneState.values[noise].setParameter(table.find("work").value(), 3.0);
    request.sceneState.values[noise].setParameter(table.find("bakeSize").value(), 32.0);
    request.views = 1;
    const StudyResult result = run(request);
    ASSERT_EQ(result.exactInReference.size(), 1U);
    const double interpolated = result.points.back().error;
    EXPECT_GT(interpolated, 1e-3);
    EXPECT_LT(result.uncertainty, 0.5 * interpolated);
}

TEST_F(StudyOfPictures, WhatIsKeptBetweenFramesIsDrawnAnewWhereItIsStudied)
{
    // If later frames reused it, a shadow map would seem to cost nothing, whatever its size.
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
}  // namespace vitrine::study
