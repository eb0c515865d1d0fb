// The divider of the pixel art, dragged on its screen in the hall by real mouse events.

#include "tests/ui/open_window.h"
#include "tests/ui/ui_main.h"

#include "exhibits/pixel_art/pixel_art.h"
#include "exhibits/pixel_art/pixel_camera.h"

using namespace vitrine;
using namespace vitrine::ui;

class PixelDividerTest : public test::OpenWindow {
    Q_OBJECT

    static constexpr std::size_t art = 2;
    const pixel_art::PixelArt exhibit_{};
    const pixel_art::PixelArtTable& t_ = exhibit_.parameters();

    std::unique_ptr<Exhibit> anotherExhibit() override { return std::make_unique<pixel_art::PixelArt>(); }
    [[nodiscard]] const ParameterValues& values() { return window_->history().sceneState().values[art]; }
    [[nodiscard]] QUndoStack& stack() { return window_->history().stack(); }
    /// Returns the position of the line's center in the picture.
    [[nodiscard]] QPointF line()
    {
        const render::View view = window_->viewport().scene().view();
        const glm::dmat4 world = gallery_->museum().worldFromExhibit(art);
        const glm::dvec3 eye(glm::inverse(world) * glm::dvec4(view.eye, 1));
        const std::vector<DraggedLine> lines =
            exhibit_.draggedLines({values(), window_->viewport().clock().time()}, eye);
        if (lines.size() != 1) return {-1, -1};
        const glm::dvec4 clip = view.clipFromWorld * world * glm::dvec4(0.5 * (lines[0].from + lines[0].to), 1);
        const QSize size = window_->viewport().size();
        return {(0.5 + 0.5 * clip.x / clip.w) * size.width(), (0.5 - 0.5 * clip.y / clip.w) * size.height()};
    }
    void drag(const QPoint& from, int pixels)
    {
        Viewport* viewport = &window_->viewport();
        QTest::mousePress(viewport, Qt::LeftButton, {}, from);
        for (int x = 0; std::abs(x) < std::abs(pixels); x += pixels > 0 ? 5 : -5)
            QTest::mouseMove(viewport, from + QPoint(x, 0));
        QTest::mouseMove(viewport, from + QPoint(pixels, 0));
        QTest::mouseRelease(viewport, Qt::LeftButton, {}, from + QPoint(pixels, 0));
    }

private slots:
    void initTestCase() { prepare(); }
    void init()
    {
        start();
        window_->visit(art);
        QTRY_COMPARE(window_->viewport().visitor().mode(), CameraControl::Mode::orbit);
        window_->history().set(art, t_.split.row, 1.0, 0);
        settle();
    }
    void cleanup() { finish(); }

    void itFollowsThePointerByWholeTexelsInOneStep()
    {
        const int steps = stack().count();
        const render::Camera camera = window_->history().sceneState().camera;
        const QPointF before = line();
        QVERIFY(window_->viewport().rect().contains(before.toPoint()));
        drag(before.toPoint(), 83);
        QCOMPARE(stack().count(), steps + 1);
        const double columns = values()[t_.divider] * pixel_art::sizeOf(values()[t_.resolution]).x;
        QVERIFY(std::abs(columns - std::round(columns)) < 1e-9);
        QVERIFY(values()[t_.divider] > 0.5);
        // 83 pixels of the pointer, within half a texel.
        const double texel = 83 / std::max(columns - 0.5 * pixel_art::sizeOf(values()[t_.resolution]).x, 1.0);
        QVERIFY2(std::abs(line().x() - before.x() - 83) <= 0.5 * texel + 1,
                 qPrintable(QStringLiteral("%1, a texel of %2").arg(line().x() - before.x()).arg(texel)));
        QCOMPARE(window_->history().sceneState().camera, camera);
        stack().undo();
        QCOMPARE(values()[t_.divider], 0.5);
    }

    void longFarBesideTheScreenItStaysAtItsBorder()
    {
        drag(line().toPoint(), -2000);
        QCOMPARE(values()[t_.divider], 0.0);
    }

    void longWithoutTwoHalvesThePictureIsTurned()
    {
        const QPoint at = line().toPoint();
        window_->history().set(art, t_.split.row, 0.0, 0);
        const render::Camera camera = window_->history().sceneState().camera;
        drag(at, 60);
        QCOMPARE(values()[t_.divider], 0.5);
        QVERIFY(!(window_->history().sceneState().camera == camera));
    }
};

VITRINE_WINDOW_TEST(PixelDividerTest)

#include "pixel_divider_test.moc"
