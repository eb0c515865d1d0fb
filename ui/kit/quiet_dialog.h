#pragma once

#include <QDialog>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace vitrine::ui {

/// A small dialog that belongs to one control: its heading stands in the dialog itself, where no window manager cuts it
/// off, and it opens over the control's own panel, so that the picture stays in sight. Deletes itself when closed.
class QuietDialog : public QDialog {
    Q_OBJECT

public:
    /// `accept`: the word on the button that keeps what was done.
    QuietDialog(const QString& heading, const QString& accept, QWidget* parent);

    /// Shows it below the anchor, or above where there is no room, and as wide as the anchor where its content allows.
    void openOver(const QWidget& anchor);

protected:
    /// What is between heading and buttons goes here.
    [[nodiscard]] QVBoxLayout& body() const { return *body_; }
    [[nodiscard]] QPushButton& acceptButton() const { return *accept_; }

private:
    QLabel* heading_;
    QVBoxLayout* body_;
    QPushButton* accept_;
};

}  // namespace vitrine::ui
