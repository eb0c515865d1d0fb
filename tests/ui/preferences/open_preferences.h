#pragma once

#include "tests/ui/open_window.h"
#include "tests/ui/preferences/fake_portal.h"
#include "tests/ui/ui_main.h"

#include "ui/kit/appearance.h"
#include "ui/preferences/preferences_dialog.h"
#include "ui/window/application.h"
#include "ui/window/window_preferences.h"

#include <QComboBox>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>

namespace vitrine::test {

/// Test of the window and its preferences, on a private message bus.
class OpenPreferences : public OpenWindow {
protected:
    [[nodiscard]] const ui::PreferenceValues& values() { return window_->preferences().values().values(); }
    ui::PreferencesDialog* openDialog(const char* tab = "Window")
    {
        QApplication::setActiveWindow(window_.get());
        QTest::keyClick(window_.get(), Qt::Key_Comma, Qt::ControlModifier);
        auto* dialog = window_->findChild<ui::PreferencesDialog*>();
        if (!dialog || !QTest::qWaitForWindowExposed(dialog, patience)) return nullptr;
        auto* tabs = dialog->findChild<QTabWidget*>();
        for (int i = 0; i < tabs->count(); ++i)
            if (tabs->tabText(i) == QLatin1String(tab)) tabs->setCurrentIndex(i);
        return dialog;
    }
    template <typename T> [[nodiscard]] T* control(const char* name)
    {
        for (T* each : window_->findChild<ui::PreferencesDialog*>()->template findChildren<T*>())
            if (each->accessibleName() == QLatin1String(name)) return each;
        return nullptr;
    }
    /// Chooses like the arrow keys and Enter.
    void choose(const char* name, const char* item)
    {
        auto* box = control<QComboBox>(name);
        QVERIFY2(box && box->findText(item) >= 0, item);
        box->setFocus();
        while (box->currentIndex() < box->findText(item)) QTest::keyClick(box, Qt::Key_Down);
        while (box->currentIndex() > box->findText(item)) QTest::keyClick(box, Qt::Key_Up);
    }
    void type(const char* name, int value)
    {
        auto* box = control<QSpinBox>(name);
        QVERIFY2(box, name);
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, QString::number(value));
        QTest::keyClick(box, Qt::Key_Return);
    }
    void reset(const char* name)
    {
        auto* dot = control<QAbstractButton>(name);
        QVERIFY2(dot && dot->isEnabled(), name);
        QTest::mouseClick(dot, Qt::LeftButton);
        QVERIFY(!dot->isEnabled());
    }
    [[nodiscard]] QPushButton* button(const char* text)
    {
        for (QPushButton* each : window_->findChild<ui::PreferencesDialog*>()->findChildren<QPushButton*>())
            if (each->text() == QLatin1String(text)) return each;
        return nullptr;
    }
    void lookLikeNothingWasChosen()
    {
        ui::applyAppearance(*qApp, {}, {});
        ui::applyTheme(*qApp, ui::darkTheme());
    }
};

/// Runs the test in an application that uses the bus from its start.
template <typename Test> int runWithBus(int argc, char** argv)
{
    const PrivateBus bus;
    qputenv("DBUS_SESSION_BUS_ADDRESS", bus.address().toLocal8Bit());
    return runUnder<ui::Application, Test>(argc, argv);
}

}  // namespace vitrine::test
