#pragma once

#include <QWidget>

class QAction;
class QLabel;
class QToolButton;

namespace vitrine::ui {

class LessonDesk;

/// A strip above the picture while a lesson is open: which step of how many, what to see, the number to read, and
/// buttons to go back, on, and out.
class LessonBar final : public QWidget {
    Q_OBJECT

public:
    /// The desk must outlive it.
    explicit LessonBar(LessonDesk&);

    /// Shows the page where the desk stands.
    void refresh();
    /// Out of sight whatever is open: nothing but the picture is shown.
    void setBanned(bool);

protected:
    void paintEvent(QPaintEvent*) override;

private:
    QToolButton* button(QAction&, const QString& words);

    LessonDesk& desk_;
    QLabel* title_;
    QLabel* count_;
    QLabel* text_;
    QLabel* number_;
    bool banned_ = false;
};

}  // namespace vitrine::ui
