#pragma once

#include <QDialog>
#include <QIcon>

namespace vitrine::ui {

/// What this is: version, what it is made with, license.
class AboutDialog final : public QDialog {
    Q_OBJECT

public:
    explicit AboutDialog(QWidget* window);
};

/// A showcase with something round in it, at all the sizes that desktops ask for.
[[nodiscard]] QIcon programIcon();

}  // namespace vitrine::ui
