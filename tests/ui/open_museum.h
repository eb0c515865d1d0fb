#pragma once

#include "tests/ui/cheap_pictures.h"
#include "tests/ui/patience.h"
#include "tests/ui/test_home.h"
#include "ui/kit/theme.h"
#include "ui/viewport/gl_probe.h"
#include "ui/viewport/museum_renderers.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>

#include <clocale>
#include <memory>
#include <utility>

namespace vitrine::test {

/// Test of the whole window over a real museum. Every function has folders of its own; the user's are never touched.
class OpenMuseum : public QObject {
protected:
    std::unique_ptr<QTemporaryDir> home_;
    std::unique_ptr<Museum> museum_;
    std::unique_ptr<ui::Renderers> renderers_;
    std::unique_ptr<ui::MainWindow> window_;

    static void prepare()
    {
        std::setlocale(LC_NUMERIC, "C");
        ui::applyTheme(*qApp, ui::darkTheme());
        QVERIFY2(ui::whyNoOpenGl().isEmpty(), qPrintable(ui::whyNoOpenGl()));
    }
    void makeHome()
    {
        home_ = newHome(ProgramCaches::shared);
        QVERIFY(home_->isValid());
    }
    /// Makes the window, which draws the museum cheaply, and leaves it hidden. Null: renderers of the museum.
    void makeWindow(const CheapPictures& pictures, std::unique_ptr<ui::Renderers> renderers = nullptr)
    {
        renderers_ = renderers ? std::move(renderers) : std::make_unique<ui::MuseumRenderers>(*museum_);
        window_ = std::make_unique<ui::MainWindow>(*museum_, *renderers_, ui::makeWindowActions);
        drawCheaply(*window_, pictures);
    }
    void showWindow(const QSize& size)
    {
        window_->resize(size);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get(), patience));
    }
    void closeWindow()
    {
        if (window_) window_->close();
        window_.reset();
    }
};

}  // namespace vitrine::test
