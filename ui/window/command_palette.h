#pragma once

#include <QDialog>
#include <QList>

class QAction;
class QLineEdit;
class QListWidget;

namespace vitrine::ui {

/// Every command of the window by name: type a few letters, Enter.
class CommandPalette final : public QDialog {
    Q_OBJECT

public:
    CommandPalette(const QList<QAction*>& actions, QWidget* window);

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    void fill();
    void run();

    QList<QAction*> actions_;
    QLineEdit* words_;
    QListWidget* list_;
};

/// All shortcuts on one page.
class ShortcutSheet final : public QDialog {
    Q_OBJECT

public:
    ShortcutSheet(const QList<QAction*>& actions, QWidget* window);
};

}  // namespace vitrine::ui
