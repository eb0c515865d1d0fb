#pragma once

#include <QDialog>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace vitrine::ui {

/// Small dialog of one control. Its heading is inside the dialog, where no window manager cuts it off. It opens over
/// the control's panel, so that the picture stays visible. Deletes itself when closed.
class InlineDialog : public QDialog {
    Q_OBJECT

public:
    /// `accept`: text of the button that accepts.
    InlineDialog(const QString& heading, const QString& accept, QWidget* parent);

    /// Shows the dialog below the anchor, or above if there is no room. It is as wide as the anchor if its content
    /// allows.
    void openOver(const QWidget& anchor);

protected:
    /// Layout between heading and buttons.
    [[nodiscard]] QVBoxLayout& body() const { return *body_; }
    [[nodiscard]] QPushButton& acceptButton() const { return *accept_; }

private:
    QLabel* heading_;
    QVBoxLayout* body_;
    QPushButton* accept_;
};

}  // namespace vitrine::ui
