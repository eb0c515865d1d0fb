#pragma once

#include <QWidget>

namespace vitrine::ui {

/// Part of the status line that says that other programs can read and change the window's values, with a button that
/// ends it.
class ServingBar final : public QWidget {
    Q_OBJECT

public:
    /// `socket`: path at which the window is served.
    explicit ServingBar(const QString& socket, QWidget* parent = nullptr);

signals:
    void stopAsked();
};

}  // namespace vitrine::ui
