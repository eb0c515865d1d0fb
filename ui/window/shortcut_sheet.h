#pragma once

#include <QDialog>
#include <QList>

class QAction;

namespace vitrine::ui {

/// Sheet with all shortcuts on one page.
class ShortcutSheet final : public QDialog {
    Q_OBJECT

public:
    ShortcutSheet(const QList<QAction*>& actions, QWidget* window);
};

}  // namespace vitrine::ui
