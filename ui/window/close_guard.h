#pragma once

#include <QObject>
#include <QPointer>

class QMessageBox;

namespace vitrine::ui {

/// Keeps the window from closing over files that are still being written.
class CloseGuard final : public QObject {
    Q_OBJECT

public:
    explicit CloseGuard(QWidget& window);

    /// Whether the window may close now. Where it may not, the visitor is asked; it is closed later if that is the
    /// answer.
    [[nodiscard]] bool mayClose();

private:
    void ask();
    void closeWhenDone();
    void closeIfDone();

    QWidget& window_;
    bool givenUp_ = false;  // What is being written.
    QPointer<QMessageBox> question_;
};

}  // namespace vitrine::ui
