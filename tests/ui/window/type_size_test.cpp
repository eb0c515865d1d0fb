#include "tests/ui/cheap_pictures.h"
#include "tests/ui/cut_off.h"
#include "tests/ui/open_window.h"
#include "tests/ui/ui_main.h"

#include "exhibits/pixel_art/pixel_art.h"
#include "ui/compare/compare_controller.h"
#include "ui/export/export_dialog.h"
#include "ui/jobs/job_dialog.h"
#include "ui/kit/appearance.h"
#include "ui/kit/export_bar.h"
#include "ui/kit/message_strip.h"
#include "ui/kit/name_dialog.h"
#include "ui/lessons/lesson_controller.h"
#include "ui/parameters/color_picker.h"
#include "ui/preferences/preferences_dialog.h"
#include "ui/print/print_dialog.h"
#include "ui/window/window_docks.h"
#include "ui/window/window_preferences.h"

#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QListWidget>
#include <QScreen>
#include <QTabWidget>

using namespace vitrine;
using namespace vitrine::ui;

/// The window, its panels and its dialogs with all font sizes on the test's screen: nothing is cut off, everything can
/// be reached and fits.
class TypeSizeTest : public test::OpenWindow {
    Q_OBJECT

    /// The exhibit that sprites are drawn by.
    [[nodiscard]] std::unique_ptr<Exhibit> anotherExhibit() override { return std::make_unique<pixel_art::PixelArt>(); }

    void setType(int percent)
    {
        PreferenceValues values = window_->preferences().values().values();
        values.typeSize = percent;
        window_->preferences().values().set(values);
    }
    /// Reports what is cut off once the widget is laid out. If VITRINE_PICTURES names a folder, draws it there.
    void look(QWidget& widget, const QString& name)
    {
        widget.ensurePolished();
        if (widget.layout()) widget.layout()->activate();
        QCoreApplication::processEvents();
        QTRY_VERIFY2(test::cutOff(widget).isEmpty(), qPrintable(name + ":\n" + test::cutOff(widget).join('\n')));
        picture(widget, name);
    }
    void picture(QWidget& widget, const QString& name)
    {
        const QString folder = qEnvironmentVariable("VITRINE_PICTURES");
        if (folder.isEmpty()) return;
        QDir().mkpath(folder);
        QVERIFY(widget.grab().save(QStringLiteral("%1/%2-%3-%4.png")
                                       .arg(folder)
                                       .arg(window_->screen()->size().width())
                                       .arg(window_->preferences().values().values().typeSize)
                                       .arg(name)));
    }
    void fits(const QWidget& widget, const QString& name)
    {
        const QSize room = widget.screen()->availableSize();
        const QSize least = widget.minimumSizeHint().expandedTo(widget.minimumSize());
        QVERIFY2(least.width() <= room.width() && least.height() <= room.height(),
                 qPrintable(QString("%1 needs %2 x %3 at least").arg(name).arg(least.width()).arg(least.height())));
        QVERIFY2(widget.width() <= room.width() && widget.height() <= room.height(),
                 qPrintable(QString("%1 is %2 x %3").arg(name).arg(widget.width()).arg(widget.height())));
    }
    void lookAtDialog(QDialog* dialog, const QString& name)
    {
        QVERIFY2(dialog, qPrintable(name));
        QVERIFY(QTest::qWaitForWindowExposed(dialog, test::patience));
        fits(*dialog, name);
        look(*dialog, name);
        delete dialog;
    }
    template <typename T> T* opened(const char* command)
    {
        action(command)->trigger();
        return window_->findChild<T*>();
    }
    [[nodiscard]] QDialog* newest()
    {
        QDialog* found = nullptr;
        for (QDialog* dialog : window_->findChildren<QDialog*>())
            if (dialog->isVisible()) found = dialog;
        return found;
    }
    [[nodiscard]] static bool isSettled(ExportDialog& dialog)
    {
        for (const JobDialog* page : dialog.findChildren<JobDialog*>())
            if (!page->settled()) return false;
        for (const PrintDialog* page : dialog.findChildren<PrintDialog*>())
            if (!page->settled()) return false;
        return true;
    }
    /// Returns the bar with the export button of the page in front.
    [[nodiscard]] static ExportBar* shownBar(ExportDialog& dialog)
    {
        for (ExportBar* bar : dialog.findChildren<ExportBar*>())
            if (bar->isVisible()) return bar;
        return nullptr;
    }
    void lookAtDialogOf(const char* command)
    {
        action(command)->trigger();
        lookAtDialog(newest(), QString(command).remove(QStringLiteral("…")));
    }
    void lookAtEveryPageOfTheExportDialog(int percent)
    {
        setType(percent);
        auto* dialog = opened<ExportDialog>("Export picture…");
        QVERIFY(QTest::qWaitForWindowExposed(dialog, test::patience));
        auto* kinds = dialog->findChild<QListWidget*>("kinds");
        QVERIFY(kinds->count() >= 9);
        for (int i = 0; i < kinds->count(); ++i) {
            const QString name = "Export, " + kinds->item(i)->text();
            QVERIFY2(kinds->item(i)->flags() & Qt::ItemIsEnabled, qPrintable(name));
            QTest::mouseClick(kinds->viewport(), Qt::LeftButton, {}, kinds->visualItemRect(kinds->item(i)).center());
            QTRY_VERIFY2(isSettled(*dialog), qPrintable(name));
            fits(*dialog, name);
            look(*dialog, name);
            auto* bar = shownBar(*dialog);
            QVERIFY2(bar, qPrintable(name));
            for (const auto* button : bar->findChildren<QAbstractButton*>())
                QVERIFY2(button->visibleRegion() == QRegion(button->rect()) &&
                             dialog->screen()->availableGeometry().contains(
                                 QRect(button->mapToGlobal(QPoint()), button->size())),
                         qPrintable(name + ": " + button->text()));
        }
        delete dialog;
    }

private slots:
    void initTestCase() { prepare(); }
    void init()
    {
        start();
        test::takeFewSamples(*window_, 1);
        window_->resize(window_->screen()->availableSize());
        window_->choose(1);
        settle();
    }
    void cleanup()
    {
        finish();
        applyAppearance(*qApp, {}, {});
        applyTheme(*qApp, darkTheme());
    }

