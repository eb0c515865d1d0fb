#pragma once

#include <QScrollArea>

class QDialog;

namespace vitrine::ui {

/// A scroll area without a frame that wants to be as large as its content, as far as the screen has room for it, and
/// can be made small.
class ScrollRoom final : public QScrollArea {
    Q_OBJECT

public:
    explicit ScrollRoom(QWidget* content, QWidget* parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    bool eventFilter(QObject*, QEvent*) override;
};

/// Lets everything in a dialog that is laid out scroll where the screen has no room for it.
void scrollWhenTight(QDialog&);

}  // namespace vitrine::ui
