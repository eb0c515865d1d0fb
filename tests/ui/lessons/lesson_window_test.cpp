#include "tests/ui/open_window.h"
#include "tests/ui/ui_main.h"

#include "exhibits/exhibits.h"
#include "render/files/assets.h"
#include "ui/kit/language.h"
#include "ui/kit/message_strip.h"
#include "ui/lessons/formula_text.h"
#include "ui/lessons/lesson_bar.h"
#include "ui/lessons/lesson_controller.h"
#include "ui/lessons/page_dialog.h"
#include "ui/window/file_opener.h"
#include "ui/window/window_dialogs.h"

#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScopeGuard>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextDocument>
#include <QToolButton>
#include <QUrl>
#include <QXmlStreamReader>

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

using namespace vitrine;
using namespace vitrine::ui;

/// A walk through a lesson in the whole window, and the pages about the exhibits.
class LessonWindowTest : public test::OpenWindow {
    Q_OBJECT

    void activate()
    {
        QApplication::setActiveWindow(window_.get());  // Under Xvfb there is no window manager.
        window_->viewport().setFocus();
    }
    [[nodiscard]] LessonController& controller() { return window_->lessons(); }
    [[nodiscard]] QToolButton* button(const char* name)
    {
        for (auto* each : controller().bar().findChildren<QToolButton*>())
            if (each->accessibleName() == QLatin1String(name)) return each;
        return nullptr;
    }
    [[nodiscard]] bool says(const QString& words)
    {
        for (const QLabel* label : controller().bar().findChildren<QLabel*>())
            if (label->isVisible() && label->text().contains(words)) return true;
        return false;
    }
    QString write(const char* name, const QByteArray& steps)
    {
        const QString path = home_->filePath(QLatin1String(name));
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly)) return {};
        file.write("# Two settings\n\n```json\n{\"format\": \"vitrine-lesson\", \"version\": 1, \"exhibit\": "
                   "\"sdf_morph\"}\n```\nWhat is **rough**?\n\n" +
                   steps);
        return path;
    }
    QString goodLesson()
    {
        return write(
            "good.md",
            "## Rough\nSee [row:roughness] & [row:hall.exposure].\n```json\n{\"values\": {\"roughness\": 0.9}, "
            "\"hall\": {\"exposure\": 2}, \"read\": \"row:roughness\"}\n```\n"
            "## Smooth\nAnd now?\n```json\n{\"values\": {\"roughness\": 0.1}, \"camera\": {\"eye\": [1, 1.2, 4], "
            "\"target\": [1, 1, 0], \"fov\": 0.8}, \"read\": \"milliseconds\"}\n```\n");
    }
    [[nodiscard]] double exposure()
    {
        const ParameterValues& hall = window_->history().sceneState().hall();
        return std::get<double>(hall.row(*hall.table().find("exposure")));
    }

    QList<QUrl> opened_;

public slots:
    /// Stands in for the web browser.
    void noteUrl(const QUrl& url) { opened_ << url; }

