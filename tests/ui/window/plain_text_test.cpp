// Texts of files and paths are shown as plain text: Qt would load files that HTML in them names.

#include "tests/ui/open_window.h"
#include "tests/ui/ui_main.h"

#include "ui/kit/message_strip.h"
#include "ui/kit/window_place.h"
#include "ui/lessons/lesson_bar.h"
#include "ui/lessons/lesson_controller.h"
#include "ui/presets/preset_controller.h"
#include "ui/print/print_dialog.h"
#include "ui/window/exhibit_list.h"
#include "ui/window/file_opener.h"
#include "ui/window/window_docks.h"

#include <QFile>
#include <QHelpEvent>
#include <QLabel>
#include <QMessageBox>
#include <QPointer>
#include <QScreen>
#include <QToolTip>

using namespace vitrine;
using namespace vitrine::ui;

class PlainTextTest : public test::OpenWindow {
    Q_OBJECT

    /// HTML with a picture of one red pixel.
    QString markup_;

    [[nodiscard]] static QLabel* tip()
    {
        for (QWidget* widget : QApplication::topLevelWidgets())
            if (widget->inherits("QTipLabel") && widget->isVisible()) return qobject_cast<QLabel*>(widget);
        return nullptr;
    }
    /// Opens the tooltip of a widget, like a resting pointer.
    QLabel* tipOver(QWidget& widget)
    {
        const QPoint at = widget.rect().center();
        QHelpEvent asked(QEvent::ToolTip, at, widget.mapToGlobal(at));
        QApplication::sendEvent(&widget, &asked);
        return tip();
    }
    /// Returns the labels that would show their text as rich text.
    [[nodiscard]] static QStringList richLabels()
    {
        QStringList rich;
        for (const QWidget* widget : QApplication::allWidgets()) {
            const auto* label = qobject_cast<const QLabel*>(widget);
            if (label && label->textFormat() != Qt::PlainText && label->text().contains(QLatin1String("<img")))
                rich << label->text();
        }
        return rich;
    }

private slots:
    void initTestCase() { prepare(); }
    void init()
    {
        start();
        QImage red(1, 1, QImage::Format_RGB32);
        red.fill(Qt::red);
        QVERIFY(red.save(home_->filePath("red.png")));
        markup_ = QStringLiteral("<h1>Title</h1><img src=\"%1\">").arg(home_->filePath("red.png"));
    }
    void cleanup()
    {
        QToolTip::hideText();
        finish();
    }

    void aTooltipShowsMarkupAsItIsWritten()
    {
        QWidget* widget = &window_->docks().exhibits();
        widget->setToolTip(markup_);
        for (int i = 0; i < 2; ++i) {  // The first tooltip, and another one in the same label.
            QTRY_VERIFY(tipOver(*widget));
            QCOMPARE(tip()->textFormat(), Qt::PlainText);
            QCOMPARE(tip()->text(), widget->toolTip());
            widget->setToolTip(QStringLiteral("<b>other</b>"));
        }
    }

    void aLessonsTitleAndTextAre()
    {
        const QString path = home_->filePath("lesson.md");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("# " + markup_.toUtf8() +
                   "\n\n```json\n{\"format\": \"vitrine-lesson\", \"version\": 1, \"exhibit\": \"sdf_morph\"}\n```\n" +
                   markup_.toUtf8() + "\n\n## " + markup_.toUtf8() + "\n\nWords.\n\n```json\n{\"values\": {}}\n```\n");
        file.close();
        window_->files().open(path);
        QTRY_VERIFY(window_->lessons().lesson());
        QVERIFY2(richLabels().isEmpty(), qPrintable(richLabels().join(' ')));
        for (QLabel* label : window_->lessons().bar().findChildren<QLabel*>()) {
            if (label->toolTip().isEmpty()) continue;
            QTRY_VERIFY(tipOver(*label));
            QCOMPARE(tip()->textFormat(), Qt::PlainText);
            QVERIFY(tip()->text().contains(QLatin1String("<img")));
        }
    }

    void namesOfFilesAndPresetsAre()
    {
        window_->files().open(home_->filePath(QStringLiteral("<img src=red.png>.xyz")));
        auto* strip = window_->findChild<MessageStrip*>();
        QTRY_VERIFY(strip->texts().join(' ').contains(QLatin1String("<img")));
        window_->choose(1);
        window_->presetController().saveUnder(QStringLiteral("<img src=red.png>"));
        QTRY_VERIFY(!rowsNamed("<img src=red.png>").isEmpty());
        QVERIFY2(richLabels().isEmpty(), qPrintable(richLabels().join(' ')));
    }

    void aBoxOfQtIs()
    {
        QMessageBox box(QMessageBox::Question, QStringLiteral("Question"), QStringLiteral("<b>bold</b>"));
        box.show();
        for (const QLabel* label : box.findChildren<QLabel*>())
            if (label->text() == QLatin1String("<b>bold</b>")) QCOMPARE(label->textFormat(), Qt::PlainText);
    }

    void aPlaceOfALargerScreenIsFittedIntoThisOne()
    {
        const QRect room = window_->screen()->availableGeometry();
        for (const QRect& kept : {QRect(room.left() + 101, room.top() + 97, room.width() + 120, room.height() + 60),
                                  QRect(room.right() - 40, room.bottom() - 30, 600, 400),
                                  QRect(room.left() - 500, room.top() - 300, 600, 400)}) {
            QWidget before;
            before.setGeometry(kept);
            QWidget after;
            restorePlace(after, before.saveGeometry());
            QVERIFY2(room.contains(after.geometry()),
                     qPrintable(QStringLiteral("%1 x %2").arg(after.width()).arg(after.height())));
            QVERIFY(after.geometry().top() >= room.top() + 20);  // Its title bar can be reached.
            if (kept.width() == 600) QCOMPARE(after.size(), kept.size());
        }
    }

    void aMessageInADialogMovesNothing()
    {
        const QPointer<PrintDialog> dialog = new PrintDialog(nullptr, nullptr);
        dialog->show();
        QVERIFY(QTest::qWaitForWindowExposed(dialog.data(), vitrine::test::patience));
        QTRY_VERIFY(dialog->settled());
        const auto places = [&] {
            QList<QPoint> all;
            for (const QWidget* widget : dialog->findChildren<QWidget*>())
                if (widget->isVisible() && !dialog->findChild<MessageStrip*>()->isAncestorOf(widget) &&
                    widget != dialog->findChild<MessageStrip*>())
                    all << widget->mapTo(dialog, QPoint(0, 0));
            return all;
        };
        const QList<QPoint> before = places();
        auto* strip = dialog->findChild<MessageStrip*>();
        strip->say(MessageStrip::Mood::notice, QStringLiteral("Saved."));
        QTRY_VERIFY(strip->isVisible());
        QTest::qWait(50);
        QCOMPARE(places(), before);
        strip->dismissAll();
        QTRY_VERIFY(!strip->isVisible());
        QCOMPARE(places(), before);
        dialog->close();
    }
};

VITRINE_WINDOW_TEST(PlainTextTest)

#include "plain_text_test.moc"
