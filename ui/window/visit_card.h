#pragma once

#include <QFrame>

#include <cstddef>

class QLabel;

namespace vitrine::ui {

class FlowLayout;
class MainWindow;

/// Card over the lower left corner of the picture that says what an exhibit is and what a visitor can do there: its
/// lesson, a comparison that it offers, nine variations, its page. It appears on the first visit of an exhibit, once
/// on this machine, and disappears when it was used or closed, a value changed, or the visitor went elsewhere.
class VisitCard final : public QFrame {
    Q_OBJECT

public:
    /// The window must outlive the card, which is a child of the picture.
    explicit VisitCard(MainWindow&);

    /// Shows the card if this exhibit is visited for the first time, and hides it otherwise.
    void follow(std::size_t exhibit);
    /// While on, the card is hidden and no visit counts as the first: used for the bare picture.
    void setBanned(bool);

protected:
    bool eventFilter(QObject*, QEvent*) override;
    void paintEvent(QPaintEvent*) override;

private:
    void fill(std::size_t exhibit);
    void place();

    MainWindow& window_;
    QLabel *title_, *summary_;
    FlowLayout* buttons_;
    std::size_t exhibit_ = 0;
    bool banned_ = false;
};

}  // namespace vitrine::ui