private slots:
    void initTestCase() { prepare(); }
    void init() { start(); }
    void cleanup()
    {
        finish();
        setLanguage(QStringLiteral("en"));
    }

    void linksListsPicturesCodeAndFormulasAreShownWhole()
    {
        QImage picture(600, 300, QImage::Format_RGB32);
        picture.fill(Qt::red);
        QVERIFY(picture.save(home_->filePath("red.png")));
        controller().open(write("forms.md", "## One\nA $t_{i+1}$ and a [paper](https://example.org/a).\n\n"
                                            "```glsl lib/sdf.glsl sdfTorus\n```\n"
                                            "### Try\n- one\n- [row:roughness]\n"
                                            "### Question\nWhy?\n### Answer\n![A square](red.png)\n"
                                            "```json\n{}\n```\n"));
        controller().nextAction().trigger();
        controller().answerAction().trigger();
        settle();
        for (const char* part :
             {"<i>t</i><sub>", "href=\"https://example.org/a\"", "float sdfTorus(", "&nbsp;&nbsp;&nbsp;&nbsp;return",
              "<li>one</li>", "href=\"row:roughness\"", "red.png\" width=\"320\" height=\"160\" alt=\"A square\""})
            QVERIFY2(says(part), part);
        for (const QLabel* label : controller().bar().findChildren<QLabel*>())
            if (label->isVisible() && label->wordWrap())
                QVERIFY2(label->height() >= label->heightForWidth(label->width()), qPrintable(label->text()));
    }

    void pagesOfTheWebAreOpenedAfterAClickAndNothingElseIs()
    {
        for (const char* scheme : {"https", "http", "file", "javascript"})
            QDesktopServices::setUrlHandler(scheme, this, "noteUrl");
        const auto unset = qScopeGuard([] {
            for (const char* scheme : {"https", "http", "file", "javascript"})
                QDesktopServices::unsetUrlHandler(scheme);
        });
        controller().open(write("web.md", "## One\nA [paper](https://example.org/a).\n```json\n{}\n```\n"));
        controller().nextAction().trigger();
        QVERIFY(opened_.isEmpty());
        QLabel* text = nullptr;
        for (QLabel* label : controller().bar().findChildren<QLabel*>())
            if (label->text().contains("example.org")) text = label;
        QVERIFY(text);
        for (const char* other : {"file:///etc/passwd", "javascript:alert(1)", "vitrine:x"})
            emit text->linkActivated(other);
        QVERIFY(opened_.isEmpty());
        emit text->linkActivated("https://example.org/a");
        QCOMPARE(opened_, QList<QUrl>{QUrl("https://example.org/a")});
    }

    void withLargeTypeTheButtonsOfALessonAreBelowItsTitle()
    {
        controller().open(goodLesson());
        QWidget& bar = controller().bar();
        auto* next = button("Next step");
        QLabel* title = nullptr;
        for (QLabel* label : bar.findChildren<QLabel*>())
            if (label->text() == "Two settings") title = label;
        QVERIFY(title);
        const int before = bar.minimumSizeHint().width();
        QVERIFY(next->y() < title->geometry().bottom());
        QFont large = bar.font();
        large.setPointSizeF(2 * large.pointSizeF());
        for (QWidget* each : bar.findChildren<QWidget*>()) each->setFont(large);
        bar.setFont(large);
        // The strip needs not more room than before, so that it widens no window.
        QTRY_VERIFY(next->y() >= title->geometry().bottom());
        QVERIFY2(bar.minimumSizeHint().width() <= before, qPrintable(QString::number(bar.minimumSizeHint().width())));
        QVERIFY2(title->height() >= title->fontMetrics().height() && title->width() > 200, "the title is shown");
    }

    void aLessonIsWalkedThroughAndWhatWasOpenComesBack()
    {
        QVERIFY(!controller().bar().isVisible());
        window_->viewport().visitor().jumpTo({{1.35, 1.65, 8}, {1, 1.6, 0}, 0.9});
        dragRoughnessOf(1, 60);
        window_->choose(hallIndex);
        settle();
        const SceneState before = window_->history().sceneState();
        const int steps = window_->history().stack().count();

        controller().open(goodLesson());
        QVERIFY(controller().bar().isVisible());
        QCOMPARE(window_->chosen(), std::size_t{1});
        QVERIFY(says("Two settings"));
        QVERIFY(says("What is <b>rough</b>?"));
        QVERIFY(says("2 steps"));
        QCOMPARE(window_->history().stack().count(), steps + 1);
        QVERIFY(!button("Step back")->isEnabled());

        QTest::mouseClick(button("Next step"), Qt::LeftButton);
        QCOMPARE(roughness(), 0.9);
        QCOMPARE(exposure(), 2.0);
        QVERIFY(says("Step 1 of 2"));
        QVERIFY(says("<a href=\"row:roughness\"><b>Roughness</b></a> &amp; "));
        QVERIFY(says("Read: Roughness 0.9"));
        QTRY_VERIFY(red() > 200);

        QTest::mouseClick(button("Next step"), Qt::LeftButton);
        QCOMPARE(roughness(), 0.1);
        QCOMPARE(exposure(), std::get<double>(before.hall().row(*before.hall().table().find("exposure"))));
        QCOMPARE(window_->history().sceneState().camera.eye, glm::dvec3(1, 1.2, 4));
        QVERIFY(!button("Next step")->isEnabled());
        QTRY_VERIFY(says(" ms"));
        QCOMPARE(window_->history().stack().count(), steps + 3);

        QTest::mouseClick(button("Step back"), Qt::LeftButton);
        QCOMPARE(roughness(), 0.9);
        QTest::mouseClick(button("Leave the lesson"), Qt::LeftButton);
        QVERIFY(!controller().bar().isVisible());
        QCOMPARE(window_->chosen(), hallIndex);
        QVERIFY(window_->history().sceneState() == before);
        QCOMPARE(window_->history().stack().count(), steps + 5);
    }

    void anAnswerOpensAndIsClosedAgainInTheNextStep()
    {
        const QByteArray block = "```json\n{\"values\": {\"roughness\": 0.9}}\n```\n";
        controller().open(
            write("asked.md", "## One\nText.\n### Try\nSet [row:roughness].\n### Question\nWhy?\n### Answer\n"
                              "So **be** it.\n" +
                                  block + "## Two\nText.\n### Question\nWhen?\n### Answer\nNow.\n" + block +
                                  "## Three\nText.\n" + block));
        QToolButton* answer = button("Show the answer");
        QVERIFY(answer && !answer->isVisible());
        controller().next();
        QVERIFY(says("<b>Try:</b> Set <a href=\"row:roughness\"><b>Roughness</b></a>."));
        QVERIFY(says("<b>Question:</b> Why?"));
        QVERIFY(answer->isVisible() && !says("So <b>be</b> it."));
        QTest::mouseClick(answer, Qt::LeftButton);
        QVERIFY(answer->isChecked() && says("So <b>be</b> it."));
        QVERIFY2(controller().bar().accessibleName().contains("So be it."), "an opened answer is announced");
        QTest::mouseClick(answer, Qt::LeftButton);
        QVERIFY(!answer->isChecked() && !says("So <b>be</b> it."));
        controller().answerAction().trigger();
        QVERIFY(says("So <b>be</b> it."));
        controller().next();
        QVERIFY(says("When?") && !says("Now.") && !answer->isChecked());
        controller().next();
        QVERIFY(!answer->isVisible() && !controller().answerAction().isEnabled());
        controller().back();
        QVERIFY(says("When?") && answer->isVisible());
    }

    void longANumberIsShownOnlyOnceThePictureOfTheStepIsDrawn()
    {
        const QString path =
            write("numbers.md", "## Rough\nText.\n```json\n{\"values\": {\"roughness\": 0.9}, \"read\": "
                                "\"milliseconds\"}\n```\n"
                                "## Smooth\nText.\n```json\n{\"values\": {\"roughness\": 0.1}, \"read\": "
                                "\"milliseconds\"}\n```\n");
        controller().open(path);
        controller().next();
        QTRY_VERIFY(says("Read: time of a picture 43.8 ms"));
        settle();
        // Drawing is blocked from here on, so that the last pictures are those of the previous step.
        const auto go = std::make_shared<std::atomic<bool>>(false);
        const auto goOn = qScopeGuard([go] { *go = true; });
        gallery_->beforeDrawing = [go](const FrameRequest&, const Renderers::IsCanceled&) {
            while (!*go) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        };
        controller().next();
        QVERIFY2(says(QString::fromUtf8("Read: time of a picture …")), qPrintable(controller().numberText()));
        QTest::qWait(50);
        QVERIFY2(says(QString::fromUtf8("Read: time of a picture …")), qPrintable(controller().numberText()));
        QVERIFY(says("previous step 43.8 ms"));
        *go = true;
        QTRY_VERIFY(says("Read: time of a picture 43.8 ms"));
        // The same if a visitor changes a value within a step, and returns to it.
        settle();
        *go = false;
        window_->history().set(1, *window_->history().sceneState().values[1].table().find("roughness"), 0.5,
                               newGesture());
        QTRY_VERIFY2(says(QString::fromUtf8("Read: time of a picture …")), qPrintable(controller().numberText()));
        controller().back();
        QVERIFY2(says(QString::fromUtf8("Read: time of a picture …")), qPrintable(controller().numberText()));
        *go = true;
        QTRY_VERIFY(says("Read: time of a picture 43.8 ms"));
        settle();
        gallery_->beforeDrawing = nullptr;
    }

    void undoLeadsThroughTheLesson()
    {
        controller().open(goodLesson());
        controller().next();
        controller().next();
        window_->history().stack().undo();
        QVERIFY(says("Step 1 of 2"));
        QCOMPARE(roughness(), 0.9);
        window_->history().stack().undo();
        window_->history().stack().undo();
        QVERIFY(!controller().lesson());
        QCOMPARE(roughness(), 0.25);
        QCOMPARE(window_->chosen(), hallIndex);
        window_->history().stack().redo();
        window_->history().stack().redo();
        QVERIFY(says("Step 1 of 2"));
        QCOMPARE(roughness(), 0.9);
        controller().leave();
        window_->history().stack().undo();
        QVERIFY2(says("Step 1 of 2"), "undone, the lesson is open again");
    }

    void whatAVisitorChangesInAStepIsGoneInTheNextAndTheLessonKnowsNoOtherExhibit()
    {
        controller().open(goodLesson());
        controller().next();
        window_->history().set(1, *window_->history().sceneState().values[1].table().find("morph"), 0.875,
                               newGesture());
        controller().next();
        controller().back();
        const ParameterValues& values = window_->history().sceneState().values[1];
        QCOMPARE(std::get<double>(values.row(*values.table().find("morph"))), 0.5);
    }

    void keysAndLinksDoTheSame()
    {
        controller().open(goodLesson());
        activate();
        QTest::keyClick(&window_->viewport(), Qt::Key_PageDown, Qt::ControlModifier);
        QTRY_VERIFY(says("Step 1 of 2"));
        QTest::keyClick(&window_->viewport(), Qt::Key_PageUp, Qt::ControlModifier);
        QTRY_VERIFY(says("2 steps"));
        controller().next();
        emit controller().parameterRequested(QStringLiteral("roughness"));
        QVERIFY(window_->panel().row("roughness")->isAncestorOf(window_->panel().focusWidget()));
        activate();
        QTest::keyClick(&window_->viewport(), Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(!controller().lesson());
        window_->files().open(goodLesson());
        QVERIFY2(controller().lesson(), "a lesson that is dropped on the window is opened");
        window_->hidePanels(true);
        QVERIFY(!controller().bar().isVisible());
        window_->hidePanels(false);
        QVERIFY(controller().bar().isVisible());
    }

    void aBadLessonIsNotOpenedAndSaysWhy()
    {
        controller().open(write("bad.md", "## One\nText.\n```json\n{\"values\": {\"roughnes\": 1}}\n```\n"));
        QVERIFY(!controller().lesson());
        QCOMPARE(window_->history().stack().count(), 0);
        const QString said = window_->findChild<MessageStrip*>()->texts().join(QLatin1Char('\n'));
        QVERIFY2(said.contains("bad.md, line 11, values.roughnes: there is no parameter"), qPrintable(said));
    }

    void aWindowThatClosesInALessonKeepsWhatWasOpenBefore()
    {
        controller().open(goodLesson());
        controller().next();
        closeWindow();
        openWindow();
        QCOMPARE(roughness(), 0.25);
        QVERIFY(!controller().lesson());
    }

    void longEveryExhibitHasItsPageAndAllPicturesAndLinksInItResolve_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("folder");
        QTest::newRow("English") << QStringLiteral("en") << QStringLiteral("pages");
        QTest::newRow("German") << QStringLiteral("de") << QStringLiteral("pages/de");
    }

    void longEveryExhibitHasItsPageAndAllPicturesAndLinksInItResolve()
    {
        QFETCH(QString, language);
        QFETCH(QString, folder);
        setLanguage(language);
        const QDir pages(QString::fromStdString(render::asset(folder.toStdString()).string()));
        QStringList names{QStringLiteral("hall"), QStringLiteral("syllabus")};
        for (const auto& exhibit : allExhibits())
            if (exhibit->isComplete()) names << QString::fromStdString(std::string(exhibit->name()));
        PageDialog dialog(nullptr, [](const QString&) { return nullptr; });
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        for (const QString& name : names) {
            dialog.showPage(name);
            const QUrl source = dialog.browser().source();
            QVERIFY2(QFileInfo::exists(source.toLocalFile()), qPrintable(source.toLocalFile()));
            QCOMPARE(QFileInfo(source.toLocalFile()).dir(), pages);
            QFile written(source.toLocalFile());
            QVERIFY(written.open(QIODevice::ReadOnly));
            QXmlStreamReader xml(written.readAll());
            while (!xml.atEnd()) xml.readNext();
            QVERIFY2(!xml.hasError(), qPrintable(QStringLiteral("%1, line %2: %3")
                                                     .arg(written.fileName())
                                                     .arg(xml.lineNumber())
                                                     .arg(xml.errorString())));
            const QTextDocument& page = *dialog.browser().document();
            QVERIFY2(page.toPlainText().size() > 600, qPrintable(name));
            QVERIFY2(!dialog.windowTitle().isEmpty(), qPrintable(name));
            int pictures = 0, links = 0;
            for (QTextBlock block = page.begin(); block.isValid(); block = block.next()) {
                for (auto part = block.begin(); !part.atEnd(); ++part) {
                    const QTextCharFormat format = part.fragment().charFormat();
                    if (format.isImageFormat()) {
                        const QString file = format.toImageFormat().name();
                        const QImage picture(QFileInfo(source.toLocalFile()).dir().filePath(file));
                        QVERIFY2(!picture.isNull(), qPrintable(name + ": " + file));
                        QVERIFY2(picture.width() <= 720, qPrintable(name + ": wider than the page: " + file));
                        ++pictures;
                    }
                    if (!format.isAnchor() || format.anchorHref().isEmpty()) continue;
                    ++links;
                    const QUrl link(format.anchorHref());
                    if (link.scheme() == "https") {
                        QVERIFY2(link.isValid() && !link.host().isEmpty(), qPrintable(format.anchorHref()));
                    } else if (link.scheme() == "lesson") {
                        QVERIFY2(names.contains(link.path()), qPrintable(format.anchorHref()));
                    } else {
                        const QString file = source.resolved(link).toLocalFile();
                        QVERIFY2(QFileInfo::exists(file), qPrintable(name + ": " + format.anchorHref()));
                    }
                }
            }
            QVERIFY2(name == "hall" || name == "syllabus" || (pictures >= 2 && links >= 1), qPrintable(name));
        }
        QCOMPARE(pages.entryList({"*.html"}).size(), names.size());
    }

    void longFormulasAreShownAsText_data()
    {
        QTest::addColumn<QString>("formula");
        QTest::addColumn<QString>("text");
        QTest::newRow("fraction")
            << "<mi>σ</mi><mo>=</mo><mfrac><mrow><mi>k</mi><mo>⁢</mo><mi>r</mi></mrow><mn>2</mn></mfrac>"
               "<mo>+</mo><msqrt><mn>1</mn><mo>+</mo><msup><mi>x</mi><mn>2</mn></msup></msqrt>"
            << "<i>σ</i> = <i>k</i> <i>r</i> / 2 + √(1 + <i>x</i><sup>2</sup>)";
        QTest::newRow("sums in a fraction")
            << "<mfrac><mrow><mi>a</mi><mo>+</mo><mi>b</mi></mrow><mrow><mn>4</mn><mo>⁢</mo><mi>k</mi></mrow></mfrac>"
            << "(<i>a</i> + <i>b</i>) / (4 <i>k</i>)";
        QTest::newRow("short fraction") << "<mfrac><mi>x</mi><mi>p</mi></mfrac>"
                                        << "<i>x</i>/<i>p</i>";
        QTest::newRow("signs")
            << "<mi>max</mi><mrow><mo>(</mo><mi>a</mi><mo>,</mo><mo>−</mo><mi>b</mi><mo>)</mo></mrow><mo>&lt;</mo>"
               "<mn>0</mn>"
            << "max(<i>a</i>, −<i>b</i>) &lt; 0";
        QTest::newRow("sum")
            << "<munderover><mo>∑</mo><mrow><mi>i</mi><mo>=</mo><mn>1</mn></mrow><mn>5</mn></munderover>"
               "<msub><mi mathvariant=\"bold\">g</mi><mi>i</mi></msub>"
            << "∑<sub><i>i</i>=1</sub><sup>5</sup> <b>g</b><sub><i>i</i></sub>";
        QTest::newRow("prime") << "<mi>sin</mi><mspace width=\"0.17em\"/><msup><mi>θ</mi><mo>′</mo></msup>"
                               << "sin <i>θ</i>′";
        QTest::newRow("words")
            << "<mtext>view </mtext><mi>k</mi><mspace width=\"2em\"/><mi mathvariant=\"normal\">d</mi>"
            << QStringLiteral("view <i>k</i>%1d").arg(QString(3, QChar(0xA0)));
    }

    void longFormulasAreShownAsText()
    {
        QFETCH(QString, formula);
        QFETCH(QString, text);
        const QString written = QStringLiteral("<p>a <math display=\"block\">%1</math> b</p>");
        QCOMPARE(withFormulasAsText(written.arg(formula)), QStringLiteral("<p>a %1 b</p>").arg(text));
    }

    void brokenFormulasStayAsTheyAre()
    {
        for (const char* broken : {"<p><math><mi>a</mo></math></p>", "<p><math><mi>a</mi>", "<math></p>", "<math"})
            QCOMPARE(withFormulasAsText(QString::fromUtf8(broken)), QString::fromUtf8(broken));
    }

    void pagesShowTheirFormulasWithoutMarks()
    {
        PageDialog dialog(nullptr, [](const QString&) { return nullptr; });
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.showPage(QStringLiteral("ice_cream"));
        const QString page = dialog.browser().toPlainText();
        QVERIFY2(page.contains(QString::fromUtf8("σ = k r / 2 + √(1 + (k r / 2)2)")), qPrintable(page));
        QVERIFY(!page.contains(QStringLiteral("math")));
    }

    void theMenuLeadsToTheSyllabusWhoseLinksStartLessons()
    {
        QAction* syllabus = nullptr;
        for (QAction* action : controller().menu())
            if (action && action->objectName() == "lesson-syllabus") syllabus = action;
        QVERIFY(syllabus);
        syllabus->trigger();
        auto* dialog = window_->findChild<PageDialog*>();
        QVERIFY(dialog && dialog->browser().source().path().endsWith("/syllabus.html"));
        // Only the request to start the lesson is tested: the exhibits of this museum lack its parameters.
        QSignalSpy asked(dialog, &PageDialog::lessonAsked);
        emit dialog->browser().anchorClicked(QUrl(QStringLiteral("lesson:sdf_morph")));
        QCOMPARE(asked.count(), 1);
        QCOMPARE(asked[0][0].toString(), QStringLiteral("sdf_morph"));
        dialog->close();
    }

    void linksOfPagesLeadToPagesInTheLanguageInUse()
    {
        setLanguage(QStringLiteral("de"));
        PageDialog dialog(nullptr, [](const QString&) { return nullptr; });
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.showPage(QStringLiteral("hall"));
        QVERIFY(dialog.browser().source().path().endsWith("/pages/de/hall.html"));
        QCOMPARE(dialog.windowTitle(), QStringLiteral("Die Halle, und was in ihr steht"));
        emit dialog.browser().anchorClicked(QUrl(QStringLiteral("noise.html")));
        QVERIFY(dialog.browser().source().path().endsWith("/pages/de/noise.html"));
        setLanguage(QStringLiteral("en"));
        emit dialog.browser().anchorClicked(QUrl(QStringLiteral("fur.html")));
        QVERIFY(dialog.browser().source().path().endsWith("/pages/fur.html"));
    }

    void thePageOfTheVisitedExhibitOpensWithF1AndStartsItsLesson()
    {
        window_->choose(1);
        activate();
        QTest::keyClick(&window_->viewport(), Qt::Key_F1);
        QTRY_VERIFY(window_->findChild<PageDialog*>());
        auto* dialog = window_->findChild<PageDialog*>();
        QVERIFY(dialog->browser().source().path().endsWith("/sdf_morph.html"));
        const QString page = dialog->browser().toPlainText();
        for (const ParameterInfo& parameter : window_->history().sceneState().values[1].rows())
            QVERIFY2(page.contains(translatedText(label(parameter))) && page.contains(translatedText(parameter.help)),
                     parameter.name.data());
        const auto lesson = [dialog] {
            for (QPushButton* each : dialog->findChildren<QPushButton*>())
                if (each->text() == "&Start the exhibit's lesson") return each;
            return static_cast<QPushButton*>(nullptr);
        };
        QVERIFY(lesson() && lesson()->isEnabled());
        window_->dialogs().openPage(hallIndex);
        QVERIFY(dialog->browser().source().path().endsWith("/hall.html"));
        QVERIFY2(!lesson()->isEnabled(), "the hall has none");
        emit dialog->browser().anchorClicked(QUrl(QStringLiteral("noise.html")));
        QVERIFY(dialog->browser().source().path().endsWith("/noise.html"));
        QVERIFY(lesson()->isEnabled());
        dialog->browser().backward();
        QVERIFY(!lesson()->isEnabled());
        QVERIFY(dialog->browser().source().path().endsWith("/hall.html"));
        dialog->close();
    }

private:
    void dragRoughnessOf(std::size_t exhibit, int pixels)
    {
        window_->choose(exhibit);
        dragRoughness(pixels);
    }
};

VITRINE_UI_TEST(LessonWindowTest)

#include "lesson_window_test.moc"
