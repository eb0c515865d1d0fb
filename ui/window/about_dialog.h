#pragma once

#include <QDialog>
#include <QIcon>

namespace vitrine::ui {

/// Dialog with the program's version, libraries and license.
class AboutDialog final : public QDialog {
    Q_OBJECT

public:
    explicit AboutDialog(QWidget* window);
};

/// Returns the program's icon, a showcase with a round object in it, in all sizes that desktops use.
[[nodiscard]] QIcon programIcon();

}  // namespace vitrine::ui
