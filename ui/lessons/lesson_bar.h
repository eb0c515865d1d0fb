#pragma once

#include "ui/kit/accessible_content.h"

#include <QWidget>

class QAction;
class QLabel;
class QToolButton;

namespace vitrine::ui {

class LessonController;

/// Strip above the picture while a lesson is open: number and text of the step, what to do, the value to read, and a
/// question with an answer that opens. Buttons lead back, to the next step, and out of the lesson. Each step is
/// announced to screen readers.
class LessonBar final : public QWidget, public AccessibleContent {
    Q_OBJECT

public:
    /// The controller must outlive the bar.
    explicit LessonBar(LessonController&);

    /// Shows the present page of the lesson.
    void refresh();
    /// While on, the bar stays hidden: used for the bare picture.
    void setBanned(bool);

    [[nodiscard]] QAccessible::Role accessibleRole() const override { return QAccessible::Notification; }

protected:
    void paintEvent(QPaintEvent*) override;

private:
    QToolButton* button(QAction&, const QString& words);
    void addText(QLabel&, const QString& name);
    void announceStep();

    LessonController& controller_;
    QLabel* title_;
    QLabel* count_;
    QLabel* text_;
    QLabel* task_;
    QLabel* number_;
    QLabel* question_;
    QLabel* answer_;
    QToolButton* answerButton_;
    bool banned_ = false;
    QString told_;  ///< Page that was announced last.
};

}  // namespace vitrine::ui
