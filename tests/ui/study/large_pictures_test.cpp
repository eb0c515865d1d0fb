// Large pictures of a study: zoomed and moved together, pixel values, wipe. No GL.

#include "tests/ui/study/open_study_dock.h"
#include "tests/ui/ui_main.h"

#include "ui/study/large_pictures.h"
#include "ui/study/study_chart.h"
#include "ui/study/study_pictures.h"
#include "ui/study/study_view.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QToolButton>
#include <QWheelEvent>

using namespace vitrine;
using namespace vitrine::ui;

class LargePicturesTest : public test::OpenStudyDock {
    Q_OBJECT

private slots:
    void init() { start(); }
    void cleanup() { close(); }

    void longADoubleClickOpensThePicturesLargeAndTheyFollowTheStudy()
    {
        measure("steps");
        auto* small = dock_->findChild<StudyPictures*>();
        QTest::mouseDClick(small, Qt::LeftButton, {}, QPoint(20, 20));
        auto* large = dock_->findChild<LargePictures*>();
        QVERIFY(large && large->isVisible());
        QVERIFY(dock_->chart().isVisible());
        PicturePanes& panes = large->panes();
        QTRY_VERIFY(panes.panes().size() == 3);
        const QImage before = panes.grab().toImage();
        emit dock_->chart().hovered(0);
        QVERIFY(panes.grab().toImage() != before);
        // Both choices of the view stay equal.
        auto* view = large->findChild<QComboBox*>();
        QCOMPARE(view->count(), 3);
        view->setCurrentIndex(2);
        QCOMPARE(dock_->view().findChild<QComboBox*>("view")->currentIndex(), 2);
        large->close();
        QTest::keyClick(small, Qt::Key_Return);
        QVERIFY(large->isVisible());
        QCOMPARE(view->currentIndex(), 2);
    }

    void thePicturesAreZoomedAndMovedTogether()
    {
        LargePictures large;
        PicturePanes& panes = large.panes();
        render::Image picture(8, 4, 4), reference(8, 4, 4), errors(8, 4, 1);
        for (float& x : picture.pixels) x = 0.25F;
        for (float& x : reference.pixels) x = 0.5F;
        for (float& x : errors.pixels) x = 0.125F;
        picture.at(6, 1, 0) = 1;
        large.setPictures({picture, reference, errors, 1}, "a setting", "a scale");
        large.resize(900, 400);
        large.show();
        QVERIFY(QTest::qWaitForWindowExposed(&large));
        const double fitting = panes.scale();
        QVERIFY(fitting > 1);
        // Beyond 100 %, every pixel is a square of one color, at the same place in all panes.
        const auto colorAt = [&](std::size_t pane, QPointF pixel) {
            const QPointF at = panes.panes()[pane].center() + (pixel - panes.middle()) * panes.scale();
            return panes.grab().toImage().pixelColor(at.toPoint());
        };
        const QColor bright = colorAt(0, {6.2, 1.2});
        QVERIFY(bright.red() > 250);
        QCOMPARE(colorAt(0, {6.8, 1.8}), bright);
        QCOMPARE(colorAt(1, {6.2, 1.2}), colorAt(1, {6.8, 1.8}));
        // The wheel keeps the pixel under the pointer in place, in any pane.
        const auto pixelAt = [&](std::size_t pane, QPointF at) {
            return (at - panes.panes()[pane].center()) / panes.scale() + panes.middle();
        };
        const QPointF at = panes.panes()[1].center() + QPointF(20, 10);
        const QPointF held = pixelAt(1, at);
        QWheelEvent wheel(at, panes.mapToGlobal(at), {}, {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                          false);
        QApplication::sendEvent(&panes, &wheel);
        QVERIFY(panes.scale() > 1.5 * fitting);
        const QPointF now = pixelAt(1, at);
        QVERIFY(std::abs(now.x() - held.x()) < 1e-6 && std::abs(now.y() - held.y()) < 1e-6);
        QCOMPARE(pixelAt(0, panes.panes()[0].center()), pixelAt(2, panes.panes()[2].center()));
        // Dragging moves the picture.
        const QPoint start = panes.panes()[0].center().toPoint();
        const QPointF middle = panes.middle();
        QTest::mousePress(&panes, Qt::LeftButton, {}, start);
        QTest::mouseMove(&panes, start + QPoint(30, 0));
        QTest::mouseRelease(&panes, Qt::LeftButton, {}, start + QPoint(30, 0));
        QVERIFY(std::abs(middle.x() - panes.middle().x() - 30 / panes.scale()) < 0.05);
        // Keys do the same.
        panes.setFocus();
        QTest::keyClick(&panes, Qt::Key_0);
        const double scale = panes.scale();
        QTest::keyClick(&panes, Qt::Key_Plus);
        QVERIFY(panes.scale() > scale);
        QTest::keyClick(&panes, Qt::Key_Minus);
        QVERIFY(std::abs(panes.scale() - scale) < 1e-9);
        const double x = panes.middle().x();
        QTest::keyClick(&panes, Qt::Key_Right);
        QVERIFY(panes.middle().x() > x);
        QTest::keyClick(&panes, Qt::Key_1);
        QCOMPARE(panes.scale(), 1.0);
        QTest::keyClick(&panes, Qt::Key_0);
        QCOMPARE(panes.scale(), fitting);
    }

    void thePixelBelowThePointerIsReadInBoth()
    {
        LargePictures large;
        PicturePanes& panes = large.panes();
        render::Image picture(8, 4, 4), reference(8, 4, 4), errors(8, 4, 1);
        for (float& x : reference.pixels) x = 0.5F;
        picture.at(6, 1, 0) = 0.25F;
        errors.at(6, 1, 0) = 0.125F;
        large.setPictures({picture, reference, errors, 1}, {}, {});
        large.resize(900, 400);
        large.show();
        QVERIFY(QTest::qWaitForWindowExposed(&large));
        for (const std::size_t pane : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
            const QPointF at = panes.panes()[pane].center() + (QPointF(6.5, 1.5) - panes.middle()) * panes.scale();
            QTest::mouseMove(&panes, at.toPoint());
            QTRY_COMPARE(panes.pixel(), std::optional(QPoint(6, 1)));
            QCOMPARE(panes.reading(), QString("Pixel 6, 1: setting 0.25 0 0; reference 0.5 0.5 0.5; error 0.125"));
        }
        // Without a pointer, the pixel is the central one.
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&panes, &leave);
        QCOMPARE(panes.pixel(), std::optional(QPoint(4, 2)));
        QStringList shown;
        for (const QLabel* label : large.findChildren<QLabel*>()) shown << label->text();
        QVERIFY(shown.contains(panes.reading()));
    }

