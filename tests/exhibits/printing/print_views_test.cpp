#include "exhibits/printing/print_views.h"
#include "render/failure.h"
#include "render/image/image_io.h"
#include "render/video/video_file.h"
#include "tests/exhibits/printing/set_up_print.h"
#include "tests/support/failures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace vitrine::printing {
namespace {

class PrintViewsTest : public test::SetUpPrint {
protected:
    [[nodiscard]] static ParameterValues shown(ParameterValues values)
    {
        values.set(printTable().origin, ViewOrigin::shown);
        return values;
    }
    [[nodiscard]] ParameterValues scaled(double strength) const
    {
        ParameterValues values = values_;
        values.set(table_.baselineScale, strength);
        return values;
    }
};

TEST_F(PrintViewsTest, ReadsFilesSpreadEvenlyAndQuiltsFromTheBottomLeft)
{
    std::vector<std::string> files;
    for (int k = 0; k < 9; ++k) {
        files.push_back((folder_.path() / ("v" + std::to_string(k) + ".png")).string());
        render::writePicture(files.back(), render::Image(8, 8, 3, static_cast<float>(k) / 8),
                             render::PictureFormat::png16);
    }
    values_.set(table_.views, 3);
    const auto three = readViews(withPictures(values_, files), {});
    ASSERT_EQ(three->count(), 3);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(three->full().row(k, 0)[0], 65535.0 * k / 2, 12);
    values_.set(table_.views, 40);
    EXPECT_EQ(readViews(withPictures(values_, {folder_.path().string()}), {})->count(), 9);  // All that exist.
    EXPECT_THROW(static_cast<void>(readViews(values_, {})), Failure);
    EXPECT_THROW(static_cast<void>(readViews(withPictures(values_, files), [](double part) { return part < 0.5; })),
                 Failure);

    render::Image quilt(8, 4, 3);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x)
            for (int c = 0; c < 3; ++c) quilt.at(x, y, c) = static_cast<float>((y < 2 ? 2 : 0) + (x < 4 ? 0 : 1)) / 3;
    render::writePicture(folder_.path() / "quilt.png", quilt, render::PictureFormat::png16);
    values_.set(table_.origin, ViewOrigin::quilt);
    values_.set(table_.quiltColumns, 2);
    values_.set(table_.quiltRows, 2);
    const auto four = readViews(withPictures(values_, {(folder_.path() / "quilt.png").string()}), {});
    ASSERT_EQ(four->count(), 4);
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(four->full().row(k, 0)[0], 65535.0 * k / 3, 12);
}

TEST_F(PrintViewsTest, ReadsTheFramesOfAVideo)
{
    const std::filesystem::path clip = folder_ / "clip.mp4";
    constexpr int frames = 6;
    render::VideoFile video(clip, {.width = 64, .height = 48});
    for (int k = 0; k < frames; ++k) video.add(render::Image(64, 48, 3, static_cast<float>(k) / (frames - 1)));
    video.finish();
    const auto levelOf = [](const PrintViews& views, int k) { return views.full().row(k, 20)[3 * 30] / 65535.0; };
    values_.set(table_.views, 0);
    const auto all = readViews(withPictures(values_, {clip.string()}), {});
    ASSERT_EQ(all->count(), frames);
    for (int k = 0; k < frames; ++k) EXPECT_NEAR(levelOf(*all, k), static_cast<double>(k) / (frames - 1), 0.02) << k;
    EXPECT_EQ(all->sources()[3], "clip.mp4, frame 3");

    // Every second one, and back again.
    values_.set(table_.every, 2);
    values_.set(table_.pingPong, true);
    const auto some = readViews(withPictures(values_, {clip.string()}), {});
    ASSERT_EQ(some->count(), 4);
    for (const auto& [view, frame] : {std::pair{0, 0}, {1, 2}, {2, 4}, {3, 2}})
        EXPECT_NEAR(levelOf(*some, view), static_cast<double>(frame) / (frames - 1), 0.02) << view;
    EXPECT_THROW(static_cast<void>(readViews(withPictures(values_, {(folder_ / "none.mp4").string()}), {})), Failure);
    std::ofstream(folder_ / "broken.mp4") << "no video";
    EXPECT_NE(vitrine::test::failureOf([&] {
                  static_cast<void>(readViews(withPictures(values_, {(folder_ / "broken.mp4").string()}), {}));
              }).find("broken.mp4"),
              std::string::npos);
}

TEST_F(PrintViewsTest, TakeTheShapeOfThePrintAndSayWhatThatCost)
{
    // The print is 3:2, so a view of 10 x 2 loses 7 of 10 columns.
    const std::string file = (folder_.path() / "wide.png").string();
    render::writePicture(file, render::Image(10, 2, 3, 0.0F), render::PictureFormat::png8);
    const auto cropped = readViews(withPictures(values_, {file}), {});
    EXPECT_EQ(cropped->full().view(0).width, 3);
    ASSERT_EQ(cropped->notes().size(), 1U);
    EXPECT_NE(cropped->notes()[0].find("70 % of their width is cut off"), std::string::npos) << cropped->notes()[0];
    values_.set(table_.fitting, Fitting::fit);
    const auto whole = readViews(withPictures(values_, {file}), {});
    EXPECT_EQ(whole->full().view(0).width, 10);
    EXPECT_EQ(whole->full().height(), 7);
    EXPECT_EQ(whole->full().row(0, 0)[0], 65535) << "white";
    EXPECT_EQ(whole->full().row(0, 2)[0], 0);
    values_.set(table_.fitting, Fitting::stretch);
    const auto stretched = readViews(withPictures(values_, {file}), {});
    EXPECT_EQ(stretched->full().view(0).width, 10);
    EXPECT_EQ(stretched->full().height(), 2);
    EXPECT_TRUE(stretched->notes().empty());
}

