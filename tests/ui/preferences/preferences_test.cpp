#include "tests/ui/ui_main.h"

#include "exhibits/framework/files/state_folder.h"
#include "ui/kit/appearance.h"
#include "ui/kit/preferences.h"
#include "ui/kit/type_size.h"
#include "ui/preferences/key_bindings.h"

#include <QAction>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <memory>

using namespace vitrine::ui;

/// Saving of preferences, and the effect of files with arbitrary content.
class PreferencesTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> home_;

    [[nodiscard]] static QString file()
    {
        return QString::fromStdString((vitrine::configFolder() / "window.ini").string());
    }
    void write(const QByteArray& bytes)
    {
        QVERIFY(QDir().mkpath(QFileInfo(file()).path()));
        QFile out(file());
        QVERIFY(out.open(QIODevice::WriteOnly));
        QCOMPARE(out.write(bytes), bytes.size());
    }
    [[nodiscard]] static QByteArray written()
    {
        QFile in(file());
        return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
    }
    [[nodiscard]] static PreferenceValues someOfEach()
    {
        PreferenceValues values;
        values.theme = ThemeChoice::highContrast;
        values.motion = MotionChoice::reduced;
        values.typeSize = 150;
        values.lookSpeed = 200;
        values.wheelSpeed = 50;
        values.invertedLook = true;
        values.mostSamples = 4;
        values.leastScale = 50;
        values.recentFiles = 3;
        values.oscPort = 9000;
        values.midi = true;
        values.keys = {{"screenshot", {"Ctrl+F12", "Alt+,"}}, {"quit", {}}};
        values.controllers = {{"fur/shellCount", "osc 1 /fader/3"}, {"hall/sunElevation", "cc 1 21"}};
        return values;
    }

