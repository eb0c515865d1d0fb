// Edits of a shader and the real picture: what is typed is seen, what has errors changes nothing.
#include "tests/ui/open_museum.h"
#include "tests/ui/ui_main.h"

#include "exhibits/fur/fur.h"
#include "exhibits/museum/museum.h"
#include "exhibits/sdf_scenes/sdf_scenes.h"
#include "exhibits/your_shader/guest_work.h"
#include "exhibits/your_shader/your_shader.h"
#include "ui/compare/compare_controller.h"
#include "ui/compare/picture_b.h"
#include "ui/editor/live_text.h"
#include "ui/editor/shader_copy.h"
#include "ui/editor/shader_panel.h"
#include "ui/kit/message_strip.h"
#include "ui/model/settings_b.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parameters/parameter_row.h"
#include "ui/viewport/viewport.h"
#include "ui/window/file_opener.h"
#include "ui/window/main_window.h"
#include "ui/window/window_docks.h"

#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>

using namespace vitrine;
using namespace vitrine::ui;
using vitrine::test::patience;

class ShaderPictureTest : public test::OpenMuseum {
    Q_OBJECT

    static constexpr std::size_t shader = 1, scenes = 2, fur = 3;

    std::size_t others_ = 0;  // Number of further exhibits in the museum.

    [[nodiscard]] const ParameterValues& values() { return window_->history().sceneState().values[shader]; }
    [[nodiscard]] ShaderPanel& panel() { return window_->docks().shader(); }
    [[nodiscard]] Viewport& viewport() { return window_->viewport(); }
    void set(const char* row, const Value& value)
    {
        window_->history().set(shader, values().table().find(row).value(), value, 0);
    }
    [[nodiscard]] double number(const char* row)
    {
        return std::get<double>(values().row(values().table().find(row).value()));
    }
    [[nodiscard]] std::string text(const char* row)
    {
        return std::get<std::string>(values().row(values().table().find(row).value()));
    }
    /// Makes a museum of Your Shader and others, or keeps the last one, whose files are read already.
    void openMuseum(std::size_t others)
    {
        if (museum_ && others == others_) return;
        renderers_.reset();
        others_ = others;
        std::vector<std::unique_ptr<Exhibit>> exhibits;
        exhibits.push_back(std::make_unique<guest::YourShader>());
        if (others > 0) exhibits.push_back(std::make_unique<scenes::SdfScenes>());
        if (others > 1) exhibits.push_back(std::make_unique<fur::Fur>());
        museum_ = std::make_unique<Museum>(std::move(exhibits));
    }
    /// Writes a shader, names it and waits for its picture.
    void show(const QString& name, const char* text)
    {
        const QString path = home_->filePath(name);
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
        file.close();
        set("file", path.toStdString());
        QTRY_VERIFY(static_cast<const guest::YourShaderTable&>(values().table()).work);
        QTRY_COMPARE(QString::fromStdString(
                         static_cast<const guest::YourShaderTable&>(values().table()).work->path.filename().string()),
                     name);
        settle();
    }
    /// Returns the pixel of a place on the screen, from 0 to 1; the origin is at the lower left.
    [[nodiscard]] QPoint at(double x, double y)
    {
        const glm::dvec4 own((2 * x - 1) * 1.2, (2 * y - 1) * 0.8, 0.02, 1);
        const glm::dvec4 clip = viewport().scene().view().clipFromWorld * museum_->worldFromExhibit(shader) * own;
        return QPointF((0.5 + 0.5 * clip.x / clip.w) * viewport().width(),
                       (0.5 - 0.5 * clip.y / clip.w) * viewport().height())
            .toPoint();
    }
    void settle() { QTRY_VERIFY(viewport().pictures().schedule().still()); }
    /// Types in place of the first occurrence of some words.
    void typeOver(const QString& words, const QString& typed)
    {
        panel().view()->goTo(1);
        QVERIFY2(panel().view()->find(words, true), qPrintable(words));
        QTest::keyClicks(&panel().view()->widget(), typed);
    }
    /// Returns the mean of all channels in the middle of the picture, where the screen is: 0 to 255.
    [[nodiscard]] static double brightness(const QImage& picture)
    {
        double sum = 0;
        int count = 0;
        for (int y = picture.height() * 3 / 8; y < picture.height() * 5 / 8; ++y)
            for (int x = picture.width() * 3 / 8; x < picture.width() * 5 / 8; ++x, ++count) {
                const QRgb p = picture.pixel(x, y);
                sum += (qRed(p) + qGreen(p) + qBlue(p)) / 3.0;
            }
        return count > 0 ? sum / count : 0;
    }

private slots:
    void initTestCase() { prepare(); }
    void init()
    {
        // Further exhibits cost a software renderer time in every picture of the hall.
        const QByteArray test = QTest::currentTestFunction();
        openMuseum(test == "longAnInputShowsAnotherExhibit"            ? 1
                   : test == "longAnExhibitIsCopiedAsAShaderOfOnesOwn" ? 2
                                                                       : 0);
        makeHome();
        makeWindow({});
        showWindow({1000, 700});
        QApplication::setActiveWindow(window_.get());
        QTRY_VERIFY(viewport().pictures().shown().pictures() > 0);
        const Parameters& hall = window_->history().sceneState().hall().table();
        // The picture light above the frame brightens a black screen by 5 codes.
        window_->history().set(hallIndex, hall.find("spotStrength").value(), 0.0, 0);
        window_->visit(shader);
        viewport().visitor().jumpTo(museum_->bestView(shader, values()));
        window_->docks().showShader();
        QTRY_VERIFY(panel().view());
    }
    void cleanup()
    {
        SceneState state = window_->history().sceneState();
        dynamic_cast<const HasDocument&>(museum_->subject(shader)).dropUnsaved(state.values[shader]);
        window_->history().stack().clear();
        window_->history().settle(state);
        closeWindow();
    }

