#pragma once

#include "ui/kit/preferences.h"

#include <QDialog>

#include <functional>
#include <utility>
#include <vector>

class QGridLayout;
class QSpinBox;
class QTabWidget;

namespace vitrine::ui {

class KeyBindings;

/// Dialog with all preferences, which are applied at once. Each line has a dot that resets it.
class PreferencesDialog final : public QDialog {
    Q_OBJECT

public:
    /// Both must outlive the dialog.
    PreferencesDialog(Preferences&, KeyBindings&, QWidget* parent);

signals:
    void forgetRecentAsked();

private:
    using Choices = std::vector<std::pair<int, QString>>;

    /// Adds a tab with a grid for lines.
    QGridLayout* page(const QString& title);
    void addWindowPage();
    void addPicturePage();
    void addControllersPage();
    void addFilesPage();
    struct LineTexts {
        QString label;  ///< Empty if the control has its own.
        QString tip;
    };
    void addChoice(QGridLayout&, const LineTexts&, const Choices&, std::function<int(const PreferenceValues&)> value,
                   std::function<void(PreferenceValues&, int)> set);
    QSpinBox* addNumber(QGridLayout&, const LineTexts&, const QString& unit, int step, PreferenceRange,
                        int PreferenceValues::*);
    void addSwitch(QGridLayout&, const QString& words, const QString& tip, bool PreferenceValues::*);
    /// Adds the choice of the language menu, which is stored separately.
    void addLanguage(QGridLayout&);
    /// Adds a line with the label, the control and a reset dot.
    void addLine(QGridLayout&, const LineTexts&, QWidget& control, std::function<void(const PreferenceValues&)> show,
                 std::function<bool(const PreferenceValues&)> differs, std::function<void(PreferenceValues&)> reset);
    void change(const std::function<void(PreferenceValues&)>& how);
    void showAll();

    Preferences& preferences_;
    QTabWidget* tabs_;
    std::vector<std::function<void(const PreferenceValues&)>> shows_;
};

}  // namespace vitrine::ui
