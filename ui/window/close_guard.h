#pragma once

#include <QObject>
#include <QPointer>
#include <QStringList>

#include <functional>

class QMessageBox;

namespace vitrine::ui {

/// Keeps the window from closing over files that are still being written.
class CloseGuard final : public QObject {
    Q_OBJECT

public:
    explicit CloseGuard(QWidget& window);

    /// Files whose changes are not in them, and what saves them where that takes no further question.
    void setUnsaved(std::function<QStringList()> names, std::function<bool()> save);

    /// Whether the window may close now. Where it may not, the visitor is asked; it is closed later if that is the
    /// answer.
    [[nodiscard]] bool mayClose();

private:
    void ask();
    void askToSave(const QStringList& names);
    void closeWhenDone();
    void closeIfDone();

    QWidget& window_;
    bool givenUp_ = false;  // What is being written.
    bool kept_ = false;     // What is not saved: it comes back next time.
    std::function<QStringList()> unsaved_;
    std::function<bool()> save_;
    QPointer<QMessageBox> question_;
};

}  // namespace vitrine::ui
