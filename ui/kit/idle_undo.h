#pragma once

#include <QObject>

namespace vitrine::ui {

/// Passes Ctrl+Z on to the window if the focused line edit has nothing to undo; a line edit alone would swallow the
/// keys. A line edit whose property `searches` is true always passes them on, because its text is no value.
class IdleUndo final : public QObject {
    Q_OBJECT

public:
    static constexpr const char* searches = "searches";

    /// Watches all line edits of this window, also those made later.
    explicit IdleUndo(QWidget* window);

    bool eventFilter(QObject*, QEvent*) override;

private:
    [[nodiscard]] bool belongs(const QObject*) const;

    QWidget* window_;
};

}  // namespace vitrine::ui
