#pragma once

#include "tests/ui/open_window.h"

#include "exhibits/jobs.h"
#include "exhibits/pixel_art/pixel_art.h"
#include "exhibits/sdf_scenes/sdf_scenes.h"
#include "ui/jobs/job_dialog.h"
#include "ui/kit/message_strip.h"
#include "ui/parameters/motion_dialog.h"
#include "ui/window/window_docks.h"

#include <QAbstractButton>
#include <QDockWidget>
#include <QFileDialog>
#include <QPointer>

#include <functional>

namespace vitrine::test {

/// Test of the window with all panels and dialogs. New ones are found automatically, as actions whose names end in
/// three dots, and as docks.
class EveryPart : public OpenWindow {
protected:
    EveryPart() { mostSamples_ = asTheHallRequests; }
    [[nodiscard]] std::unique_ptr<Exhibit> anotherExhibit() override { return std::make_unique<scenes::SdfScenes>(); }

    void activate(QWidget* window)
    {
        QApplication::setActiveWindow(window);  // Under Xvfb there is no window manager.
        QTRY_COMPARE(QApplication::activeWindow(), window);
    }
    /// Opens every panel and calls `look` while it is in front. A tree is shown, and the exhibit has parameters of all
    /// kinds.
    void forEveryDock(const std::function<void(QDockWidget&)>& look)
    {
        for (QDockWidget* dock : window_->docks().all()) {
            window_->choose(dock->objectName() == QLatin1String("tree") ? 2 : 1);
            const bool closed = dock->isHidden();
            dock->show();
            dock->raise();
            QTRY_VERIFY2(dock->isVisible() && !dock->visibleRegion().isEmpty(), qPrintable(dock->objectName()));
            look(*dock);
            dock->setHidden(closed);
        }
    }
    /// Opens all dialogs one after the other, calls `look`, and closes each.
    void forEveryDialog(const std::function<void(const QString& name, QWidget&)>& look)
    {
        window_->choose(1);
        QList<QPointer<QAction>> actions;
        for (QAction* each : window_->findChildren<QAction*>()) {
            const QString name = each->text().remove('&');
            const bool more = name == "About Vitrine" || name == "About this exhibit" || name.startsWith("Keyboard");
            if (!each->menu() && (more || name.endsWith(QChar(0x2026)))) actions << each;
        }
        QVERIFY(actions.size() >= 8);
        for (const QPointer<QAction>& each : actions)
            if (each && each->isEnabled())
                lookAt(
                    each->text().remove('&'), [&] { each->trigger(); }, look);
        lookAt(
            "Animate",
            [this] {
                auto* dialog = new ui::MotionDialog(window_->history(), 1, {0}, window_.get());
                dialog->openOver(window_->viewport());
            },
            look);
        lookAt(
            "Color",
            [this] {
                for (auto* button : window_->panel().row("baseColor")->findChildren<QAbstractButton*>())
                    if (button->accessibleName().contains("choose a color")) button->click();
            },
            look);
        lookAt(
            "Sprites",
            [this] {
                static const Museum museum(withSprites());  // The museum must outlive the dialog.
                const auto scene = [] { return jobs::JobScene{&museum, museum.initialSceneState(), 1, {}}; };
                (new ui::JobDialog(*jobs::findJob("sprite"), scene, *gallery_, window_->viewport().renderThread(),
                                   window_.get()))
                    ->show();
            },
            look);
    }
    /// Returns the visible dialog of the program; dialogs of the system do not count.
    [[nodiscard]] static QWidget* openDialog()
    {
        for (QWidget* each : QApplication::topLevelWidgets())
            if (each->inherits("QDialog") && each->isVisible()) return each;
        return nullptr;
    }

private:
    [[nodiscard]] static std::vector<std::unique_ptr<Exhibit>> withSprites()
    {
        std::vector<std::unique_ptr<Exhibit>> exhibits;
        exhibits.push_back(std::make_unique<pixel_art::PixelArt>());
        return exhibits;
    }
    void lookAt(const QString& name, const std::function<void()>& open,
                const std::function<void(const QString&, QWidget&)>& look)
    {
        open();
        // Some actions open nothing at the moment.
        if (!QTest::qWaitFor([] { return openDialog() || QApplication::activePopupWidget(); }, 500)) return;
        if (QWidget* menu = QApplication::activePopupWidget(); menu && !menu->inherits("QDialog")) {
            menu->close();
            return;
        }
        QPointer<QWidget> dialog = openDialog();
        QVERIFY(QTest::qWaitForWindowExposed(dialog, patience));
        if (!dialog->inherits("QFileDialog")) {
            QApplication::setActiveWindow(dialog);
            look(name, *dialog);
        }
        if (dialog) dialog->close();
        QTRY_VERIFY2(!openDialog(), qPrintable(name));
    }
};

}  // namespace vitrine::test
