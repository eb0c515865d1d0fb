#pragma once

#include "tests/ui/painted_gallery.h"
#include "tests/ui/test_home.h"

#include "ui/kit/theme.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parameters/parameter_row.h"
#include "ui/parameters/value_slider.h"
#include "ui/presets/preset_list.h"
#include "ui/viewport/gl_probe.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

#include <QAction>
#include <QApplication>
#include <QListWidget>
#include <QTemporaryDir>
#include <QTest>

#include <clocale>
#include <limits>
#include <memory>

namespace vitrine::test {

/// Test of the whole window with a real OpenGL context, over a gallery whose picture has one color.
class OpenWindow : public QObject {
protected:
    std::unique_ptr<QTemporaryDir> home_;
    std::shared_ptr<PlainMuseum> kept_;  // Museum with another exhibit; null: none.
    std::unique_ptr<PaintedGallery> gallery_;
    std::unique_ptr<ui::MainWindow> window_;
    /// Largest number of supersamples of a static picture. The window is painted once for each; two are enough to see
    /// a picture refined.
    int mostSamples_ = 2;
    static constexpr int asTheHallRequests = std::numeric_limits<int>::max();

    /// Returns a further exhibit for the gallery; null: none. Its museum is kept for all functions, so that its files
    /// are read once.
    [[nodiscard]] virtual std::unique_ptr<Exhibit> anotherExhibit() { return nullptr; }

    static void prepare()
    {
        std::setlocale(LC_NUMERIC, "C");
        ui::applyTheme(*qApp, ui::darkTheme());
        QVERIFY2(ui::whyNoOpenGl().isEmpty(), qPrintable(ui::whyNoOpenGl()));
    }
    void start()
    {
        // Every test has folders of its own; the user's are never touched.
        home_ = newHome(ProgramCaches::none);
        QVERIFY(home_->isValid());
        openWindow();
    }
    void finish()
    {
        if (window_) closeWindow();
    }
    void openWindow()
    {
        if (!kept_)
            if (auto another = anotherExhibit()) kept_ = std::make_shared<PlainMuseum>(std::move(another));
        gallery_ = std::make_unique<PaintedGallery>(kept_);
        window_ = std::make_unique<ui::MainWindow>(gallery_->museum(), *gallery_, ui::makeWindowActions);
        window_->viewport().pictures().setLimits(mostSamples_, 0);
        window_->resize(1200, 800);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get(), vitrine::test::patience));
        settle();
    }
    void settle() { QTRY_VERIFY(window_->viewport().pictures().schedule().still()); }
    void closeWindow()
    {
        window_->close();
        window_.reset();
    }
    [[nodiscard]] int red() { return window_->viewport().grabFramebuffer().pixelColor(20, 20).red(); }
    [[nodiscard]] double roughness(std::size_t exhibit = 1)
    {
        return window_->history().sceneState().values[exhibit][gallery_->table().roughness];
    }
    [[nodiscard]] QListWidget* presets() { return window_->findChild<ui::PresetList*>()->findChild<QListWidget*>(); }
    /// Returns the presets of this name, including shipped ones.
    [[nodiscard]] QList<QListWidgetItem*> rowsNamed(const char* name)
    {
        return presets()->findItems(QString::fromUtf8(name), Qt::MatchExactly);
    }
    template <typename T> T* in(const char* row) { return window_->panel().row(row)->findChild<T*>(); }
    QAction* action(const char* text)
    {
        for (QAction* a : window_->findChildren<QAction*>())
            if (a->text().remove('&') == QString::fromUtf8(text)) return a;
        return nullptr;
    }
    void dragRoughness(int percent) { drag("roughness", percent); }
    /// Drags a row's slider from near its left end by a percentage of the slider's width, so that the drag does not
    /// depend on the width of the panel.
    void drag(const char* row, int percent)
    {
        auto* slider = in<ui::ValueSlider>(row);
        const QPoint from(12, slider->height() / 2);
        QTest::mousePress(slider, Qt::LeftButton, {}, from);
        const auto at = [&](int part) { return from + QPoint(slider->width() * part / 100, 0); };
        for (int part = 0; part <= percent; part += 2) QTest::mouseMove(slider, at(part));
        QTest::mouseRelease(slider, Qt::LeftButton, {}, at(percent));
    }
};

}  // namespace vitrine::test