    void theWipeIsDraggedByItsLine()
    {
        LargePictures large;
        PicturePanes& panes = large.panes();
        render::Image picture(8, 4, 4), reference(8, 4, 4), errors(8, 4, 1);
        for (float& x : reference.pixels) x = 1.0F;
        large.setPictures({picture, reference, errors, 1}, {}, {});
        large.resize(900, 400);
        large.show();
        QVERIFY(QTest::qWaitForWindowExposed(&large));
        QToolButton* wipe = nullptr;
        for (QToolButton* each : large.findChildren<QToolButton*>())
            if (each->text() == QLatin1String("Wipe")) wipe = each;
        QVERIFY(wipe);
        QTest::mouseClick(wipe, Qt::LeftButton);
        QCOMPARE(panes.panes().size(), std::size_t{2});
        const QPointF line = panes.panes()[0].center();
        const QPointF middle = panes.middle();
        const double quarter = 2 * panes.scale();
        QTest::mousePress(&panes, Qt::LeftButton, {}, line.toPoint());
        QTest::mouseMove(&panes, (line - QPointF(quarter, 0)).toPoint());
        QTest::mouseRelease(&panes, Qt::LeftButton, {}, (line - QPointF(quarter, 0)).toPoint());
        QVERIFY2(std::abs(panes.wipe() - 0.25) < 0.02, qPrintable(QString::number(panes.wipe())));
        QCOMPARE(panes.middle(), middle);
        const QImage seen = panes.grab().toImage();
        const double left = line.x() - 4 * panes.scale();
        QVERIFY(seen.pixelColor(QPointF(left + 1.5 * panes.scale(), line.y() + panes.scale() * 1.5).toPoint()).red() <
                5);
        QVERIFY(seen.pixelColor(QPointF(left + 5.5 * panes.scale(), line.y() + panes.scale() * 1.5).toPoint()).red() >
                250);
        QTest::keyClick(&panes, Qt::Key_Right, Qt::ControlModifier);
        QVERIFY(panes.wipe() > 0.27);
    }
};

VITRINE_UI_TEST(LargePicturesTest)

#include "large_pictures_test.moc"
