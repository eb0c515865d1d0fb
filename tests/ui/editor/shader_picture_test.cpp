// Edits of a shader and the real picture: what is typed is seen, what has errors changes nothing.
#include "tests/ui/few_samples.h"
#include "tests/ui/ui_main.h"

#include "exhibits/museum/museum.h"
#include "exhibits/your_shader/your_shader.h"
#include "ui/editor/live_text.h"
#include "ui/editor/shader_panel.h"
#include "ui/kit/theme.h"
#include "ui/viewport/gl_probe.h"
#include "ui/viewport/museum_renderers.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"
#include "ui/window/window_docks.h"

#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

#include <clocale>
#include <memory>

using namespace vitrine;
using namespace vitrine::ui;
using vitrine::test::patience;

class ShaderPictureTest : public QObject {
    Q_OBJECT

    static constexpr std::size_t shader = 1;

    std::unique_ptr<QTemporaryDir> home_;
    std::unique_ptr<Museum> museum_;
    std::unique_ptr<MuseumRenderers> renderers_;
    std::unique_ptr<MainWindow> window_;

    [[nodiscard]] const ParameterValues& values() { return window_->history().sceneState().values[shader]; }
    [[nodiscard]] ShaderPanel& panel() { return window_->docks().shader(); }
    [[nodiscard]] Viewport& viewport() { return window_->viewport(); }
    void set(const char* row, const Value& value)
    {
        window_->history().set(shader, values().table().find(row).value(), value, 0);
    }
    void settle() { QTRY_VERIFY(viewport().schedule().still()); }
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
    void initTestCase()
    {
        std::setlocale(LC_NUMERIC, "C");
        applyTheme(*qApp, darkTheme());
        QVERIFY2(whyNoOpenGl().isEmpty(), qPrintable(whyNoOpenGl()));
        std::vector<std::unique_ptr<Exhibit>> exhibits;
        exhibits.push_back(std::make_unique<YourShader>());
        museum_ = std::make_unique<Museum>(std::move(exhibits));
    }
    void init()
    {
        home_ = std::make_unique<QTemporaryDir>();
        for (const char* name : {"HOME", "XDG_STATE_HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME"})
            qputenv(name, home_->path().toLocal8Bit());
        renderers_ = std::make_unique<MuseumRenderers>(*museum_);
        window_ = std::make_unique<MainWindow>(*museum_, *renderers_);
        window_->resize(1000, 700);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get(), patience));
        QApplication::setActiveWindow(window_.get());
        test::takeFewSamples(*window_, 1);
        QTRY_VERIFY(viewport().picturesDrawn() > 0);
        window_->visit(shader);
        viewport().jumpTo(museum_->bestView(shader, values()));
        window_->docks().showShader();
        QTRY_VERIFY(panel().view());
    }
    void cleanup()
    {
        SceneState state = window_->history().sceneState();
        dynamic_cast<const HasDocument&>(museum_->subject(shader)).dropUnsaved(state.values[shader]);
        window_->history().stack().clear();
        window_->history().settle(state);
        window_->close();
        window_.reset();
        renderers_.reset();
    }

    void anEditIsSeen_data()
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
    void anEditIsSeen()
    {
        QFETCH(QString, file);
        QFETCH(QString, words);
        QFETCH(QString, typed);
        set("file", file.toStdString());
        QTRY_VERIFY(panel().view()->text().contains(words));
        QTRY_VERIFY(!panel().live().isChecking());
        settle();
        const double before = brightness(viewport().shown());
        for (int times = 0; times < 3; ++times) {
            typeOver(words, typed);
            QElapsedTimer timer;
            timer.start();
            qint64 checked = 0;
            while (std::abs(brightness(viewport().shown()) - before) < 4 && timer.elapsed() < 60000) {
                if (checked == 0 && !panel().live().isChecking()) checked = timer.elapsed();
                QTest::qWait(2);
            }
            qInfo("%s: %lld ms from the last key to the shader, %lld ms to the picture", qPrintable(file), checked,
                  timer.elapsed());
            QVERIFY(std::abs(brightness(viewport().shown()) - before) >= 4);
            settle();
            typeOver(typed, words);
            QTRY_VERIFY(!panel().live().isChecking());
            settle();
            QTRY_VERIFY(std::abs(brightness(viewport().shown()) - before) < 1);
        }
    }

    void anErrorLeavesThePictureAsItIs()
    {
        QTRY_VERIFY(!panel().live().isChecking());
        settle();
        const QImage before = viewport().shown().copy();
        typeOver("exp(-1.4", "exq(-0.2");
        QTRY_VERIFY(!panel().live().findings().empty());
        settle();
        QCOMPARE(viewport().shown(), before);
        typeOver("exq(-0.2", "exp(-0.2");
        QTRY_VERIFY(std::abs(brightness(viewport().shown()) - brightness(before)) >= 4);
    }
};

VITRINE_WINDOW_TEST(ShaderPictureTest)

#include "shader_picture_test.moc"