    void longTheWindowAndItsPanels_data() { sizes(); }
    void longTheWindowAndItsPanels()
    {
        QFETCH(int, percent);
        setType(percent);
        fits(*window_, "window");
        look(*window_, "window");
        WindowDocks& docks = window_->docks();
        const std::pair<const char*, void (WindowDocks::*)()> panels[]{
            {"study", &WindowDocks::showStudy}, {"charts", &WindowDocks::showCharts}, {"log", &WindowDocks::showLog}};
        for (const auto& [name, show] : panels) {
            (docks.*show)();
            settle();
            fits(*window_, name);
            look(*window_, name);
        }
    }

    void longTheStripsAroundThePicture_data() { sizes(); }
    void longTheStripsAroundThePicture()
    {
        QFETCH(int, percent);
        setType(percent);
        window_->say(MessageStrip::Mood::problem,
                     "A file that was named and cannot be read is left out until it can be read again.");
        window_->comparison().setToCurrent();
        action("Signed difference")->trigger();
        settle();
        fits(*window_, "strips");
        look(*window_, "strips");
        window_->comparison().letGo();
        window_->lessons().start(1);
        settle();
        fits(*window_, "lesson");
        look(*window_, "lesson");
    }

    void longTheDialogs_data() { sizes(); }
    void longTheDialogs()
    {
        QFETCH(int, percent);
        setType(percent);
        for (const char* command :
             {"Search…", "Keyboard, mouse and gamepad", "About this exhibit", "About Vitrine", "Preferences…"})
            lookAtDialogOf(command);
        action("Preferences…")->trigger();
        auto* preferences = window_->findChild<PreferencesDialog*>();
        auto* tabs = preferences->findChild<QTabWidget*>();
        for (int tab = 0; tab < tabs->count(); ++tab) {
            tabs->setCurrentIndex(tab);
            look(*preferences, "Preferences, " + tabs->tabText(tab));
        }
        delete preferences;
        auto* name = new NameDialog("Save the preset under another name", "Old gold", window_.get());
        name->openOver(window_->panel());
        lookAtDialog(name, "Name");
        for (auto* button : window_->panel().row("baseColor")->findChildren<QAbstractButton*>())
            if (button->accessibleName().contains("choose a color")) button->click();
        lookAtDialog(window_->findChild<ColorDialog*>(), "Color");
    }

    void longEveryPageOfTheExportDialog_data() { sizes(); }
    void longEveryPageOfTheExportDialog()
    {
        QFETCH(int, percent);
        lookAtEveryPageOfTheExportDialog(percent);
    }

    void whatIsCutOffIsSeen()
    {
        QWidget room;
        auto* label = new QLabel("Quite a few words", &room);
        room.resize(400, 100);
        label->setGeometry(0, 0, 300, 40);
        room.show();
        QVERIFY(test::cutOff(room).isEmpty());
        label->resize(40, 40);
        QCOMPARE(test::cutOff(room).size(), 1);
        label->resize(300, 5);
        QCOMPARE(test::cutOff(room).size(), 1);
        label->resize(300, 40);
        label->move(300, 0);  // Beyond the edge.
        QCOMPARE(test::cutOff(room).size(), 1);
        label->hide();
        QVERIFY(test::cutOff(room).isEmpty());
    }

private:
    static void sizes()
    {
        QTest::addColumn<int>("percent");
        for (const int percent : {100, 150, 200}) QTest::newRow(qPrintable(QString("%1 %").arg(percent))) << percent;
    }
};

VITRINE_WINDOW_TEST(TypeSizeTest)
#include "type_size_test.moc"
