#include "tests/ui/open_window.h"
#include "tests/ui/point_at.h"
#include "tests/ui/ui_main.h"

#include "render/files/assets.h"
#include "ui/kit/message_strip.h"
#include "ui/viewport/overlay.h"

#include <QDropEvent>
#include <QElapsedTimer>
#include <QFile>
#include <QMenu>
#include <QMimeData>

using namespace vitrine;
using namespace vitrine::ui;

/// The visitor's own objects in the window: dropped, visited, undone, removed.
class OwnObjectsTest : public test::OpenWindow {
    Q_OBJECT

    /// Writes a bear of this name to the folder of the test.
    [[nodiscard]] QString bear(const QString& name) const
    {
        const QString path = home_->filePath(name);
        QFile::copy(QString::fromStdString(render::asset("models/teddy.glb").string()), path);
        return path;
    }
    void drop(const QStringList& files)
    {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString& file : files) urls << QUrl::fromLocalFile(file);
        data.setUrls(urls);
        QDragEnterEvent enter({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(window_.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent event({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(window_.get(), &event);
    }
    /// Returns the file names at the four places.
    [[nodiscard]] QStringList standing() const
    {
        const ParameterValues& hall = window_->history().sceneState().hall();
        QStringList names;
        for (const char* row : {"model", "secondModel", "thirdModel", "fourthModel"})
            names << QFileInfo(QString::fromStdString(std::get<std::string>(hall.row(*hall.table().find(row)))))
                         .fileName();
        return names;
    }
    [[nodiscard]] QStringList said() const { return window_->findChild<MessageStrip*>()->texts(); }
    [[nodiscard]] QMenu* menu() const
    {
        for (QMenu* menu : window_->findChildren<QMenu*>())
            if (menu->title().remove('&') == "Your objects") return menu;
        return nullptr;
    }
    /// Returns an entry of the menu as it is when opened.
    [[nodiscard]] QAction* entry(const QString& text) const
    {
        emit menu()->aboutToShow();
        for (QAction* action : menu()->actions())
            if (action->text().remove('&') == text) return action;
        return nullptr;
    }
    [[nodiscard]] render::Camera camera() const { return window_->history().sceneState().camera; }
    [[nodiscard]] QStringList overlays() const
    {
        QStringList shown;
        for (const Overlay* overlay : window_->viewport().findChildren<Overlay*>())
            if (overlay->isVisible()) shown << overlay->text();
        return shown;
    }

private slots:
    void initTestCase() { prepare(); }
    void init() { start(); }
    void cleanup() { finish(); }

    void twoDroppedAtOnceStandAtTheFirstTwoPlacesAndAreUndoneOneByOne()
    {
        drop({bear("one.glb"), bear("two.glb")});
        QTRY_COMPARE(standing(), (QStringList{"one.glb", "two.glb", "", ""}));
        QCOMPARE(window_->history().stack().count(), 2);
        QCOMPARE(window_->history().stack().undoText(), QString("Put two.glb into the hall"));
        window_->history().stack().undo();
        QCOMPARE(standing(), (QStringList{"one.glb", "", "", ""}));
        window_->history().stack().undo();
        QCOMPARE(standing(), (QStringList{"", "", "", ""}));
        window_->history().stack().redo();
        QCOMPARE(standing(), (QStringList{"one.glb", "", "", ""}));
        QVERIFY(said().isEmpty());
    }

    void longEachIsVisitedFromTheMenuAndPickedInThePicture()
    {
        QVERIFY(menu());
        emit menu()->aboutToShow();
        QCOMPARE(menu()->actions().size(), 1);
        QVERIFY(!menu()->actions().front()->isEnabled());
        drop({bear("one.glb"), bear("two.glb"), bear("three.glb")});
        QTRY_COMPARE(standing(), (QStringList{"one.glb", "two.glb", "three.glb", ""}));
        QTRY_COMPARE(window_->museum().surroundings().ownObjects(window_->viewport().scene().prepared()).size(),
                     std::size_t{3});
        for (const OwnObjectShown& object :
             window_->museum().surroundings().ownObjects(window_->viewport().scene().prepared())) {
            const QString visit = "Visit " + standing()[static_cast<int>(object.which)];
            QVERIFY2(entry(visit) && entry(visit)->isEnabled(), qPrintable(visit));
            entry(visit)->trigger();
            QTRY_VERIFY2(glm::distance(camera().eye, object.view.eye) < 1e-6, qPrintable(visit));
            QVERIFY(glm::distance(camera().target, object.view.target) < 1e-6);
            // From farther away, a click on it leads to the same view.
            render::Camera away = object.view;
            away.eye += 0.6 * (away.eye - away.target);
            window_->viewport().visitor().jumpTo(away);
            QTRY_VERIFY(glm::distance(camera().eye, away.eye) < 1e-6);
            settle();
            const QPoint middle = window_->viewport().rect().center();
            vitrine::test::pointAt(window_->viewport(), middle - QPoint(200, 100));
            const QString name = QString::fromStdString(object.name);
            // The pointer moves a little until the name is shown, because events of the real pointer may come late and
            // reset it.
            QElapsedTimer since;
            since.start();
            for (int turn = 0; !overlays().contains(name) && since.elapsed() < vitrine::test::patience; ++turn) {
                vitrine::test::pointAt(window_->viewport(), middle + QPoint(turn % 2, 0));
                QTest::qWait(1000);
            }
            QVERIFY2(overlays().contains(name), qPrintable(name + " is not named: " + overlays().join(';')));
            QTest::mouseClick(&window_->viewport(), Qt::LeftButton, {}, middle);
            QTRY_VERIFY2(glm::distance(camera().eye, object.view.eye) < 1e-6, qPrintable(name));
        }
    }

    void removingOneIsOneStepAndLeavesTheOthers()
    {
        drop({bear("one.glb"), bear("two.glb"), bear("three.glb")});
        QTRY_COMPARE(standing(), (QStringList{"one.glb", "two.glb", "three.glb", ""}));
        QVERIFY(entry("Remove two.glb"));
        entry("Remove two.glb")->trigger();
        QCOMPARE(standing(), (QStringList{"one.glb", "", "three.glb", ""}));
        QCOMPARE(window_->history().stack().count(), 4);
        QVERIFY(!entry("Remove two.glb"));
        // The next object takes the free place.
        drop({bear("four.glb")});
        QTRY_COMPARE(standing(), (QStringList{"one.glb", "four.glb", "three.glb", ""}));
        window_->history().stack().undo();
        window_->history().stack().undo();
        QCOMPARE(standing(), (QStringList{"one.glb", "two.glb", "three.glb", ""}));
    }

    void aFifthIsAnsweredWithOneSentenceAndChangesNothing()
    {
        drop({bear("1.glb"), bear("2.glb"), bear("3.glb"), bear("4.glb"), bear("5.glb")});
        QTRY_COMPARE(said().size(), 1);
        QVERIFY2(said().front().startsWith("5.glb was not put into the hall: "), qPrintable(said().front()));
        QCOMPARE(standing(), (QStringList{"1.glb", "2.glb", "3.glb", "4.glb"}));
        QCOMPARE(window_->history().stack().count(), 4);
    }

    void aFileThatIsNoModelTakesNoPlace()
    {
        QFile noise(home_->filePath("noise.glb"));
        QVERIFY(noise.open(QFile::WriteOnly));
        noise.write(QByteArray(300, '\x17'));
        noise.close();
        drop({bear("one.glb"), noise.fileName(), bear("two.glb")});
        QTRY_COMPARE(standing(), (QStringList{"one.glb", "two.glb", "", ""}));
        QCOMPARE(said().size(), 1);
        QVERIFY2(said().front().contains("noise.glb") && said().front().endsWith("Nothing was changed."),
                 qPrintable(said().front()));
    }
};

VITRINE_UI_TEST(OwnObjectsTest)

#include "own_objects_test.moc"
