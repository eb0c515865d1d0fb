#pragma once

#include "ui/preferences/key_bindings.h"

#include <QWidget>

class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace vitrine::ui {

/// Page with all commands and their shortcuts: search, change, reset. A shortcut of another command is taken only after
/// the visitor confirms.
class KeysPage final : public QWidget {
    Q_OBJECT

public:
    /// The bindings must outlive the page.
    explicit KeysPage(KeyBindings&, QWidget* parent = nullptr);

private:
    void build();
    void fill();
    void filter();
    void showChosen();
    [[nodiscard]] QAction* chosen() const;
    void typed();
    /// Gives the shortcuts to the chosen command. Asks first if another command has one of them.
    void give(const KeyBindings::Keys&);
    void say(const QString& words, bool asks);

    KeyBindings& keys_;
    QLineEdit* words_;
    QTreeWidget* list_;
    QLabel* name_;
    QKeySequenceEdit* edit_;
    QPushButton* none_;
    QPushButton* reset_;
    QPushButton* resetAll_;
    QLabel* message_;
    QPushButton* take_;
    QPushButton* leave_;
    KeyBindings::Keys asked_;  // Shortcuts that wait for the visitor's confirmation.
};

}  // namespace vitrine::ui
