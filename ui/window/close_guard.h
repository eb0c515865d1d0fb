#pragma once

#include <QObject>
#include <QPointer>
#include <QStringList>

#include <functional>

class QMessageBox;

namespace vitrine::ui {

/// Prevents the window from closing while files are being written.
class CloseGuard final : public QObject {
    Q_OBJECT

public:
    explicit CloseGuard(QWidget& window);

    /// Sets two functions: `names` returns the files with unsaved changes; `save` saves them and returns whether no
    /// further question was needed.
    void setUnsaved(std::function<QStringList()> names, std::function<bool()> save);

    /// Returns whether the window may close now. Otherwise the visitor is asked, and the window is closed later if the
    /// answer says so.
    [[nodiscard]] bool mayClose();

private:
    void ask();
    void askToSave(const QStringList& names);
    void closeWhenDone();
    void closeIfDone();

    QWidget& window_;
    bool givenUp_ = false;  // Files being written may be lost.
    bool kept_ = false;     // Unsaved changes stay in the session, which is restored next time.
    std::function<QStringList()> unsaved_;
    std::function<bool()> save_;
    QPointer<QMessageBox> question_;
};

}  // namespace vitrine::ui
