#include "tests/ui/open_window.h"
#include "tests/ui/ui_main.h"

#include "ui/kit/message_strip.h"
#include "ui/report/frame_graph.h"
#include "ui/viewport/overlay.h"
#include "ui/window/status_line.h"

#include <QSignalSpy>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <set>
#include <thread>

using namespace vitrine;
using namespace vitrine::ui;

/// Checks when the window draws its picture, with a gallery whose picture has one color.
class WindowPictureTest : public test::OpenWindow {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        mostSamples_ = asTheHallRequests;
        prepare();
    }
    void init() { start(); }
    void cleanup() { finish(); }

    void longOneMoveOfTheMouseStartsThePictureAnewOnce()
    {
        window_->choose(1);
        settle();
        const auto before = static_cast<std::ptrdiff_t>(gallery_->requests().size());
        QSignalSpy changed(&window_->history(), &History::changed);
        auto* slider = in<ValueSlider>("roughness");
        QTest::mousePress(slider, Qt::LeftButton, {}, {slider->width() - 20, slider->height() / 2});
        QTest::mouseRelease(slider, Qt::LeftButton, {}, {slider->width() - 20, slider->height() / 2});
        settle();
        QCOMPARE(changed.count(), 1);
        const std::vector<FrameRequest> requests = gallery_->requests();
        const glm::ivec2 whole = requests.back().raster.size;
        const auto full = std::count_if(requests.begin() + before, requests.end(), [&](const FrameRequest& request) {
            return request.sample == 0 && request.raster.size == whole;
        });
        QCOMPARE(full, 1);
    }

    void anIdleWindowDrawsNothing()
    {
        settle();
        QTest::qWait(300);
        const long long drawn = window_->viewport().pictures().shown().pictures();
        QTest::qWait(2000);
        QCOMPARE(window_->viewport().pictures().shown().pictures(), drawn);
        QVERIFY(window_->findChild<StatusLine*>()->text().contains("Done ("));
        QVERIFY(window_->findChild<FrameGraph*>()->summary().contains("frame"));
    }

    void longAChangeDoesNotWaitForWhatChangesByItselfMuchLater()
    {
        window_->choose(1);
        gallery_->exhibit().changesIn = 3600;
        window_->viewport().scene().change();
        settle();
        QTRY_VERIFY(window_->viewport().pictures().nextTick() > 1'000'000);
        dragRoughness(60);
        QCOMPARE(window_->viewport().pictures().nextTick(), 0);
        settle();
        QTRY_VERIFY(window_->viewport().pictures().nextTick() > 1'000'000);
        QTest::keyPress(&window_->viewport(), Qt::Key_W);
        QCOMPARE(window_->viewport().pictures().nextTick(), 0);
        QTest::keyRelease(&window_->viewport(), Qt::Key_W);
    }

    void longValuesThatRestAreDrawnFasterWithoutAnotherPicture()
    {
        window_->choose(1);
        settle();
        const std::size_t before = gallery_->requests().size();
        gallery_->betterBuilds =
            0;  // Before the drag: a busy machine may need longer for its picture than values to rest.
        dragRoughness(40);
        settle();
        QVERIFY(!gallery_->requests()[before].idle);
        const long long drawn = window_->viewport().pictures().shown().pictures();
        QTRY_VERIFY_WITH_TIMEOUT(window_->viewport().scene().request().idle, test::patience);
        QTRY_VERIFY_WITH_TIMEOUT(gallery_->betterBuilds > 0, test::patience);
        QVERIFY2(gallery_->betterBuilds < 100, "only while the values rest");
        QCOMPARE(gallery_->strangers, 0);
        QCOMPARE(window_->viewport().pictures().shown().pictures(), drawn);
        window_->viewport().scene().change();  // Like a visitor who looks around.
        settle();
        QVERIFY(gallery_->requests().back().idle);
        const std::size_t rested = gallery_->requests().size();
        dragRoughness(60);
        settle();
        QVERIFY2(!gallery_->requests()[rested].idle, "a drag ends the rest");
    }

    void aStillPictureIsRefinedOverSixteenSamples()
    {
        gallery_->forgetRequests();
        window_->viewport().scene().change();
        QTRY_VERIFY(gallery_->requests().size() >= 16);
        settle();
        QCOMPARE(gallery_->requests().back().sample, 15);
        QCOMPARE(gallery_->requests().back().samples, 16);
    }

    void longARowThatDoesNotActDrawsNothingAgain()
    {
        window_->choose(1);
        SceneState next = window_->history().sceneState();
        next.values[1].set(gallery_->table().animated, false);
        window_->history().change("Stand still", next);
        settle();
        const long long drawn = window_->viewport().pictures().shown().pictures();
        next.values[1].set(gallery_->table().speed, 3.0);  // Has an effect only while it is animated.
        window_->history().change("Change speed", next);
        QTest::qWait(300);
        QCOMPARE(window_->viewport().pictures().shown().pictures(), drawn);
        next.values[1].set(gallery_->table().animated, true);
        window_->history().change("Move", next);
        QTRY_VERIFY(window_->viewport().pictures().shown().pictures() > drawn);
    }

    void longANewWindowAroundThePictureShowsItAndLeavesWhatDrawsItAlone()
    {
        // Without shared contexts a new top-level window means a new context for the widget.
        const QColor before = window_->viewport().grabFramebuffer().pixelColor(20, 20);
        auto* other = new QWidget;
        QWidget* home = window_->viewport().parentWidget();
        window_->viewport().setParent(other);
        other->resize(320, 240);
        window_->viewport().resize(320, 240);
        window_->viewport().show();
        other->show();
        QVERIFY(QTest::qWaitForWindowExposed(other, vitrine::test::patience));
        QTRY_COMPARE(window_->viewport().pictures().shown().image().size(), QSize(320, 240));
        settle();
        QCOMPARE(window_->viewport().grabFramebuffer().pixelColor(20, 20), before);
        QCOMPARE(gallery_->opened, 1);
        QCOMPARE(gallery_->closed, 0);
        window_->viewport().setParent(home);
        delete other;
    }

    void longTheWindowsThreadDrawsNothing()
    {
        window_->choose(1);
        dragRoughness(60);
        window_->visit(1);
        settle();
        QVERIFY(!gallery_->requests().empty());
        QVERIFY(gallery_->thread != std::this_thread::get_id());
        QCOMPARE(gallery_->strangers, 0);
    }

    void longUntilTheFirstPictureTheViewportSaysThatItComes()
    {
        closeWindow();
        gallery_ = std::make_unique<test::PaintedGallery>();
        std::atomic<bool> held = true;
        gallery_->beforeDrawing = [&](const FrameRequest&, const Renderers::IsCanceled&) {
            while (held) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        };
        window_ = std::make_unique<MainWindow>(gallery_->museum(), *gallery_, makeWindowActions);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get(), test::patience));
        const auto colors = [&] {
            const QImage picture = window_->viewport().grabFramebuffer();
            std::set<QRgb> found;
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x) found.insert(picture.pixel(x, y));
            return found.size();
        };
        const auto opening = colors();
        held = false;
        settle();
        QVERIFY2(opening > 3, "no words");
        QCOMPARE(colors(), std::size_t(1));
    }

    void aPictureThatTakesLongHoldsNothingUpAndTheNewestComesNext()
    {
        window_->choose(1);
        settle();
        std::promise<void> begun, enough;
        std::shared_future<void> released = enough.get_future().share();
        std::atomic<int> pictures = 0;
        gallery_->beforeDrawing = [&](const FrameRequest&, const Renderers::IsCanceled&) {
            if (++pictures != 1) return;
            begun.set_value();
            released.wait();
        };
        dragRoughness(10);
        QTRY_VERIFY(pictures == 1);
        begun.get_future().wait();
        // The window keeps running: each of these needs another picture, and none can be drawn.
        double last = roughness();
        for (const int pixels : {30, 50, 40, 60}) {
            dragRoughness(pixels);
            QVERIFY(roughness() != last);
            last = roughness();
        }
        action("About Vitrine")->trigger();
        QCOMPARE(pictures, 1);
        gallery_->forgetRequests();
        enough.set_value();
        QTRY_VERIFY(gallery_->requests().size() >= 2);
        // The delayed picture ends, and the next one shows the newest value: the four between are never drawn.
        QTRY_VERIFY(window_->viewport().pictures().schedule().current());
        settle();
        QCOMPARE(window_->viewport().pictures().shown().image().pixelColor(20, 20).red(),
                 QColor::fromRgbF(static_cast<float>(last), 0, 0).red());
        QVERIFY2(pictures <= 2 + 16, qPrintable(QString::number(pictures)));
        gallery_->beforeDrawing = {};
    }

    void longAnOutdatedSupersampleIsGivenUp()
    {
        window_->choose(1);
        settle();
        std::atomic<int> abandoned = 0;
        std::atomic<bool> reached = false;
        gallery_->beforeDrawing = [&](const FrameRequest& request, const Renderers::IsCanceled& isCanceled) {
            if (request.sample != 3 || abandoned > 0) return;
            reached = true;
            while (!isCanceled()) std::this_thread::yield();
            ++abandoned;
            throw render::gl::Abandoned();
        };
        window_->viewport().scene().change();
        QTRY_VERIFY(reached);
        dragRoughness(60);
        QTRY_COMPARE(int(abandoned), 1);
        settle();
        QCOMPARE(window_->viewport().pictures().shown().image().pixelColor(20, 20).red(),
                 QColor::fromRgbF(static_cast<float>(roughness()), 0, 0).red());
        QVERIFY(window_->findChild<MessageStrip*>()->texts().isEmpty());
        gallery_->beforeDrawing = {};
    }

    void whatIsAskedOfOneMomentIsPreparedOnce()
    {
        Viewport& viewport = window_->viewport();
        settle();
        const long long before = viewport.scene().preparations();
        // Queries the button in view and the animations, with one preparation.
        viewport.visitor().jumpTo(test::PaintedGallery::towardsButton(1.2));
        settle();
        QCOMPARE(viewport.scene().preparations(), before + 1);
        QTest::mouseMove(&viewport, viewport.rect().center());
        QTRY_COMPARE(viewport.cursor().shape(), Qt::PointingHandCursor);
        QCOMPARE(viewport.scene().preparations(), before + 1);
    }

    void longWhatMovesFarAwayNeitherCoarsensNorRestartsThePicture()
    {
        window_->choose(1);
        SceneState alight = window_->history().sceneState();  // A shadow on the floor would move, too.
        alight.hall().setParameter(*alight.hall().table().find("sunShadows"), 0.0);
        window_->history().change("Without shadows", alight);
        settle();
        const QImage before = window_->viewport().pictures().shown().image();
        const int height = before.height();
        FrameRequest request = gallery_->requests().back();
        request.raster.size = {before.width(), height};
        const Museum& museum = gallery_->museum();
        gallery_->exhibit().moves = true;
        const PictureRegion region =
            museum.movingRegion(museum.prepare(window_->history().sceneState(), request), request).value();
        QVERIFY(region.size.x > 10 && region.size.y > 10 && 4 * region.size.x < before.width());
        window_->viewport().scene().change();
        QTRY_VERIFY(window_->viewport().pictures().shown().regions() >= 2);
        const long long whole = window_->viewport().pictures().shown().pictures();
        const auto requests = gallery_->requests();
        QVERIFY(std::none_of(requests.end() - 1, requests.end(),
                             [](const FrameRequest& r) { return r.raster.size.x < 100; }));
        const QImage now = window_->viewport().pictures().shown().image();
        QCOMPARE(now.size(), before.size());
        int moved = 0, elsewhere = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < now.width(); ++x) {
                if (now.pixel(x, y) == before.pixel(x, y)) continue;
                const glm::ivec2 place = glm::ivec2(x, height - 1 - y) - region.offset;
                const bool within = glm::all(glm::greaterThanEqual(place, glm::ivec2(0))) &&
                                    glm::all(glm::lessThan(place, region.size));
                ++(within ? moved : elsewhere);
            }
        QCOMPARE(moved, region.size.x * region.size.y);
        QCOMPARE(elsewhere, 0);
        const long long regions = window_->viewport().pictures().shown().regions();
        QTRY_VERIFY(window_->viewport().pictures().shown().regions() > regions);
        gallery_->exhibit().moves = false;  // The motion has ended.
        QTest::qWait(500);
        QTRY_VERIFY_WITH_TIMEOUT(window_->viewport().pictures().schedule().still(), vitrine::test::patience);
        const long long rested = window_->viewport().pictures().shown().regions();
        const long long refined = window_->viewport().pictures().shown().pictures();
        QVERIFY(refined - whole <= 16);
        QTest::qWait(500);
        QCOMPARE(window_->viewport().pictures().shown().regions(), rested);
        QCOMPARE(window_->viewport().pictures().shown().pictures(), refined);
        // A screenshot of it is drawn separately, because the picture behind the region has another time.
        QVERIFY(!window_->viewport().pictures().finished());
    }

    void longAJumpOfTheCameraIsACutAndWhatIsRefinedIsNone()
    {
        settle();
        gallery_->forgetRequests();
        window_->viewport().visitor().jumpTo({{0, 1.65, 8}, {0, 1.5, 0}, 0.9});
        settle();
        window_->viewport().scene().change();
        settle();
        const std::vector<FrameRequest> requests = gallery_->requests();
        QVERIFY(requests.size() >= 32);
        QVERIFY(requests.front().resetHistory);
        QCOMPARE(std::count_if(requests.begin(), requests.end(), [](const FrameRequest& r) { return r.resetHistory; }),
                 1);
        QVERIFY(std::none_of(requests.begin(), requests.end(), [](const FrameRequest& r) { return r.finished; }));
    }

    void longAFileThatTakesLongToReadIsNamedAndHoldsUpNothing()
    {
        settle();
        const QString path = home_->filePath("panorama.hdr");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(QByteArray(5000, 'x')) == 5000);
        file.close();
        std::promise<void> begun, end;
        gallery_->exhibit().read = [&](const std::string&) {
            begun.set_value();
            end.get_future().wait();
            return render::AssetStore::Made<int>{std::make_shared<int>(1), 4};
        };
        gallery_->exhibit().file = path.toStdString();
        window_->viewport().scene().change();
        const std::future<void> reading = begun.get_future();
        QTRY_VERIFY(reading.wait_for(std::chrono::seconds(0)) == std::future_status::ready);
        const auto said = [&] {
            for (const Overlay* overlay : window_->viewport().findChildren<Overlay*>())
                if (overlay->isVisible() && overlay->text().startsWith("Reading ")) return overlay->text();
            return QString();
        };
        QTRY_VERIFY(said().startsWith("Reading panorama.hdr ("));
        // The window keeps responding in the meantime: its preparations do not wait.
        const long long before = window_->viewport().scene().preparations();
        const auto camera = window_->history().sceneState().camera;
        QTest::mousePress(&window_->viewport(), Qt::LeftButton, {}, {50, 50});
        QTest::mouseMove(&window_->viewport(), {120, 60});
        QTest::mouseRelease(&window_->viewport(), Qt::LeftButton, {}, {120, 60});
        QVERIFY(!(window_->history().sceneState().camera == camera));
        QVERIFY(window_->viewport().scene().preparations() > before);
        const QString later = said();
        QTRY_VERIFY(said() != later);  // The displayed seconds advance.
        end.set_value();
        QTRY_COMPARE(said(), QString());
        QTRY_VERIFY(window_->viewport().pictures().schedule().still());
        gallery_->exhibit().file.clear();
    }

    void aFrameWithWorkLeftIsDrawnAgain()
    {
        settle();
        gallery_->forgetRequests();
        gallery_->unfinishedFrames = 3;
        window_->viewport().scene().change();
        settle();
        QCOMPARE(int(gallery_->unfinishedFrames), 0);
        // Each of the three starts again; only the fourth is refined completely.
        QVERIFY(gallery_->requests().size() >= std::size_t(3 + window_->viewport().pictures().schedule().samples()));
        QTRY_VERIFY(window_->viewport().pictures().schedule().still());
    }
};

VITRINE_UI_TEST(WindowPictureTest)

#include "window_picture_test.moc"