    void longAnEditIsSeen_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("words");
        QTest::addColumn<QString>("typed");
        QTest::newRow("gyroid") << "gyroid.frag"
                                << "exp(-1.4"
                                << "exp(-0.2";
        QTest::newRow("ink") << "ink.fs"
                             << "vec3(0.965, 0.95"
                             << "vec3(0.165, 0.15";
        QTest::newRow("agate") << "agate.glsl"
                               << "exp(-1.55"
                               << "exp(-0.55";
    }
    void longAnEditIsSeen()
    {
        QFETCH(QString, file);
        QFETCH(QString, words);
        QFETCH(QString, typed);
        set("file", file.toStdString());
        QTRY_VERIFY(panel().view()->text().contains(words));
        QTRY_VERIFY(!panel().live().isChecking());
        settle();
        const double before = brightness(viewport().pictures().shown().image());
        static_assert(LiveText::pause <= 200, "the text is checked soon after the last key");
        for (int times = 0; times < 3; ++times) {
            typeOver(words, typed);
            QElapsedTimer timer;
            timer.start();
            qint64 checked = 0;
            int checks = 0, frames = 0;
            bool isSmall = false;
            QObject watch;
            connect(&panel().live(), &LiveText::checked, &watch, [&] { checks += !panel().live().isChecking(); });
            connect(&viewport().pictures(), &ViewportPictures::drawn, &watch, [&](const render::FrameReport& report) {
                if (checks == 0) return;
                ++frames;
                for (const render::StepReport& step : report.ran)
                    isSmall = isSmall || step.name == "your_shader/first picture";
            });
            while (std::abs(brightness(viewport().pictures().shown().image()) - before) < 4 &&
                   timer.elapsed() < 60000) {
                if (checked == 0 && !panel().live().isChecking()) checked = timer.elapsed();
                QTest::qWait(2);
            }
            qInfo("%s: %lld ms from the last key to the shader, %lld ms to the picture", qPrintable(file), checked,
                  timer.elapsed());
            QVERIFY(std::abs(brightness(viewport().pictures().shown().image()) - before) >= 4);
            // The work between key and picture, which does not depend on the machine's load: the text is checked once,
            // and one of the next frames shows it. The first picture of a text is small unless buffers are kept.
            QCOMPARE(checks, 1);
            QVERIFY2(frames <= 3, qPrintable(QString::number(frames)));
            const auto work = static_cast<const guest::YourShaderTable&>(values().table()).work;
            QVERIFY(work);
            if (times == 0) QCOMPARE(isSmall, !work->isKept);
            settle();
            typeOver(typed, words);
            QTRY_VERIFY(!panel().live().isChecking());
            settle();
            QTRY_VERIFY(std::abs(brightness(viewport().pictures().shown().image()) - before) < 1);
        }
    }

    void longThePointerInThePictureIsTheMouseOfTheShader()
    {
        show("mouse.glsl",
             "void mainImage(out vec4 c, in vec2 p) { c = iMouse.z > 0.0 ? vec4(1) : vec4(0, 0, 0, 1); }");
        const render::Camera camera = window_->history().sceneState().camera;
        const int steps = window_->history().stack().count();
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, at(0.25, 0.75));
        QVERIFY(std::abs(number("mouseX") - 0.25) < 0.01 && std::abs(number("mouseY") - 0.75) < 0.01);
        QCOMPARE(number("mouseDown"), 1.0);
        QTRY_VERIFY(brightness(viewport().pictures().shown().image()) > 250);
        QTest::mouseMove(&viewport(), at(0.5, 0.5));
        QVERIFY(std::abs(number("mouseX") - 0.5) < 0.01 && std::abs(number("pressX") - 0.25) < 0.01);
        QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, at(0.6, 0.5));
        QCOMPARE(number("mouseDown"), 0.0);
        QVERIFY(std::abs(number("mouseX") - 0.6) < 0.01);
        QTRY_VERIFY(brightness(viewport().pictures().shown().image()) < 5);
        QCOMPARE(window_->history().stack().count(), steps + 1);
        QVERIFY(window_->history().sceneState().camera == camera);
        // For a shader that reads no mouse, dragging turns the view.
        show("still.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(0.5); }");
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, at(0.75, 0.75));
        for (const double x : {0.7, 0.6, 0.5}) QTest::mouseMove(&viewport(), at(x, 0.75));
        QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, at(0.5, 0.75));
        QVERIFY(std::abs(number("pressX") - 0.25) < 0.01);
        QVERIFY(!(window_->history().sceneState().camera == camera));
    }

    void aPointOfAnIsfIsDragged()
    {
        show("point.fs",
             "/*{\"INPUTS\": [{\"NAME\": \"center\", \"TYPE\": \"point2D\", \"MIN\": [-1, -1], \"MAX\": [1, "
             "1], \"DEFAULT\": [0, 0]}]}*/\nvoid main() { gl_FragColor = vec4(center.x); }");
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, at(0.5, 0.5));
        QTest::mouseMove(&viewport(), at(0.7, 0.6));
        QTest::mouseMove(&viewport(), at(0.75, 0.25));
        QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, at(0.75, 0.25));
        QVERIFY2(std::abs(number("centerX") - 0.5) < 0.02, qPrintable(QString::number(number("centerX"))));
        QVERIFY(std::abs(number("centerY") + 0.5) < 0.02);
    }

    void longTheButtonOfAnEventPressesItForOneStep()
    {
        show("count.fs", R"(/*{"INPUTS": [{"NAME": "flash", "TYPE": "event"}],
            "PASSES": [{"TARGET": "sum", "PERSISTENT": true, "FLOAT": true}, {}]}*/
            void main() { gl_FragColor = IMG_THIS_PIXEL(sum) + (PASSINDEX == 0 && flash ? 0.2 : 0.0); })");
        auto* button = window_->panel().row("flashAt")->findChild<QPushButton*>();
        QVERIFY(button && button->isVisible());
        QVERIFY(!window_->panel().row("moment")->findChild<QPushButton*>());
        QTRY_VERIFY(brightness(viewport().pictures().shown().image()) < 5);
        // While time stands, a press advances it by one step.
        const int steps = window_->history().stack().count();
        for (const double presses : {1.0, 2.0}) {
            QTest::mouseClick(button, Qt::LeftButton);
            QVERIFY(std::abs(number("moment") - presses / 60) < 1e-6);
            QCOMPARE(number("flashAt"), number("moment"));
            QTRY_VERIFY(std::abs(brightness(viewport().pictures().shown().image()) - 51 * presses) < 2);
        }
        QCOMPARE(window_->history().stack().count(), steps + 2);
        // While it runs, the next step is pressed, and no other one.
        set("animate", 1.0);
        QTRY_VERIFY(viewport().clock().time() > 0.2);
        QTest::mouseClick(button, Qt::LeftButton);
        QTRY_VERIFY(std::abs(brightness(viewport().pictures().shown().image()) - 153) < 2);
        const double pressed = viewport().clock().time();
        QTRY_VERIFY(viewport().clock().time() > pressed + 0.3);
        QVERIFY(std::abs(brightness(viewport().pictures().shown().image()) - 153) < 2);
        set("animate", 0.0);
    }

    void longAnInputShowsAnotherExhibit()
    {
        show("shown.fs", R"(/*{"INPUTS": [{"NAME": "inputImage", "TYPE": "image"}]}*/
            void main() { gl_FragColor = vec4(IMG_NORM_PIXEL(inputImage, vec2(0.5)).rgb, 1.0); })");
        auto* choice = window_->panel().row("inputImageSource")->findChild<QComboBox*>();
        QVERIFY(choice);
        set("pictureSide", 16.0);
        settle();
        const double testPicture = brightness(viewport().pictures().shown().image());
        QVERIFY(choice->findText("SDF Scenes") > 0);
        choice->setFocus();
        QTest::keyClicks(choice, "SDF");
        QTRY_COMPARE(choice->currentText(), QString("SDF Scenes"));
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(brightness(viewport().pictures().shown().image()) - testPicture) > 8, 60000);
        window_->history().stack().undo();
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(brightness(viewport().pictures().shown().image()) - testPicture) < 1, 60000);
    }

    void longInputsVaryAtRandom()
    {
        show("vary.fs", R"(/*{"INPUTS": [{"NAME": "level", "TYPE": "float", "DEFAULT": 0.5},
            {"NAME": "tint", "TYPE": "color", "DEFAULT": [1, 1, 1, 1]}]}*/
            void main() { gl_FragColor = vec4(level * tint.rgb, 1.0); })");
        const int steps = window_->history().stack().count();
        std::set<double> levels{number("level")};
        for (int i = 0; i < 3; ++i) {
            window_->panel().vary();
            levels.insert(number("level"));
            QVERIFY(number("level") >= 0 && number("level") <= 1);
        }
        QVERIFY(levels.size() >= 3);
        QCOMPARE(text("file"), home_->filePath("vary.fs").toStdString());
        QCOMPARE(window_->history().stack().count(), steps + 3);
        for (int i = 0; i < 3; ++i) window_->history().stack().undo();
        QCOMPARE(number("level"), 0.5);
        settle();
        QTRY_VERIFY(std::abs(brightness(viewport().pictures().shown().image()) - 127.5) < 3);
    }

    void longKeysInThePictureAreThoseOfTheShader()
    {
        show("keys.glsl", "#iChannel0::Type \"Keyboard\"\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(texelFetch("
                          "iChannel0, ivec2(87, 0), 0).x); }");
        set("moment", 2.0);
        const render::Camera camera = window_->history().sceneState().camera;
        const int steps = window_->history().stack().count();
        viewport().setFocus();
        QTRY_VERIFY(viewport().hasFocus());
        QTest::keyPress(&viewport(), Qt::Key_W);
        QCOMPARE(text("keys"), std::string("87@2"));
        QTRY_VERIFY(brightness(viewport().pictures().shown().image()) > 250);
        QTest::keyPress(&viewport(), Qt::Key_Space);
        QTest::keyRelease(&viewport(), Qt::Key_Space);
        QTest::keyRelease(&viewport(), Qt::Key_W);
        QCOMPARE(text("keys"), std::string("87@2-2 32@2-2"));
        QTRY_VERIFY(brightness(viewport().pictures().shown().image()) < 5);
        QCOMPARE(window_->history().stack().count(), steps + 1);
        QVERIFY(window_->history().sceneState().camera == camera);
        QTest::keyPress(&viewport(), Qt::Key_A);
        panel().view()->widget().setFocus();
        QTRY_VERIFY(!viewport().hasFocus());
        QCOMPARE(text("keys"), std::string("87@2-2 32@2-2 65@2-2"));
    }

    void longTwoFilesStandSideBySideWithTheirCosts()
    {
        CompareController& compared = window_->comparison();
        show("dark.glsl",
             "#iUniform float gain = 0.25 in {0, 1}\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(gain); }");
        compared.setToCurrent();
        show("bright.fs", "/*{\"INPUTS\": [{\"NAME\": \"level\", \"TYPE\": \"float\", \"DEFAULT\": 0.75}], \"PASSES\": "
                          "[{\"TARGET\": \"raw\"}, {}]}*/\nvoid main() { gl_FragColor = PASSINDEX == 0 ? vec4(level) : "
                          "IMG_THIS_PIXEL(raw); }");
        compared.setMode(CompareMode::sideBySide);
        QTRY_VERIFY(compared.picture().finished() && compared.picture().upToDate());
        settle();
        QVERIFY(std::abs(brightness(compared.picture().image()) - 63.75) < 3);
        QTRY_VERIFY(std::abs(brightness(viewport().pictures().shown().image()) - 191.25) < 3);
        const auto passes = [](const render::FrameReport& report) {
            std::set<std::string> names;
            for (const render::StepReport& step : report.ran)
                if (step.name.starts_with("your_shader/")) names.insert(step.name);
            for (const render::CulledPass& pass : report.skipped)
                if (pass.name.starts_with("your_shader/")) names.insert(pass.name);
            return names;
        };
        QVERIFY(passes(compared.picture().report()).contains("your_shader/1 Image"));
        QVERIFY(compared.picture().report().milliseconds > 0);
        // An input of B alone is not lost, and neither has those of the other.
        const ParameterValues& b = compared.other().sceneState().values[shader];
        QVERIFY(b.table().find("gain") && !b.table().find("level"));
        QVERIFY(values().table().find("level") && !values().table().find("gain"));
        set("level", 0.5);
        settle();
        QTRY_VERIFY(std::abs(brightness(viewport().pictures().shown().image()) - 127.5) < 3);
        QVERIFY(std::abs(brightness(compared.picture().image()) - 63.75) < 3);
        compared.other().swap();
        QTRY_VERIFY(values().table().find("gain"));
        settle();
        QTRY_VERIFY(std::abs(brightness(viewport().pictures().shown().image()) - 63.75) < 3);
        QTRY_VERIFY(std::abs(brightness(compared.picture().image()) - 127.5) < 3);
        compared.letGo();
    }

    void longAnExhibitIsCopiedAsAShaderOfOnesOwn()
    {
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        QToolButton* copy = nullptr;
        for (QToolButton* each : panel().findChildren<QToolButton*>())
            if (each->text() == "Copy as a shader of my own") copy = each;
        QVERIFY(copy);
        QTRY_COMPARE(copy->toolTip(), QString("This is a shader of your own already."));
        QVERIFY(!copy->isEnabled());
        settle();
        const QImage gyroid = viewport().pictures().shown().image().copy();
        window_->visit(fur);
        QTRY_VERIFY_WITH_TIMEOUT(copy->toolTip().startsWith("Fur with Physics cannot stand alone: "), 60000);
        QVERIFY(!copy->isEnabled());
        window_->visit(scenes);
        const ParameterValues& ofScenes = window_->history().sceneState().values[scenes];
        window_->history().set(scenes, ofScenes.table().find("scene").value(), std::string("torus.json"), 0);
        QTRY_VERIFY_WITH_TIMEOUT(copy->isEnabled(), 60000);
        copy->click();
        auto* dialog = window_->findChild<QFileDialog*>();
        QVERIFY(dialog);
        dialog->setDirectory(home_->path());
        QCOMPARE(dialog->findChild<QLineEdit*>("fileNameEdit")->text(), QString("sdf_scenes.fs"));
        QSignalSpy copied(&panel().copy(), &ShaderCopy::copied);
        static_cast<QDialog*>(dialog)->accept();
        const QString path = home_->filePath("sdf_scenes.fs");
        QTRY_COMPARE_WITH_TIMEOUT(copied.count(), 1, 60000);
        QCOMPARE(copied.first().first().toString(), path);
        auto* strip = window_->findChild<MessageStrip*>();
        QTRY_VERIFY(strip->texts().join(QLatin1Char('\n')).contains("It is a shader of your own now."));
        QCOMPARE(window_->chosen(), shader);
        QTRY_VERIFY(panel().view()->text().contains("as Vitrine draws it"));
        const auto work = [&] { return static_cast<const guest::YourShaderTable&>(values().table()).work; };
        QTRY_VERIFY(work() && work()->path.filename() == "sdf_scenes.fs");
        viewport().visitor().jumpTo(museum_->bestView(shader, values()));
        QTRY_VERIFY_WITH_TIMEOUT(viewport().pictures().schedule().still(), 60000);
        QVERIFY(brightness(viewport().pictures().shown().image()) > 5);
        QVERIFY(viewport().pictures().shown().image() != gyroid);
    }

    void longAnAttackEndsWithAMessageWhileTheWindowAnswers_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("sentence");
        QString calls = "float f0(float x) { return sin(x); }\n";
        for (int i = 1; i < 26; ++i)
            calls += QString("float f%1(float x) { return f%2(x) + f%2(x + 1.0); }\n").arg(i).arg(i - 1);
        QTest::newRow("calls") << calls + "void main() { gl_FragColor = vec4(f25(gl_FragCoord.x)); }"
                               << "instructions when every call is replaced by its function";
        // Macros that are given macros are not counted before: the compiler runs into its limit.
        QTest::newRow("macros") << "#define D(x) x x\n#define E(x) D(D(D(D(D(D(x))))))\n"
                                   "void main() { gl_FragColor = vec4(E(E(E(E(E(1.0 +))))) 1.0); }"
                                << "the GLSL compiler needs more than";
        QTest::newRow("array") << "void main() { float a[20000000]; a[int(gl_FragCoord.x)] = 1.0; gl_FragColor = "
                                  "vec4(a[int(gl_FragCoord.y)]); }"
                               << "make the arrays smaller";
        QTest::newRow("loop") << "void main() { float n = 0.0; for (;;) { n += 1.0; if (n < 0.0) break; } "
                                 "gl_FragColor = vec4(n); }"
                              << "takes too long here";
    }
    void longAnAttackEndsWithAMessageWhileTheWindowAnswers()
    {
        QFETCH(QString, text);
        QFETCH(QString, sentence);
        settle();
        const QString path = home_->filePath("attack.frag");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text.toUtf8());
        file.close();
        QElapsedTimer sinceOpened, sinceAnswer;
        qint64 longest = 0;
        QTimer answers;
        connect(&answers, &QTimer::timeout, this, [&] { longest = std::max(longest, sinceAnswer.restart()); });
        sinceOpened.start();
        sinceAnswer.start();
        answers.start(10);
        window_->files().open(path);
        auto* strip = window_->findChild<MessageStrip*>();
        QTRY_VERIFY2_WITH_TIMEOUT(strip->texts().join(QLatin1Char('\n')).contains(sentence),
                                  qPrintable(strip->texts().join(QLatin1Char('\n'))), 120000);
        const qint64 told = sinceOpened.elapsed();
        longest = std::max(longest, sinceAnswer.elapsed());
        qInfo("%lld ms to the message, %lld ms at most without an answer", told, longest);
        // The time to the message depends on the machine's load; on an idle one it is at most 6 s as well.
        QVERIFY2(longest < 6000, qPrintable(QString::number(longest)));
        set("file", std::string("gyroid.frag"));
        settle();
        QVERIFY(brightness(viewport().pictures().shown().image()) > 5);
    }

    void longAnErrorLeavesThePictureAsItIs()
    {
        QTRY_VERIFY(!panel().live().isChecking());
        settle();
        const QImage before = viewport().pictures().shown().image().copy();
        typeOver("exp(-1.4", "exq(-0.2");
        QTRY_VERIFY(!panel().live().findings().empty());
        settle();
        QCOMPARE(viewport().pictures().shown().image(), before);
        typeOver("exq(-0.2", "exp(-0.2");
        QTRY_VERIFY(std::abs(brightness(viewport().pictures().shown().image()) - brightness(before)) >= 4);
    }
};

VITRINE_WINDOW_TEST(ShaderPictureTest)

#include "shader_picture_test.moc"
