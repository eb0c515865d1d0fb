#include "tests/ui/print/open_print_dialog.h"
#include "tests/ui/ui_main.h"

#include "ui/print/eyes_preview.h"
#include "ui/print/strip_preview.h"

#include <QWheelEvent>

#include <cmath>
#include <limits>

using namespace vitrine;
using namespace vitrine::ui;

/// Previews of the print dialog.
class PrintPreviewTest : public test::OpenPrintDialog {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }
    void init() { start(); }
    void cleanup() { finish(); }

    void draggingTurnsTheCardThroughItsViews()
    {
        const int count = 5;
        dialog_->openFiles(solidViews(count));
        settle();
        ParameterValues values = dialog_->values();
        values.setParameter(*values.table().find("distance"),
                            1000.0);  // One direction for the whole card and both eyes.
        values.setParameter(*values.table().find("width"), 0.03);
        values.setParameter(*values.table().find("height"), 0.02);
        values.setParameter(*values.table().find("dotsPerInch"), 1440.0);
        dialog_->setValues(values);
        settle();
        auto* eyes = dialog_->findChild<EyesPreview*>();
        // Chief rays: the middle of view k's part of a zone of 30 degrees; the mean over the lens differs by 4 %.
        for (const int k : {0, 4, 2, 3, 1}) {
            const double angle = std::atan(((k + 0.5) / count - 0.5) * 2 * std::tan(3.14159265358979 / 12) * 1.04);
            const QPoint from(200, 60);
            const QPoint to =
                from +
                QPoint(static_cast<int>(std::lround((angle - eyes->angle()) / (0.15 * 3.14159265358979 / 180))), 0);
            QTest::mousePress(eyes, Qt::LeftButton, {}, from);
            QTest::mouseMove(eyes, (from + to) / 2);
            QTest::mouseMove(eyes, to);
            QTest::mouseRelease(eyes, Qt::LeftButton, {}, to);
            QVERIFY(std::abs(eyes->angle() - angle) < 0.003);
            QTRY_COMPARE(eyes->shownAngle(), eyes->angle());
            for (const std::size_t eye : {std::size_t{0}, std::size_t{1}}) {
                const QImage& seen = eyes->seen(eye);
                const QColor at = seen.pixelColor(seen.width() / 2, seen.height() / 2);
                int best = 0;
                int bestDistance = 1000;
                for (int view = 0; view < count; ++view) {
                    const QColor color = colorOf(view, count);
                    const int distance = std::abs(color.red() - at.red()) + std::abs(color.green() - at.green()) +
                                         std::abs(color.blue() - at.blue());
                    if (distance < bestDistance) best = view;
                    bestDistance = std::min(bestDistance, distance);
                }
                QCOMPARE(best, k);
            }
        }
    }

    /// At the given distance, or at 40 cm where the print is made for none.
    void longTheTwoEyesSeeNeighboringViews_data()
    {
        QTest::addColumn<double>("distance");
        QTest::newRow("40 cm") << 0.4;
        QTest::newRow("none") << std::numeric_limits<double>::infinity();
    }

    void longTheTwoEyesSeeNeighboringViews()
    {
        QFETCH(const double, distance);
        const int count = 12;
        dialog_->openFiles(solidViews(count));
        set("distance", distance);
        auto* eyes = dialog_->findChild<EyesPreview*>();
        QTRY_VERIFY(!eyes->seen(1).isNull());
        const auto hue = [&](std::size_t eye) {
            return eyes->seen(eye).pixelColor(eyes->seen(eye).width() / 2, eyes->seen(eye).height() / 2).hueF();
        };
        // 65 mm at 400 mm are 9.3 of the zone's 31 degrees, or about 3.6 of 12 views with 25 degrees of hue each.
        const double views = static_cast<double>(hue(1) - hue(0)) * 360 / 25;
        QVERIFY2(views > 2.6 && views < 4.6, qPrintable(QString::number(views)));
        QTest::keyClick(eyes, Qt::Key_Right);
        QVERIFY(std::abs(eyes->angle() - 3.14159265358979 / 180) < 1e-9);
        QTest::keyClick(eyes, Qt::Key_Up, Qt::ShiftModifier);
        QVERIFY(std::abs(eyes->angleAlong() - 3.14159265358979 / 1800) < 1e-9);
        QTest::keyClick(eyes, Qt::Key_Home);
        QCOMPARE(eyes->angle(), 0.0);
    }

    void theRasterIsZoomedByTheWheelAboutThePointer()
    {
        dialog_->openFiles(solidViews(3));
        settle();
        auto* strips = dialog_->findChild<StripPreview*>();
        QTRY_VERIFY(!strips->image().isNull());
        const double before = strips->zoom();
        const QPointF at(40, 30);
        for (int i = 0; i < 4; ++i) {
            QWheelEvent turn(at, strips->mapToGlobal(at), {}, {0, 120}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
            QApplication::sendEvent(strips, &turn);
        }
        QVERIFY(std::abs(strips->zoom() / before - std::pow(1.25, 4)) < 1e-9);
        QTest::keyClick(strips, Qt::Key_Minus);
        QVERIFY(strips->zoom() < before * 2);
        for (int i = 0; i < 40; ++i) QTest::keyClick(strips, Qt::Key_Minus);
        QTRY_VERIFY(strips->image().width() > strips->width());  // Whole dots, displayed smaller.
    }
};

VITRINE_UI_TEST(PrintPreviewTest)

#include "print_preview_test.moc"
