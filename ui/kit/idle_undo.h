#pragma once

#include <QObject>

namespace vitrine::ui {

/// Leaves Ctrl+Z to the window where a line edit of it has the focus but nothing typed to take back. Without it the
/// line edit takes the keys and does nothing. One whose property `searches` is true never takes them: what is typed
/// there is no value.
class IdleUndo final : public QObject {
    Q_OBJECT

public:
    static constexpr const char* searches = "searches";

    /// Watches the line edits of this window from now on, also those made later.
    explicit IdleUndo(QWidget* window);

    bool eventFilter(QObject*, QEvent*) override;

private:
    [[nodiscard]] bool belongs(const QObject*) const;

    QWidget* window_;
};

}  // namespace vitrine::ui