TEST_F(PrintViewsTest, PlaceThePictureThatIsMeantAmongThoseThatAreTaken)
{
    std::vector<std::string> files;
    for (int k = 0; k < 5; ++k) {
        files.push_back((folder_.path() / ("v" + std::to_string(k) + ".png")).string());
        render::writePicture(files.back(), render::Image(6, 4, 3, 0.0F), render::PictureFormat::png8);
    }
    values_.set(table_.views, 3);  // Pictures 1, 3 and 5.
    ParameterValues moved = values_;
    moved.set(table_.places, std::string("3:0,50,0; 4:0,-50,0"));
    EXPECT_FALSE(sameViews(values_, moved));
    EXPECT_TRUE(sameViews(shown(values_), shown(moved)));
    const auto views = readViews(withPictures(moved, files), {});
    EXPECT_EQ(views->pictures(), (std::vector<int>{1, 3, 5}));
    for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(views->full().row(k, 1)[0], k == 1 ? 65535 : 0) << k << ": white at the left of what moved right";
        EXPECT_EQ(views->full().row(k, 1)[3 * 5], 0) << k;
    }
    moved.set(table_.places, std::string("3:0,50"));
    EXPECT_THROW(static_cast<void>(readViews(withPictures(moved, files), {})), Failure);
}

TEST_F(PrintViewsTest, ShotsStandAsTheLensesShowAndDraftsAreTheSameButSmall)
{
    SceneState sceneState{{}, {{0, 1.6, 4}, {0, 1.2, 0}, 0.9}};
    const auto fine = printShots(values_, sceneState, {}, false).shots();
    const auto draft = printShots(values_, sceneState, {}, true).shots();
    ASSERT_EQ(fine.size(), 12U);
    ASSERT_EQ(draft.size(), 12U);
    for (std::size_t k = 0; k + 1 < fine.size(); ++k)
        EXPECT_GT(fine[k + 1].sceneState.camera.eye.x, fine[k].sceneState.camera.eye.x);
    EXPECT_EQ(fine[3].sceneState.camera, draft[3].sceneState.camera);
    EXPECT_EQ(fine[0].request.frame.raster.size.x, 960);
    EXPECT_LE(draft[0].request.frame.raster.size.x, 240);
    EXPECT_NEAR(static_cast<double>(fine[0].request.frame.raster.size.y) / 960, 0.02 / 0.03, 1e-3);
    values_.set(table_.baselineScale, 0.0);
    const auto flat = printShots(values_, sceneState, {}, false).shots();
    EXPECT_EQ(flat[0].sceneState.camera.eye, flat[11].sceneState.camera.eye);

    ParameterValues other = values_;
    other.set(table_.phase, 0.2);
    EXPECT_TRUE(sameViews(values_, other));
    other.set(table_.lensesPerInch, 40.0);
    EXPECT_TRUE(sameViews(values_, other));  // Files stay the same,
    ParameterValues wider = values_;
    wider.set(table_.width, 2 * values_[table_.width]);
    EXPECT_FALSE(sameViews(values_, wider));  // but their cropping changes,
    for (ParameterValues* values : {&values_, &wider}) values->set(table_.fitting, Fitting::stretch);
    EXPECT_TRUE(sameViews(values_, wider));
    for (ParameterValues* values : {&values_, &other}) values->set(table_.fitting, Fitting::crop);
    const ParameterValues fromWindow = shown(values_);
    const ParameterValues coarser = shown(other);
    EXPECT_FALSE(sameViews(fromWindow, coarser));  // and so do cameras, which depend on the lenses.
    EXPECT_FALSE(sameViews(values_, fromWindow));
}

TEST_F(PrintViewsTest, TheBaselineScaleThatFitsHoldsTheSceneAndALargerOneDoesNot)
{
    values_ = shown(values_);
    const SceneState sceneState{{}, {{0, 1.6, 4}, {0, 1.2, 0}, 0.9}};
    render::Image picture(20, 10, 5, 1.0F);
    picture.channelNames = {"R", "G", "B", "A", "depth.Z"};
    for (int x = 0; x < 20; ++x)
        for (int y = 0; y < 10; ++y) picture.at(x, y, 4) = 2.0F + static_cast<float>(x);
    const SceneDepth deep = sceneDepth(values_, sceneState, picture);
    EXPECT_NEAR(deep.scene.nearest, 2, 0.01);
    EXPECT_NEAR(deep.scene.farthest, 21, 0.01);
    EXPECT_FALSE(deep.warnings.empty());
    ASSERT_LT(deep.strengthThatHolds, 1);
    const SceneDepth held = sceneDepth(scaled(deep.strengthThatHolds), sceneState, picture);
    EXPECT_LE(held.held.nearest, held.scene.nearest * (1 + 1e-9));
    EXPECT_GE(held.held.farthest, held.scene.farthest * (1 - 1e-9));
    EXPECT_TRUE(held.warnings.empty());
    const SceneDepth more = sceneDepth(scaled(deep.strengthThatHolds * 1.05), sceneState, picture);
    EXPECT_FALSE(more.warnings.empty());
}

}  // namespace
}  // namespace vitrine::printing
