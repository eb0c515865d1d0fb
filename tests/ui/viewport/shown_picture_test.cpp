#include "tests/ui/ui_main.h"

#include "ui/viewport/shown_picture.h"

#include <QTest>

using namespace vitrine;
using namespace vitrine::ui;

namespace {

/// Returns a drawn picture of one color, 8 x 6 pixels. `sample`: index of its supersample.
DrawnPicture drawnWhole(Qt::GlobalColor color, int sample)
{
    DrawnPicture drawn;
    drawn.image = QImage(8, 6, QImage::Format_RGB32);
    drawn.image.fill(color);
    drawn.order.order.sample = sample;
    drawn.order.screen = drawn.image.size();
    return drawn;
}

/// Returns a drawn region of one color: 2 x 3 pixels, its lower left corner at (5, 1).
DrawnPicture drawnRegion(Qt::GlobalColor color)
{
    DrawnPicture drawn;
    drawn.image = QImage(2, 3, QImage::Format_RGB32);
    drawn.image.fill(color);
    drawn.order.screen = {8, 6};
    drawn.order.region = PictureRegion{{5, 1}, {2, 3}};
    return drawn;
}

/// Returns whether exactly the pixels of the region have its color, and all others that of the picture.
bool liesOver(const QImage& image, Qt::GlobalColor ofRegion, Qt::GlobalColor ofPicture)
{
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const bool inside = x >= 5 && x < 7 && y >= 2 && y < 5;  // Rows are counted from above here.
            if (image.pixelColor(x, y) != QColor(inside ? ofRegion : ofPicture)) return false;
        }
    return true;
}

}  // namespace

class ShownPictureTest : public QObject {
    Q_OBJECT

private slots:
    void aRegionLiesOverThePictureAtItsPlace()
    {
        ShownPicture shown;
        QVERIFY(shown.image().isNull());
        shown.show(drawnWhole(Qt::red, 0));
        QVERIFY(!shown.hasRegion());
        shown.showRegion(drawnRegion(Qt::green));
        QVERIFY(shown.hasRegion());
        QVERIFY(liesOver(shown.image(), Qt::green, Qt::red));
    }

    void aRegionStaysOverLaterSamplesAndGoesWithTheNextPicture()
    {
        ShownPicture shown;
        shown.show(drawnWhole(Qt::red, 0));
        shown.showRegion(drawnRegion(Qt::green));
        shown.show(drawnWhole(Qt::blue, 1));
        QVERIFY(shown.hasRegion());
        QVERIFY(liesOver(shown.image(), Qt::green, Qt::blue));
        shown.show(drawnWhole(Qt::yellow, 0));
        QVERIFY(!shown.hasRegion());
        QVERIFY(liesOver(shown.image(), Qt::yellow, Qt::yellow));
    }

    void aRegionLeavesTheDrawnPictureItselfAsItWas()
    {
        const DrawnPicture drawn = drawnWhole(Qt::red, 0);
        ShownPicture shown;
        shown.show(drawn);
        shown.showRegion(drawnRegion(Qt::green));
        QVERIFY(liesOver(drawn.image, Qt::red, Qt::red));
    }

    void picturesAndRegionsAreCountedAndTheOrderOfThePictureIsKept()
    {
        ShownPicture shown;
        DrawnPicture drawn = drawnWhole(Qt::red, 2);
        drawn.order.request.time = 7.5;
        shown.show(drawn);
        shown.showRegion(drawnRegion(Qt::green));
        shown.showRegion(drawnRegion(Qt::blue));
        QCOMPARE(shown.pictures(), 1LL);
        QCOMPARE(shown.regions(), 2LL);
        QCOMPARE(shown.request().time, 7.5);
        QCOMPARE(shown.order().sample, 2);
    }
};

VITRINE_UI_TEST(ShownPictureTest)

#include "shown_picture_test.moc"
