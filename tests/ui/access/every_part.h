#pragma once

#include "tests/ui/open_window.h"

#include "exhibits/pixel_art/pixel_art.h"
#include "exhibits/sdf_scenes/sdf_scenes.h"
#include "ui/kit/message_strip.h"
#include "ui/parameters/motion_dialog.h"
#include "ui/sprites/sprite_dialog.h"
#include "ui/window/window_docks.h"

#include <QAbstractButton>
#include <QDockWidget>
#include <QFileDialog>
#include <QPointer>

#include <functional>

namespace vitrine::test {

/// The window with every panel and every dialog of it, whatever they are: those that are added later come by
/// themselves, as actions whose names end in three dots, and as docks.
class EveryPart : public OpenWindow {
protected:
    [[nodiscard]] std::unique_ptr<Exhibit> anotherExhibit() override { return std::make_unique<SdfScenes>(); }

    void activate(QWidget* window)
    {
        QApplication::setActiveWindow(window);  // No window manager does it under Xvfb.
        QTRY_COMPARE(QApplication::activeWindow(), window);
    }
    /// Opens every panel and, for each, calls `look` while it is in front; a tree is on show, and the exhibit has rows
    /// of all kinds.
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
    /// Opens one dialog after the other, calls `look`, and sees to it that it is gone afterwards.
    void forEveryDialog(const std::function<void(const QString& name, QWidget&)>& look)
    {
        window_->choose(1);
        QList<QPointer<QAction>> actions;
        for (QAction* each : window_->findChildren<QAction*>()) {
            const QString name = each->text().remove('&');
            const bool more = name == "About Vitrine" || name == "How this works" || name.startsWith("Keyboard");
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
                static const PixelArt sprites;  // Its table outlives the dialog.
                (new ui::SpriteDialog(sprites.parameters().initial(), *gallery_, window_->viewport().renderThread(),
                                      window_.get()))
                    ->show();
            },
            look);
    }
    /// The dialogs that are seen; those of the system are not ours.
    [[nodiscard]] static QWidget* openDialog()
    {
        for (QWidget* each : QApplication::topLevelWidgets())
            if (each->inherits("QDialog") && each->isVisible()) return each;
        return nullptr;
    }

private:
    void lookAt(const QString& name, const std::function<void()>& open,
                const std::function<void(const QString&, QWidget&)>& look)
    {
        open();
        // What has nothing to ask just now opens nothing.
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
