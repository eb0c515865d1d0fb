// The real window in German: menus, panel and messages. Written files are the same as in English.

#include "tests/ui/open_window.h"
#include "tests/ui/ui_main.h"

#include "exhibits/framework/files/state_folder.h"
#include "ui/kit/language.h"
#include "ui/kit/message_strip.h"
#include "ui/parameters/shown_text.h"
#include "ui/presets/preset_controller.h"
#include "ui/window/file_opener.h"

#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QMenuBar>

#include <map>

using namespace vitrine;

class GermanWindowTest final : public test::OpenWindow {
    Q_OBJECT

private:
    void startIn(const QString& language)
    {
        ui::setLanguage(language);
        start();
    }
    /// Drags a slider, saves a preset, and returns the file's bytes.
    [[nodiscard]] QByteArray savedPreset(const QString& language)
    {
        startIn(language);
        window_->visit(1);
        settle();
        const Parameters& rows = window_->history().sceneState().values[1].table();
        window_->history().set(1, *rows.find("roughness"), 0.43, 0);
        const double chosen = roughness();
        window_->presetController().saveUnder(QStringLiteral("Rough one"));
        QByteArray bytes;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(userPresetFolder()))
            if (QFile saved(QString::fromStdString(entry.path().string()));
                entry.is_regular_file() && saved.open(QIODevice::ReadOnly))
                bytes += saved.readAll();
        // The file can be loaded in either language.
        SceneState initial = window_->history().sceneState();
        initial.values[1] = rows.initial();
        window_->history().change(QStringLiteral("Reset"), initial);
        if (roughness() == chosen) return {};
        presets()->setCurrentItem(rowsNamed("Rough one").front());
        emit presets()->itemActivated(rowsNamed("Rough one").front());
        return roughness() == chosen ? bytes : QByteArray();
    }

private slots:
    void initTestCase()
    {
        mostSamples_ = asTheHallRequests;
        prepare();
    }
    void cleanup()
    {
        finish();
        ui::setLanguage(QStringLiteral("en"));
    }

    void longMenusAndPanelAreGerman()
    {
        startIn(QStringLiteral("de"));
        QStringList menus;
        for (const QAction* action : window_->menuBar()->actions()) menus << action->text().remove(QLatin1Char('&'));
        for (const char* title : {"Datei", "Bearbeiten", "Preset", "Ansicht", "Vergleich", "Exponat", "Hilfe"})
            QVERIFY2(menus.contains(QString::fromUtf8(title)), title);
        QVERIFY(action("Alle Parameter zurücksetzen"));
        QVERIFY(!action("Reset all parameters"));
        // A shape's operation is called Shift, too: keys have the names that Qt gives them.
        const QString keys = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E).toString(QKeySequence::NativeText);
        QVERIFY2(!keys.contains(QStringLiteral("Verschiebung")), qPrintable(keys));
        window_->visit(1);
        settle();
        QVERIFY(window_->panel().row("roughness"));
        QVERIFY2(window_->panel().row("roughness")->toolTip().startsWith(QStringLiteral("Rauheit\n")),
                 qPrintable(window_->panel().row("roughness")->toolTip()));
        QVERIFY(window_->panel().row("roughness")->toolTip().contains(QStringLiteral("Ausgangswert: ")));
    }

    void longNoTwoActionsOfAMenuHaveOneMnemonic()
    {
        startIn(QStringLiteral("de"));
        QList<QList<QAction*>> menus{window_->menuBar()->actions()};
        for (const QMenu* menu : window_->menuBar()->findChildren<QMenu*>()) menus << menu->actions();
        for (const QList<QAction*>& menu : menus) {
            std::map<QChar, QString> taken;
            for (const QAction* each : menu) {
                const QString words = QString(each->text()).remove(QStringLiteral("&&"));
                const qsizetype mark = words.indexOf(QLatin1Char('&'));
                if (mark < 0) continue;
                const auto [known, added] = taken.emplace(words[mark + 1].toLower(), each->text());
                QVERIFY2(added, qPrintable(known->second + QStringLiteral(" / ") + each->text()));
            }
        }
    }

    void shippedPresetsHaveGermanNamesAndTags()
    {
        startIn(QStringLiteral("de"));
        window_->choose(1);
        QVERIFY(rowsNamed("Porcelain mug").isEmpty());
        QCOMPARE(rowsNamed("Porzellanbecher").size(), 1);
        QListWidgetItem* mug = rowsNamed("Porzellanbecher").front();
        QStringList spoken;
        for (int i = 0; i < presets()->count(); ++i)
            spoken << presets()->item(i)->data(Qt::AccessibleTextRole).toString();
        QVERIFY2(spoken.join(' ').contains(QStringLiteral("Material")) && !spoken.join(' ').contains("material"),
                 qPrintable(spoken.join(' ')));
        // A copy is the visitor's own and keeps the displayed text.
        presets()->setCurrentItem(mug);
        window_->presetController().duplicate();
        const QList<QListWidgetItem*> copies =
            presets()->findItems(QStringLiteral("Porzellanbecher"), Qt::MatchStartsWith);
        QCOMPARE(copies.size(), 2);
        // Names of the visitor's own presets stay as they were typed.
        window_->presetController().saveUnder(QStringLiteral("Night"));
        QCOMPARE(rowsNamed("Night").size(), 1);
    }

    void longPresetsAreTheSameBytesAsInEnglish()
    {
        const QByteArray german = savedPreset(QStringLiteral("de"));
        finish();
        const QByteArray english = savedPreset(QStringLiteral("en"));
        QVERIFY(!english.isEmpty());
        QCOMPARE(german, english);
    }

    void messagesAboutFilesAreGerman()
    {
        startIn(QStringLiteral("de"));
        const QString file = home_->path() + QStringLiteral("/broken.json");
        QFile broken(file);
        QVERIFY(broken.open(QIODevice::WriteOnly));
        broken.write("{\"format\": ");
        broken.close();
        window_->files().open(file);
        auto* strip = window_->findChild<ui::MessageStrip*>();
        QTRY_VERIFY(!strip->texts().isEmpty());
        QVERIFY2(strip->texts().join(QLatin1Char(' ')).contains(QStringLiteral("kein gültiges JSON")),
                 qPrintable(strip->texts().join(QLatin1Char(' '))));
    }

    void longANumberMayHaveADecimalComma()
    {
        startIn(QStringLiteral("de"));
        const QLocale before;
        QLocale::setDefault(QLocale(QLocale::German));
        QString problem;
        const auto value =
            ui::typedValue(gallery_->table().rows()[gallery_->table().roughness.row], QStringLiteral("0,25"), &problem);
        QLocale::setDefault(before);
        QVERIFY2(value.has_value(), qPrintable(problem));
        QCOMPARE(std::get<double>(*value), 0.25);
    }
};

VITRINE_WINDOW_TEST(GermanWindowTest)
#include "german_window_test.moc"
