#pragma once

#include "ui/kit/spoken.h"

#include <QWidget>

class QAction;
class QLabel;
class QToolButton;

namespace vitrine::ui {

class LessonDesk;

/// A strip above the picture while a lesson is open: which step of how many, what to see, the number to read, and
/// buttons to go back, on, and out. A screen reader is told every step when it comes.
class LessonBar final : public QWidget, public Spoken {
    Q_OBJECT

public:
    /// The desk must outlive it.
    explicit LessonBar(LessonDesk&);

    /// Shows the page where the desk stands.
    void refresh();
    /// Out of sight whatever is open: nothing but the picture is shown.
    void setBanned(bool);

    [[nodiscard]] QAccessible::Role spokenRole() const override { return QAccessible::Notification; }

protected:
    void paintEvent(QPaintEvent*) override;

private:
    QToolButton* button(QAction&, const QString& words);
    void tell();

    LessonDesk& desk_;
    QLabel* title_;
    QLabel* count_;
    QLabel* text_;
    QLabel* number_;
    bool banned_ = false;
    QString told_;  ///< The page that a screen reader was told last.
};

}  // namespace vitrine::ui