private slots:
    void twoWindowsKeepEachOthersChanges()
    {
        Preferences a, b;
        PreferenceValues inA = a.values(), inB = b.values();
        inA.theme = ThemeChoice::light;
        inA.keys = {{"screenshot", {"F9"}}};
        a.set(inA);
        inB.motion = MotionChoice::reduced;
        inB.keys = {{"quit", {"Ctrl+W"}}};
        b.set(inB);
        PreferenceValues both = Preferences::saved();
        QCOMPARE(both.theme, ThemeChoice::light);
        QCOMPARE(both.motion, MotionChoice::reduced);
        QCOMPARE(both.keys, (QMap<QString, QStringList>{{"quit", {"Ctrl+W"}}, {"screenshot", {"F9"}}}));
        inA.keys.clear();
        inA.theme = ThemeChoice::desktop;
        a.set(inA);
        both = Preferences::saved();
        QCOMPARE(both.theme, ThemeChoice::desktop);
        QCOMPARE(both.motion, MotionChoice::reduced);
        QCOMPARE(both.keys, (QMap<QString, QStringList>{{"quit", {"Ctrl+W"}}}));
    }

    void init()
    {
        home_ = std::make_unique<QTemporaryDir>();
        QVERIFY(home_->isValid());
        for (const char* name : {"HOME", "XDG_CONFIG_HOME"}) qputenv(name, home_->path().toLocal8Bit());
    }

    void everyPreferenceComesBackAndInitialOnesAreNotWritten()
    {
        {
            Preferences first;
            QCOMPARE(first.values(), PreferenceValues());
            QVERIFY(!QFile::exists(file()));
            first.set(someOfEach());
            QVERIFY(first.failure().isEmpty());
        }
        Preferences second;
        QVERIFY2(second.complaint().isEmpty(), qPrintable(second.complaint()));
        QVERIFY(second.values() == someOfEach());
        QVERIFY(Preferences::saved() == someOfEach());
        second.set({});
        QCOMPARE(written().simplified(), QByteArray());
    }

    void numbersAreKeptWithinTheirRanges()
    {
        Preferences preferences;
        PreferenceValues values;
        values.typeSize = 1000;
        values.mostSamples = -3;
        preferences.set(values);
        QCOMPARE(preferences.values().typeSize, 200);
        QCOMPARE(preferences.values().mostSamples, 1);
    }

    void whatOthersKeepInTheFileStays()
    {
        write("language=de\ntheme=dark\n");
        Preferences preferences;
        PreferenceValues values = preferences.values();
        QCOMPARE(values.theme, ThemeChoice::dark);
        values.theme = ThemeChoice::light;
        preferences.set(values);
        QCOMPARE(QSettings(file(), QSettings::IniFormat).value("language").toString(), QString("de"));
    }

    void valuesThatAreNotValidAreInitialAndNamedInOneMessage_data()
    {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QString>("name");
        QTest::newRow("a theme that there is not") << QByteArray("theme=plaid") << "theme";
        QTest::newRow("a number that is none") << QByteArray("typeSize=large") << "typeSize";
        QTest::newRow("a number out of range") << QByteArray("typeSize=99999999999999999999") << "typeSize";
        QTest::newRow("a negative number") << QByteArray("recentCount=-1") << "recentCount";
        QTest::newRow("a list for a number") << QByteArray("lookSpeed=1, 2, 3") << "lookSpeed";
        QTest::newRow("a size for a number") << QByteArray("leastScale=@Size(3 4)") << "leastScale";
        QTest::newRow("neither true nor false") << QByteArray("invertedLook=perhaps") << "invertedLook";
        QTest::newRow("keys that there are not") << QByteArray("[keys]\nquit=Ctrl+Nonsense") << "keys/quit";
        QTest::newRow("five shortcuts") << QByteArray("[keys]\nquit=F1, F2, F3, F4, F5") << "keys/quit";
        QTest::newRow("two strokes") << QByteArray("[keys]\nquit=\"Ctrl+A, Ctrl+B\"") << "keys/quit";
        QTest::newRow("a long one") << QByteArray("[keys]\nquit=") + QByteArray(5000, 'x') << "keys/quit";
    }
    void valuesThatAreNotValidAreInitialAndNamedInOneMessage()
    {
        QFETCH(QByteArray, line);
        QFETCH(QString, name);
        write("wheelSpeed=300\n" + line + "\n");
        Preferences preferences;
        PreferenceValues expected;
        expected.wheelSpeed = 300;  // Valid values are used all the same.
        QVERIFY(preferences.values() == expected);
        QVERIFY2(preferences.complaint().contains(name) && preferences.complaint().contains(file()),
                 qPrintable(preferences.complaint()));
        // The next change repairs the file.
        expected.typeSize = 110;
        preferences.set(expected);
        Preferences again;
        QVERIFY2(again.complaint().isEmpty(), qPrintable(again.complaint()));
        QVERIFY(again.values() == expected);
    }

    void aFileThatIsNoneOfOursIsPutAsideWhole_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("objects of Qt's") << QByteArray("theme=@Variant(\\0\\0\\0\\x46\\xff\\xff\\xff\\xff)\n");
        QTest::newRow("a moment") << QByteArray("theme=@DateTime(\\0\\0\\0\\x10)\n");
        QTest::newRow("no text") << QByteArray("\x7f"
                                               "ELF\0\0\1\2",
                                               8);
        QTest::newRow("no settings") << QByteArray("theme\nnothing equals\n[[[\n");
        QTest::newRow("two megabytes") << QByteArray(2 << 20, 'a');
    }
    void aFileThatIsNoneOfOursIsPutAsideWhole()
    {
        QFETCH(QByteArray, bytes);
        write(bytes);
        Preferences preferences;
        QVERIFY(preferences.values() == PreferenceValues());
        QVERIFY2(preferences.complaint().contains(file() + ".damaged"), qPrintable(preferences.complaint()));
        QFile aside(file() + ".damaged");
        QVERIFY(aside.open(QIODevice::ReadOnly));
        QCOMPARE(aside.readAll(), bytes);
        preferences.set(someOfEach());
        QVERIFY(Preferences::saved() == someOfEach());
    }

    void randomBytesNeverEndTheProgram()
    {
        std::uint32_t state = 1;
        for (int round = 0; round < 300; ++round) {
            QByteArray bytes = "theme=light\ntypeSize=120\n[keys]\nquit=Ctrl+Q\n";
            for (int i = 0; i < 12; ++i) {
                state = state * 1664525U + 1013904223U;
                bytes[static_cast<int>((state >> 8) % static_cast<unsigned>(bytes.size()))] =
                    static_cast<char>(state >> 24);
            }
            write(bytes);
            const PreferenceValues values = Preferences().values();
            QVERIFY(values.typeSize >= 100 && values.typeSize <= 200);
        }
    }

    void aFolderThatCannotBeWrittenIsSaidAndChangesHold()
    {
        QFile blocker(home_->filePath("vitrine"));  // A file in place of the folder.
        QVERIFY(blocker.open(QIODevice::WriteOnly));
        blocker.close();
        Preferences preferences;
        int told = 0;
        connect(&preferences, &Preferences::notWritten, this, [&] { ++told; });
        preferences.set(someOfEach());
        QVERIFY(preferences.values() == someOfEach());
        QCOMPARE(told, 1);
        QVERIFY2(preferences.failure().contains(file()), qPrintable(preferences.failure()));
    }

    void contrastIsThatOfTheStandard()
    {
        QCOMPARE(contrastOf(Qt::black, Qt::white), 21.0);
        QCOMPARE(contrastOf(Qt::red, Qt::red), 1.0);
        // Computed by hand from the definition of relative luminance in WCAG 2.2.
        QVERIFY(std::abs(contrastOf(QColor("#777777"), Qt::white) - 4.478) < 0.001);
    }

    void everyThemeCanBeReadAndTheOnesOfHighContrastByAll()
    {
        const std::array themes{darkTheme(), lightTheme(), highContrastTheme(true), highContrastTheme(false)};
        for (const Theme& theme : themes) {
            const double least = theme.highContrast ? 7 : 4.5;
            for (const QColor& ground : {theme.window, theme.base}) {
                for (const QColor& ink : {theme.text, theme.dim, theme.accent, theme.error, theme.good})
                    QVERIFY2(contrastOf(ink, ground) >= least,
                             qPrintable(
                                 QString("%1 on %2: %3").arg(ink.name(), ground.name()).arg(contrastOf(ink, ground))));
                // Outlines and the focus, which has the accent color.
                QVERIFY(contrastOf(theme.outline, ground) >= 3);
            }
            applyTheme(*qApp, theme);
            const QPalette palette = QApplication::palette();
            QVERIFY(contrastOf(palette.color(QPalette::HighlightedText), palette.color(QPalette::Highlight)) >= least);
            QVERIFY(contrastOf(palette.color(QPalette::ButtonText), palette.color(QPalette::Button)) >= least);
            QVERIFY(contrastOf(palette.color(QPalette::ToolTipText), palette.color(QPalette::ToolTipBase)) >= least);
        }
    }

    void theDesktopsWishesCountWhereTheVisitorLeavesItToThem()
    {
        PreferenceValues values;
        QCOMPARE(themeFor(values, {}, true), darkTheme());
        QCOMPARE(themeFor(values, {}, false), lightTheme());
        QCOMPARE(themeFor(values, {.dark = false}, true), lightTheme());
        QCOMPARE(themeFor(values, {.dark = true, .highContrast = true}, false), highContrastTheme(true));
        values.theme = ThemeChoice::light;
        QCOMPARE(themeFor(values, {.dark = true, .highContrast = true}, true), lightTheme());
        values.theme = ThemeChoice::highContrast;
        QCOMPARE(themeFor(values, {}, false), highContrastTheme(false));

        QVERIFY(!reducesMotion(values, {}));
        QVERIFY(reducesMotion(values, {.reducedMotion = true}));
        values.motion = MotionChoice::full;
        QVERIFY(!reducesMotion(values, {.reducedMotion = true}));
        values.motion = MotionChoice::reduced;
        QVERIFY(reducesMotion(values, {}));
    }

    void sizesGrowWithTheTypeAndNeverShrink()
    {
        QLabel label("Type");
        growHeight(label, 26);
        const int usual = label.height();
        QVERIFY(usual >= 26);
        QFont large = label.font();
        large.setPointSizeF(2 * large.pointSizeF());
        label.setFont(large);
        QVERIFY2(label.height() >= 1.7 * usual && label.height() <= 2.2 * usual,
                 qPrintable(QString::number(label.height())));
        QFont small = label.font();
        small.setPointSizeF(1);
        label.setFont(small);
        QCOMPARE(label.height(), 26);
    }

    void shortcutsAreTakenGivenBackAndNeverDoubled()
    {
        Preferences preferences;
        QAction open("&Open…"), quit("&Quit"), unnamed("Unnamed");
        open.setObjectName("open");
        quit.setObjectName("quit");
        open.setShortcut(QKeySequence("Ctrl+O"));
        quit.setShortcuts({QKeySequence("Ctrl+Q"), QKeySequence("Alt+F4")});
        KeyBindings keys({&open, &quit, &unnamed}, preferences);
        QCOMPARE(keys.actions().size(), 2);
        QCOMPARE(KeyBindings::nameOf(open), QString("Open"));

        QCOMPARE(keys.user({QKeySequence("Ctrl+Q")}, open), &quit);
        keys.set(open, {QKeySequence("Ctrl+Q")});
        QCOMPARE(open.shortcuts(), QList<QKeySequence>{QKeySequence("Ctrl+Q")});
        QCOMPARE(quit.shortcuts(), QList<QKeySequence>{QKeySequence("Alt+F4")});
        QVERIFY(keys.differs(open) && keys.differs(quit));

        QAction open2("&Öffnen…"), quit2("&Beenden");  // In the next session, in another language.
        open2.setObjectName("open");
        quit2.setObjectName("quit");
        open2.setShortcut(QKeySequence("Ctrl+O"));
        quit2.setShortcuts({QKeySequence("Ctrl+Q"), QKeySequence("Alt+F4")});
        Preferences read;
        KeyBindings next({&open2, &quit2}, read);
        QCOMPARE(open2.shortcut(), QKeySequence("Ctrl+Q"));
        QCOMPARE(quit2.shortcut(), QKeySequence("Alt+F4"));
        next.resetAll();
        QCOMPARE(open2.shortcut(), QKeySequence("Ctrl+O"));
        QCOMPARE(quit2.shortcuts().size(), 2);
        QVERIFY(!next.anyDiffers());
    }

    void aFileThatGivesOneShortcutTwiceDoublesNone()
    {
        write("[keys]\nopen=Ctrl+Q\nsave=Ctrl+Q\n");
        Preferences preferences;
        QAction open("Open"), save("Save"), quit("Quit");
        open.setObjectName("open");
        save.setObjectName("save");
        quit.setObjectName("quit");
        quit.setShortcut(QKeySequence("Ctrl+Q"));
        const KeyBindings keys({&open, &save, &quit}, preferences);
        QCOMPARE(open.shortcuts().size() + save.shortcuts().size() + quit.shortcuts().size(), 1);
    }

    void keysThatOneTypesAndWalksWithAreRefused()
    {
        for (const char* plain : {"W", "Shift+E", "3", "Up", "Esc", "Space", "Backspace"})
            QVERIFY2(!KeyBindings::refusal(QKeySequence(plain)).isEmpty(), plain);
        for (const char* good : {"Ctrl+W", "Alt+Left", "F7", "Shift+F9", "Meta+X", "Pause"})
            QVERIFY2(KeyBindings::refusal(QKeySequence(good)).isEmpty(), good);
    }
};

VITRINE_UI_TEST(PreferencesTest)
#include "preferences_test.moc"
